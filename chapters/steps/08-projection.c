/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 8: projection.
 *
 * Now the velocity itself is diffused and convected, in a box whose lid moves:
 *
 *     du/dt + u . grad u = nu laplacian u - grad p / rho_f,   div u = 0
 *
 * [LS 3.13]. A step predicts u without p, finds the p that makes div u vanish,
 * and corrects u by it. A field is now one row of numbers, cell after cell, and
 * the velocity two of them: one line of the program is an equation for both.
 * For the number that it prints, [Ghia82] found -0.2109. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 32, W = N + 2, CELLS = W * W }; /* N cells a side, and ghosts */
static const double rho_f = 1.2, nu = 1.5e-5, lid = 0.05; /* Re = 100 */
static const double dx = 0.03 / N, dt = 0.01;             /* [m], [s] */
/* One value a cell. The next cell in direction k is c + next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};
static field p;      /* [Pa] */
static field u[2];   /* [m/s] u_k on the lower face of a cell across k */
static field mob[2]; /* [m^3 s/kg] how u_k follows the slope of p; 0 at walls */

/* The mean of the velocities on both sides of a wall is that of the wall. */
static void walls(void)
{
    for (int i = 1; i <= N; i++) {
        u[0][i] = -u[0][i + W];
        u[0][i + W * (N + 1)] = 2.0 * lid - u[0][i + W * N];
        u[1][W * i] = -u[1][W * i + 1];
        u[1][W * i + N + 1] = -u[1][W * i + N];
    }
}

/* What advection by a and diffusion change in f; s is 1/2 in (5.9). */
static double change(const double *f, int c, const double a[2])
{
    double sum = nu * (f[c - 1] + f[c + 1] + f[c - W] + f[c + W] - 4.0 * f[c]);
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
        for (int c = W * (1 + k); c < W * (N + 1); c++) {
            if (c % W < 2 - k || c % W > N) continue; /* a wall */
            const int b = c - next[k], o = next[1 - k];
            const double *const f = old[k], *const f_o = old[1 - k];
            double a[2];
            a[k] = f[c];
            a[1 - k] = 0.25 * (f_o[b] + f_o[b + o] + f_o[c] + f_o[c + o]);
            mob[k][c] = dt / rho_f;
            u[k][c] = f[c] + change(f, c, a);
        }
}

/* Successive over-relaxation: 1.5 times the change that solves the equation. */
static void find_pressure(void)
{
    for (int sweep = 0; sweep < 40; sweep++)
        for (int c = W; c < W * (N + 1); c++) {
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
        for (int c = W; c < W * (N + 1); c++)
            u[k][c] -= mob[k][c] * (p[c] - p[c - next[k]]) / dx;
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
    fprintf(file, "# vtk DataFile Version 3.0\ncavity\nASCII\n");
    fprintf(file, "DATASET STRUCTURED_POINTS\nDIMENSIONS %d %d 1\n", N + 1,
            N + 1);
    fprintf(file, "ORIGIN 0 0 0\nSPACING %g %g 1\n", dx, dx);
    fprintf(file, "CELL_DATA %d\nVECTORS u double\n", N * N);
    for (int c = W; c < W * (N + 1); c++)
        if (c % W > 0 && c % W <= N)
            fprintf(file, "%.9g %.9g 0\n", 0.5 * (u[0][c] + u[0][c + 1]),
                    0.5 * (u[1][c] + u[1][c + W]));
    fclose(file);
}

/* A stroke for each cell, thick where it begins; 3 cells long for 0.05 m/s. */
static void write_svg(FILE *file)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='600' "
                  "viewBox='-1 -34 36 37' fill='#1f5fa8' font-size='1.2'>\n"
                  "<text y='2'>30 mm; the longest strokes: 0.05 m/s</text>\n");
    for (int c = W; c < W * (N + 1); c++) {
        const int i = c % W, j = c / W;
        if (i == 0 || i > N) continue;
        const double a = 1.5 / lid * (u[0][c] + u[0][c + 1]);
        const double b = 1.5 / lid * (u[1][c] + u[1][c + W]);
        fprintf(file, "<path d='M%.2f %.2fL%.2f %.2fL%.2f %.2fz'/>\n",
                i - 0.1 * b, -j - 0.1 * a, i + 0.1 * b, -j + 0.1 * a, i + a,
                -j - b);
    }
    fprintf(file, "</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 12.0;
    double lowest = 0.0;
    for (int n = 0; n < lround(t_end / dt); n++) {
        walls();
        predict();
        find_pressure();
        correct();
    }
    for (int c = N / 2 + 1; c < CELLS; c += W)
        lowest = lowest <= u[0][c] / lid ? lowest : u[0][c] / lid;
    printf("t = %g s: lowest u_x / lid half way = %.4f\n", t_end, lowest);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: give the pressure one sweep a step instead of 40, then two. Then let
 * the faces carry what comes from upwind, as in step 7: how far off is it? */
