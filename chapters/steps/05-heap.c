/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 5: a heap.
 *
 * A column of grains collapses on a row of grains that do not move. The springs
 * along the contacts (2.8) store the slip of the grains, and so a heap remains.
 * The slope of a triangle is its mean height over the mean distance from its
 * middle. At rest the floor bears the weight.
 *
 *     build/steps/05-heap [friction=0] [end=0.3] */
#include "steps.h"

enum { N = 246, FLOOR = 56, W = 52, CELLS = W * 18 }; /* the first are fixed */
static const double g = 9.81;                         /* [m/s^2] gravity */
static const double k_n = 100.0; /* [N/m] stiffness of the contact */
static const double k_t = 2.0 / 7.0 * 100.0; /* [N/m] along the floor */
static const double box[2] = {75e-3, 24e-3}; /* [m] */
static double e = 0.7, zeta;                 /* [-] restitution, damping */
static double friction = 0.5;                /* [-] friction */
static const double dx = 1.5e-3;             /* [m] width of a cell */
static double x[2][N + 1], v[2][N + 1], F[2][N + 1]; /* [m], [m/s], [N] */
static double R[N + 1], m[N + 1];                    /* [m], [kg] */
static double w[N + 1], M[N + 1];                    /* [rad/s], [N m] */
static double xi[N][N + 4]; /* [m] springs of pairs, and of four walls */

const struct number numbers[] = {
    {"friction", &friction, 0.0, 1.0, 0.05, "friction, mu in (2.8) [-]"},
    {"e", &e, 0.05, 1.0, 0.05, "restitution [-]"},
    {"dt", &dt, 1e-6, 2e-4, 0.0, "time step [s]"},
    {"end", &end, 0.0, 1.0, 0.01, "time at which it ends [s]"},
    {0}};
static double dt = 1e-5, end = 0.5; /* [s] */

void start(void)
{
    zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    for (int i = 0; i < N; i++) {
        const int a = i - FLOOR, row = a / 16; /* in the column */
        R[i] = 0.5e-3 + 0.2e-3 * random_number();
        m[i] = 1000.0 * 4.0 / 3.0 * pi * R[i] * R[i] * R[i];
        x[0][i] = a < 0 ? 1.33e-3 * (i + 0.5)
                        : 1.45e-3 * (a % 16 + 18 + 0.4 * (row % 2));
        x[1][i] = a < 0 ? 0.7e-3 : 1.45e-3 * (row + 1.5);
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
    for (int i = 0; i < N; i++) {
        const int c = cell_of(i);
        const double X = x[0][i], Y = x[1][i];
        for (int a = 0; a < 9; a++)
            for (int j = first[c + around[a]]; j >= 0; j = next_one[j])
                contact(i, j, X - x[0][j], Y - x[1][j], &xi[i][j]);
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
    for (int i = FLOOR; i < N; i++) {
        for (int k = 0; k < 2; k++)
            v[k][i] += (F[k][i] / m[i] - k * g) * time;
        w[i] += M[i] / (0.4 * m[i] * R[i] * R[i]) * time;
    }
}

static void drift(void)
{
    for (int i = FLOOR; i < N; i++)
        for (int k = 0; k < 2; k++)
            x[k][i] += v[k][i] * dt;
}

static double angle(void) /* [degrees] of the slope */
{
    double height = 0.0, distance = 0.0;
    for (int i = FLOOR; i < N; i++) {
        height += x[1][i] - 1.2e-3;
        distance += fabs(x[0][i] - 0.5 * box[0]);
    }
    return 180.0 / pi * atan(height / distance);
}

void step(void)
{
    kick(0.5 * dt);
    drift();
    forces();
    kick(0.5 * dt);
    point(t, angle());
}

void report(void)
{
    double weight = 0.0, borne = 0.0;
    for (int i = 0; i < N; i++) {
        borne -= i < FLOOR ? F[1][i] : 0.0;
        weight += i < FLOOR ? 0.0 : m[i] * g;
    }
    printf("t = %g s: angle = %.1f degrees\n", t, angle());
    printf("the floor bears %.5g N, weight = %.5g N\n", borne, weight);
}

/* The floor is dark. */
void draw(void)
{
    window(box[0], box[1], "75 mm wide");
    for (int i = 0; i < N; i++)
        put_disc(x[0][i], x[1][i], R[i], BLUE, i < FLOOR ? 0.9 : 0.2);
    plot("time [s]", "slope [degrees]", NAN);
    vtk_grains(N, x[0], x[1], R);
}

/* To try: friction=0 is without friction. Which slope is left, and why any? */
