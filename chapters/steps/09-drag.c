/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 9: drag on one grain.
 *
 * A grain sinks through the box of step 8, which is now filled with a liquid
 * and has no lid. The force of the liquid on the grain is
 *
 *     f = k (u_f - u_p),   k = 3 pi mu d (1 + 0.15 Re^0.687)     (10.1) (9.4)
 *
 * [SN33], where u_f is the velocity of the liquid in the cell of the grain and
 * Re = rho_f d |u_f - u_p| / mu (9.2). The reaction acts on the liquid:
 * -f is distributed to the faces of the same cell, with the same weights with
 * which u_f was taken from them. After a while the slip is that at which drag
 * carries weight less buoyancy:
 *
 *     slip = tau g (1 - rho_f / rho_s),   tau = m / k                     (9.5)
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NX = 16, NY = 32, W = NX + 2, CELLS = W * (NY + 2) }; /* cells */
enum { MOST = 1000 };                                        /* steps kept */

static const double pi = 3.14159265358979323846, g = 9.81; /* [m/s^2] */
static const double rho_f = 1000.0, mu = 0.02;  /* [kg/m^3], [Pa s] liquid */
static const double rho_s = 2500.0, d = 1.2e-3; /* [kg/m^3], [m] grain */
static const double dx = 1.5e-3, depth = 6e-3;  /* [m] cells, box across */
static const double dt = 1e-3;                  /* [s] */

/* One value a cell. The next cell in direction k is c + next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};
static field p;      /* [Pa] */
static field u[2];   /* [m/s] u_k on the lower face of a cell across k */
static field mob[2]; /* [m^3 s/kg] how u_k follows the slope of p; 0 at walls */
static field F[2];   /* [N/m^3] from the grain, on the same faces */

static double x[2], v[2]; /* [m], [m/s] the grain */
static double force[2];   /* [N] drag on it */
static double path[MOST][2];

/* No wall moves: the mean of the velocities on both sides is zero. */
static void walls(void)
{
    for (int i = 1; i <= NX; i++) {
        u[0][i] = -u[0][i + W];
        u[0][i + W * (NY + 1)] = -u[0][i + W * NY];
    }
    for (int j = 1; j <= NY; j++) {
        u[1][W * j] = -u[1][W * j + 1];
        u[1][W * j + NX + 1] = -u[1][W * j + NX];
    }
}

/* What advection by a and diffusion change in f; s is 1/2 in (5.9). */
static double change(const double *f, int c, const double a[2])
{
    double sum =
        mu / rho_f * (f[c - 1] + f[c + 1] + f[c - W] + f[c + W] - 4.0 * f[c]);
    for (int k = 0; k < 2; k++)
        sum -= 0.5 * dx * a[k] * (f[c + next[k]] - f[c - next[k]]);
    return sum * dt / (dx * dx);
}

/* Predicts u without p. The velocity along a face is the mean of four. */
static void predict(void)
{
    static field old[2];
    memcpy(old, u, sizeof u);
    for (int k = 0; k < 2; k++)
        for (int c = W * (1 + k); c < W * (NY + 1); c++) {
            if (c % W < 2 - k || c % W > NX) continue; /* a wall */
            const int b = c - next[k], o = next[1 - k];
            const double *const f = old[k], *const f_o = old[1 - k];
            double a[2];
            a[k] = f[c];
            a[1 - k] = 0.25 * (f_o[b] + f_o[b + o] + f_o[c] + f_o[c + o]);
            mob[k][c] = dt / rho_f;
            u[k][c] = f[c] + change(f, c, a) + dt / rho_f * F[k][c];
        }
}

/* Successive over-relaxation: 1.5 times the change that solves the equation. */
static void find_pressure(void)
{
    for (int sweep = 0; sweep < 40; sweep++)
        for (int c = W; c < W * (NY + 1); c++) {
            double sum = 0.0, sum_mob = 0.0;
            for (int k = 0; k < 2; k++) {
                const int n = c + next[k];
                sum += mob[k][c] * p[c - next[k]] + mob[k][n] * p[n] -
                       dx * (u[k][n] - u[k][c]);
                sum_mob += mob[k][c] + mob[k][n];
            }
            if (sum_mob > 0.0) p[c] += 1.5 * (sum / sum_mob - p[c]);
        }
}

static void correct(void)
{
    for (int k = 0; k < 2; k++)
        for (int c = W; c < W * (NY + 1); c++)
            u[k][c] -= mob[k][c] * (p[c] - p[c - next[k]]) / dx;
}

/* [kg/s] drag over slip (9.1), (9.2), (9.4) */
static double drag(double slip)
{
    const double Re = rho_f * d * slip / mu;
    return 3.0 * pi * mu * d * (1.0 + 0.15 * pow(Re, 0.687));
}

/* Moves the grain for a step, and puts the opposite of the drag on the faces of
 * its cell, half on either side. Returns the slip. */
static double move_grain(void)
{
    const double V_p = pi / 6.0 * d * d * d, m = rho_s * V_p; /* [m^3], [kg] */
    const int c = (int)(x[0] / dx) + 1 + W * ((int)(x[1] / dx) + 1);
    double slip[2];

    for (int k = 0; k < 2; k++)
        slip[k] = 0.5 * (u[k][c] + u[k][c + next[k]]) - v[k];
    const double size = hypot(slip[0], slip[1]);
    memset(F, 0, sizeof F);
    for (int k = 0; k < 2; k++) {
        force[k] = drag(size) * slip[k];
        F[k][c] = F[k][c + next[k]] = -0.5 * force[k] / (dx * dx * depth);
        v[k] += (force[k] / m - k * g * (1.0 - rho_f / rho_s)) * dt;
        x[k] += v[k] * dt;
    }
    return size;
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
    fprintf(file, "# vtk DataFile Version 3.0\nliquid\nASCII\n");
    fprintf(file, "DATASET STRUCTURED_POINTS\nDIMENSIONS %d %d 1\n", NX + 1,
            NY + 1);
    fprintf(file, "ORIGIN 0 0 0\nSPACING %g %g 1\n", dx, dx);
    fprintf(file, "CELL_DATA %d\nVECTORS u double\n", NX * NY);
    for (int c = W; c < W * (NY + 1); c++)
        if (c % W > 0 && c % W <= NX)
            fprintf(file, "%.9g %.9g 0\n", 0.5 * (u[0][c] + u[0][c + 1]),
                    0.5 * (u[1][c] + u[1][c + W]));
    fclose(file);
}

/* The box in cells. A stroke for each cell, thick where it begins, three cells
 * long for 0.01 m/s; then the grain and its path. */
static void write_svg(FILE *file, int n_steps)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='400' "
                  "viewBox='0 -33 17 36' fill='#1f5fa8' stroke-width='0.1' "
                  "font-size='0.8'>\n<text x='0.5' y='0.7'>24 mm wide</text>\n"
                  "<text x='0.5' y='1.9'>3 cells long: 0.01 m/s</text>\n"
                  "<path d='M0.5-32.5V-0.5H16.5V-32.5z' fill='none' "
                  "stroke='black'/>\n");
    for (int c = W; c < W * (NY + 1); c++) {
        const int i = c % W, j = c / W;
        if (i == 0 || i > NX) continue;
        const double a = 150.0 * (u[0][c] + u[0][c + 1]);
        const double b = 150.0 * (u[1][c] + u[1][c + W]);
        fprintf(file, "<path d='M%.2f %.2fL%.2f %.2fL%.2f %.2fz'/>\n",
                i - 0.1 * b, -j - 0.1 * a, i + 0.1 * b, -j + 0.1 * a, i + a,
                -j - b);
    }
    fprintf(file, "<polyline fill='none' stroke='red' points='");
    for (int n = 0; n < n_steps && n < MOST; n++)
        fprintf(file, "%.3f,%.3f ", path[n][0] / dx + 0.5,
                -path[n][1] / dx - 0.5);
    fprintf(file, "'/>\n<circle cx='%.3f' cy='%.3f' r='%.3f' fill='red'/>\n",
            x[0] / dx + 0.5, -x[1] / dx - 0.5, 0.5 * d / dx);
    fprintf(file, "</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.5;
    const int n_steps = (int)lround(t_end / dt);
    double slip = 0.0, tau = 0.0, settled = 0.0, reaction = 0.0;

    x[0] = 0.4 * NX * dx;
    x[1] = 0.9 * NY * dx;
    for (int n = 0; n < n_steps; n++) {
        walls();
        predict();
        find_pressure();
        correct();
        slip = move_grain();
        if (n < MOST) memcpy(path[n], x, sizeof x);
    }
    for (int c = 0; c < CELLS; c++)
        reaction += F[1][c] * dx * dx * depth;
    for (int n = 0; n < 50; n++) { /* (9.5), a fixed point */
        tau = rho_s * pi / 6.0 * d * d * d / drag(settled);
        settled = tau * g * (1.0 - rho_f / rho_s);
    }
    printf("t = %g s: velocity of the grain = %.5g m/s, slip = %.5g m/s\n",
           t_end, v[1], slip);
    printf("steady slip = %.9g m/s, Re = %.9g, tau = %.9g s\n", settled,
           rho_f * d * settled / mu, tau);
    printf("drag on the grain = %.9g N, on the liquid = %.9g N\n", force[1],
           reaction);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"), n_steps);
    return 0;
}

/* To try: make the box as deep as it is wide, depth = 24e-3. Why does the grain
 * sink at another speed, though its slip is nearly the same? Then let go of it
 * close to a wall, x[0] = 0.05 * NX * dx. */
