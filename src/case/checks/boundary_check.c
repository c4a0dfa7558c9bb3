/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/boundary_check.h"

#include <stdlib.h>

#include "case/boundaries/inlet_builder.h"
#include "case/build_boundaries.h"
#include "case/case_mesh.h"

/* 1 if the boundary has what is only found right by building it. */
static int needs_arrays(const struct settings *s, const struct patch *p)
{
    char path[BUILD_BOUNDARIES_PATH];

    return build_boundaries_has(s, p, "rotation", path) ||
           (build_boundaries_has(s, p, "profile", path) &&
            inlet_builder_is_checked(s, p));
}

int boundary_check(const struct settings *s)
{
    struct mesh *m = case_mesh_outline(s);
    int failed = 0, needs = 0;

    for (int i = 0; i < m->n_patches; i++)
        needs |= needs_arrays(s, &m->patches[i]);
    mesh_free(m);
    if (!needs) return 0;
    m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m);
    failed = all == NULL;
    if (!failed) build_boundaries_free(all, m->n_patches);
    mesh_free(m);
    return failed ? 2 : 0;
}
