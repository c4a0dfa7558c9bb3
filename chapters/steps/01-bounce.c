/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 1: a bounce.
 *
 * A grain falls on a floor and bounces. While it flies, Newton's law moves it:
 *
 *     dx/dt = v,   m dv/dt = -m g                                    [LS 4.16]
 *
 * in steps of velocity Verlet (2.12). The impact takes no time here: the grain
 * leaves with e times the speed with which it came. This e is the restitution.
 * The exact speed of impact number k = 0, 1, ... is e^k sqrt(2 g h).
 *
 *     build/steps/01-bounce [e=0.9] [dt=1e-3] [end=10]
 *
 * All steps keep their data in this way: x[0][i] is the place of grain i along
 * the floor, x[1][i] its height, and so for each vector. */
#include "steps.h"

enum { N = 1 };                         /* grains */
static const double g = 9.81;           /* [m/s^2] gravity */
static double e = 0.7;                  /* [-] restitution */
static double h = 0.02;                 /* [m] height of the fall */
static double x[2][N + 1], v[2][N + 1]; /* [m], [m/s]; entry N: the floor */
static double R[N + 1];                 /* [m] */

enum { SHOWN = 5 };
static int impacts;
static double t_hit[SHOWN], v_hit[SHOWN]; /* [s], [m/s] the first, the last */

const struct number numbers[] = {
    {"e", &e, 0.0, 1.0, 0.05, "restitution [-]"},
    {"h", &h, 0.0, 0.02, 0.001, "height of the fall [m]"},
    {"dt", &dt, 1e-6, 2e-3, 0.0, "time step [s]"},
    {"end", &end, 0.0, 10.0, 0.1, "time at which it ends [s]"},
    {0}};
static double dt = 1e-5, end = 0.3; /* [s] */

void start(void)
{
    for (int i = 0; i < N; i++) {
        R[i] = 0.6e-3;
        x[0][i] = 4e-3;
        x[1][i] = R[i] + h;
    }
}

/* v moves for a time, usually half a step. */
static void kick(double time)
{
    for (int i = 0; i < N; i++)
        v[1][i] -= g * time;
}

static void drift(void)
{
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 2; k++)
            x[k][i] += v[k][i] * dt;
}

static void bounce(void)
{
    for (int i = 0; i < N; i++) {
        if (x[1][i] >= R[i] || v[1][i] >= 0.0) continue;
        const int k = impacts < SHOWN ? impacts : SHOWN - 1;
        impacts++;
        t_hit[k] = t + dt;
        v_hit[k] = -v[1][i];
        x[1][i] = R[i];
        v[1][i] = -e * v[1][i];
    }
}

void step(void)
{
    kick(0.5 * dt);
    drift();
    kick(0.5 * dt);
    bounce();
    point(t + dt, 1e3 * x[1][0]);
}

void report(void)
{
    for (int a = 0; a < SHOWN && a < impacts; a++) {
        const int k = a < SHOWN - 1 ? a : impacts - 1;
        printf("impact %d: t = %.4f s, speed = %.4f m/s, exact %.4f\n", k,
               t_hit[a], v_hit[a], pow(e, k) * sqrt(2.0 * g * h));
    }
    printf("t = %g s: y = %.6g m, v = %.6g m/s\n", t, x[1][0], v[1][0]);
}

void draw(void)
{
    window(8e-3, 22e-3, "8 mm wide");
    for (int i = 0; i < N; i++)
        put_disc(x[0][i], x[1][i], R[i], BLUE, 0.4);
    plot("time [s]", "height of the centre [mm]", NAN);
    vtk_grains(N, x[0], x[1], R);
}

/* To try: e=1 dt=1e-3 end=10. The grain gains energy from bounce to bounce.
 * Take x[1][i] = R[i] out of the impact, and it does not. Why? How does the
 * gain depend on dt? */
