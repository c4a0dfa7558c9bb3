/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 11: diffusion of the void fraction.
 *
 * In step 10 a cell has two grains or three by chance, so that eps depends on
 * the mesh. Here the solids of each cell are spread into a Gaussian of the
 * bandwidth bw, which depends on the grains and not on the mesh. This is step
 * 6 in a pseudo-time T, whose unit is that of an area:
 *
 *     d eps_s / dT = laplacian eps_s   up to   T = bw^2 / 4       (8.8), (8.9)
 *
 * [SX15 5a, 6]. The drag is spread in the same way. And eps and u at a grain
 * are means with the same weights, that is, diffused as well (8.3): then the
 * grains gain what the air loses (8.4), which is printed. All else is as in
 * step 10.
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
static double bw = 4.8e-3;                     /* [m] bandwidth, b in (8.9) */
static int steps = 24;                         /* steps of the diffusion */

/* One value a cell. The next cell in direction k is c + next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};

static field p, eps;     /* [Pa], [-] in the cell */
static field resist;     /* [kg/(m^3 s)] first K, then slope of p over q */
static field u[2], q[2]; /* [m/s] on the lower face across k: u_k, eps u_k */
static field mob[2];   /* [m^3 s/kg] mobility there: q over slope of p (6.4) */
static double x[2][N]; /* [m] grains */
static double on_grains, on_air; /* [N] upward drag, which the air loses */

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

/* (8.8) in small explicit steps: the sum over the cells stays what it is. */
static void diffuse(field f)
{
    const double ratio = 0.25 * bw * bw / (steps * dx * dx);
    field old;
    for (int n = 0; n < steps; n++) {
        extend(f);
        memcpy(old, f, sizeof old);
        for (int c = W + 1; c < W * (NY + 1); c++)
            f[c] += ratio * (old[c - 1] + old[c + 1] + old[c - W] + old[c + W] -
                             4.0 * old[c]);
    }
    extend(f);
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

/* The u_k of the air in a cell. */
static double in_cell(int k, int c)
{
    return 0.5 * (q[k][c] + q[k][c + next[k]]) / eps[c];
}

/* The same at the grains in a cell (8.3). */
static void gather(int k, field u_f)
{
    for (int c = W + 1; c < W * (NY + 1); c++)
        u_f[c] = in_cell(k, c);
    diffuse(u_f);
}

/* (8.6): each grain to the cell of its centre, then all spread. */
static void average(void)
{
    const double V_c = dx * dx * depth;
    field eps_p, u_f[2];
    for (int c = 0; c < CELLS; c++) {
        eps[c] = 1.0;
        resist[c] = 0.0;
    }
    for (int a = 0; a < N; a++)
        eps[cell_of(a)] -= V_p / V_c;
    diffuse(eps);
    memcpy(eps_p, eps, sizeof eps);
    diffuse(eps_p);
    for (int k = 0; k < 2; k++)
        gather(k, u_f[k]);
    on_grains = on_air = 0.0;
    for (int a = 0; a < N; a++) {
        const int c = cell_of(a);
        const double slip = hypot(u_f[0][c], u_f[1][c]);
        const double friction = V_p * resistance(eps_p[c], slip);
        on_grains += friction * u_f[1][c];
        resist[c] += friction / V_c;
    }
    diffuse(resist);
    for (int c = W + 1; c < W * (NY + 1); c++)
        if (c % W > 0 && c % W <= NX) on_air += V_c * resist[c] * in_cell(1, c);
    for (int c = 0; c < CELLS; c++)
        resist[c] = (rho_f / dt + resist[c] / eps[c]) / eps[c];
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
    double lowest = 1.0, solids = 0.0;
    if (argc > 2) bw = atof(argv[2]);
    if (argc > 3) steps = atoi(argv[3]);
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
        if (c % W > 0 && c % W <= NX) {
            lowest = fmin(lowest, eps[c]);
            solids += (1.0 - eps[c]) * dx * dx * depth;
        }
    printf("t = %g s: lowest eps = %.6f, pressure drop = %.8g Pa\n", t_end,
           lowest, 1.5 * row(1) - 0.5 * row(2));
    printf("volume of solids = %.12g m^3, of the grains %.12g\n", solids,
           N * V_p);
    printf("drag on the grains = %.9g N, drag on the air = %.9g N\n", on_grains,
           on_air);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: the second number is the bandwidth, as in 11-smooth 0.02 0.0024; with
 * 0 this is step 10. Then take finer cells, dx = 1 mm and twice as many each
 * way: how much does the lowest eps change with 0.0024 m, how much with 0.0048?
 * The third number is that of the steps of the diffusion: how many are enough?
 */
