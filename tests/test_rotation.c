/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a rigid body turns that no torque acts on. */
#include "base/rotation.h"

#include "facts.h"

#include <string.h>

struct top {
    double q[4], L[3], per_I[3];
};

/* An asymmetric body, which tumbles: omega is 1.06 rad/s. */
static struct top tumbling(void)
{
    return (struct top){
        .q = {1.0}, .L = {0.3, 2.0, 0.6}, .per_I = {1.0, 1.0 / 2.0, 1.0 / 3.0}};
}

static void turn(struct top *t, int steps, double dt)
{
    for (int i = 0; i < steps; i++)
        rotation_advance(t->q, t->L, t->per_I, dt);
}

static double energy(const struct top *t)
{
    double w[3];

    rotation_spin(t->q, t->L, t->per_I, w);
    return 0.5 * vector_dot(w, t->L);
}

/* The largest error of the energy in n steps [-]. */
static double energy_error(struct top *t, double E, int n, double dt)
{
    double most = 0.0;

    for (int i = 0; i < n; i++) {
        turn(t, 1, dt);
        most = fmax(most, fabs(energy(t) / E - 1.0));
    }
    return most;
}

/* With 120 and 1200 steps in a turn, over 3000 and 300 turns. The error is of
 * second order, goes up and down, and is as large in the end as it was in the
 * beginning. */
FACT_FOR_EACH(dullweber97_the_energy_of_a_free_rotation_does_not_drift, 2)
{
    const double dt = _i == 0 ? 0.05 : 0.005, most = _i == 0 ? 1.3e-5 : 1.3e-7;
    struct top t = tumbling();
    const double E = energy(&t);
    const double early = energy_error(&t, E, 40000, dt);

    turn(&t, 280000, dt);
    const double late = energy_error(&t, E, 40000, dt);
    ck_assert_double_eq_tol(early / most, 1.0, 0.05);
    ck_assert_double_eq_tol(late / early, 1.0, 1e-3);
}

/* The same steps with -dt: what is left is the rounding of 2000 steps. */
FACT(dullweber97_a_free_rotation_can_be_taken_back)
{
    struct top t = tumbling();
    const struct top begin = t;

    turn(&t, 1000, 0.05);
    ck_assert_double_ge(fabs(t.q[0] - begin.q[0]), 0.1);
    turn(&t, 1000, -0.05);
    for (int k = 0; k < 4; k++)
        ck_assert_double_eq_tol(t.q[k], begin.q[k], 1e-12);
}

/* A top of I_1 = I_2: its axis goes round L at |L|/I_1, here 1 rad/s about z,
 * and it turns about the axis at L . axis (1/I_3 - 1/I_1). Returns how far the
 * frame is from that after 10 s [-]. */
static double top_error(int axis, int steps)
{
    const int i = (axis + 1) % 3;
    const double end = 10.0, tilt = 0.8, own = cos(tilt) * (1.0 / 0.3 - 1.0);
    struct top t = {.L = {0.0, 0.0, 1.0}, .per_I = {1.0, 1.0, 1.0}};
    const double turned[4] = {cos(0.5 * end), 0.0, 0.0, sin(0.5 * end)};
    double lay[4] = {0.5, 0.5, 0.5, 0.5}, spin[4] = {cos(0.5 * own * end)};
    double lean[4] = {cos(0.5 * tilt)}, q[4], exact[4], off = 0.0;

    /* The frame in which axis z of the box is `axis` of the body. */
    for (int k = 0; k < 4 && axis == 2; k++)
        lay[k] = k == 0 ? 1.0 : 0.0;
    for (int k = 1; k < 4 && axis == 0; k++)
        lay[k] = -0.5;
    t.per_I[axis] = 1.0 / 0.3;
    lean[1 + i] = sin(0.5 * tilt);
    spin[1 + axis] = sin(0.5 * own * end);
    rotation_product(lay, lean, t.q);
    rotation_product(turned, t.q, q);
    rotation_product(q, spin, exact);
    turn(&t, steps, end / steps);
    for (int k = 0; k < 4; k++)
        off = fmax(off, fmin(fabs(t.q[k] - exact[k]), fabs(t.q[k] + exact[k])));
    return off;
}

/* For each of the axes of the body: a step of half the size leaves a quarter of
 * the error. */
FACT_FOR_EACH(dullweber97_a_symmetric_top_goes_round_at_the_exact_rate, 3)
{
    const double coarse = top_error(_i, 400), fine = top_error(_i, 800);

    ck_assert_double_le(fine, 1e-3);
    ck_assert_double_eq_tol(coarse / fine, 4.0, 0.05);
}

/* Of a body whose axes are those of the box, and of one that is as round as a
 * cube, the frame is that of the box to the bit. */
FACT_FOR_EACH(a_frame_that_is_principal_stays_as_it_is, 2)
{
    const double moments[2][3] = {{0.2, 0.5, 0.6}, {0.4, 0.4, 0.4}};
    const double *const own = moments[_i];
    const double G[6] = {own[0], 0.0, 0.0, own[1], 0.0, own[2]};
    double q[4], I[3];

    rotation_principal(G, q, I);
    ck_assert_int_eq(memcmp(q, (double[4]){1.0}, sizeof q), 0);
    ck_assert_int_eq(memcmp(I, own, sizeof I), 0);
}

/* Of an ellipsoid that is turned: what spins about one of its axes has I times
 * the spin as its angular momentum. */
FACT(moments_of_inertia_are_diagonal_in_the_principal_frame)
{
    const double own[3] = {0.2, 0.5, 0.6};
    double q[4] = {0.5, 0.1, -0.7, 0.3}, I[3], Q[3][3], G[6] = {0.0};

    rotation_normalize(q);
    rotation_matrix(q, Q);
    for (int e = 0; e < 9; e++)
        for (int l = e / 3; l < 3; l++)
            G[vector_place(e / 3, l)] +=
                Q[e / 3][e % 3] * own[e % 3] * Q[l][e % 3];
    rotation_principal(G, q, I);
    rotation_matrix(q, Q);
    ck_assert_double_eq_tol(I[0] * I[1] * I[2], 0.06, 1e-15);
    ck_assert_double_eq_tol(I[0] + I[1] + I[2], 1.3, 1e-15);
    for (int k = 0; k < 3; k++) {
        const double per_I[3] = {1.0 / I[0], 1.0 / I[1], 1.0 / I[2]};
        double L[3], w[3];
        for (int e = 0; e < 3; e++)
            L[e] = G[vector_place(e, 0)] * Q[0][k] +
                   G[vector_place(e, 1)] * Q[1][k] +
                   G[vector_place(e, 2)] * Q[2][k];
        rotation_spin(q, L, per_I, w);
        for (int e = 0; e < 3; e++) {
            ck_assert_double_eq_tol(L[e], I[k] * Q[e][k], 1e-15);
            ck_assert_double_eq_tol(w[e], Q[e][k], 1e-15);
        }
    }
}
