/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 2: spring and dashpot.
 *
 * In step 1 an impact took no time. Now it has a duration: while the grain
 * overlaps the floor by delta = R - y (2.1), a spring and a dashpot act on it,
 *
 *     F_n = k delta - eta v_n                                    (2.4) [LS 4.4]
 *
 * The dashpot is chosen so that the grain leaves with e times its speed (2.5):
 *
 *     eta = 2 zeta sqrt(k m),   zeta = -ln e / sqrt(pi^2 + ln^2 e)
 *
 * Half a period of this oscillator is the time of contact,
 * t_c = pi / sqrt(k/m - (eta/2m)^2). The step must resolve it.
 *
 *     build/steps/02-spring [END]       END [s] is the time at which it ends
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;
static const double g = 9.81;       /* [m/s^2] gravity */
static const double R = 0.6e-3;     /* [m] radius of the grain */
static const double rho_s = 1000.0; /* [kg/m^3] its density */
static const double e = 0.7;        /* [-] restitution */
static const double k = 100.0;      /* [N/m] stiffness of the contact */
static const double h = 0.02;       /* [m] height of the fall */
static const double dt = 1e-6;      /* [s] time step */

enum { MOST = 2000 }; /* as many points of the first impact are kept */

static double m, eta;     /* [kg] mass, [kg/s] damping */
static double y, v;       /* [m] height of the centre, [m/s] */
static double delta, F_n; /* [m] overlap, [N] force of the floor */

static double path_delta[MOST], path_F[MOST];
static int n_path;

/* (2.1) and (2.4): there is a force only while the grain overlaps the floor. */
static void contact(void)
{
    delta = R - y;
    F_n = delta > 0.0 ? k * delta - eta * v : 0.0;
}

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

/* The first impact as a line: overlap in mm and force in mN. */
static void write_vtk(FILE *file)
{
    fprintf(file,
            "# vtk DataFile Version 3.0\nforce against overlap\nASCII\n"
            "DATASET STRUCTURED_GRID\nDIMENSIONS %d 1 1\n"
            "POINTS %d double\n",
            n_path, n_path);
    for (int a = 0; a < n_path; a++)
        fprintf(file, "%.9g %.9g 0\n", 1e3 * path_delta[a], 1e3 * path_F[a]);
    fclose(file);
}

/* Force against overlap: 500 by 280 points for 60 um by 7 mN. */
static void write_svg(FILE *file)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='560' "
                  "height='380' font-family='sans-serif' font-size='14'>\n"
                  "<rect width='560' height='380' fill='white'/>\n"
                  "<path d='M50 20V360M50 300H550' stroke='black'/>\n"
                  "<text x='56' y='16'>force of the floor [mN]</text>\n"
                  "<text x='32' y='105'>5</text><text x='32' y='305'>0</text>\n"
                  "<text x='250' y='340'>overlap [um]</text>\n"
                  "<text x='210' y='320'>20</text><text x='376' y='320'>40"
                  "</text><text x='542' y='320'>60</text>\n"
                  "<path d='M46 100H550M217 20V304M383 20V304M550 20V304' "
                  "stroke='#ccc'/>\n");
    fprintf(file, "<polyline fill='none' stroke='#1f5fa8' stroke-width='2' "
                  "points='");
    for (int a = 0; a < n_path; a++)
        fprintf(file, "%.1f,%.1f ", 50.0 + 500.0 * path_delta[a] / 60e-6,
                300.0 - 280.0 * path_F[a] / 7e-3);
    fprintf(file, "'/>\n</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.3;
    const int n_steps = (int)lround(t_end / dt);
    const double zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    double v_before = 0.0, t_before = 0.0;
    int impacts = 0;

    m = rho_s * 4.0 / 3.0 * pi * R * R * R;
    eta = 2.0 * zeta * sqrt(k * m);
    printf("m = %.9g kg, eta = %.9g kg/s, t_c = %.4g s\n", m, eta,
           pi / sqrt(k / m - pow(eta / (2.0 * m), 2)));
    y = R + h;
    for (int step = 0; step < n_steps; step++) {
        v += (F_n / m - g) * 0.5 * dt;
        y += v * dt;
        contact();
        v += (F_n / m - g) * 0.5 * dt;

        if (delta > 0.0 && v_before == 0.0) { /* the impact begins */
            v_before = v;
            t_before = step * dt;
        }
        if (delta > 0.0 && impacts == 0 && n_path < MOST) {
            path_delta[n_path] = delta;
            path_F[n_path++] = F_n;
        }
        if (delta <= 0.0 && v_before < 0.0) { /* the impact ends */
            printf("impact %d: e = %.4f of %g, time = %.4g s\n", impacts++,
                   -v / v_before, e, step * dt - t_before);
            v_before = 0.0;
        }
    }
    printf("t = %g s: y = %.9g m, v = %.9g m/s\n", t_end, y, v);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: make the step longer, 1e-5 s, then 5e-5 s and 1e-4 s. How many steps
 * does a contact need before e is right to a per cent? Then take 2e-4 s: a step
 * longer than 2 t_c / pi throws the grain higher than it was. */
