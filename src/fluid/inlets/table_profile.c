/* SPDX-License-Identifier: GPL-3.0-or-later */
/* table_profile.c -- the profile of an inlet by a table in the case, linear
 * between its rows and constant beyond them. */
#include "fluid/inlet_profile.h"

#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "fluid/inlets/face_mean.h"

static double table_profile_value_at(const void *of, const double x[3])
{
    const struct boundary_options *const o = of;
    const double *const at = o->table.at, *const u = o->table.value;
    const double s = vector_dot(o->along, x);
    int i = 0;

    if (s <= at[0]) return u[0];
    while (i < o->table.n - 1 && s > at[i + 1])
        i++;
    if (i == o->table.n - 1) return u[i];
    return u[i] + (u[i + 1] - u[i]) * (s - at[i]) / (at[i + 1] - at[i]);
}

static int table_profile_create(const struct boundary_request *r,
                                struct boundary *b, char wrong[BOUNDARY_TEXT])
{
    const double length = vector_length(r->says->along);

    if (fabs(length - 1.0) > 1e-6) {
        snprintf(wrong, BOUNDARY_TEXT,
                 "its rows are along a direction of length 1, not %g; give "
                 "`along`",
                 length);
        return 1;
    }
    double *const profile = alloc_doubles(r->patch->n);
    for (int j = 0; j < r->patch->n; j++)
        profile[j] = face_mean(r->mesh, r->patch->first + j,
                               table_profile_value_at, r->says);
    b->profile = b->memory = profile;
    return 0;
}

static const struct key keys[] = {
    {"fluid.<patch>.table", KEY_CURVE, "m, -", ">= 0", KEY_OPTIONAL,
     "of the profile `table`: rows of a coordinate and the velocity over that "
     "of the inlet",
     "", "", .at = KEY_AT(boundary_options, table),
     .given = KEY_AT(boundary_options, has_table)},
    {"fluid.<patch>.along", KEY_VECTOR, "-", "", "[0.0, 1.0, 0.0]",
     "direction of that coordinate; its length is 1", "", "",
     .at = KEY_AT(boundary_options, along)},
    KEY_END};

const struct inlet_profile table_profile = {
    .name = "table",
    .what = "rows of a coordinate and a velocity, on any patch",
    .equations = "",
    .function = "table_profile_value_at",
    .keys = {keys},
    .asks = "table",
    .create = table_profile_create,
};
