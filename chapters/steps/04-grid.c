/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 4: many grains and a grid of cells.
 *
 * 200 grains fall in a box. Each contact is that of step 3, and acts on both
 * partners with opposite forces. The lever of each is its part of the distance
 * (2.3). Grains are put into cells at least a diameter wide: one can only touch
 * those of its own cell and of the eight around it. To test all pairs would
 * take long. A ring of empty cells surrounds the box, so that each has eight.
 *
 *     build/steps/04-grid [dx=3e-3] [friction=0] [end=0.2] */
#include "steps.h"

enum { N = 200, W = 34, CELLS = W * 42 }; /* grains, cells: W in a row */
static const double g = 9.81;             /* [m/s^2] gravity */
static const double k_n = 100.0;          /* [N/m] stiffness of the contact */
static const double k_t = 2.0 / 7.0 * 100.0; /* [N/m] along the floor */
static const double box[2] = {24e-3, 30e-3}; /* [m] */
static double e = 0.7, zeta;                 /* [-] restitution, damping */
static double friction = 0.2;                /* [-] friction */
static double dx = 1.5e-3;                   /* [m] width of a cell */
static double x[2][N + 1], v[2][N + 1], F[2][N + 1]; /* [m], [m/s], [N] */
static double R[N + 1], m[N + 1];                    /* [m], [kg] */
static double w[N + 1], M[N + 1];                    /* [rad/s], [N m] */
static double xi[N][N + 4]; /* [m] springs of pairs, and of four walls */
static int compared;

const struct number numbers[] = {
    {"dx", &dx, 0.75e-3, 6e-3, 0.75e-3, "width of a cell [m]"},
    {"friction", &friction, 0.0, 1.0, 0.05, "friction, mu in (2.8) [-]"},
    {"e", &e, 0.05, 1.0, 0.05, "restitution [-]"},
    {"dt", &dt, 1e-6, 2e-4, 0.0, "time step [s]"},
    {"end", &end, 0.0, 1.0, 0.01, "time at which it ends [s]"},
    {0}};
static double dt = 1e-5, end = 0.05; /* [s] */

void start(void)
{
    zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    for (int i = 0; i < N; i++) {
        R[i] = 0.5e-3 + 0.2e-3 * random_number();
        m[i] = 1000.0 * 4.0 / 3.0 * pi * R[i] * R[i] * R[i];
        x[0][i] = 1.65e-3 * (i % 14 + 0.6 + 0.4 * (i / 14 % 2));
        x[1][i] = 1.65e-3 * (i / 14 + 2.8);
    }
}

static int cell_of(int i) /* the cell of a grain */
{
    if (!(x[0][i] > 0.0 && x[0][i] < box[0] && x[1][i] > 0.0 &&
          x[1][i] < box[1]))
        stop("t = %g s: grain %d has left the box; try a shorter dt\n", t, i);
    return (int)(x[0][i] / dx) + 1 + W * ((int)(x[1][i] / dx) + 1);
}

/* The force of j on i, and the opposite; rx, ry [m] point from j to i. A wall
 * is a grain of the same radius that lies behind it and touches it. */
static void contact(int i, int j, double rx, double ry, double *xi_ij)
{
    const double r = sqrt(rx * rx + ry * ry), nx = rx / r, ny = ry / r;
    const double R_j = j < N ? R[j] : R[i], delta = R[i] + R_j - r; /* (2.1) */
    if (delta <= 0.0) *xi_ij = 0.0;
    if (delta <= 0.0) return;
    const double l_i = r * R[i] / (R[i] + R_j), l_j = r - l_i; /* (2.3) */
    const double m_star = j < N ? m[i] * m[j] / (m[i] + m[j]) : m[i];
    const double eta = 2.0 * zeta * sqrt(k_n * m_star), eta_t = 2.0 / 7.0 * eta;
    const double v_x = v[0][i] - v[0][j], v_y = v[1][i] - v[1][j];
    const double v_n = v_x * nx + v_y * ny; /* (2.2) */
    const double v_t = v_y * nx - v_x * ny - l_i * w[i] - l_j * w[j];
    const double F_n = k_n * delta - eta * v_n;
    *xi_ij += v_t * dt;
    double F_t = -k_t * *xi_ij - eta_t * v_t;
    if (fabs(F_t) > friction * fabs(F_n)) {
        F_t = copysign(friction * F_n, F_t);
        if (k_t * fabs(*xi_ij) > fabs(F_t)) *xi_ij = -F_t / k_t;
    }
    F[0][i] += F_n * nx - F_t * ny;
    F[0][j] -= F_n * nx - F_t * ny;
    F[1][i] += F_n * ny + F_t * nx;
    F[1][j] -= F_n * ny + F_t * nx;
    M[i] -= l_i * F_t;
    M[j] -= l_j * F_t;
}

/* Grain i is compared with the grains before it, which are in the grid, and is
 * then put there itself. So each pair is compared once. */
static void forces(void)
{
    static const int around[9] = {0,      -1, 1,     -W,   -W - 1,
                                  -W + 1, W,  W - 1, W + 1};
    int first[CELLS], next_one[N];
    memset(first, -1, sizeof first);
    memset(F, 0, sizeof F);
    memset(M, 0, sizeof M);
    compared = 0;
    for (int i = 0; i < N; i++) {
        const int c = cell_of(i);
        const double X = x[0][i], Y = x[1][i];
        for (int a = 0; a < 9; a++)
            for (int j = first[c + around[a]]; j >= 0; j = next_one[j]) {
                contact(i, j, X - x[0][j], Y - x[1][j], &xi[i][j]);
                compared++;
            }
        next_one[i] = first[c];
        first[c] = i;
        contact(i, N, X + R[i], 0.0, &xi[i][N]);
        contact(i, N, X - R[i] - box[0], 0.0, &xi[i][N + 1]);
        contact(i, N, 0.0, Y + R[i], &xi[i][N + 2]);
        contact(i, N, 0.0, Y - R[i] - box[1], &xi[i][N + 3]);
    }
}

/* v moves for a time, usually half a step. */
static void kick(double time)
{
    for (int i = 0; i < N; i++) {
        for (int k = 0; k < 2; k++)
            v[k][i] += (F[k][i] / m[i] - k * g) * time;
        w[i] += M[i] / (0.4 * m[i] * R[i] * R[i]) * time;
    }
}

static void drift(void)
{
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 2; k++)
            x[k][i] += v[k][i] * dt;
}

static double mean_height(void) /* [m] */
{
    double sum = 0.0;
    for (int i = 0; i < N; i++)
        sum += x[1][i] / N;
    return sum;
}

void step(void)
{
    kick(0.5 * dt);
    drift();
    forces();
    kick(0.5 * dt);
    point(t, 1e3 * mean_height());
}

void report(void)
{
    printf("t = %g s: compared %d of %d pairs, mean height = %.9g m\n", t,
           compared, N * (N - 1) / 2, mean_height());
}

/* Darker grains are faster, up to 0.4 m/s. */
void draw(void)
{
    window(box[0], box[1], "24 mm wide; the darker, the faster");
    for (int i = 0; i < N; i++)
        put_disc(x[0][i], x[1][i], R[i], BLUE,
                 0.2 + 2.0 * sqrt(v[0][i] * v[0][i] + v[1][i] * v[1][i]));
    plot("time [s]", "mean height [mm]", NAN);
    vtk_grains(N, x[0], x[1], R);
}

/* To try: cells twice as wide, dx=3e-3. Which number changes, which does not?
 * And in cells of half the width, dx=0.75e-3? */
