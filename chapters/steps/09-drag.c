/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 9: drag on one grain.
 *
 * A grain sinks through the box of step 8, which is now filled with a liquid
 * and has no lid. The force of the fluid on the grain is
 *
 *     f = k (u_f - u_p),   k = 3 pi mu d (1 + 0.15 Re^0.687)     (10.1) (9.4)
 *
 * [SN33], where u_f is the velocity of the liquid in the cell of the grain and
 * Re = rho_f d |u_f - u_p| / mu (9.2). The reaction acts on the liquid: -f is
 * distributed to the faces of the same cell, with the same weights with which
 * u_f was taken from them. After a while the slip is that at which drag carries
 * weight less buoyancy:
 *
 *     slip = tau g (1 - rho_f / rho_s),   tau = m / k                     (9.5)
 *
 *     build/steps/09-drag [mu=0.05] [x=0.05] [depth=24e-3] */
#include "steps.h"

enum { N = 1, W = 18, CELLS = W * 67 };      /* grains, cells: W in a row */
static int NX, NY;                           /* those without the ghosts */
static double cells = 16, dx;                /* across, [m] width of a cell */
static const double box[2] = {24e-3, 48e-3}; /* [m] */
static const double side = -1.0;    /* 1: fluid slips along walls; -1: not */
static const double g = 9.81;       /* [m/s^2] gravity */
static double depth = 6e-3;         /* [m] of the box, across */
static const double rho_f = 1000.0; /* [kg/m^3] */
static double mu = 0.02, D;         /* [Pa s], [m^2/s] mu / rho_f */
static const double rho_s = 2500.0, d = 1.2e-3; /* [kg/m^3], [m] grain */
static double x_0 = 0.4;    /* [-] where it begins, of the width */
static double upwind = 0.0; /* 0: the mean of both cells */
static double sweeps = 40;  /* for the pressure, in a step */

/* One value a cell. The cell before it in direction k is c - next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};
static field p;      /* [Pa] */
static field u[2];   /* [m/s] u_k on the lower face of a cell across k */
static field mob[2]; /* [m^3 s/kg] how u_k follows the slope of p; 0 at walls */
static field f[2];   /* [N/m^3] drag on the fluid, in a cell */
static double x[2][N], v[2][N], R[N], m[N]; /* [m], [m/s], [m], [kg] */
static double P[2][N];                      /* [N] force of the fluid */

const struct number numbers[] = {
    {"mu", &mu, 0.005, 0.1, 0.005, "viscosity [Pa s]"},
    {"x", &x_0, 0.05, 0.95, 0.05, "where it begins, of the width [-]"},
    {"depth", &depth, 6e-3, 24e-3, 1e-3, "depth of the box [m]"},
    {"cells", &cells, 8, 16, 4, "cells across [-]"},
    {"dt", &dt, 1e-4, 1e-3, 1e-4, "time step [s]"},
    {"end", &end, 0.0, 2.0, 0.1, "time at which it ends [s]"},
    {0}};
static double dt = 1e-3, end = 0.5; /* [s] */

void start(void)
{
    NX = (int)cells;
    NY = (int)lround(NX * box[1] / box[0]);
    dx = box[0] / NX;
    D = mu / rho_f;
    for (int i = 0; i < N; i++) {
        R[i] = 0.5 * d;
        m[i] = rho_s * pi / 6.0 * d * d * d;
        x[0][i] = x_0 * box[0];
        x[1][i] = 0.9 * box[1];
    }
}

static int cell_of(int i) /* the cell of a grain */
{
    if (!(x[0][i] > 0.0 && x[0][i] < box[0] && x[1][i] > 0.0 &&
          x[1][i] < box[1]))
        stop("t = %g s: grain %d has left the box; try a shorter dt\n", t, i);
    return (int)(x[0][i] / dx) + 1 + W * ((int)(x[1][i] / dx) + 1);
}

/* The mean of the velocities on both sides of a wall is that of the wall. */
static void walls(void)
{
    for (int i = 1; i <= NX; i++) {
        u[0][i] = side * u[0][i + W];
        u[0][i + W * (NY + 1)] = side * u[0][i + W * NY];
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
                u[k][c] += mob[k][c] * 0.5 * (f[k][c] + f[k][c - next[k]]);
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

/* The velocity [m/s] of the fluid in a cell. */
static double in_cell(int k, int c)
{
    return 0.5 * (u[k][c] + u[k][c + next[k]]);
}

/* [kg/s] drag over slip. */
static double resistance(double slip)
{
    const double Re = rho_f * d * slip / mu;
    return 3.0 * pi * mu * d * (1.0 + 0.15 * power(Re, 0.687));
}

/* The drag on each grain, and the reaction on the fluid of its cell. */
static void average(void)
{
    const double V_c = dx * dx * depth;
    memset(f, 0, sizeof f);
    for (int i = 0; i < N; i++) {
        const int c = cell_of(i);
        const double a = in_cell(0, c) - v[0][i], b = in_cell(1, c) - v[1][i];
        const double drag = resistance(sqrt(a * a + b * b));
        for (int k = 0; k < 2; k++) {
            P[k][i] = drag * (in_cell(k, c) - v[k][i]);
            f[k][c] -= P[k][i] / V_c;
        }
    }
}

/* In so thick a liquid a grain stays on the floor that it has reached. */
static void move_grains(void)
{
    for (int i = 0; i < N; i++) {
        for (int k = 0; k < 2; k++) {
            v[k][i] += (P[k][i] / m[i] - k * g * (1.0 - rho_f / rho_s)) * dt;
            x[k][i] += v[k][i] * dt;
        }
        if (x[1][i] < R[i]) {
            x[1][i] = R[i];
            v[1][i] = 0.0;
        }
    }
}

static double slip(void) /* [m/s] of the first grain, along y */
{
    return in_cell(1, cell_of(0)) - v[1][0];
}

static double steady(void) /* [m/s] the slip of (9.5), a fixed point */
{
    double right = 0.0;
    for (int n = 0; n < 50; n++)
        right = m[0] / resistance(right) * g * (1.0 - rho_f / rho_s);
    return right;
}

void step(void)
{
    average();
    walls();
    predict();
    find_pressure();
    correct();
    move_grains();
    point(t + dt, 1e3 * slip());
}

void report(void)
{
    double reaction = 0.0;
    average();
    for (int c = 0; c < CELLS; c++)
        reaction += f[1][c] * dx * dx * depth;
    printf("t = %g s: velocity of the grain = %.5g m/s, slip = %.5g m/s\n", t,
           v[1][0], slip());
    printf("steady slip = %.9g m/s, Re = %.9g, tau = %.9g s\n", steady(),
           rho_f * d * steady() / mu, m[0] / resistance(steady()));
    printf("drag on the grain = %.9g N, on the liquid = %.9g N\n", P[1][0],
           reaction);
}

/* The longest strokes are some 3 cells long. */
void draw(void)
{
    window(box[0], box[1], "24 mm wide; 3 cells long: 0.01 m/s");
    for (int j = 1; j <= NY; j++)
        for (int i = 1; i <= NX; i++) {
            const int c = i + W * j;
            put_stroke((i - 0.5) * dx, (j - 0.5) * dx,
                       300.0 * dx * in_cell(0, c), 300.0 * dx * in_cell(1, c),
                       0.2 * dx);
        }
    for (int i = 0; i < N; i++)
        put_disc(x[0][i], x[1][i], R[i], RED, 0.4);
    plot("time [s]", "slip [mm/s]", 1e3 * steady());
    vtk_cells(NX, NY, W, dx, u[0], u[1]);
}

/* To try: make the box as deep as it is wide, depth=24e-3. Why does the grain
 * sink at another speed, though its slip is nearly the same? Then let go of it
 * close to a wall, x=0.05. */
