/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/motion.h"

#include <gsl/gsl_math.h>
#include <string.h>

#include "base/vector.h"

int motion_is_any(const struct motion *m)
{
    return m->carrier != NULL || m->table != NULL ||
           vector_dot(m->velocity, m->velocity) > 0.0 ||
           vector_dot(m->spin, m->spin) > 0.0 ||
           (vector_dot(m->amplitude, m->amplitude) > 0.0 && m->frequency > 0.0);
}

int motion_is_on(const struct motion *m, double t)
{
    return t >= m->from && (m->until == 0.0 || t < m->until);
}

/* How long it has moved. */
static double moved(const struct motion *m, double t)
{
    const double end = m->until > 0.0 ? fmin(t, m->until) : t;
    return fmax(end - m->from, 0.0);
}

/* Q by Rodrigues: cos a 1 + sin a [e]x + (1 - cos a) e e^T, with the axis e
 * and the angle a; exactly 1 where nothing turns. */
static void turn_about(const double spin[3], double s, double Q[3][3])
{
    const double rate = vector_length(spin), a = rate * s;
    const double per_rate = rate > 0.0 ? 1.0 / rate : 0.0;
    const double e[3] = {spin[0] * per_rate, spin[1] * per_rate,
                         spin[2] * per_rate};
    const double ex[3][3] = {
        {0.0, -e[2], e[1]}, {e[2], 0.0, -e[0]}, {-e[1], e[0], 0.0}};

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            Q[i][j] = (i == j ? cos(a) : 0.0) + sin(a) * ex[i][j] +
                      (1.0 - cos(a)) * e[i] * e[j];
}

static struct pose carried_pose(const struct carrier *by, double t)
{
    struct pose p = by->pose;

    vector_along(by->pose.centre, t - by->t, p.velocity, p.centre);
    return p;
}

struct pose motion_pose(const struct motion *m, double t)
{
    if (m->carrier != NULL) return carried_pose(m->carrier, t);
    const double s = moved(m, t), w = 2.0 * M_PI * m->frequency;
    const int on = motion_is_on(m, t);
    struct pose p;
    double unused[3] = {0.0, 0.0, 0.0};

    memcpy(p.start, m->centre, sizeof p.start);
    for (int k = 0; k < 3; k++) {
        p.centre[k] =
            m->centre[k] + m->velocity[k] * s + m->amplitude[k] * sin(w * s);
        p.velocity[k] =
            on ? m->velocity[k] + m->amplitude[k] * w * cos(w * s) : 0.0;
        p.spin[k] = on ? m->spin[k] : 0.0;
    }
    if (m->table != NULL)
        motion_table_add(m->table, s, p.centre, on ? p.velocity : unused);
    turn_about(m->spin, s, p.rotation);
    return p;
}

double motion_speed(const struct motion *m, double reach)
{
    if (m->carrier != NULL)
        return vector_length(m->carrier->pose.velocity) +
               vector_length(m->carrier->pose.spin) * reach;
    return vector_length(m->velocity) +
           2.0 * M_PI * m->frequency * vector_length(m->amplitude) +
           vector_length(m->spin) * reach +
           (m->table != NULL ? m->table->fastest : 0.0);
}

void motion_turn(const struct pose *p, const double start[3], double v[3])
{
    for (int k = 0; k < 3; k++)
        v[k] = vector_dot(p->rotation[k], start);
}

void motion_place(const struct pose *p, const double start[3], double x[3])
{
    double arm[3], turned[3];

    vector_between(start, p->start, arm);
    motion_turn(p, arm, turned);
    vector_along(p->centre, 1.0, turned, x);
}

void motion_origin(const struct pose *p, const double x[3], double start[3])
{
    double arm[3];

    vector_between(x, p->centre, arm);
    for (int k = 0; k < 3; k++)
        start[k] = p->start[k] + p->rotation[0][k] * arm[0] +
                   p->rotation[1][k] * arm[1] + p->rotation[2][k] * arm[2];
}

void motion_velocity(const struct pose *p, const double x[3], double v[3])
{
    double arm[3], around[3];

    vector_between(x, p->centre, arm);
    vector_cross(p->spin, arm, around);
    vector_along(p->velocity, 1.0, around, v);
}
