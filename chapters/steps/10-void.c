/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 10: void fraction.
 *
 * Air is blown through 300 grains that do not move, in a slot little deeper
 * than one of them. A cell of the mesh holds some grains and the air between
 * them, and eps is the part that is air. The oldest method counts a grain
 * wholly in the cell of its centre, the particle-centroid method (PCM):
 *
 *     eps = 1 - sum V_p / V_c                                (8.6) [XS11 3.1]
 *
 * With eps the equations of step 8 become the averaged ones of a fluid that
 * shares the space with grains. The velocity between the grains is u, and the
 * volume that passes, per area and time, is q = eps u:
 *
 *     div q = 0                                               (5.7) [XS11 2.7]
 *     eps rho_f du/dt + rho_f div(q u) = -eps grad p + f                (5.12)
 *
 * (5.12) is divided by eps here. f is the reaction of the drag, of step 9: that
 * of grains which are alone. In a bed it is far too small, see step 11. The
 * viscosity of the air itself is small beside it.
 *
 *     build/steps/10-void [U=0.4] [cells=16] */
#include "steps.h"

enum { N = 300, W = 18, CELLS = W * 67 };    /* grains, cells: W in a row */
static int NX, NY;                           /* those without the ghosts */
static double cells = 8, dx;                 /* across, [m] width of a cell */
static const double box[2] = {16e-3, 64e-3}; /* [m] */
static const double side = 1.0;     /* 1: fluid slips along walls; -1: not */
static const double depth = 1.5e-3; /* [m] of the box, across */
static const double rho_f = 1.2;    /* [kg/m^3] */
static const double mu = 1.8e-5;    /* [Pa s] of air */
static const double D = 1.5e-5;     /* [m^2/s] mu / rho_f */
static const double d = 1.2e-3;     /* [m] grain */
static const double V_p = 9.04778684e-10; /* [m^3] its volume */
static double U = 0.2;                    /* [m/s] at the inlet */
static double upwind = 1.0;               /* 0: the mean of both cells */
static double sweeps = 60;                /* for the pressure, in a step */

/* One value a cell. The cell before it in direction k is c - next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};
static field p, eps;     /* [Pa], [-] in the cell */
static field u[2], q[2]; /* [m/s] u_k on the lower face across k, eps u_k */
static field mob[2]; /* [m^3 s/kg] how q_k follows the slope of p; 0 at walls */
static field f[2];   /* [N/m^3] drag on the fluid, in a cell */
static double x[2][N], R[N]; /* [m] grains */
static double P[2][N];       /* [N] force of the fluid */

const struct number numbers[] = {
    {"U", &U, 0.0, 0.5, 0.05, "air at the inlet [m/s]"},
    {"cells", &cells, 4, 16, 1, "cells across [-]"},
    {"dt", &dt, 1e-5, 5e-4, 1e-5, "time step [s]"},
    {"end", &end, 0.0, 0.1, 0.01, "time at which it ends [s]"},
    {0}};
static double dt = 2e-4, end = 0.02; /* [s] */

void start(void)
{
    NX = (int)cells;
    NY = (int)lround(NX * box[1] / box[0]);
    dx = box[0] / NX;
    for (int i = 0; i < N; i++) { /* rows of twelve */
        R[i] = 0.5 * d;
        x[0][i] = 1.28e-3 * (i % 12 + 0.5 + 0.5 * (i / 12 % 2));
        x[1][i] = 1.11e-3 * (i / 12 + 0.6);
    }
}

static int cell_of(int i) /* the cell of a grain */
{
    if (!(x[0][i] > 0.0 && x[0][i] < box[0] && x[1][i] > 0.0 &&
          x[1][i] < box[1]))
        stop("t = %g s: grain %d has left the box; try a shorter dt\n", t, i);
    return (int)(x[0][i] / dx) + 1 + W * ((int)(x[1][i] / dx) + 1);
}

/* The ghost cells around the mesh take the values of the cells beside them. */
static void extend(field a)
{
    for (int i = 1; i <= NX; i++) {
        a[i] = a[i + W];
        a[i + W * (NY + 1)] = a[i + W * NY];
    }
    for (int j = 0; j <= NY + 1; j++) {
        a[W * j] = a[W * j + 1];
        a[W * j + NX + 1] = a[W * j + NX];
    }
}

/* The velocities on both sides of a wall. Air enters below, leaves above. */
static void walls(void)
{
    for (int i = 1; i <= NX; i++) {
        u[0][i] = side * u[0][i + W];
        u[0][i + W * (NY + 1)] = side * u[0][i + W * NY];
        q[1][i + W] = U;
        u[1][i + W] = U / eps[i + W];
        u[1][i + W * (NY + 2)] = u[1][i + W * (NY + 1)];
        q[1][i + W * (NY + 2)] = q[1][i + W * (NY + 1)];
    }
    for (int j = 1; j <= NY + 1; j++) {
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

/* 1 / eps on the lower face across k. */
static double inverse(int k, int c)
{
    return 0.5 / eps[c] + 0.5 / eps[c - next[k]];
}

/* Predicts q without p. */
static void predict(void)
{
    static field old[2], old_q[2];
    memcpy(old, u, sizeof u);
    memcpy(old_q, q, sizeof q);
    for (int k = 0; k < 2; k++)
        for (int j = 1 + k; j <= NY + k; j++)
            for (int c = W * j + 2 - k; c <= W * j + NX; c++) {
                const int b = c - next[k];
                for (int l = 0; l < 2; l++)
                    u[k][c] += dt / dx * inverse(k, c) *
                               (flux_of(k, old, old_q, c, l) -
                                flux_of(k, old, old_q, c + next[l], l));
                mob[k][c] = dt / rho_f / inverse(k, c);
                q[k][c] =
                    mob[k][c] * (rho_f / dt * u[k][c] +
                                 0.5 * (f[k][b] / eps[b] + f[k][c] / eps[c]));
            }
}

/* Successive over-relaxation: 1.7 times the change that solves the equation of
 * a cell. Where the mobility is 0, p has no effect; it is 0 beyond the outlet.
 */
static void find_pressure(void)
{
    for (int sweep = 0; sweep < (int)sweeps; sweep++)
        for (int j = 1; j <= NY; j++)
            for (int c = W * j + 1; c <= W * j + NX; c++) {
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
        for (int c = W; c < W * (NY + 2); c++) {
            q[k][c] -= mob[k][c] * (p[c] - p[c - next[k]]) / dx;
            u[k][c] = q[k][c] * inverse(k, c);
        }
}

/* The velocity [m/s] of the fluid in a cell. */
static double in_cell(int k, int c)
{
    return 0.5 * (q[k][c] + q[k][c + next[k]]) / eps[c];
}

/* [kg/s] drag over slip. */
static double resistance(double slip)
{
    const double Re = rho_f * d * slip / mu;
    return 3.0 * pi * mu * d * (1.0 + 0.15 * power(Re, 0.687));
}

/* (8.6): each grain to the cell of its centre. Then its drag, and the reaction
 * on the air of the cell. */
static void average(void)
{
    const double V_c = dx * dx * depth;
    for (int c = 0; c < CELLS; c++)
        eps[c] = 1.0;
    for (int i = 0; i < N; i++)
        eps[cell_of(i)] -= V_p / V_c;
    extend(eps);
    for (int c = 0; c < CELLS; c++)
        if (!(eps[c] > 0.0))
            stop("t = %g s: a cell has no air, eps = %.3f\n", t, eps[c]);
    memset(f, 0, sizeof f);
    for (int i = 0; i < N; i++) {
        const int c = cell_of(i);
        const double a = in_cell(0, c), b = in_cell(1, c);
        const double drag = resistance(sqrt(a * a + b * b));
        for (int k = 0; k < 2; k++) {
            P[k][i] = drag * in_cell(k, c);
            f[k][c] -= P[k][i] / V_c;
        }
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

void step(void)
{
    average();
    walls();
    predict();
    find_pressure();
    correct();
    point(t + dt, 1.5 * row(1) - 0.5 * row(2));
}

void report(void)
{
    const double V_c = dx * dx * depth;
    double lowest = 1.0, solids = 0.0, on_grains = 0.0, on_air = 0.0;
    average();
    for (int j = 1; j <= NY; j++)
        for (int c = W * j + 1; c <= W * j + NX; c++) {
            lowest = fmin(lowest, eps[c]);
            solids += (1.0 - eps[c]) * V_c;
            on_air += f[1][c] * V_c;
        }
    for (int i = 0; i < N; i++)
        on_grains += P[1][i];
    printf("t = %g s: lowest eps = %.6f, pressure drop = %.8g Pa\n", t, lowest,
           1.5 * row(1) - 0.5 * row(2));
    printf("volume of solids = %.12g m^3, of the grains %.12g\n", solids,
           N * V_p);
    printf("drag on the grains = %.9g N, on the air = %.9g N\n", on_grains,
           on_air);
}

/* Darker cells have less air. The pressure falls along the bed. */
void draw(void)
{
    window(box[0], box[1], "16 mm wide; the darker, the less air");
    for (int j = 1; j <= NY; j++)
        for (int i = 1; i <= NX; i++)
            put_square((i - 1) * dx, (j - 1) * dx, dx, 1.0 - eps[i + W * j]);
    for (int i = 0; i < N; i++)
        put_disc(x[0][i], x[1][i], R[i], INK, 0.0);
    curve.n = curve.calls = 0;
    for (int j = 1; j <= NY; j++)
        point(1e3 * (j - 0.5) * dx, row(j));
    plot("height [mm]", "pressure [Pa]", 0.0);
    vtk_cells(NX, NY, W, dx, eps, p);
}

/* To try: finer cells, cells=16. What are the lowest eps and the pressure drop
 * now? How many grains are in a cell? */
