/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 3: friction and spin.
 *
 * The grain of step 2 is thrown along the floor. Where the surfaces slip, with
 * v_t (2.2), a second spring is stretched by xi, and together with its dashpot
 * it exerts a force along the floor,
 *
 *     F_t = -k_t xi - eta_t v_t,   dxi/dt = v_t,   |F_t| <= mu |F_n|
 *
 * (2.8) [LS 4.8]. Where Coulomb's law limits the force, xi is reduced. F_t also
 * turns the grain by its lever l, I dw/dt = -l F_t, I = 2/5 m R^2 (2.11). The
 * two springs have the same period if k_t / k and eta_t / eta are 2/7 (2.10).
 * An impact that slides to its end reduces the slip by 7/2 mu (1 + e) v_n.
 *
 *     build/steps/03-friction [friction=0.1] [spin=5000] [end=0.3] */
#include "steps.h"

enum { N = 1 };                  /* grains */
static const double g = 9.81;    /* [m/s^2] gravity */
static const double k_n = 100.0; /* [N/m] stiffness of the contact */
static const double k_t = 2.0 / 7.0 * 100.0; /* [N/m] along the floor */
static double e = 0.7, zeta;                 /* [-] restitution, damping */
static double friction = 0.2;                /* [-] friction */
static double h = 0.006;                     /* [m] height of the fall */
static const double speed = 0.6;             /* [m/s] along the floor */
static double spin;                          /* [rad/s] at the start */
static double x[2][N + 1], v[2][N + 1], F[2][N + 1]; /* [m], [m/s], [N] */
static double R[N + 1], m[N + 1];                    /* [m], [kg] */
static double w[N + 1], M[N + 1], turn[N];           /* [rad/s], [N m], [rad] */
static double xi[N][N + 1]; /* [m] spring of grain and floor */

enum { SHOWN = 5, MOST = 100 };
static int impacts, kept;
static double v_before, slip_before;                 /* [m/s] */
static double from[SHOWN], to[SHOWN], slides[SHOWN]; /* [m/s] slips */
static double path[MOST][3];                         /* [m], [m], [rad] */

const struct number numbers[] = {
    {"friction", &friction, 0.0, 1.0, 0.05, "friction, mu in (2.8) [-]"},
    {"spin", &spin, -5000.0, 5000.0, 250.0, "spin at the start [rad/s]"},
    {"e", &e, 0.05, 1.0, 0.05, "restitution [-]"},
    {"h", &h, 0.0, 0.006, 0.001, "height of the fall [m]"},
    {"dt", &dt, 1e-6, 2e-4, 0.0, "time step [s]"},
    {"end", &end, 0.0, 10.0, 0.1, "time at which it ends [s]"},
    {0}};
static double dt = 1e-6, end = 0.14; /* [s] */

void start(void)
{
    zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    for (int i = 0; i < N; i++) {
        R[i] = 0.6e-3;
        m[i] = 1000.0 * 4.0 / 3.0 * pi * R[i] * R[i] * R[i];
        x[1][i] = R[i] + h;
        v[0][i] = speed;
        w[i] = spin;
    }
}

/* The force of j on i, and the opposite; rx, ry [m] point from j to i. */
static void contact(int i, int j, double rx, double ry, double *xi_ij)
{
    const double r = sqrt(rx * rx + ry * ry), nx = rx / r, ny = ry / r;
    const double delta = 2.0 * R[i] - r, l_i = 0.5 * r; /* (2.1) */
    if (delta <= 0.0) *xi_ij = 0.0;
    if (delta <= 0.0) return;
    const double eta = 2.0 * zeta * sqrt(k_n * m[i]), eta_t = 2.0 / 7.0 * eta;
    const double v_x = v[0][i] - v[0][j], v_y = v[1][i] - v[1][j];
    const double v_n = v_x * nx + v_y * ny; /* (2.2) */
    const double v_t = v_y * nx - v_x * ny - l_i * w[i];
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
}

static void forces(void)
{
    memset(F, 0, sizeof F);
    memset(M, 0, sizeof M);
    for (int i = 0; i < N; i++)
        contact(i, N, 0.0, x[1][i] + R[i], &xi[i][N]);
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
    for (int i = 0; i < N; i++) {
        for (int k = 0; k < 2; k++)
            x[k][i] += v[k][i] * dt;
        turn[i] += w[i] * dt;
    }
}

/* Notes when an impact begins, and what it did when it has ended. */
static void watch(void)
{
    const int a = impacts < SHOWN ? impacts : SHOWN - 1;
    const int touches = x[1][0] < R[0];
    const double slip = v[0][0] + 0.5 * (R[0] + fmin(x[1][0], R[0])) * w[0];
    point(t, slip);
    if (kept < MOST && t >= 0.03 * kept * end) {
        path[kept][0] = x[0][0];
        path[kept][1] = x[1][0];
        path[kept++][2] = turn[0];
    }
    if (touches && v_before == 0.0) v_before = v[1][0];
    if (v_before == 0.0) slip_before = slip;
    if (touches || v_before == 0.0) return;
    from[a] = slip_before;
    to[a] = slip;
    slides[a] =
        from[a] - copysign(3.5 * friction * (1.0 + e) * v_before, from[a]);
    v_before = 0.0;
    impacts++;
}

void step(void)
{
    kick(0.5 * dt);
    drift();
    forces();
    kick(0.5 * dt);
    watch();
}

void report(void)
{
    for (int a = 0; a < SHOWN && a < impacts; a++)
        printf("impact %d: slip %.4f -> %.4f m/s, by sliding alone %.4f\n",
               a < SHOWN - 1 ? a : impacts - 1, from[a], to[a], slides[a]);
    printf("t = %g s: y = %.9g, vx = %.9g, vy = %.9g m/s, w = %.9g rad/s\n", t,
           x[1][0], v[0][0], v[1][0], w[0]);
}

/* The grain at 34 times, with a radius that turns with it. */
void draw(void)
{
    double left = 0.0, right = 0.07;
    for (int a = 0; a < kept; a++) {
        left = fmin(left, path[a][0]);
        right = fmax(right, path[a][0]);
    }
    char caption[80];
    snprintf(caption, sizeof caption, "%.0f mm wide", 1e3 * (right - left));
    window(right - left + 2e-3, 9e-3, caption);
    for (int a = 0; a < kept; a++) {
        const double *const p = path[a], X = p[0] - left + 1e-3;
        put_disc(X, p[1], R[0], BLUE, 0.2);
        put_stroke(X, p[1], R[0] * cos(p[2]), R[0] * sin(p[2]), 2e-4);
    }
    plot("time [s]", "slip of the surface [m/s]", 0.0);
    vtk_grains(N, x[0], x[1], R);
}

/* To try: throw it with backspin, spin=5000, and see where it is at end=0.3
 * and end=0.6. Then raise the friction, friction=1: the spring reverses a part
 * of the slip, as with a bouncing ball of rubber. */
