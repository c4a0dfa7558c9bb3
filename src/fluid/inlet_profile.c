/* SPDX-License-Identifier: GPL-3.0-or-later */
/* inlet_profile.c -- the profiles of an inlet but for the one by a file, and
 * the mean of a function over a face. */
#include "fluid/inlet_profile.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "mesh/measures.h"

/* --- uniform ---------------------------------------------------------------
 */

int inlet_profile_is_given(const struct inlet_profile *profile,
                           const struct boundary_options *o)
{
    return profile->asks == NULL ||
           *(const int *)((const char *)o + profile->keys[0]->given - 1);
}

static int uniform(const struct boundary_request *r, struct boundary *b,
                   char wrong[BOUNDARY_TEXT])
{
    (void)r;
    (void)b;
    (void)wrong;
    return 0;
}

const struct inlet_profile inlet_profile_uniform = {
    .name = "uniform",
    .what = "the same velocity everywhere",
    .equations = "",
    .function = "uniform",
    .create = uniform,
};

/* --- the mean over a face --------------------------------------------------
 */

enum { MOST_CORNERS = 64 }; /* further ones are left out */

/* Seven points of degree 5: barycentric coordinates and weights [Dunavant85].
 */
static double triangle_mean(const double a[3], const double b[3],
                            const double c[3],
                            double (*g)(const void *, const double *),
                            const void *of)
{
    static const double near[2] = {0.470142064105115, 0.101286507323456};
    static const double weight[2] = {0.132394152788506, 0.125939180544827};
    double sum = 0.0, x[3];

    for (int k = 0; k < 3; k++)
        x[k] = (a[k] + b[k] + c[k]) / 3.0;
    sum = 0.225 * g(of, x);
    for (int group = 0; group < 2; group++)
        for (int i = 0; i < 3; i++) {
            const double s = near[group], t = 1.0 - 2.0 * s;
            const double of_a = i == 0 ? t : s, of_b = i == 1 ? t : s;
            for (int k = 0; k < 3; k++)
                x[k] = of_a * a[k] + of_b * b[k] + (1.0 - of_a - of_b) * c[k];
            sum += weight[group] * g(of, x);
        }
    return sum;
}

static double triangle_area(const double a[3], const double b[3],
                            const double c[3])
{
    double u[3], v[3], n[3];

    vector_between(b, a, u);
    vector_between(c, a, v);
    vector_cross(u, v, n);
    return 0.5 * vector_length(n);
}

double inlet_profile_face_mean(const struct mesh *m, int f,
                               double (*g)(const void *of, const double x[3]),
                               const void *of)
{
    double x[MOST_CORNERS][3], middle[3] = {0.0, 0.0, 0.0};
    double sum = 0.0, area = 0.0;
    const int all = mesh_face_corners(m, f, MOST_CORNERS, x);
    const int n = all < MOST_CORNERS ? all : MOST_CORNERS;

    for (int i = 0; i < n; i++)
        vector_along(middle, 1.0 / n, x[i], middle);
    for (int i = 0; i < n; i++) {
        const double *const next = x[(i + 1) % n];
        const double part = triangle_area(middle, x[i], next);
        sum += part * triangle_mean(middle, x[i], next, g, of);
        area += part;
    }
    return sum / area;
}

/* --- a parabola ------------------------------------------------------------
 */

double inlet_profile_parabola_mean(double a, double b)
{
    const double square = a * a + a * b + b * b; /* (b^3 - a^3) / (b - a) */

    return 3.0 * (a + b) - 2.0 * square; /* mean of 6 s (1 - s) */
}

/* Creates a profile that is a parabola in each direction between walls, with
 * the mean 1. */
static int parabola(const struct boundary_request *r, struct boundary *b,
                    char wrong[BOUNDARY_TEXT])
{
    const struct mesh *const m = r->mesh;
    const struct patch *const p = r->patch;
    double *const profile = alloc_doubles(p->n);

    (void)wrong;
    for (int j = 0; j < p->n; j++) {
        const int *const n = m->box.n, c = m->owner[p->first + j];
        const int at[3] = {c % n[0], c / n[0] % n[1], c / n[0] / n[1]};
        profile[j] = 1.0;
        for (int k = 0; k < 3; k++) {
            const double *const x = m->box.edge[k];
            if (mesh_S(m, p->first + j)[k] == 0.0 && r->between_walls[k])
                profile[j] *= inlet_profile_parabola_mean(
                    x[at[k]] / x[n[k]], x[at[k] + 1] / x[n[k]]);
        }
    }
    b->profile = b->memory = profile;
    return 0;
}

const struct inlet_profile inlet_profile_parabola = {
    .name = "parabola",
    .what = "zero at the walls beside the inlet of a plain box, its mean 1",
    .equations = "",
    .function = "inlet_profile_parabola_mean",
    .create = parabola,
};

/* --- a table ---------------------------------------------------------------
 */

/* The profile of an inlet by a table in the case, linear
 * between its rows and constant beyond them. */

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
        profile[j] = inlet_profile_face_mean(r->mesh, r->patch->first + j,
                                             table_profile_value_at, r->says);
    b->profile = b->memory = profile;
    return 0;
}

static const struct key table_keys[] = {
    {"fluid.<patch>.table", KEY_CURVE, "m, -", ">= 0", KEY_OPTIONAL,
     "of the profile `table`: rows of a coordinate and the velocity over that "
     "of the inlet",
     "", "", KEY_AT(boundary_options, table),
     KEY_GIVEN(boundary_options, has_table)},
    {"fluid.<patch>.along", KEY_VECTOR, "-", "", "[0.0, 1.0, 0.0]",
     "direction of that coordinate; its length is 1", "", "",
     KEY_AT(boundary_options, along)},
    KEY_END};

static const struct inlet_profile table_profile = {
    .name = "table",
    .what = "rows of a coordinate and a velocity, on any patch",
    .equations = "",
    .function = "table_profile_value_at",
    .keys = {table_keys},
    .asks = "table",
    .create = table_profile_create,
};

/* --- a formula -------------------------------------------------------------
 */

/* The profile of an inlet by a formula of x, y, z and t.
 * Without t its means over the faces are computed once. */

/* The data of a profile that varies in time, in one piece of memory. */
struct by_formula {
    const struct mesh *mesh;
    int first; /* [-] face of the patch */
    double t;  /* [s] of the evaluation */
    struct formula *formula;
};

static double formula_profile_value_at(const void *of, const double x[3])
{
    const struct by_formula *const p = of;
    return formula_value(p->formula, x, p->t);
}

static double formula_profile_varying(const struct boundary *b, int j, double t)
{
    struct by_formula now = *(const struct by_formula *)b->memory;

    now.t = t;
    return inlet_profile_face_mean(now.mesh, now.first + j,
                                   formula_profile_value_at, &now);
}

static void formula_profile_release(struct boundary *b)
{
    formula_free(((struct by_formula *)b->memory)->formula);
    free(b->memory);
}

static int formula_profile_create(const struct boundary_request *r,
                                  struct boundary *b, char wrong[BOUNDARY_TEXT])
{
    struct formula *const f =
        formula_create(r->says->formula, wrong, BOUNDARY_TEXT);

    if (f == NULL) return 1;
    const struct by_formula p = {r->mesh, r->patch->first, 0.0, f};
    if (formula_varies(f)) {
        struct by_formula *const kept = alloc_zeroed(1, sizeof *kept);
        *kept = p;
        b->memory = kept;
        b->varying = formula_profile_varying;
        b->release = formula_profile_release;
        return 0;
    }
    double *const profile = alloc_doubles(r->patch->n);
    for (int j = 0; j < r->patch->n; j++)
        profile[j] = inlet_profile_face_mean(p.mesh, p.first + j,
                                             formula_profile_value_at, &p);
    b->profile = b->memory = profile;
    formula_free(f);
    return 0;
}

static const struct key formula_keys[] = {
    {"fluid.<patch>.formula", KEY_TEXT, "", "", KEY_OPTIONAL,
     "of the profile `formula`: velocity over that of the inlet, of x, y, z "
     "[m] and t [s], as in \"6*y*(0.41-y)/0.41^2\"",
     "", "", KEY_AT(boundary_options, formula),
     KEY_GIVEN(boundary_options, has_formula)},
    KEY_END};

static const struct inlet_profile formula_profile = {
    .name = "formula",
    .what = "a formula of x, y, z and t, on any patch",
    .equations = "",
    .function = "formula_value",
    .keys = {formula_keys},
    .asks = "formula",
    .create = formula_profile_create,
};

/* --- all -------------------------------------------------------------------
 */

const struct inlet_profile *const inlet_profiles[] = {
    &inlet_profile_uniform, &inlet_profile_parabola, &formula_profile,
    &table_profile,         &file_profile,           NULL};
