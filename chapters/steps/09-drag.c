/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 9: drag on one grain.
 *
 * A grain sinks through the box of step 8, which is now filled with a liquid
 * and has no lid. The liquid pushes the grain with
 *
 *     f = k (u_f - u_p),   k = 3 pi mu d (1 + 0.15 Re^0.687)     (10.1) (9.4)
 *
 * [SN33], where u_f is the velocity of the liquid in the cell of the grain and
 * Re = rho_f d |u_f - u_p| / mu (9.2). What the grain gets, the liquid loses:
 * -f goes to the faces of the same cell, by the same shares with which u_f was
 * taken from them. After a while the slip is that at which drag carries weight
 * less buoyancy:
 *
 *     slip = tau g (1 - rho_f / rho_s),   tau = m / k                     (9.5)
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NX = 16, NY = 32, MOST = 1000 }; /* cells; steps that are kept */

static const double pi = 3.14159265358979323846, g = 9.81; /* [m/s^2] */
static const double rho_f = 1000.0, mu = 0.02;  /* [kg/m^3], [Pa s] */
static const double rho_s = 2500.0, d = 1.2e-3; /* [kg/m^3], [m] the grain */
static const double dx = 1.5e-3, depth = 6e-3;  /* [m] cells, box across */
static const double dt = 1e-3;                  /* [s] */

/* [m/s] on the left face of a cell, on its lower face; [Pa] in its middle */
static double ux[NX + 2][NY + 2], uy[NX + 2][NY + 2], p[NX + 2][NY + 2];
static double Fx[NX + 2][NY + 2], Fy[NX + 2][NY + 2]; /* [N/m^3] on the faces */

static double x, y, vx, vy; /* [m], [m/s] the grain */
static double path[MOST][2];

/* No wall moves: on its two sides the mean velocity is zero. */
static void walls(void)
{
    for (int i = 1; i <= NX; i++) {
        ux[i][0] = -ux[i][1];
        ux[i][NY + 1] = -ux[i][NY];
    }
    for (int j = 1; j <= NY; j++) {
        uy[0][j] = -uy[1][j];
        uy[NX + 1][j] = -uy[NX][j];
    }
}

/* What advection with u, v, diffusion and a force F change in a component f. */
static double change(double f[NX + 2][NY + 2], int i, int j, double u, double v,
                     double F)
{
    const double sum = f[i - 1][j] + f[i + 1][j] + f[i][j - 1] + f[i][j + 1];
    return dt * (mu / rho_f * (sum - 4.0 * f[i][j]) / (dx * dx) -
                 u * (f[i + 1][j] - f[i - 1][j]) / (2.0 * dx) -
                 v * (f[i][j + 1] - f[i][j - 1]) / (2.0 * dx) + F / rho_f);
}

static void predict(void)
{
    static double old_x[NX + 2][NY + 2], old_y[NX + 2][NY + 2];
    memcpy(old_x, ux, sizeof ux);
    memcpy(old_y, uy, sizeof uy);
    for (int i = 1; i <= NX; i++)
        for (int j = 1; j <= NY; j++) {
            const double v = 0.25 * (old_y[i - 1][j] + old_y[i][j] +
                                     old_y[i - 1][j + 1] + old_y[i][j + 1]);
            const double u = 0.25 * (old_x[i][j - 1] + old_x[i][j] +
                                     old_x[i + 1][j - 1] + old_x[i + 1][j]);
            if (i > 1)
                ux[i][j] += change(old_x, i, j, old_x[i][j], v, Fx[i][j]);
            if (j > 1)
                uy[i][j] += change(old_y, i, j, u, old_y[i][j], Fy[i][j]);
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
        for (int i = 1; i <= NX; i++)
            for (int j = 1; j <= NY; j++) {
                const double w = (i > 1), e = (i < NX), s = (j > 1),
                             n = (j < NY);
                const double sum = w * p[i - 1][j] + e * p[i + 1][j] +
                                   s * p[i][j - 1] + n * p[i][j + 1];
                const double b = rho_f * dx * dx / dt * divergence(i, j);
                p[i][j] += 1.5 * ((sum - b) / (w + e + s + n) - p[i][j]);
            }
}

static void correct(void)
{
    for (int i = 1; i <= NX; i++)
        for (int j = 1; j <= NY; j++) {
            if (i > 1) ux[i][j] -= dt / rho_f * (p[i][j] - p[i - 1][j]) / dx;
            if (j > 1) uy[i][j] -= dt / rho_f * (p[i][j] - p[i][j - 1]) / dx;
        }
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
    const int i = (int)(x / dx) + 1, j = (int)(y / dx) + 1;   /* its cell */
    const double slip_x = 0.5 * (ux[i][j] + ux[i + 1][j]) - vx;
    const double slip_y = 0.5 * (uy[i][j] + uy[i][j + 1]) - vy;
    const double slip = sqrt(slip_x * slip_x + slip_y * slip_y);
    const double f_x = drag(slip) * slip_x, f_y = drag(slip) * slip_y; /* [N] */
    const double half_cell = 0.5 / (dx * dx * depth); /* [1/m^3] */

    memset(Fx, 0, sizeof Fx);
    memset(Fy, 0, sizeof Fy);
    Fx[i][j] = Fx[i + 1][j] = -f_x * half_cell;
    Fy[i][j] = Fy[i][j + 1] = -f_y * half_cell;
    vx += f_x / m * dt;
    vy += (f_y / m - g * (1.0 - rho_f / rho_s)) * dt;
    x += vx * dt;
    y += vy * dt;
    return slip;
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
    for (int j = 1; j <= NY; j++)
        for (int i = 1; i <= NX; i++)
            fprintf(file, "%.9g %.9g 0\n", 0.5 * (ux[i][j] + ux[i + 1][j]),
                    0.5 * (uy[i][j] + uy[i][j + 1]));
    fclose(file);
}

/* The box in cells. A stroke for each cell, thick where it begins, one cell
 * long for 1 cm/s; then the grain and its path. */
static void write_svg(FILE *file, int n_steps)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='400' "
                  "viewBox='0 -32.5 17 33' fill='#1f5fa8'>\n<path d='M0.5 "
                  "0.5V-32.5M16.5-32.5V0.5H0.5' fill='none' stroke='black' "
                  "stroke-width='0.1'/>\n");
    for (int i = 1; i <= NX; i++)
        for (int j = 1; j <= NY; j++) {
            const double u = 150.0 * (ux[i][j] + ux[i + 1][j]);
            const double v = 150.0 * (uy[i][j] + uy[i][j + 1]);
            fprintf(file, "<path d='M%.2f %.2fL%.2f %.2fL%.2f %.2fz'/>\n",
                    i - 0.1 * v, -j - 0.1 * u, i + 0.1 * v, -j + 0.1 * u, i + u,
                    -j - v);
        }
    fprintf(file,
            "<polyline fill='none' stroke='red' stroke-width='0.1' points='");
    for (int n = 0; n < n_steps && n < MOST; n++)
        fprintf(file, "%.3f,%.3f ", path[n][0] / dx + 0.5,
                -path[n][1] / dx - 0.5);
    fprintf(file,
            "'/>\n<circle cx='%.3f' cy='%.3f' r='%.3f' fill='red'/>\n</svg>\n",
            x / dx + 0.5, -y / dx - 0.5, 0.5 * d / dx);
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.5;
    const int n_steps = (int)lround(t_end / dt);
    double slip = 0.0, tau = 0.0, settled = 0.0;

    x = 0.4 * NX * dx;
    y = 0.9 * NY * dx;
    for (int n = 0; n < n_steps; n++) {
        walls();
        predict();
        find_pressure();
        correct();
        slip = move_grain();
        if (n < MOST) {
            path[n][0] = x;
            path[n][1] = y;
        }
    }
    for (int n = 0; n < 50;
         n++) { /* (9.5) for the steady slip, by repetition */
        tau = rho_s * pi / 6.0 * d * d * d / drag(settled);
        settled = tau * g * (1.0 - rho_f / rho_s);
    }
    printf("t = %g s: velocity of the grain = %.5g m/s, slip = %.5g m/s\n",
           t_end, vy, slip);
    printf("steady slip = %.9g m/s, Re = %.9g, tau = %.9g s\n", settled,
           rho_f * d * settled / mu, tau);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"), n_steps);
    return 0;
}

/* To try: make the box as deep as it is wide. Why does the grain sink at
 * another speed, though its slip is the same? Then let go of it close to a
 * wall. */
