/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 1: a bounce.
 *
 * A grain falls on a floor and bounces. While it flies, Newton's law moves it:
 *
 *     dy/dt = v,   m dv/dt = -m g                                    [LS 4.16]
 *
 * in steps of velocity Verlet (2.12). The impact takes no time here: the grain
 * leaves with e times the speed with which it came. This e is the restitution.
 * The exact speed of impact number k = 0, 1, ... is e^k sqrt(2 g h).
 *
 *     build/steps/01-bounce [END]       END [s] is the time at which it ends
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double g = 9.81;   /* [m/s^2] gravity */
static const double R = 0.6e-3; /* [m] radius of the grain */
static const double e = 0.7;    /* [-] restitution */
static const double h = 0.02;   /* [m] height of the fall */
static const double dt = 1e-5;  /* [s] time step */

enum { EVERY = 50, MOST = 2000 }; /* one step in 50 is kept for the files */

static double path_t[MOST], path_y[MOST]; /* [s], [m] */
static int n_path;

/* Opens the file PROGRAM + ending; the files lie beside the program. */
static FILE *create(const char *program, const char *ending)
{
    char name[1000];
    snprintf(name, sizeof name, "%s%s", program, ending);
    FILE *const file = fopen(name, "w");
    if (file != NULL) return file;
    perror(name);
    exit(4);
}

/* The path as a line through its points; time is the first coordinate. */
static void write_vtk(FILE *file)
{
    fprintf(file,
            "# vtk DataFile Version 3.0\nheight against time\nASCII\n"
            "DATASET STRUCTURED_GRID\nDIMENSIONS %d 1 1\n"
            "POINTS %d double\n",
            n_path, n_path);
    for (int k = 0; k < n_path; k++)
        fprintf(file, "%.9g %.9g 0\n", path_t[k], path_y[k]);
    fclose(file);
}

/* Height against time: 500 by 320 points for t_end by 22 mm. */
static void write_svg(FILE *file, double t_end)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='560' "
                  "height='380' font-family='sans-serif' font-size='14'>\n"
                  "<rect width='560' height='380' fill='white'/>\n"
                  "<path d='M50 20V340H550' fill='none' stroke='black'/>\n"
                  "<text x='56' y='16'>height of the centre [mm]</text>\n"
                  "<text x='24' y='54'>20</text>\n"
                  "<text x='24' y='199'>10</text>\n"
                  "<text x='32' y='345'>0</text>\n"
                  "<path d='M46 49H550M46 194H550' stroke='#ccc'/>\n");
    fprintf(file,
            "<text x='280' y='360'>time [s]</text>\n"
            "<text x='46' y='360'>0</text><text x='530' y='360'>%g</text>\n",
            t_end);
    fprintf(file, "<polyline fill='none' stroke='#1f5fa8' stroke-width='2' "
                  "points='");
    for (int k = 0; k < n_path; k++)
        fprintf(file, "%.1f,%.1f ", 50.0 + 500.0 * path_t[k] / t_end,
                340.0 - 320.0 * path_y[k] / 0.022);
    fprintf(file, "'/>\n</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.3;
    const int n_steps = (int)lround(t_end / dt);
    double y = R + h, v = 0.0; /* [m], [m/s] */
    int impacts = 0;

    for (int step = 0; step < n_steps; step++) {
        v += -g * 0.5 * dt; /* half a kick, a drift, half a kick */
        y += v * dt;
        v += -g * 0.5 * dt;
        if (y < R && v < 0.0) {
            printf("impact %d: t = %.4f s, speed = %.4f m/s, exact %.4f\n",
                   impacts, (step + 1) * dt, -v,
                   pow(e, impacts) * sqrt(2.0 * g * h));
            y = R;
            v = -e * v;
            impacts++;
        }
        if (step % EVERY == 0 && n_path < MOST) {
            path_t[n_path] = (step + 1) * dt;
            path_y[n_path++] = y;
        }
    }
    printf("t = %g s: y = %.6g m, v = %.6g m/s\n", t_end, y, v);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"), t_end);
    return 0;
}

/* To try: let e be 1 and dt 1e-3 s, and go on to 10 s. The grain gains energy
 * from bounce to bounce. Take y = R out of the impact, and it does not. Why?
 * How does the gain depend on dt? */
