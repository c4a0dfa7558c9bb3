/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 2: spring and dashpot.
 *
 * In step 1 an impact took no time. Now it has a duration: while the grain
 * overlaps the floor by delta (2.1), a spring and a dashpot act on it,
 *
 *     F_n = k delta - eta v_n                                    (2.4) [LS 4.4]
 *
 * The dashpot is chosen so that the grain leaves with e times its speed (2.5):
 *
 *     eta = 2 zeta sqrt(k m),   zeta = -ln e / sqrt(pi^2 + ln^2 e)
 *
 * Half a period of this oscillator is the time of contact,
 * t_c = pi / sqrt(k/m - (eta/2m)^2). The step must resolve it. The floor is
 * grain N, of the same radius, which lies below it and does not move.
 *
 *     build/steps/02-spring [e=0.9] [dt=1e-5] [end=0.1] */
#include "steps.h"

enum { N = 1 };                  /* grains */
static const double g = 9.81;    /* [m/s^2] gravity */
static const double k_n = 100.0; /* [N/m] stiffness of the contact */
static double e = 0.7, zeta;     /* [-] restitution, damping */
static double h = 0.02;          /* [m] height of the fall */
static double x[2][N + 1], v[2][N + 1], F[2][N + 1]; /* [m], [m/s], [N] */
static double R[N + 1], m[N + 1];                    /* [m], [kg] */

enum { SHOWN = 5 };
static int impacts;
static double v_before, t_before;         /* [m/s], [s] */
static double e_hit[SHOWN], t_hit[SHOWN]; /* [-], [s] the first, the last */

const struct number numbers[] = {
    {"e", &e, 0.05, 1.0, 0.05, "restitution [-]"},
    {"h", &h, 0.0, 0.02, 0.001, "height of the fall [m]"},
    {"dt", &dt, 1e-6, 2e-4, 0.0, "time step [s]"},
    {"end", &end, 0.0, 10.0, 0.1, "time at which it ends [s]"},
    {0}};
static double dt = 1e-6, end = 0.3; /* [s] */

void start(void)
{
    zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    for (int i = 0; i < N; i++) {
        R[i] = 0.6e-3;
        m[i] = 1000.0 * 4.0 / 3.0 * pi * R[i] * R[i] * R[i];
        x[0][i] = 4e-3;
        x[1][i] = R[i] + h;
    }
}

/* The force of j on i, and the opposite; rx, ry [m] point from j to i. */
static void contact(int i, int j, double rx, double ry)
{
    const double r = sqrt(rx * rx + ry * ry), nx = rx / r, ny = ry / r;
    const double delta = 2.0 * R[i] - r; /* (2.1) */
    if (delta <= 0.0) return;
    const double eta = 2.0 * zeta * sqrt(k_n * m[i]);
    const double v_x = v[0][i] - v[0][j], v_y = v[1][i] - v[1][j];
    const double v_n = v_x * nx + v_y * ny; /* (2.2) */
    const double F_n = k_n * delta - eta * v_n;
    if (i == 0 && impacts == 0) point(1e6 * delta, 1e3 * F_n);
    F[0][i] += F_n * nx;
    F[0][j] -= F_n * nx;
    F[1][i] += F_n * ny;
    F[1][j] -= F_n * ny;
}

static void forces(void)
{
    memset(F, 0, sizeof F);
    for (int i = 0; i < N; i++)
        contact(i, N, 0.0, x[1][i] + R[i]);
}

/* v moves for a time, usually half a step. */
static void kick(double time)
{
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 2; k++)
            v[k][i] += (F[k][i] / m[i] - k * g) * time;
}

static void drift(void)
{
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 2; k++)
            x[k][i] += v[k][i] * dt;
}

/* Notes when an impact begins, and what it did when it has ended. */
static void watch(void)
{
    const int a = impacts < SHOWN ? impacts : SHOWN - 1;
    const int touches = x[1][0] < R[0];
    if (touches && v_before == 0.0) {
        v_before = v[1][0];
        t_before = t;
    }
    if (touches || v_before == 0.0) return;
    e_hit[a] = -v[1][0] / v_before;
    t_hit[a] = t - t_before;
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
    const double eta = 2.0 * zeta * sqrt(k_n * m[0]);
    printf("m = %.9g kg, eta = %.9g kg/s, t_c = %.4g s\n", m[0], eta,
           pi / sqrt(k_n / m[0] - pow(eta / (2.0 * m[0]), 2)));
    for (int a = 0; a < SHOWN && a < impacts; a++)
        printf("impact %d: e = %.4f of %g, time = %.4g s\n",
               a < SHOWN - 1 ? a : impacts - 1, e_hit[a], e, t_hit[a]);
    printf("t = %g s: y = %.9g m, v = %.9g m/s\n", t, x[1][0], v[1][0]);
}

void draw(void)
{
    window(8e-3, 22e-3, "8 mm wide");
    for (int i = 0; i < N; i++)
        put_disc(x[0][i], x[1][i], R[i], BLUE, 0.4);
    plot("overlap [um]", "force of the floor [mN]", NAN);
    vtk_grains(N, x[0], x[1], R);
}

/* To try: a longer step, dt=1e-5, then dt=5e-5 and dt=1e-4. How many steps
 * does a contact need before e is right to a per cent? Then take dt=2e-4: a
 * step longer than 2 t_c / pi throws the grain higher than it was. */
