/* SPDX-License-Identifier: GPL-3.0-or-later */
/* formula_profile.c -- the profile of an inlet by a formula of x, y, z and t.
 * Without t its means over the faces are computed once. */
#include "fluid/inlet_profile.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "fluid/inlets/face_mean.h"
#include "fluid/inlets/formula.h"

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
    return face_mean(now.mesh, now.first + j, formula_profile_value_at, &now);
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
        profile[j] =
            face_mean(p.mesh, p.first + j, formula_profile_value_at, &p);
    b->profile = b->memory = profile;
    formula_free(f);
    return 0;
}

static const struct key keys[] = {
    {"fluid.<patch>.formula", KEY_TEXT, "", "", KEY_OPTIONAL,
     "of the profile `formula`: velocity over that of the inlet, of x, y, z "
     "[m] and t [s], as in \"6*y*(0.41-y)/0.41^2\"",
     "", "", .at = KEY_AT(boundary_options, formula),
     .given = KEY_AT(boundary_options, has_formula)},
    KEY_END};

const struct inlet_profile formula_profile = {
    .name = "formula",
    .what = "a formula of x, y, z and t, on any patch",
    .equations = "",
    .function = "formula_value",
    .keys = {keys},
    .asks = "formula",
    .create = formula_profile_create,
};
