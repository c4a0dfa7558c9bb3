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

static struct mesh *create(const struct settings *s,
                           struct mesh *(*make)(const struct box_spec *))
{
    struct mesh *own;
    const struct mesh *const kept = settings_mesh(s);

    if (kept == NULL) {
        const struct box_spec spec = case_mesh_box(s);
        return make(&spec);
    }
    memcpy(&own, &kept, sizeof own); /* one more holds it; none changes it */
    return mesh_retain(own);
}

struct mesh *case_mesh_create(const struct settings *s)
{
    return create(s, mesh_create_box);
}

struct mesh *case_mesh_outline(const struct settings *s)
{
    return create(s, mesh_outline_box);
}

double case_mesh_cells(const struct settings *s)
{
    const struct mesh *const kept = settings_mesh(s);

    if (kept != NULL) return kept->n_cells;
    if (!settings_has(s, "mesh.cells")) return 0.0;
    const struct box_spec spec = case_mesh_box(s);
    return (double)spec.cells[0] * spec.cells[1] * spec.cells[2];
}

const struct mesh_form *case_mesh_form(const struct settings *s, int from_files)
{
    for (int i = 0; mesh_forms[i] != NULL; i++)
        if ((mesh_forms[i]->read != NULL) == from_files &&
            settings_has(s, mesh_forms[i]->keys[0].path))
            return mesh_forms[i];
    return NULL;
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

/* Of a box the product of its sides. */
double case_mesh_volume(const struct settings *s)
{
    const struct mesh *const m = settings_mesh(s);
    double size[3], sum = 0.0;

    for (int c = 0; m != NULL && c < m->n_cells; c++)
        sum += m->V[c];
    if (m != NULL) return sum;
    settings_vector(s, "mesh.size", size);
    return size[0] * size[1] * size[2];
}

int case_mesh_holds(const struct settings *s, const double x[3])
{
    const struct mesh *const m = settings_mesh(s);
    double lo[3], hi[3], offset[3];

    if (m != NULL) return mesh_cell_and_offset(m, x, offset) >= 0;
    case_mesh_ends(s, lo, hi);
    for (int k = 0; k < 3; k++)
        if (!(x[k] >= lo[k] && x[k] <= hi[k])) return 0;
    return 1;
}
