/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_mesh.h"

#include <math.h>
#include <string.h>

/* --- making it ------------------------------------------------------------ */

static struct mesh *
case_mesh_make(const struct settings *s,
               struct mesh *(*make)(const struct box_spec *))
{
    struct mesh *own;
    const struct mesh *const kept = settings_mesh(s);

    if (kept == NULL) return make(&s->mesh.box);
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

    for (int k = 0; k < 3; k++) {
        lo[k] = m == NULL ? 0.0 : m->lo[k];
        hi[k] = s->mesh.box.size[k];
        if (m == NULL) continue;
        const double period = mesh_period(m, k);
        hi[k] = period > 0.0 ? lo[k] + period : m->hi[k];
    }
}

void case_mesh_periodic(const struct settings *s, int periodic[3])
{
    const struct mesh *const m = settings_mesh(s);

    for (int k = 0; k < 3; k++)
        periodic[k] =
            m == NULL ? s->mesh.box.periodic[k] : mesh_period(m, k) > 0.0;
}
