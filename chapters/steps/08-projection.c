/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 8: projection.
 *
 * What is diffused and carried is now the velocity itself, in a box whose lid
 * moves. A pressure keeps the volume what it is [LS 3.13]:
 *
 *     du/dt + u . grad u = nu laplacian u - grad p / rho_f,   div u = 0
 *
 * A step predicts u without p, finds the p that makes div u vanish, and
 * corrects u by it. [Ghia82] found -0.2109 for the number that it prints. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 32 }; /* cells along x and y; one more lies around each side */
static const double rho_f = 1.2, nu = 1.5e-5, lid = 0.05; /* Re = 100 */
static const double dx = 0.03 / N, dt = 0.01;             /* [m], [s] */

/* [m/s] on the left face of a cell, on its lower face; [Pa] in its middle */
static double ux[N + 2][N + 2], uy[N + 2][N + 2], p[N + 2][N + 2];

/* The mean of the velocities on both sides of a wall is that of the wall. */
static void walls(void)
{
    for (int k = 1; k <= N; k++) {
        ux[k][0] = -ux[k][1];
        ux[k][N + 1] = 2.0 * lid - ux[k][N];
        uy[0][k] = -uy[1][k];
        uy[N + 1][k] = -uy[N][k];
    }
}

/* What advection with u, v and diffusion change in a component f. The faces
 * carry the mean of both sides: s is 1/2 in (5.9). */
static double change(double f[N + 2][N + 2], int i, int j, double u, double v)
{
    const double sum = f[i - 1][j] + f[i + 1][j] + f[i][j - 1] + f[i][j + 1];
    return dt * (nu * (sum - 4.0 * f[i][j]) / (dx * dx) -
                 u * (f[i + 1][j] - f[i - 1][j]) / (2.0 * dx) -
                 v * (f[i][j + 1] - f[i][j - 1]) / (2.0 * dx));
}

static void predict(void)
{
    static double old_x[N + 2][N + 2], old_y[N + 2][N + 2];
    memcpy(old_x, ux, sizeof ux);
    memcpy(old_y, uy, sizeof uy);
    for (int i = 1; i <= N; i++)
        for (int j = 1; j <= N; j++) {
            const double v = 0.25 * (old_y[i - 1][j] + old_y[i][j] +
                                     old_y[i - 1][j + 1] + old_y[i][j + 1]);
            const double u = 0.25 * (old_x[i][j - 1] + old_x[i][j] +
                                     old_x[i + 1][j - 1] + old_x[i + 1][j]);
            if (i > 1) ux[i][j] += change(old_x, i, j, old_x[i][j], v);
            if (j > 1) uy[i][j] += change(old_y, i, j, u, old_y[i][j]);
        }
}

static double divergence(int i, int j) /* [1/s] */
{
    return (ux[i + 1][j] - ux[i][j] + uy[i][j + 1] - uy[i][j]) / dx;
}

/* Over and over, each p goes to where its own equation wants it, and half as
 * far again. Nothing flows through a wall, and so a wall has no term. */
static void find_pressure(void)
{
    for (int sweep = 0; sweep < 40; sweep++)
        for (int i = 1; i <= N; i++)
            for (int j = 1; j <= N; j++) {
                const double w = (i > 1), e = (i < N), s = (j > 1), n = (j < N);
                const double sum = w * p[i - 1][j] + e * p[i + 1][j] +
                                   s * p[i][j - 1] + n * p[i][j + 1];
                const double b = rho_f * dx * dx / dt * divergence(i, j);
                p[i][j] += 1.5 * ((sum - b) / (w + e + s + n) - p[i][j]);
            }
}

static void correct(void)
{
    for (int i = 1; i <= N; i++)
        for (int j = 1; j <= N; j++) {
            if (i > 1) ux[i][j] -= dt / rho_f * (p[i][j] - p[i - 1][j]) / dx;
            if (j > 1) uy[i][j] -= dt / rho_f * (p[i][j] - p[i][j - 1]) / dx;
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
    fprintf(file, "# vtk DataFile Version 3.0\ncavity\nASCII\n");
    fprintf(file, "DATASET STRUCTURED_POINTS\nDIMENSIONS %d %d 1\n", N + 1,
            N + 1);
    fprintf(file, "ORIGIN 0 0 0\nSPACING %g %g 1\n", dx, dx);
    fprintf(file, "CELL_DATA %d\nVECTORS u double\n", N * N);
    for (int j = 1; j <= N; j++)
        for (int i = 1; i <= N; i++)
            fprintf(file, "%.9g %.9g 0\n", 0.5 * (ux[i][j] + ux[i + 1][j]),
                    0.5 * (uy[i][j] + uy[i][j + 1]));
    fclose(file);
}

/* A stroke for each cell, thick where it begins; 3 cells long at the lid. */
static void write_svg(FILE *file)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='600' "
                  "viewBox='-1 -34 34 35' fill='#1f5fa8'>\n");
    for (int i = 1; i <= N; i++)
        for (int j = 1; j <= N; j++) {
            const double u = 1.5 / lid * (ux[i][j] + ux[i + 1][j]);
            const double v = 1.5 / lid * (uy[i][j] + uy[i][j + 1]);
            fprintf(file, "<path d='M%.2f %.2fL%.2f %.2fL%.2f %.2fz'/>\n",
                    i - 0.1 * v, -j - 0.1 * u, i + 0.1 * v, -j + 0.1 * u, i + u,
                    -j - v);
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
    for (int j = 1; j <= N; j++)
        lowest = fmin(lowest, ux[N / 2 + 1][j] / lid);
    printf("t = %g s: div u = %.0e / s, lowest u_x / lid half way = %.4f\n",
           t_end, divergence(N / 2, N / 2), lowest);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: give the pressure one sweep a step instead of 40. What is left of the
 * divergence, and does the flow notice? Then carry velocity upwind (step 7). */
