/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"
#include "mesh/poly/poly.h"

void mesh_free(struct mesh *m)
{
    if (m != NULL && m->reference_count-- == 0) owner_free(m);
}

struct mesh *mesh_retain(struct mesh *m)
{
    m->reference_count++;
    return m;
}

double mesh_period(const struct mesh *m, int k)
{
    const struct box *const b = &m->box;

    if (m->face_centre == NULL)
        return b->periodic[k] ? b->edge[k][b->n[k]] - b->edge[k][0] : 0.0;
    for (int i = 0; i < m->n_periods; i++) {
        const double *const P = m->period[i];
        const double across = fabs(P[(k + 1) % 3]) + fabs(P[(k + 2) % 3]);
        if (across <= 1e-9 * fabs(P[k])) return fabs(P[k]);
    }
    return 0.0;
}

/* The interval of the edges that contains x, or -1 outside. An interval
 * contains its lower end, and the last one both. The search begins with the
 * interval in which x would be if all were equal. */
static int interval_at(const double *edge, int n, double x)
{
    if (!(x >= edge[0] && x <= edge[n])) return -1;
    const double fraction = (x - edge[0]) / (edge[n] - edge[0]);
    int i = number_clamped(fraction * n, 0, n - 1);

    while (i > 0 && x < edge[i])
        i--;
    while (i < n - 1 && x >= edge[i + 1])
        i++;
    return i;
}

/* x, moved by whole periods into [lo, hi). */
static double wrapped(double x, double lo, double hi)
{
    const double y = x - (hi - lo) * floor((x - lo) / (hi - lo));
    return y >= hi || y < lo ? lo : y; /* rounding can land on the end */
}

int mesh_cell_at(const struct mesh *m, double x, double y, double z)
{
    const struct box *const b = &m->box;
    const double point[3] = {x, y, z};
    double offset[3];
    int at[3];

    if (m->bins != NULL) return locate_cell(m, point, offset);
    for (int k = 0; k < 3; k++) {
        const double lo = b->edge[k][0], hi = b->edge[k][b->n[k]];
        const double q = b->periodic[k] ? wrapped(point[k], lo, hi) : point[k];
        at[k] = interval_at(b->edge[k], b->n[k], q);
        if (at[k] < 0) return -1;
    }
    return at[0] + b->n[0] * (at[1] + b->n[1] * at[2]);
}

int mesh_cell_and_offset(const struct mesh *m, const double x[3],
                         double offset[3])
{
    if (m->bins != NULL) return locate_cell(m, x, offset);
    const int c = mesh_cell_at(m, x[0], x[1], x[2]);
    for (int k = 0; k < 3 && c >= 0; k++) {
        const double period = mesh_period(m, k);
        offset[k] = x[k] - m->centre[3 * c + k];
        if (period > 0.0) offset[k] -= period * rint(offset[k] / period);
    }
    return c;
}

const struct patch *mesh_patch(const struct mesh *m, const char *name)
{
    for (int i = 0; i < m->n_patches; i++)
        if (strcmp(m->patches[i].name, name) == 0) return &m->patches[i];
    return NULL;
}

void mesh_allocate(struct mesh *m)
{
    m->V = owner_doubles(m, m->n_cells);
    m->centre = owner_doubles(m, 3 * m->n_cells);
    m->owner = owner_ints(m, m->n_faces);
    m->neighbour = owner_ints(m, m->n_internal);
    if (m->n_S > 0) {
        m->S_at = owner_ints(m, m->n_faces);
        m->d_at = owner_ints(m, m->n_faces);
    } else
        m->n_S = m->n_d = m->n_faces;
    m->S = owner_doubles(m, 3 * m->n_S);
    m->d = owner_doubles(m, 3 * m->n_d);
    m->w = owner_doubles(m, m->n_faces);
    if (m->patches == NULL)
        m->patches = owner_zeroed(m, (size_t)m->n_patches, sizeof *m->patches);
    m->cell_start = owner_ints(m, m->n_cells + 1);
}

double *mesh_links(const struct mesh *m)
{
    double *const link = alloc_doubles(3 * m->n_internal);

    for (int f = 0; f < m->n_internal; f++)
        memcpy(&link[3 * f], mesh_d(m, f), 3 * sizeof *link);
    return link;
}

/* 1 if a component of a is larger than `part` times the length of b. */
static int mesh_larger(const double a[3], double part, const double b[3])
{
    const double limit = part * part * vector_dot(b, b);

    return a[0] * a[0] > limit || a[1] * a[1] > limit || a[2] * a[2] > limit;
}

void mesh_collect_faces(struct mesh *m)
{
    int *const fill = alloc_ints(m->n_cells + 1);

    for (int f = 0; f < m->n_faces; f++) {
        m->cell_start[m->owner[f] + 1]++;
        if (f < m->n_internal) m->cell_start[m->neighbour[f] + 1]++;
    }
    for (int c = 0; c < m->n_cells; c++)
        m->cell_start[c + 1] += m->cell_start[c];
    m->cell_face = owner_ints(m, m->cell_start[m->n_cells]);
    m->out = owner_zeroed(m, (size_t)m->cell_start[m->n_cells], sizeof *m->out);
    for (int f = 0; f < m->n_faces; f++) {
        const int o = m->owner[f];
        m->out[m->cell_start[o] + fill[o]] = 1;
        m->cell_face[m->cell_start[o] + fill[o]++] = f;
        if (f >= m->n_internal) continue;
        const int n = m->neighbour[f];
        m->out[m->cell_start[n] + fill[n]] = -1;
        m->cell_face[m->cell_start[n] + fill[n]++] = f;
    }
    free(fill);
    for (int f = 0; f < m->n_internal; f++) {
        double oblique[3];
        mesh_oblique_part(m, f, oblique);
        if (mesh_larger(oblique, 1e-10, mesh_S(m, f))) m->oblique = 1;
    }
    for (int f = 0; f < m->n_faces && m->face_centre != NULL; f++) {
        double off[3];
        if (mesh_misses_middle(m, f, off)) m->skewed = 1;
    }
    for (int c = 0; c < m->n_cells && m->skewed; c++)
        if (m->cell_start[c + 1] - m->cell_start[c] == 4) m->skewed = 2;
}

void mesh_oblique_part(const struct mesh *m, int f, double oblique[3])
{
    const double *const S = mesh_S(m, f), *const d = mesh_d(m, f);
    vector_along(S, -vector_dot(S, S) / vector_dot(S, d), d, oblique);
}

void mesh_off_middle(const struct mesh *m, int f, double off[3])
{
    const double *const d = mesh_d(m, f), *const S = mesh_S(m, f);

    if (f >= m->n_internal)
        vector_along(d, -vector_dot(S, d) / vector_dot(S, S), S, off);
    else
        for (int k = 0; k < 3; k++)
            off[k] = m->face_centre[3 * f + k] -
                     m->centre[3 * m->owner[f] + k] - (1.0 - m->w[f]) * d[k];
}

int mesh_misses_middle(const struct mesh *m, int f, double off[3])
{
    mesh_off_middle(m, f, off);
    return mesh_larger(off, 1e-6, mesh_d(m, f));
}

/* The keys of the group `mesh`, and the members of struct
 * mesh_options that they fill. */

#define AT(member) KEY_AT(mesh_options, member)

const struct key mesh_keys[] = {
    {"mesh", KEY_GROUP, "", "", NULL,
     "a box and its cells, or a mesh from files", "", "",
     .divided = KEY_DIVIDED},
    {"mesh.size", KEY_VECTOR, "m", "> 0", "",
     "length of the box in x, y, z; y points upward; needed by a box",
     "SX15 Table 1", "", AT(box.size), .divided = KEY_DIVIDED},
    {"mesh.cells", KEY_COUNTS, "-", ">= 1", "",
     "cells in x, y, z; 1 where the flow does not vary; needed by a box",
     "SX15 Table 2", "", AT(box.cells), .mark = KEY_AFTER_BED,
     .divided = KEY_DIVIDED},
    {"mesh.grading", KEY_VECTOR, "-", "> 0", "[1.0, 1.0, 1.0]",
     "width of the last cell over that of the first", "", "", AT(box.grading),
     KEY_GIVEN(mesh_options, has_grading), .divided = KEY_DIVIDED},
    {"mesh.periodic", KEY_FLAGS, "", "", "[false, false, false]",
     "periodic directions", "", "", AT(box.periodic),
     KEY_GIVEN(mesh_options, has_periodic), .divided = KEY_DIVIDED},
    {"mesh.polymesh", KEY_FILE, "", "", "",
     "instead of a box: the folder of an OpenFOAM mesh, beside the case unless "
     "it begins with /; its patches take the place of the sides under fluid",
     "", "", AT(polymesh), .mark = KEY_FOLDER,
     .divided = "only boxes are divided so far"},
    {"mesh.shear", KEY_VECTOR, "-", "", "",
     "shift of the box along x over height y, along x over depth z, along y "
     "over depth z; left out: none",
     "", "", AT(shear), KEY_GIVEN(mesh_options, has_shear),
     .divided = "only boxes are divided so far"},
    KEY_END};
