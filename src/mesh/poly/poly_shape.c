/* SPDX-License-Identifier: GPL-3.0-or-later */
/* poly_shape.c -- the corners of a mesh, kept for files, pictures and walls. */
#include "mesh/poly/poly_order.h"

#include <stdlib.h>

#include "base/alloc.h"

/* Lists the polygons of each cell, in the order of the files. */
static void list_polygons(const struct poly_raw *r, struct mesh_shape *s)
{
    int *const used = alloc_ints(r->n_cells);

    s->cell_start = alloc_ints(r->n_cells + 1);
    for (int pass = 0; pass < 2; pass++) {
        for (int f = 0; f < r->n_faces; f++)
            for (int side = 0; side < 1 + (f < r->n_inner); side++) {
                const int c =
                    r->number[side == 0 ? r->owner[f] : r->neighbour[f]];
                if (pass == 0) {
                    s->cell_start[c + 1]++;
                    continue;
                }
                s->turned[s->cell_start[c] + used[c]] = side == 0 ? 1 : -1;
                s->polygon[s->cell_start[c] + used[c]++] = f;
            }
        if (pass == 1) break;
        for (int c = 0; c < r->n_cells; c++)
            s->cell_start[c + 1] += s->cell_start[c];
        s->polygon = alloc_ints(s->cell_start[r->n_cells]);
        s->turned = alloc_ints(s->cell_start[r->n_cells]);
    }
    free(used);
}

struct mesh_shape *poly_shape_create(struct poly_raw *r)
{
    struct mesh_shape *const s = alloc_zeroed(1, sizeof *s);

    s->n_points = r->n_points;
    s->n_polygons = r->n_faces;
    list_polygons(r, s);
    s->boundary = poly_boundary_order(r);
    s->point = r->point;
    s->start = r->start;
    s->corner = r->corner;
    r->point = NULL;
    r->start = r->corner = NULL;
    return s;
}
