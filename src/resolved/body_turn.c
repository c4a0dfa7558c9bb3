/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_turn.h"

#include <math.h>

#include "base/vector.h"

/* Q of the quaternion s + v. */
static void body_turn_set_rotation(const double q[4], double Q[3][3])
{
    const double s = q[0], *const v = &q[1];
    const double cross[3][3] = {
        {0.0, -v[2], v[1]}, {v[2], 0.0, -v[0]}, {-v[1], v[0], 0.0}};

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            Q[i][j] = (i == j ? s * s - vector_dot(v, v) : 0.0) +
                      2.0 * (v[i] * v[j] + s * cross[i][j]);
}

/* q becomes the rotation by omega dt after q, of length 1. */
static void body_turn_step(double q[4], const double w[3], double dt)
{
    const double rate = vector_length(w), half = 0.5 * rate * dt;
    const double c = cos(half), per = sin(half) / rate;
    const double r[3] = {per * w[0], per * w[1], per * w[2]};
    const double *const v = &q[1];
    double next[4], turned[3];

    vector_cross(r, v, turned);
    next[0] = c * q[0] - vector_dot(r, v);
    for (int k = 0; k < 3; k++)
        next[1 + k] = c * v[k] + q[0] * r[k] + turned[k];
    const double length =
        sqrt(next[0] * next[0] + vector_dot(&next[1], &next[1]));
    for (int k = 0; k < 4; k++)
        q[k] = next[k] / length;
}

void body_turn_begin(struct solid_bodies *b)
{
    for (int i = 0; i < b->ps->n; i++)
        b->turn[4 * i] = 1.0;
}

void body_turn_load(struct solid_bodies *b)
{
    for (int i = 0; i < b->ps->n; i++)
        body_turn_set_rotation(&b->turn[4 * i], b->shape[i].turn);
}

void body_turn_advance(struct solid_bodies *b, double dt)
{
    const struct particles *const ps = b->ps;

    for (int i = 0; i < ps->n; i++) {
        const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};
        if (b->shape[i].kind != BODY_OUTLINE || !(vector_dot(w, w) > 0.0))
            continue;
        body_turn_step(&b->turn[4 * i], w, dt);
        body_turn_set_rotation(&b->turn[4 * i], b->shape[i].turn);
    }
}

static const int at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

void body_turn_times(const double G[6], const double v[3], double product[3])
{
    for (int k = 0; k < 3; k++)
        product[k] =
            G[at[k][0]] * v[0] + G[at[k][1]] * v[1] + G[at[k][2]] * v[2];
}

void body_turn_gyration(const struct solid_bodies *b, int i, double G[6])
{
    const struct body_shape *const shape = &b->shape[i];
    const double(*const Q)[3] = shape->turn;

    for (int k = 0; k < 3; k++)
        for (int l = k; l < 3; l++) {
            double half[3];
            body_turn_times(shape->outline->gyration, Q[l], half);
            G[at[k][l]] = vector_dot(Q[k], half);
        }
}
