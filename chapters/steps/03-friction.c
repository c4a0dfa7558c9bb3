/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 3: friction and spin.
 *
 * The grain of step 2 is thrown along the floor. Where the surfaces slip, with
 * v_t (2.2), a second spring is stretched by xi, and together with its dashpot
 * it exerts a force along the floor,
 *
 *     F_t = -k_t xi - eta_t v_t,   dxi/dt = v_t,   |F_t| <= mu |F_n|
 *
 * (2.8) [LS 4.8]. Where Coulomb's law limits the force, xi is reduced. F_t also
 * turns the grain by its lever l, I dw/dt = l F_t, I = 2/5 m R^2 (2.11). An
 * impact that slides to its end reduces the slip by 7/2 mu (1 + e) v_n.
 *
 *     build/steps/03-friction [END]     END [s] is the time at which it ends
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;
static const double g = 9.81;       /* [m/s^2] gravity */
static const double R = 0.6e-3;     /* [m] radius of the grain */
static const double rho_s = 1000.0; /* [kg/m^3] its density */
static const double e = 0.7;        /* [-] restitution */
static const double mu = 0.2;       /* [-] friction */
static const double k = 100.0;      /* [N/m] stiffness of the contact */
static const double h = 0.006;      /* [m] height of the fall */
static const double dt = 1e-6;      /* [s] time step */

enum { EVERY = 4000, MOST = 100 }; /* one step in 4000 is kept */
static double m, eta;              /* [kg] mass, [kg/s] damping */
static double x, y, angle;         /* [m], [rad] */
static double vx, vy, w;           /* [m/s], [rad/s] */
static double delta, l, v_t, xi;   /* [m], [m], [m/s], [m] of the contact */
static double F_n, F_t;            /* [N] force of the floor, up and along x */

static double path[MOST][3]; /* x, y, angle */
static int n_path;

/* (2.1)-(2.4), (2.8). The two springs have the same period if both k_t / k
 * and eta_t / eta are 2/7 (2.10). */
static void contact(void)
{
    const double k_t = 2.0 / 7.0 * k, eta_t = 2.0 / 7.0 * eta;
    delta = R - y;
    l = R - 0.5 * delta;
    v_t = vx + l * w;
    F_n = delta > 0.0 ? k * delta - eta * vy : 0.0;
    xi = delta > 0.0 ? xi + v_t * dt : 0.0;
    F_t = delta > 0.0 ? -k_t * xi - eta_t * v_t : 0.0;
    if (fabs(F_t) > mu * fabs(F_n)) {
        F_t = copysign(mu * F_n, F_t);
        if (k_t * fabs(xi) > fabs(F_t)) xi = -F_t / k_t;
    }
}

static void kick(double time)
{
    vx += F_t / m * time;
    vy += (F_n / m - g) * time;
    w += l * F_t / (0.4 * m * R * R) * time;
}

static FILE *create(const char *program, const char *ending)
{
    char name[1000];
    snprintf(name, sizeof name, "%s%s", program, ending);
    FILE *const file = fopen(name, "w");
    if (file != NULL) return file;
    perror(name);
    exit(4);
}

/* The path as a line through the centres. */
static void write_vtk(FILE *file)
{
    fprintf(file,
            "# vtk DataFile Version 3.0\npath of the grain\nASCII\n"
            "DATASET STRUCTURED_GRID\nDIMENSIONS %d 1 1\n"
            "POINTS %d double\n",
            n_path, n_path);
    for (int a = 0; a < n_path; a++)
        fprintf(file, "%.9g %.9g 0\n", path[a][0], path[a][1]);
    fclose(file);
}

/* The grain every 4 ms, with a radius that turns with it; in millimetres. The
 * bar is 10 mm long. */
static void write_svg(FILE *file)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='852' "
                  "height='120' viewBox='-1 -9 71 10' stroke='#1f5fa8' "
                  "stroke-width='0.1'>\n<path d='M-2 0H71M58 -7H68'/>\n"
                  "<text x='61' y='-7.4' font-size='1.5' stroke='none' "
                  "font-family='sans-serif'>10 mm</text>\n");
    for (int a = 0; a < n_path; a++)
        fprintf(file,
                "<g transform='translate(%.2f %.2f) rotate(%.0f)'>"
                "<circle r='0.6' fill='#cfe0f3'/><path d='M0 0H0.6'/></g>\n",
                1e3 * path[a][0], -1e3 * path[a][1], -180.0 / pi * path[a][2]);
    fprintf(file, "</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.14;
    const int n_steps = (int)lround(t_end / dt);
    const double zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    double v_before = 0.0, slip_before = 0.0;
    int impacts = 0;

    m = rho_s * 4.0 / 3.0 * pi * R * R * R;
    eta = 2.0 * zeta * sqrt(k * m);
    y = R + h;
    vx = 0.6;
    for (int step = 0; step < n_steps; step++) {
        kick(0.5 * dt);
        x += vx * dt;
        y += vy * dt;
        angle += w * dt;
        contact();
        kick(0.5 * dt);
        if (delta > 0.0 && v_before == 0.0) { /* the impact begins */
            v_before = vy;
            slip_before = v_t;
        }
        if (delta <= 0.0 && v_before < 0.0) { /* the impact ends */
            const double loss = -3.5 * mu * (1.0 + e) * v_before;
            printf("impact %d: slip %.4f -> %.4f m/s, by sliding alone %.4f\n",
                   impacts++, slip_before, v_t,
                   slip_before - copysign(loss, slip_before));
            v_before = 0.0;
        }
        if (step % EVERY == 0 && n_path < MOST) {
            path[n_path][0] = x;
            path[n_path][1] = y;
            path[n_path++][2] = angle;
        }
    }
    printf("t = %g s: y = %.9g, vx = %.9g, vy = %.9g m/s, w = %.9g rad/s\n",
           t_end, y, vx, vy, w);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: throw it with backspin, w = 5000.0 before the loop, and see where it
 * is after 0.3 s and 0.6 s (with MOST 200). Then raise mu to 1: the spring
 * reverses a part of the slip, as with a bouncing ball of rubber. */
