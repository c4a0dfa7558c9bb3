/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sheared.c -- a sheared box: a parallelepiped.
 *
 * Each height y is moved along x by shear[0] y, each depth z along x by
 * shear[1] z and along y by shear[2] z. Volumes stay, as the map has the
 * determinant 1. The mesh is built as if its points and faces came from files;
 * a periodic direction is a pair of cyclic patches.
 */
#include "mesh/poly/poly.h"

#include <stdio.h>

#include "base/alloc.h"

/* The point at a corner of the cells. */
static int point_at(const int n[3], int i, int j, int k)
{
    return i + (n[0] + 1) * (j + (n[1] + 1) * k);
}

static void set_points(struct poly_raw *r, const struct box *b,
                       const double shear[3])
{
    const int *const n = b->n;
    int p = 0;

    r->n_points = (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
    r->point = alloc_doubles(3 * r->n_points);
    for (int k = 0; k <= n[2]; k++)
        for (int j = 0; j <= n[1]; j++)
            for (int i = 0; i <= n[0]; i++, p++) {
                const double y = b->edge[1][j], z = b->edge[2][k];
                r->point[3 * p] = b->edge[0][i] + shear[0] * y + shear[1] * z;
                r->point[3 * p + 1] = y + shear[2] * z;
                r->point[3 * p + 2] = z;
            }
}

/* The four corners of the face of cell `at` on the lower or upper side of
 * direction k, turned so that its area points out of it. */
static void sheared_add_face(struct poly_raw *r, const int n[3],
                             const int at[3], int k, int upper)
{
    static const int round[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    int *const corner = &r->corner[4 * r->n_faces];

    for (int c = 0; c < 4; c++) {
        const int turn = upper ? c : 3 - c;
        int p[3];
        p[k] = at[k] + upper;
        p[k1] = at[k1] + round[turn][0];
        p[k2] = at[k2] + round[turn][1];
        corner[c] = point_at(n, p[0], p[1], p[2]);
    }
    r->owner[r->n_faces] = at[0] + n[0] * (at[1] + n[1] * at[2]);
    r->n_faces++;
    r->start[r->n_faces] = 4 * r->n_faces;
}

static void sheared_inner_faces(struct poly_raw *r, const int n[3])
{
    const int stride[3] = {1, n[0], n[0] * n[1]};
    int at[3];

    for (at[2] = 0; at[2] < n[2]; at[2]++)
        for (at[1] = 0; at[1] < n[1]; at[1]++)
            for (at[0] = 0; at[0] < n[0]; at[0]++)
                for (int k = 0; k < 3; k++) {
                    if (at[k] == n[k] - 1) continue;
                    sheared_add_face(r, n, at, k, 1);
                    r->neighbour[r->n_inner++] =
                        r->owner[r->n_faces - 1] + stride[k];
                }
}

/* Adds the faces of one end. Their partners at the other end have the same
 * order, so that a period joins them. */
static void sheared_end_faces(struct poly_raw *r, const struct box *b, int k,
                              int upper)
{
    struct poly_part *const part = &r->part[r->n_parts++];
    const int *const n = b->n, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    int at[3];

    snprintf(part->name, sizeof part->name, "%s", mesh_sides[2 * k + upper]);
    snprintf(part->other, sizeof part->other, "%s", mesh_sides[2 * k + !upper]);
    snprintf(part->type, sizeof part->type, "%s",
             b->periodic[k] ? "cyclic" : "patch");
    part->first = r->n_faces;
    at[k] = upper ? n[k] - 1 : 0;
    for (at[k2] = 0; at[k2] < n[k2]; at[k2]++)
        for (at[k1] = 0; at[k1] < n[k1]; at[k1]++)
            sheared_add_face(r, n, at, k, upper);
    part->n = r->n_faces - part->first;
}

struct mesh *mesh_create_sheared(const struct box_spec *spec,
                                 const double shear[3])
{
    struct mesh *const straight = mesh_create_box(spec);
    const struct box *const b = &straight->box;
    struct poly_raw r = {.n_cells = straight->n_cells};
    int most = 0;

    for (int k = 0; k < 3; k++)
        most += straight->n_cells / b->n[k] * (b->n[k] + 1);
    r.part = alloc_zeroed(6, sizeof *r.part);
    r.start = alloc_ints(most + 1);
    r.corner = alloc_ints(4 * most);
    r.owner = alloc_ints(most);
    r.neighbour = alloc_ints(most);
    set_points(&r, b, shear);
    sheared_inner_faces(&r, b->n);
    for (int k = 0; k < 3; k++)
        for (int upper = 0; upper < 2; upper++)
            sheared_end_faces(&r, b, k, upper);
    struct mesh *const m = poly_build(&r, "the sheared box");
    poly_raw_release(&r);
    mesh_free(straight);
    return m;
}
