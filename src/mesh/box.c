/* SPDX-License-Identifier: GPL-3.0-or-later */
/* box.c -- creates the list of faces of a box.
 *
 * Each cell owns the faces on its upper sides: first all faces across x, then
 * the periodic ones across x; then those across y, then z. So the faces between
 * a row of cells and the next row have consecutive numbers, and a loop over
 * them reads contiguous memory (linear/faces.h).
 */
#include "mesh/mesh.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"

const char *const mesh_sides[6] = {"left", "right", "bottom",
                                   "top",  "back",  "front"};

/* The edges of n cells from 0 to size [m]. Each cell is wider than the one
 * before it by the same factor, and the last is `grading` times as wide as the
 * first. */
static double *edges_create(void *owner, double size, int n, double grading)
{
    double *const edge = owner_doubles(owner, n + 1);
    const double factor = n > 1 ? pow(grading, 1.0 / (n - 1)) : 1.0;
    double width = 1.0;

    for (int i = 0; i < n; i++) {
        edge[i + 1] = grading == 1.0 ? i + 1 : edge[i] + width;
        width *= factor;
    }
    const double sum = edge[n];
    for (int i = 0; i <= n; i++)
        edge[i] *= size / sum;
    edge[n] = size;
    return edge;
}

/* The width [m] of cell i along axis k. */
static double width(const struct box *b, int k, int i)
{
    return b->edge[k][i + 1] - b->edge[k][i];
}

static void place_cells(struct mesh *m)
{
    const struct box *const b = &m->box;
    int c = 0;

    for (int k = 0; k < b->n[2]; k++)
        for (int j = 0; j < b->n[1]; j++)
            for (int i = 0; i < b->n[0]; i++, c++) {
                const int at[3] = {i, j, k};
                m->V[c] = 1.0;
                for (int a = 0; a < 3; a++) {
                    m->V[c] *= width(b, a, at[a]);
                    m->centre[3 * c + a] =
                        0.5 * (b->edge[a][at[a]] + b->edge[a][at[a] + 1]);
                }
            }
}

/* The area of the faces of the cell `at` across direction k [m^2]. */
static double face_area(const struct box *b, int k, const int at[3])
{
    const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    return width(b, k1, at[k1]) * width(b, k2, at[k2]);
}

/* The number of the cell at the place (i, j, k), with i fastest. */
static int cell_index(const struct box *b, const int at[3])
{
    return at[0] + b->n[0] * (at[1] + b->n[1] * at[2]);
}

/* Which area vector and which link vector the inner face of cell `at` across
 * direction k has: faces side by side have the same link, those one after the
 * other along k the same area. Those of the boundary are the first. */
static int area_at(const struct mesh *m, int k, const int at[3])
{
    const int *const n = m->box.n, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    int i = m->n_faces - m->n_internal + at[k1] + n[k1] * at[k2];

    for (int a = 0; a < k; a++)
        i += n[(a + 1) % 3] * n[(a + 2) % 3];
    return i;
}

static int link_at(const struct mesh *m, int k, const int at[3])
{
    int i = m->n_faces - m->n_internal + at[k];

    for (int a = 0; a < k; a++)
        i += m->box.n[a];
    return i;
}

/* Sets face f, between `at` and the next cell in direction k. */
static void inner_face(struct mesh *m, int f, int k, const int at[3])
{
    const struct box *const b = &m->box;
    int next[3] = {at[0], at[1], at[2]};
    next[k] = (at[k] + 1) % b->n[k]; /* periodic image */
    const double h0 = width(b, k, at[k]), h1 = width(b, k, next[k]);

    m->owner[f] = cell_index(b, at);
    m->neighbour[f] = cell_index(b, next);
    m->S_at[f] = area_at(m, k, at);
    m->d_at[f] = link_at(m, k, at);
    m->S[3 * m->S_at[f] + k] = face_area(b, k, at);
    m->d[3 * m->d_at[f] + k] = 0.5 * (h0 + h1);
    m->w[f] = h1 / (h0 + h1);
}

/* Sets the inner faces across direction k, those between neighbours or those
 * across the period, numbered from f on; returns the next number. */
static int faces_across(struct mesh *m, int f, int k, int periodic)
{
    const struct box *const b = &m->box;
    int at[3];

    for (at[2] = 0; at[2] < b->n[2]; at[2]++)
        for (at[1] = 0; at[1] < b->n[1]; at[1]++)
            for (at[0] = 0; at[0] < b->n[0]; at[0]++) {
                if ((at[k] == b->n[k] - 1) != periodic) continue;
                inner_face(m, f++, k, at);
            }
    return f;
}

static void box_inner_faces(struct mesh *m)
{
    const struct box *const b = &m->box;
    int f = 0;

    for (int k = 0; k < 3; k++) {
        f = faces_across(m, f, k, 0);
        if (b->periodic[k] && b->n[k] > 1) f = faces_across(m, f, k, 1);
    }
    assert(f == m->n_internal);
}

/* Sets the faces of the lower (side 0) or upper (1) end of direction k,
 * numbered from `first` on; returns the next number. */
static int box_end_faces(struct mesh *m, int first, int k, int side)
{
    const struct box *const b = &m->box;
    const int k1 = k == 0 ? 1 : 0, k2 = k == 2 ? 1 : 2;
    int f = first, at[3];

    at[k] = side == 0 ? 0 : b->n[k] - 1;
    for (at[k2] = 0; at[k2] < b->n[k2]; at[k2]++)
        for (at[k1] = 0; at[k1] < b->n[k1]; at[k1]++, f++) {
            const double out = side == 0 ? -1.0 : 1.0;
            const int i = f - m->n_internal;
            m->owner[f] = cell_index(b, at);
            m->S_at[f] = m->d_at[f] = i;
            m->S[3 * i + k] = out * face_area(b, k, at);
            m->d[3 * i + k] = out * 0.5 * width(b, k, at[k]);
        }
    return f;
}

static void boundary_faces(struct mesh *m)
{
    int f = m->n_internal, p = 0;

    for (int k = 0; k < 3; k++)
        for (int side = 0; side < 2 && !m->box.periodic[k]; side++, p++) {
            assert(f == m->patches[p].first);
            f = box_end_faces(m, f, k, side);
        }
    assert(f == m->n_faces);
}

/* The inner faces are those between neighbours, and a layer across a period of
 * more than one cell. */
static void count_faces(struct mesh *m)
{
    const struct box *const b = &m->box;

    for (int k = 0; k < 3; k++)
        m->n_internal +=
            m->n_cells / b->n[k] * (b->n[k] - !(b->periodic[k] && b->n[k] > 1));
    m->n_faces = m->n_internal;
    m->patches = owner_zeroed(m, 6, sizeof *m->patches);
    for (int k = 0; k < 3; k++)
        for (int side = 0; side < 2 && !b->periodic[k]; side++) {
            struct patch *const patch = &m->patches[m->n_patches++];
            snprintf(patch->name, sizeof patch->name, "%s",
                     mesh_sides[2 * k + side]);
            patch->first = m->n_faces;
            patch->n = m->n_cells / b->n[k];
            m->n_faces += patch->n;
        }
}

struct mesh *mesh_outline_box(const struct box_spec *spec)
{
    struct mesh *const m = owner_create(sizeof *m);

    for (int k = 0; k < 3; k++) {
        m->box.n[k] = spec->cells[k];
        m->box.periodic[k] = spec->periodic[k];
        m->box.edge[k] =
            edges_create(m, spec->size[k], spec->cells[k], spec->grading[k]);
        m->hi[k] = spec->size[k];
    }
    m->n_cells = spec->cells[0] * spec->cells[1] * spec->cells[2];
    count_faces(m);
    return m;
}

struct mesh *mesh_create_box(const struct box_spec *spec)
{
    struct mesh *const m = mesh_outline_box(spec);

    assert(m->n_faces <= MESH_MOST_FACES);
    m->n_S = m->n_d = m->n_faces - m->n_internal;
    for (int k = 0; k < 3; k++) {
        m->n_S += m->n_cells / m->box.n[k];
        m->n_d += m->box.n[k];
    }
    mesh_allocate(m);
    place_cells(m);
    box_inner_faces(m);
    boundary_faces(m);
    mesh_collect_faces(m);
    return m;
}
