/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 8: projection.
 *
 * Now the velocity itself is what is convected and diffused, in a box whose lid
 * moves:
 *
 *     du/dt + div(u u) = D laplacian u - grad p / rho_f,   div u = 0
 *
 * [LS 3.13], where D is the kinematic viscosity. A step predicts u without p by
 * the fluxes of step 7 around each face, finds the p that makes div u vanish,
 * and corrects u by it. For the number that it prints, [Ghia82] found -0.2109.
 *
 *     build/steps/08-projection [sweeps=2] [upwind=1] */
#include "steps.h"

enum { W = 34, CELLS = W * 67 };             /* cells: W in a row */
static int NX, NY;                           /* those without the ghosts */
static double cells = 32, dx;                /* across, [m] width of a cell */
static const double box[2] = {30e-3, 30e-3}; /* [m] */
static const double side = -1.0; /* 1: fluid slips along walls; -1: not */
static double D = 1.5e-5;        /* [m^2/s] viscosity over density */
static const double rho_f = 1.2; /* [kg/m^3] */
static double lid = 0.05;        /* [m/s]; Re = 100 */
static double upwind = 0.0;      /* 0: the mean of both cells */
static double sweeps = 40;       /* for the pressure, in a step */

/* One value a cell. The cell before it in direction k is c - next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};
static field p;      /* [Pa] */
static field u[2];   /* [m/s] u_k on the lower face of a cell across k */
static field mob[2]; /* [m^3 s/kg] how u_k follows the slope of p; 0 at walls */

const struct number numbers[] = {
    {"upwind", &upwind, 0.0, 1.0, 0.25, "share of upwind [-]"},
    {"lid", &lid, 0.005, 0.05, 0.005, "speed of the lid [m/s]"},
    {"cells", &cells, 8, 32, 4, "cells across [-]"},
    {"sweeps", &sweeps, 1, 100, 1, "sweeps for the pressure"},
    {"dt", &dt, 1e-3, 0.02, 0.001, "time step [s]"},
    {"end", &end, 0.0, 20.0, 0.5, "time at which it ends [s]"},
    {0}};
static double dt = 0.01, end = 12.0; /* [s] */

void start(void)
{
    NX = (int)cells;
    NY = (int)lround(NX * box[1] / box[0]);
    dx = box[0] / NX;
}

/* The mean of the velocities on both sides of a wall is that of the wall. */
static void walls(void)
{
    for (int i = 1; i <= NX; i++) {
        u[0][i] = side * u[0][i + W];
        u[0][i + W * (NY + 1)] = side * u[0][i + W * NY] + 2.0 * lid;
    }
    for (int j = 1; j <= NY; j++) {
        u[1][W * j] = side * u[1][W * j + 1];
        u[1][W * j + NX + 1] = side * u[1][W * j + NX];
    }
}

/* What flows [m/s] through the lower face of a cell across k, along k, where
 * the velocity is V. */
static double flux(const field a, int c, int k, double V)
{
    const double below = a[c - next[k]], here = a[c];
    return 0.5 * V * (below + here) +
           (D / dx + 0.5 * upwind * fabs(V)) * (below - here);
}

/* What flows [m/s] through a lower face of the cell that has the face of u_k in
 * its middle: the mean of two. */
static double through(int k, field a[2], int c, int l)
{
    return 0.5 * (a[l][c] + a[l][c - next[k]]);
}

/* The flux of the velocity a[k] there, by the flow b. */
static double flux_of(int k, field a[2], field b[2], int c, int l)
{
    return flux(a[k], c, l, through(k, b, c, l));
}

/* Predicts u without p. */
static void predict(void)
{
    static field old[2];
    memcpy(old, u, sizeof u);
    for (int k = 0; k < 2; k++)
        for (int j = 1 + k; j <= NY; j++)
            for (int c = W * j + 2 - k; c <= W * j + NX; c++) {
                for (int l = 0; l < 2; l++)
                    u[k][c] += dt / dx *
                               (flux_of(k, old, old, c, l) -
                                flux_of(k, old, old, c + next[l], l));
                mob[k][c] = dt / rho_f;
            }
}

/* Successive over-relaxation: 1.7 times the change that solves the equation of
 * a cell. Where the mobility is 0, p has no effect. */
static void find_pressure(void)
{
    for (int sweep = 0; sweep < (int)sweeps; sweep++)
        for (int j = 1; j <= NY; j++)
            for (int c = W * j + 1; c <= W * j + NX; c++) {
                double sum = 0.0, sum_mob = 0.0;
                for (int k = 0; k < 2; k++) {
                    const int n = c + next[k];
                    sum += mob[k][c] * p[c - next[k]] + mob[k][n] * p[n] -
                           dx * (u[k][n] - u[k][c]);
                    sum_mob += mob[k][c] + mob[k][n];
                }
                if (sum_mob > 0.0) p[c] += 1.7 * (sum / sum_mob - p[c]);
            }
}

static void correct(void)
{
    for (int k = 0; k < 2; k++)
        for (int c = W; c < CELLS; c++)
            u[k][c] -= mob[k][c] * (p[c] - p[c - next[k]]) / dx;
}

static double lowest(void) /* u_x / lid half way across */
{
    double low = 0.0;
    for (int c = NX / 2 + 1; c < CELLS; c += W)
        low = low <= u[0][c] / lid ? low : u[0][c] / lid;
    return low;
}

void step(void)
{
    walls();
    predict();
    find_pressure();
    correct();
    if (!(fabs(lowest()) < 1e3))
        stop("t = %g s: the flow has no end; try more sweeps, a shorter dt\n",
             t);
    point(t + dt, lowest());
}

void report(void)
{
    printf("t = %g s: lowest u_x / lid half way = %.4f\n", t, lowest());
}

/* The longest strokes are 3 cells long. */
void draw(void)
{
    window(box[0], box[1], "30 mm wide; 3 cells long: 0.05 m/s");
    for (int j = 1; j <= NY; j++)
        for (int i = 1; i <= NX; i++) {
            const int c = i + W * j;
            put_stroke((i - 0.5) * dx, (j - 0.5) * dx,
                       30.0 * dx * (u[0][c] + u[0][c + 1]),
                       30.0 * dx * (u[1][c] + u[1][c + W]), 0.2 * dx);
        }
    plot("time [s]", "lowest u_x / lid half way across", -0.2109);
    vtk_cells(NX, NY, W, dx, u[0], u[1]);
}

/* To try: give the pressure one sweep a step instead of 40, sweeps=1, then two.
 * Then let the faces carry what comes from upwind, upwind=1: how far off is
 * it? */
