/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/motion.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
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

/* Adds its way [m] and its velocity [m/s] a time s [s] after the start. */
static void motion_table_add(const struct motion_table *t, double s,
                             double x[3], double v[3])
{
    const struct motion_row *const last = &t->row[t->n - 1];
    const double times = t->repeat ? floor(s / last->t) : 0.0;
    const double in = s - times * last->t;
    int i = 0, beyond = t->repeat ? t->n - 1 : t->n;

    while (beyond - i > 1) {
        const int middle = (i + beyond) / 2;
        if (in >= t->row[middle].t)
            i = middle;
        else
            beyond = middle;
    }
    const struct motion_row *const r = &t->row[i];
    const double since = in - r->t;
    for (int k = 0; k < 3; k++) {
        x[k] += times * last->x[k] + r->x[k] +
                since * (r->v[k] + 0.5 * since * r->a[k]);
        v[k] += r->v[k] + since * r->a[k];
    }
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

/* --- motion table --------------------------------------------------------- */

/* Where the columns are, and of which kind. */
struct motion_columns {
    int t, value[3], velocities; /* [-] -1: left out; 1: they are velocities */
};

static int motion_table_columns(const struct csv *c, struct motion_columns *at,
                                char wrong[CSV_WRONG])
{
    static const char *const names[2][3] = {{"x", "y", "z"},
                                            {"v_x", "v_y", "v_z"}};
    int found = 0;
    char have[CSV_WRONG / 2];

    at->t = csv_column(c, "t");
    at->velocities = csv_column(c, "v_x") >= 0 || csv_column(c, "v_y") >= 0 ||
                     csv_column(c, "v_z") >= 0;
    for (int k = 0; k < 3; k++) {
        at->value[k] = csv_column(c, names[at->velocities][k]);
        if (at->value[k] < 0) continue;
        found++;
        if (csv_check_unit(c, at->value[k], at->velocities ? "m/s" : "m",
                           wrong) != 0)
            return 1;
    }
    if (at->t >= 0 && found > 0 && found + 1 == c->n_columns)
        return csv_check_unit(c, at->t, "s", wrong);
    csv_names(c, have, (int)sizeof have);
    snprintf(wrong, CSV_WRONG,
             "expected columns t [s] and some of x y z [m] or of v_x v_y v_z "
             "[m/s], found %s",
             have);
    return 1;
}

/* Fills the numbers of the rows: t, and x or v. */
static int motion_table_take(struct motion_table *m, const struct csv *c,
                             const struct motion_columns *at,
                             char wrong[CSV_WRONG])
{
    for (int i = 0; i < m->n; i++) {
        const double *const from = c->value + (long)i * c->n_columns;
        struct motion_row *const r = &m->row[i];
        int fine = number_is_coordinate(from[at->t]) &&
                   (i > 0 ? from[at->t] > r[-1].t : from[at->t] == 0.0);
        r->t = from[at->t];
        for (int k = 0; k < 3; k++) {
            const double u = at->value[k] >= 0 ? from[at->value[k]] : 0.0;
            fine = fine && number_is_coordinate(u);
            (at->velocities ? r->v : r->x)[k] = u;
        }
        if (fine) continue;
        snprintf(wrong, CSV_WRONG,
                 "row %d: expected numbers up to 1e12, and t from 0 on and "
                 "rising",
                 i + 1);
        return 1;
    }
    return 0;
}

/* What follows from row r and the next one: velocity and acceleration until
 * then, and of velocities the place there. */
static void motion_table_join(struct motion_row *r, int velocities)
{
    const double h = r[1].t - r->t;

    for (int k = 0; k < 3; k++) {
        if (velocities) {
            r->a[k] = (r[1].v[k] - r->v[k]) / h;
            r[1].x[k] = r->x[k] + 0.5 * h * (r->v[k] + r[1].v[k]);
        } else {
            r->v[k] = (r[1].x[k] - r->x[k]) / h;
        }
    }
}

static void motion_table_complete(struct motion_table *m, int velocities)
{
    struct motion_row *const last = &m->row[m->n - 1];
    const double start[3] = {m->row->x[0], m->row->x[1], m->row->x[2]};

    for (struct motion_row *r = m->row; r < last; r++) {
        motion_table_join(r, velocities);
        m->fastest = fmax(m->fastest, vector_length(r->v));
    }
    m->fastest = fmax(m->fastest, vector_length(last->v));
    for (struct motion_row *r = m->row; r <= last; r++)
        for (int k = 0; k < 3; k++)
            r->x[k] -= start[k];
    for (int k = 0; k < 3; k++)
        last->v[k] = 0.0;
}

struct motion_table *motion_table_create(const struct input *in, int repeat,
                                         char wrong[CSV_WRONG])
{
    struct motion_columns at;
    struct csv c;

    if (csv_read(&c, in, wrong) != 0) return NULL;
    struct motion_table *m = alloc_zeroed(
        1, sizeof *m + (size_t)c.n_rows * sizeof(struct motion_row));
    m->n = c.n_rows;
    m->repeat = repeat;
    int failed = motion_table_columns(&c, &at, wrong) != 0 ||
                 motion_table_take(m, &c, &at, wrong) != 0;
    if (!failed && m->n < 2)
        failed = snprintf(wrong, CSV_WRONG, "expected two rows or more") > 0;
    if (!failed) motion_table_complete(m, at.velocities);
    if (!failed && !number_is_coordinate(m->fastest))
        failed = snprintf(wrong, CSV_WRONG, "it moves at %g m/s", m->fastest);
    csv_release(&c);
    if (!failed) return m;
    free(m);
    return NULL;
}
