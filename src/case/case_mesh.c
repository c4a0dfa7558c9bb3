/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_mesh.h"

#include <math.h>
#include <string.h>

/* --- making it ------------------------------------------------------------ */

struct box_spec case_mesh_box(const struct settings *s)
{
    struct box_spec spec;

    settings_vector(s, "mesh.size", spec.size);
    settings_counts(s, "mesh.cells", spec.cells);
    settings_vector(s, "mesh.grading", spec.grading);
    settings_flags(s, "mesh.periodic", spec.periodic);
    return spec;
}

static struct mesh *
case_mesh_make(const struct settings *s,
               struct mesh *(*make)(const struct box_spec *))
{
    struct mesh *own;
    const struct mesh *const kept = settings_mesh(s);

    if (kept == NULL) {
        const struct box_spec spec = case_mesh_box(s);
        return make(&spec);
    }
    memcpy(&own, &kept,
           sizeof own); /* a further reference; nobody changes the mesh */
    return mesh_retain(own);
}

struct mesh *case_mesh_create(const struct settings *s)
{
    return case_mesh_make(s, mesh_create_box);
}

struct mesh *case_mesh_outline(const struct settings *s)
{
    return case_mesh_make(s, mesh_outline_box);
}

/* --- where it is ---------------------------------------------------------- */

void case_mesh_ends(const struct settings *s, double lo[3], double hi[3])
{
    const struct mesh *const m = settings_mesh(s);

    if (m == NULL) settings_vector(s, "mesh.size", hi);
    for (int k = 0; k < 3; k++) {
        lo[k] = m == NULL ? 0.0 : m->lo[k];
        if (m == NULL) continue;
        const double period = mesh_period(m, k);
        hi[k] = period > 0.0 ? lo[k] + period : m->hi[k];
    }
}

void case_mesh_periodic(const struct settings *s, int periodic[3])
{
    const struct mesh *const m = settings_mesh(s);

    if (m == NULL) settings_flags(s, "mesh.periodic", periodic);
    for (int k = 0; k < 3 && m != NULL; k++)
        periodic[k] = mesh_period(m, k) > 0.0;
}
