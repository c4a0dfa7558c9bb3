/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 10: void fraction by PCM.
 *
 * Air is blown through 300 grains that do not move, in a slot little deeper
 * than one of them. A cell of the mesh holds some grains and the air between
 * them, and eps is the part that is air. The oldest method counts a grain
 * wholly in the cell of its centre, the particle-centroid method:
 *
 *     eps = 1 - sum V_p / V_c                                (8.6) [XS11 3.1]
 *
 * With eps the equations of step 8 become the averaged ones of a fluid that
 * shares the space with grains. The velocity between the grains is u, and the
 * volume that passes, per area and time, is q = eps u:
 *
 *     div q = 0                                               (5.7) [XS11 2.7]
 *     rho_f (du/dt + u . grad u) = -grad p - K u / eps                  (5.12)
 *
 * (5.12) is divided by eps here, and without viscosity: in a bed the drag of
 * the grains is a hundred times as much. K is their drag over the volume of the
 * cell and the velocity (10.2), for each grain by the law of Syamlal and
 * O'Brien (9.11)-(9.14) [Syamlal87]. It acts on the velocity at the end of the
 * step, so that the step is stable for any K. Convection is upwind, as in
 * step 7.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 300, NX = 8, NY = 32 };            /* grains, cells */
enum { W = NX + 2, CELLS = W * (NY + 3) };    /* with ghosts: W in a row */
static const double rho_f = 1.2, mu = 1.8e-5; /* [kg/m^3], [Pa s] of air */
static const double d = 1.2e-3, V_p = 9.04778684e-10; /* [m], [m^3] grains */
static const double dx = 2e-3, depth = 1.5e-3; /* [m] cells, slot across */
static const double U = 0.2, dt = 2e-4;        /* [m/s] at the inlet, [s] */

/* One value a cell. The next cell in direction k is c + next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};

static field p, eps;     /* [Pa], [-] in the cell */
static field resist;     /* [kg/(m^3 s)] first K, then slope of p over q */
static field u[2], q[2]; /* [m/s] on the lower face across k: u_k, eps u_k */
static field mob[2];   /* [m^3 s/kg] mobility there: q over slope of p (6.4) */
static double x[2][N]; /* [m] grains */

static int cell_of(int a) /* the cell of a grain */
{
    return (int)(x[0][a] / dx) + 1 + W * ((int)(x[1][a] / dx) + 1);
}

/* The ghost cells around the mesh take the values of the cells beside them. */
static void extend(field f)
{
    for (int i = 1; i <= NX; i++) {
        f[i] = f[i + W];
        f[i + W * (NY + 1)] = f[i + W * NY];
    }
    for (int j = 0; j <= NY + 1; j++) {
        f[W * j] = f[W * j + 1];
        f[W * j + NX + 1] = f[W * j + NX];
    }
}

/* beta / eps_s [kg/(m^3 s)], drag over volume of the grain and slip. */
static double resistance(double eps_f, double slip)
{
    const double Re = rho_f * d * slip / mu, a = 0.06 * Re; /* (9.2) */
    const double A1 = pow(eps_f, 4.14);                     /* (9.11) */
    const double A2 = eps_f <= 0.85 ? 0.8 * pow(eps_f, 1.28) : pow(eps_f, 2.65);
    const double V_r = /* (9.13) [XS11 2.13] */
        0.5 * (A1 - a + sqrt(a * a + 2.0 * a * (2.0 * A2 - A1) + A1 * A1));
    const double root = 0.63 * sqrt(slip) + 4.8 * sqrt(V_r * mu / (rho_f * d));
    return 0.75 * root * root * rho_f * eps_f / (V_r * V_r * d); /* (9.14) */
}

/* (8.6): each grain to the cell of its centre. Then their drag K, and from it
 * the slope of the pressure that inertia and drag need over q.
 */
static void average(void)
{
    const double V_c = dx * dx * depth;
    for (int c = 0; c < CELLS; c++) {
        eps[c] = 1.0;
        resist[c] = 0.0;
    }
    for (int a = 0; a < N; a++)
        eps[cell_of(a)] -= V_p / V_c;
    for (int a = 0; a < N; a++) {
        const int c = cell_of(a);
        const double slip =
            0.5 / eps[c] * hypot(q[0][c] + q[0][c + 1], q[1][c] + q[1][c + W]);
        resist[c] += V_p / V_c * resistance(eps[c], slip);
    }
    for (int c = 0; c < CELLS; c++)
        resist[c] = (rho_f / dt + resist[c] / eps[c]) / eps[c];
    extend(eps);
    extend(resist);
}

/* Predicts q without p, and finds the mobility m, by which q follows p. Half of
 * the way through a face lies in each of its cells: 1 / m is their mean (6.6).
 */
static void predict(void)
{
    static field old[2];
    memcpy(old, u, sizeof u);
    extend(old[0]);
    extend(old[1]);
    for (int c = W + 1; c <= W + NX; c++) {
        q[1][c] = U;
        old[1][c] = U / eps[c];
    }
    for (int k = 0; k < 2; k++)
        for (int c = W * (1 + k); c < W * (NY + 1 + k); c++) {
            if (c % W < 2 - k || c % W > NX) continue; /* a wall */
            const int b = c - next[k], o = next[1 - k];
            const double *const f = old[k], *const f_o = old[1 - k];
            double a[2], u_new = f[c]; /* convected by a, upwind */
            a[k] = f[c];
            a[1 - k] = 0.25 * (f_o[b] + f_o[b + o] + f_o[c] + f_o[c + o]);
            for (int l = 0; l < 2; l++)
                u_new -= a[l] * dt / dx *
                         (a[l] > 0.0 ? f[c] - f[c - next[l]]
                                     : f[c + next[l]] - f[c]);
            mob[k][c] = 2.0 / (resist[b] + resist[c]);
            q[k][c] = mob[k][c] * rho_f / dt * u_new;
        }
}

/* Successive over-relaxation with the factor 1.7. The mobility is 0 at walls
 * and at the inlet, so that p has no effect there; p is 0 beyond the outlet. */
static void find_pressure(void)
{
    for (int sweep = 0; sweep < 60; sweep++)
        for (int c = W; c < W * (NY + 1); c++) {
            double sum = 0.0, sum_mob = 0.0;
            for (int k = 0; k < 2; k++) {
                const int n = c + next[k];
                sum += mob[k][c] * p[c - next[k]] + mob[k][n] * p[n] -
                       dx * (q[k][n] - q[k][c]);
                sum_mob += mob[k][c] + mob[k][n];
            }
            if (sum_mob > 0.0) p[c] += 1.7 * (sum / sum_mob - p[c]);
        }
}

static void correct(void)
{
    for (int k = 0; k < 2; k++)
        for (int c = W + 1; c < W * (NY + 2); c++) {
            const int b = c - next[k];
            q[k][c] -= mob[k][c] * (p[c] - p[b]) / dx;
            u[k][c] = q[k][c] * (0.5 / eps[b] + 0.5 / eps[c]);
        }
}

/* [Pa] The mean of p over row j of the cells. */
static double row(int j)
{
    double sum = 0.0;
    for (int c = W * j + 1; c <= W * j + NX; c++)
        sum += p[c] / NX;
    return sum;
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

static void write_field(FILE *file, const char *name, const double *f)
{
    fprintf(file, "SCALARS %s double\nLOOKUP_TABLE default\n", name);
    for (int c = W; c < W * (NY + 1); c++)
        if (c % W > 0 && c % W <= NX) fprintf(file, "%.9g\n", f[c]);
}

static void write_vtk(FILE *file)
{
    fprintf(file, "# vtk DataFile Version 3.0\nair\nASCII\n");
    fprintf(file, "DATASET STRUCTURED_POINTS\nDIMENSIONS %d %d 1\n", NX + 1,
            NY + 1);
    fprintf(file, "ORIGIN 0 0 0\nSPACING %g %g 1\n", dx, dx);
    fprintf(file, "CELL_DATA %d\n", NX * NY);
    write_field(file, "eps", eps);
    write_field(file, "p", p);
    fclose(file);
}

/* In millimetres: the cells, darker with less air, the grains, and on the right
 * the pressure against height. */
static void write_svg(FILE *file)
{
    const double h = 1e3 * dx; /* [mm] */
    fprintf(file,
            "<svg xmlns='http://www.w3.org/2000/svg' width='600' "
            "viewBox='-1 -41 40 46' fill='blue' stroke-width='0.1' "
            "font-size='2' font-family='sans-serif'>\n"
            "<text x='3' y='3'>16 mm wide</text>\n"
            "<text x='18' y='3'>pressure, to %.3g Pa</text>\n",
            row(1));
    for (int c = W; c < W * (NY + 1) && h * (c / W) <= 40.0; c++)
        if (c % W > 0 && c % W <= NX)
            fprintf(file, "<path d='M%g %gh%gv%gh-%gz' opacity='%.2f'/>\n",
                    h * (c % W - 1), -h * (c / W), h, h, h, 1.0 - eps[c]);
    fprintf(file, "<g fill='none' stroke='black'>\n"
                  "<path d='M0-40V0H16V-40M19-40V0H39'/>\n");
    for (int a = 0; a < N; a++)
        fprintf(file, "<circle cx='%.2f' cy='%.2f' r='0.55'/>\n", 1e3 * x[0][a],
                -1e3 * x[1][a]);
    fprintf(file, "<polyline stroke='red' stroke-width='0.3' points='");
    for (int j = 1; h * j <= 40.0; j++)
        fprintf(file, "%.2f,%.2f ", 19.0 + 18.0 * row(j) / row(1),
                h * (0.5 - j));
    fprintf(file, "'/></g>\n</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.02;
    double lowest = 1.0;
    for (int a = 0; a < N; a++) { /* rows of twelve */
        x[0][a] = 1.28e-3 * (a % 12 + 0.5 + 0.5 * (a / 12 % 2));
        x[1][a] = 1.11e-3 * (a / 12 + 0.6);
    }
    for (int n = 0; n < lround(t_end / dt); n++) {
        average();
        predict();
        find_pressure();
        correct();
    }
    for (int c = W; c < W * (NY + 1); c++)
        lowest = fmin(lowest, eps[c]);
    printf("t = %g s: lowest eps = %.6f, pressure drop = %.8g Pa\n", t_end,
           lowest, 1.5 * row(1) - 0.5 * row(2));
    printf("beta at eps = 0.5 and 0.5 m/s: %.9g kg/(m^3 s)\n",
           0.5 * resistance(0.5, 0.5));
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: take finer cells, dx = 1 mm and twice as many each way. What are the
 * lowest eps and the pressure drop now? How many grains are in a cell? */
