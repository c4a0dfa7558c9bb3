/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 7: advection.
 *
 * The air of step 6 moves, and convects the smoke:
 *
 *     df/dt + div(u f) = D laplacian f                                [LS 3.13]
 *
 * The velocity is known at the faces: its normal component there is the volume
 * that passes, per area. Which f does the flux have? The mean of both cells, or
 * that of the cell which it comes from, upwind: s of (5.9) is 1/2, or 0 or 1.
 * Upwind never overshoots, but the difference of the two is the flux of a
 * diffusivity u dx / 2. So it smears: the mean square distance along x grows
 * not by 2 D t alone but by u dx (1 - u dt / dx) t more. The middle moves by
 * u t.
 *
 *     build/steps/07-advection [upwind=0] [D=0] */
#include "steps.h"

enum { NX = 41, NY = 41, W = NX + 2, CELLS = W * (NY + 2) }; /* W in a row */
static const double dx = 2e-3;         /* [m] width of a cell */
static double D = 1.5e-5;              /* [m^2/s] diffusivity */
static double i_0 = 11, j_0 = 14;      /* the full cell, from 1 */
static double wind[2] = {0.03, 0.015}; /* [m/s] along x and y */
static double upwind = 1.0;            /* 0: the mean of both cells */

/* One value a cell. The cell before it in direction k is c - next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};
static field f;    /* [-] smoke */
static field u[2]; /* [m/s] u_k on the lower face of a cell across k */

const struct number numbers[] = {
    {"upwind", &upwind, 0.0, 1.0, 0.25, "share of upwind [-]"},
    {"u", &wind[0], -0.04, 0.04, 0.005, "wind along x [m/s]"},
    {"D", &D, 0.0, 3e-5, 1e-6, "diffusivity [m^2/s]"},
    {"i", &i_0, 1, NX, 1, "column of the full cell"},
    {"j", &j_0, 1, NY, 1, "row of the full cell"},
    {"dt", &dt, 1e-3, 0.1, 0.001, "time step [s]"},
    {"end", &end, 0.0, 10.0, 0.1, "time at which it ends [s]"},
    {0}};
static double dt = 0.02, end = 1.0; /* [s] */

void start(void)
{
    f[(int)i_0 + W * (int)j_0] = 1.0;
    for (int k = 0; k < 2; k++) /* nothing passes a wall */
        for (int j = 1 + k; j <= NY; j++)
            for (int c = W * j + 2 - k; c <= W * j + NX; c++)
                u[k][c] = wind[k];
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

/* What flows [m/s] through the lower face of a cell across k, along k, where
 * the velocity is V. */
static double flux(const field a, int c, int k, double V)
{
    const double below = a[c - next[k]], here = a[c];
    return 0.5 * V * (below + here) +
           (D / dx + 0.5 * upwind * fabs(V)) * (below - here);
}

static double sum_of(int k, int power) /* of f x_k^power, [m^power] */
{
    const int from[2] = {(int)i_0, (int)j_0};
    double sum = 0.0;
    for (int j = 1; j <= NY; j++)
        for (int i = 1; i <= NX; i++)
            sum += f[i + W * j] * pow(((k == 0 ? i : j) - from[k]) * dx, power);
    return sum;
}

void step(void)
{
    static field old;
    extend(f);
    memcpy(old, f, sizeof f);
    for (int j = 1; j <= NY; j++)
        for (int c = W * j + 1; c <= W * j + NX; c++)
            for (int k = 0; k < 2; k++) {
                const int n = c + next[k];
                f[c] += dt / dx *
                        (flux(old, c, k, u[k][c]) - flux(old, n, k, u[k][n]));
            }
    point(t + dt, 1e6 * (sum_of(0, 2) - pow(sum_of(0, 1), 2)));
}

void report(void)
{
    printf("t = %g s: sum = %.12g\n", t, sum_of(0, 0));
    printf("the middle moved by %.6g, %.6g m, exact %.6g, %.6g\n", sum_of(0, 1),
           sum_of(1, 1), wind[0] * t, wind[1] * t);
    for (int k = 0; k < 2; k++)
        printf(
            "mean square along %c = %.6g m^2, exact %.6g, without smearing "
            "%.6g\n",
            "xy"[k], sum_of(k, 2) - pow(sum_of(k, 1), 2),
            (2.0 * D + fabs(wind[k]) * upwind * dx - wind[k] * wind[k] * dt) *
                t,
            2.0 * D * t);
}

/* The cell that is fullest is darkest. The circle is where the middle should
 * be, with the bandwidth of diffusion alone. */
void draw(void)
{
    double top = 0.0;
    for (int c = 0; c < CELLS; c++)
        top = fmax(top, f[c]);
    window(NX * dx, NY * dx, "82 mm wide; the darker, the more smoke");
    for (int j = 1; j <= NY; j++)
        for (int i = 1; i <= NX; i++)
            put_square((i - 1) * dx, (j - 1) * dx, dx, f[i + W * j] / top);
    put_disc((i_0 - 0.5) * dx + wind[0] * t, (j_0 - 0.5) * dx + wind[1] * t,
             sqrt(4.0 * D * t), RED, 0.0);
    plot("time [s]", "mean square distance along x [mm^2]", 2e6 * D * end);
    vtk_cells(NX, NY, W, dx, f, f);
}

/* To try: upwind=0 lets the face carry the mean of the two cells, the linear
 * scheme with s = 1/2. Is the mean square right now? (An explicit step takes
 * u^2 dt t away from it.) Then take D=0 with both schemes. Which results are
 * impossible? */
