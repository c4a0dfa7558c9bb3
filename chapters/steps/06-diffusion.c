/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 6: diffusion.
 *
 * A puff of smoke spreads in air at rest. Space is now a mesh of cells, each
 * with one value f, and between two neighbours smoke flows from more to less:
 *
 *     df/dt = D laplacian f                                    [SX15 5a, 5c]
 *
 * What leaves a cell enters its neighbour, and nothing leaves through a wall:
 * there the cell beyond, a ghost, has the value of the cell before it. So the
 * sum over the cells is constant. After the time t one full cell has become a
 * Gaussian of the bandwidth b = sqrt(4 D t) (8.9) [SX15 6], and the mean square
 * distance from its middle has grown by 4 D t.
 *
 *     build/steps/06-diffusion [dt=0.07] [i=1] [j=1] */
#include "steps.h"

enum { NX = 41, NY = 41, W = NX + 2, CELLS = W * (NY + 2) }; /* W in a row */
static const double dx = 2e-3;    /* [m] width of a cell */
static double D = 1.5e-5;         /* [m^2/s] diffusivity */
static double i_0 = 21, j_0 = 21; /* the full cell, from 1 */

/* One value a cell. The cell before it in direction k is c - next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};
static field f; /* [-] smoke */

const struct number numbers[] = {
    {"D", &D, 0.0, 3e-5, 1e-6, "diffusivity [m^2/s]"},
    {"i", &i_0, 1, NX, 1, "column of the full cell"},
    {"j", &j_0, 1, NY, 1, "row of the full cell"},
    {"dt", &dt, 1e-3, 0.1, 0.001, "time step [s]"},
    {"end", &end, 0.0, 10.0, 0.1, "time at which it ends [s]"},
    {0}};
static double dt = 0.02, end = 2.0; /* [s] */

void start(void)
{
    f[(int)i_0 + W * (int)j_0] = 1.0;
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

/* What flows [m/s] through the lower face of a cell across k, along k. */
static double flux(const field a, int c, int k)
{
    const double below = a[c - next[k]], here = a[c];
    return D / dx * (below - here);
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
            for (int k = 0; k < 2; k++)
                f[c] += dt / dx * (flux(old, c, k) - flux(old, c + next[k], k));
    point(t + dt, 1e6 * (sum_of(0, 2) + sum_of(1, 2)));
}

void report(void)
{
    const double b = sqrt(4.0 * D * t);
    printf("t = %g s: sum = %.12g\n", t, sum_of(0, 0));
    printf("mean square distance = %.6g m^2, exact %.6g\n",
           sum_of(0, 2) + sum_of(1, 2), 4.0 * D * t);
    printf("highest value = %.5g, Gaussian %.5g with b = %.6g m\n",
           f[(int)i_0 + W * (int)j_0], dx * dx / (pi * b * b), b);
}

/* The cell that is fullest is darkest. */
void draw(void)
{
    double top = 0.0;
    for (int c = 0; c < CELLS; c++)
        top = fmax(top, f[c]);
    window(NX * dx, NY * dx, "82 mm wide; the darker, the more smoke");
    for (int j = 1; j <= NY; j++)
        for (int i = 1; i <= NX; i++)
            put_square((i - 1) * dx, (j - 1) * dx, dx, f[i + W * j] / top);
    plot("time [s]", "mean square distance [mm^2]", 4e6 * D * end);
    vtk_cells(NX, NY, W, dx, f, f);
}

/* To try: dt=0.07. Why does the chessboard appear, and why is its limit
 * dx^2 / (4 D)? Put the puff into a corner, i=1 j=1: by which factor is the
 * highest value larger, and why? */
