/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/motion_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

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

void motion_table_add(const struct motion_table *t, double s, double x[3],
                      double v[3])
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
