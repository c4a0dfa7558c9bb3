/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 12: the coupled bed.
 *
 * The grains of step 4 move in the air of step 11. In each step of the air
 *   1. averaging gives eps, the flux of the solids s = eps_s u_s, and the drag
 *      on the air per volume, K u - F with F = sum k u_p / V_c          (10.2)
 *   2. the air moves, and of air and grains div(q + s) = 0 (5.7) [XS11 2.7]
 *   3. the force on a grain is the drag k (u_f - u_p) (10.1), and the force of
 *      the pressure on its volume, -V_p grad p                           (5.3)
 *   4. the grains move, in many steps of their own, for contacts are short.
 * Both directions use the same weights, so that momentum is conserved (8.4).
 * Once the air carries the bed, the pressure drop varies about its weight. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 300, NX = 8, NY = 32 };         /* grains, cells */
enum { W = NX + 2, CELLS = W * (NY + 3) }; /* with ghosts: W in a row */
static const double g = 9.81, rho_f = 1.2, mu = 1.8e-5;     /* of air, in SI */
static const double dx = 2e-3, depth = 1.5e-3, bw = 4.8e-3; /* [m] step 11 */
static const double d = 1.2e-3, V_p = 9.04778684e-10; /* [m], [m^3] grains */
static const double m = 9.04778684e-7;                /* [kg], of 1000 kg/m^3 */
static const double k_n = 100.0, k_t = 2.0 / 7.0 * 100.0; /* [N/m] (2.10) */
static const double zeta = 0.033518, friction = 0.1; /* [-] e = 0.9 (2.5) */
static const double dt = 2e-4, dt_s = 1e-5; /* [s] of the air, of the grains */

/* One value a cell. The next cell in direction k is c + next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};

static field p, eps;     /* [Pa], [-] in the cell */
static field resist;     /* [kg/(m^3 s)] first K, then slope of p over q */
static field u[2], q[2]; /* [m/s] on the lower face across k: u_k, eps u_k */
static field mob[2]; /* [m^3 s/kg] mobility there: q over slope of p (6.4) */
static field s[2], F[2]; /* [m/s], [N/m^3] in the cell */
static double U;         /* [m/s] at the inlet */

/* The grains. Entry N is the walls, which do not move. */
static double x[2][N], v[2][N + 1], w[N + 1]; /* [m], [m/s], [rad/s] */
static double P[2][N], drag[N]; /* [N] force of the air, [kg/s] k in (10.1) */
static double C[2][N + 1], M[N + 1]; /* [N], [N m] of the contacts */
static double xi[N][N + 3]; /* [m] springs of pairs, and of three walls */

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
    const double ratio = 0.25 * bw * bw / (24 * dx * dx);
    field old;
    for (int n = 0; n < 24; n++) {
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

/* The u_k of the air at the grains in a cell (8.3). */
static void gather(int k, field u_f)
{
    for (int c = W + 1; c < W * (NY + 1); c++)
        u_f[c] = 0.5 * (q[k][c] + q[k][c + next[k]]) / eps[c];
    diffuse(u_f);
}

/* (8.6): each grain to the cell of its centre, then all spread. */
static void average(void)
{
    const double V_c = dx * dx * depth;
    field eps_p, u_f[2];
    for (int c = 0; c < CELLS; c++) {
        eps[c] = 1.0;
        resist[c] = F[0][c] = F[1][c] = s[0][c] = s[1][c] = 0.0;
    }
    for (int a = 0; a < N; a++) {
        eps[cell_of(a)] -= V_p / V_c;
        for (int k = 0; k < 2; k++)
            s[k][cell_of(a)] += V_p / V_c * v[k][a];
    }
    diffuse(eps);
    memcpy(eps_p, eps, sizeof eps);
    diffuse(eps_p);
    for (int k = 0; k < 2; k++) {
        diffuse(s[k]);
        gather(k, u_f[k]);
    }
    for (int a = 0; a < N; a++) {
        const int c = cell_of(a);
        const double slip = hypot(u_f[0][c] - v[0][a], u_f[1][c] - v[1][a]);
        drag[a] = V_p * resistance(eps_p[c], slip);
        resist[c] += drag[a] / V_c;
        for (int k = 0; k < 2; k++)
            F[k][c] += drag[a] / V_c * v[k][a];
    }
    diffuse(resist);
    diffuse(F[0]);
    diffuse(F[1]);
    for (int c = 0; c < CELLS; c++)
        resist[c] = (rho_f / dt + resist[c] / eps[c]) / eps[c];
}

/* Predicts q without p, of air and grains together until correct(), and finds
 * the mobility m. Half of the way lies in each cell: 1 / m is a mean (6.6). */
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
            q[k][c] = mob[k][c] * (rho_f / dt * u_new + 0.5 * F[k][b] / eps[b] +
                                   0.5 * F[k][c] / eps[c]) +
                      0.5 * (s[k][b] + s[k][c]);
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
            if (mob[k][c] > 0.0)
                q[k][c] -=
                    mob[k][c] * (p[c] - p[b]) / dx + 0.5 * (s[k][b] + s[k][c]);
            u[k][c] = q[k][c] * (0.5 / eps[b] + 0.5 / eps[c]);
        }
}

/* Forces of the air on each grain; along y (k = 1) weight less buoyancy. */
static void forces_of_air(void)
{
    field u_f, slope;
    extend(p);
    for (int c = 1; c <= NX; c++) {
        p[c] = 2.0 * p[c + W] - p[c + 2 * W];
        p[c + W * (NY + 1)] = 0.0;
    }
    for (int k = 0; k < 2; k++) {
        gather(k, u_f);
        for (int c = W + 1; c < W * (NY + 1); c++)
            slope[c] = (p[c + next[k]] - p[c - next[k]]) / (2.0 * dx);
        diffuse(slope);
        for (int a = 0; a < N; a++)
            P[k][a] = drag[a] * (u_f[cell_of(a)] - v[k][a]) -
                      V_p * slope[cell_of(a)] - k * (m - rho_f * V_p) * g;
    }
}

/* As in step 4, with grains of one size. */
static void contact(int i, int j, double rx, double ry, double *xi_ij)
{
    const double r = sqrt(rx * rx + ry * ry), delta = d - r, l = 0.5 * r;
    const double nx = rx / r, ny = ry / r;
    if (delta <= 0.0) *xi_ij = 0.0;
    if (delta <= 0.0) return;
    const double eta = 2.0 * zeta * sqrt(k_n * (j < N ? 0.5 * m : m));
    const double v_x = v[0][i] - v[0][j], v_y = v[1][i] - v[1][j];
    const double v_n = v_x * nx + v_y * ny; /* (2.2) */
    const double v_t = v_y * nx - v_x * ny - l * (w[i] + w[j]);
    const double F_n = k_n * delta - eta * v_n; /* (2.4) */
    *xi_ij += v_t * dt_s;
    double F_t = -k_t * *xi_ij - 2.0 / 7.0 * eta * v_t; /* (2.8) */
    if (fabs(F_t) > friction * fabs(F_n)) {
        F_t = copysign(friction * F_n, F_t);
        if (k_t * fabs(*xi_ij) > fabs(F_t)) *xi_ij = -F_t / k_t;
    }
    C[0][i] += F_n * nx - F_t * ny;
    C[0][j] -= F_n * nx - F_t * ny;
    C[1][i] += F_n * ny + F_t * nx;
    C[1][j] -= F_n * ny + F_t * nx;
    M[i] -= l * F_t;
    M[j] -= l * F_t;
}

/* As in step 4, with the cells of the air as the grid; the ghosts are empty. */
static void move_grains(void)
{
    static const int around[9] = {0,      -1, 1,     -W,   -W - 1,
                                  -W + 1, W,  W - 1, W + 1};
    int first[CELLS], next_one[N];
    memset(first, -1, sizeof first);
    memset(C, 0, sizeof C);
    memset(M, 0, sizeof M);
    for (int i = 0; i < N; i++) {
        const double x_i = x[0][i], y_i = x[1][i];
        for (int a = 0; a < 9; a++)
            for (int j = first[cell_of(i) + around[a]]; j >= 0; j = next_one[j])
                contact(i, j, x_i - x[0][j], y_i - x[1][j], &xi[i][j]);
        next_one[i] = first[cell_of(i)];
        first[cell_of(i)] = i;
        contact(i, N, 0.0, y_i + 0.5 * d, &xi[i][N]);
        contact(i, N, x_i + 0.5 * d, 0.0, &xi[i][N + 1]);
        contact(i, N, x_i - NX * dx - 0.5 * d, 0.0, &xi[i][N + 2]);
    }
    for (int i = 0; i < N; i++) {
        w[i] += M[i] / (0.1 * m * d * d) * dt_s;
        for (int k = 0; k < 2; k++) {
            v[k][i] += (C[k][i] + P[k][i]) / m * dt_s;
            x[k][i] += v[k][i] * dt_s;
        }
    }
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

static void write_vtk(FILE *file)
{
    fprintf(file, "# vtk DataFile Version 3.0\ngrains\nASCII\n");
    fprintf(file, "DATASET POLYDATA\nPOINTS %d double\n", N);
    for (int a = 0; a < N; a++)
        fprintf(file, "%.9g %.9g 0\n", x[0][a], x[1][a]);
    fclose(file);
}

/* Adds the bed in millimetres: the cells, darker with less air, and the grains.
 */
static void draw_bed(FILE *svg, int place, double t)
{
    fprintf(svg, "<g transform='translate(%d 0)'>\n", 20 * place);
    for (int c = W; c < W * (NY + 1); c++)
        if (c % W > 0 && c % W <= NX)
            fprintf(svg, "<path d='M%d %dh2v2h-2z' opacity='%.2f'/>\n",
                    2 * (c % W - 1), -2 * (c / W), 1.0 - eps[c]);
    fprintf(svg,
            "<text x='4' y='4'>%.2f s</text>\n<g fill='none' "
            "stroke='black'>\n<path d='M0-64V0H16V-64'/>",
            t);
    for (int a = 0; a < N; a++)
        fprintf(svg, "<circle cx='%.2f' cy='%.2f' r='0.55'/>\n", 1e3 * x[0][a],
                -1e3 * x[1][a]);
    fprintf(svg, "</g></g>\n");
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.5;
    const int n_steps = (int)lround(t_end / dt);
    FILE *const svg = create(argv[0], ".svg");
    double mean = 0.0;
    const double weight = N * (m - rho_f * V_p) * g / (NX * dx * depth);
    for (int a = 0; a < N; a++) { /* rows of twelve */
        x[0][a] = 1.28e-3 * (a % 12 + 0.5 + 0.5 * (a / 12 % 2));
        x[1][a] = 1.11e-3 * (a / 12 + 0.6);
    }
    fprintf(svg,
            "<svg xmlns='http://www.w3.org/2000/svg' width='900' "
            "viewBox='-1 -65 99 94' fill='blue' stroke-width='0.1' "
            "font-size='3' font-family='sans-serif'>\n"
            "<text y='10'>16 mm wide; pressure drop, weight %.0f Pa</text>\n"
            "<path d='M0 8V28H96M0 %gH96' fill='none' stroke='black'/>\n",
            weight, 28.0 - 0.12 * weight);
    for (int n = 1; n <= n_steps; n++) {
        double drop = 0.0;
        U = fmin(n * dt / 0.05, 1.0);
        average();
        predict();
        find_pressure();
        correct();
        forces_of_air();
        for (int l = 0; l < lround(dt / dt_s); l++)
            move_grains();
        for (int c = 1; c <= NX; c++)
            drop += 0.5 * (p[c] + p[c + W]) / NX;
        if (2 * n > n_steps) mean += 2.0 * drop / n_steps;
        fprintf(svg, "<circle cx='%.2f' cy='%.2f' r='0.15'/>\n",
                96.0 * n / n_steps, 28.0 - 0.12 * drop);
        if (5 * n % n_steps == 0) draw_bed(svg, 5 * n / n_steps - 1, n * dt);
    }
    printf("mean pressure drop = %.4g Pa, weight over ground = %.4g Pa\n", mean,
           weight);
    fprintf(svg, "</svg>\n");
    write_vtk(create(argv[0], ".vtk"));
    return 0;
}

/* To try: let the air enter at 0.4 m/s: is the bed lifted? Then leave the
 * force of the pressure out of forces_of_air(): which force has no reaction? */
