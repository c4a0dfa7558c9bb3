/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly_rows.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

/* The six faces of each cell. Once it has been reached, face 2 k is the one
 * before it in direction k and 2 k + 1 the one behind. */
struct walk {
    const struct poly_raw *r;
    int (*face)[6];
    int (*at)[3];
    char *reached;
};

/* Lists the faces of each cell; 0 if a cell does not have six faces, or a face
 * not four corners. */
static int take_faces(struct walk *w)
{
    const struct poly_raw *const r = w->r;
    int *const used = alloc_ints(r->n_cells);
    int fits = 1;

    for (int f = 0; f < r->n_faces && fits; f++) {
        fits = r->start[f + 1] - r->start[f] == 4;
        for (int side = 0; side < 1 + (f < r->n_inner) && fits; side++) {
            const int c = side == 0 ? r->owner[f] : r->neighbour[f];
            fits = used[c] < 6;
            if (fits) w->face[c][used[c]++] = f;
        }
    }
    for (int c = 0; c < r->n_cells && fits; c++)
        fits = used[c] == 6;
    free(used);
    return fits;
}

static int has_corner(const struct poly_raw *r, int f, int point)
{
    const int *const corner = &r->corner[r->start[f]];
    return corner[0] == point || corner[1] == point || corner[2] == point ||
           corner[3] == point;
}

/* The number of corners that faces f, g and h have in common; with h = g, those
 * of f and g. */
static int poly_rows_common(const struct poly_raw *r, int f, int g, int h)
{
    int n = 0;

    for (int i = r->start[f]; i < r->start[f + 1]; i++)
        n += has_corner(r, g, r->corner[i]) && has_corner(r, h, r->corner[i]);
    return n;
}

/* The face of cell c, other than f, with this many corners in common with f and
 * g; or -1. */
static int poly_rows_find_face(const struct walk *w, int c, int f, int g,
                               int corners)
{
    for (int i = 0; i < 6; i++) {
        const int h = w->face[c][i];
        if (h != f && poly_rows_common(w->r, f, g, h) == corners) return h;
    }
    return -1;
}

/* Puts the faces of cell c in order: `first` gets the number s, and face 2 k
 * has an edge in common with face 2 k of the cell before. 0 if the cell is no
 * hexahedron. */
static int poly_rows_turn(struct walk *w, int c, int first, int s,
                          const int before[6])
{
    int face[6];

    face[s ^ 1] = poly_rows_find_face(w, c, first, first, 0);
    face[s] = first;
    for (int k = 0; k < 6; k += 2) {
        if (k == (s & ~1)) continue;
        face[k] = poly_rows_find_face(w, c, first, before[k], 2);
        if (face[k] < 0) return 0;
        face[k + 1] = poly_rows_find_face(w, c, face[k], face[k], 0);
    }
    for (int i = 0; i < 6; i++)
        if (face[i] < 0) return 0;
    memcpy(w->face[c], face, sizeof face);
    return 1;
}

/* Orders the faces of the first cell: any face, one beside it, and one beside
 * both. */
static int poly_rows_begin(struct walk *w)
{
    const int *const own = w->face[0];
    int face[6] = {own[0], 0, -1, 0, -1, 0};

    for (int i = 1; i < 6; i++) {
        if (poly_rows_common(w->r, own[0], own[i], own[i]) != 2) continue;
        if (face[2] < 0)
            face[2] = own[i];
        else if (poly_rows_common(w->r, face[2], own[i], own[i]) == 2)
            face[4] = own[i];
    }
    if (face[4] < 0) return 0;
    for (int k = 0; k < 6; k += 2) {
        face[k + 1] = poly_rows_find_face(w, 0, face[k], face[k], 0);
        if (face[k + 1] < 0) return 0;
    }
    memcpy(w->face[0], face, sizeof face);
    w->reached[0] = 1;
    return 1;
}

/* Goes from the cells that have been reached to those behind their faces, until
 * there are no more; returns how many have been reached. */
static int poly_rows_walk_on(struct walk *w)
{
    const struct poly_raw *const r = w->r;
    int *const queue = alloc_ints(r->n_cells);
    int n = poly_rows_begin(w);

    for (int done = 0; done < n; done++) {
        const int c = queue[done];
        for (int s = 0; s < 6; s++) {
            const int f = w->face[c][s];
            if (f >= r->n_inner) continue;
            const int next = r->owner[f] == c ? r->neighbour[f] : r->owner[f];
            if (w->reached[next] ||
                !poly_rows_turn(w, next, f, s ^ 1, w->face[c]))
                continue;
            memcpy(w->at[next], w->at[c], sizeof w->at[c]);
            w->at[next][s / 2] += s % 2 ? 1 : -1;
            w->reached[next] = 1;
            queue[n++] = next;
        }
    }
    free(queue);
    return n;
}

/* Integers from 0 on. */
static void shift(int (*at)[3], int n, int extent[3])
{
    for (int k = 0; k < 3; k++) {
        int least = 0, most = 0;
        for (int c = 0; c < n; c++) {
            least = at[c][k] < least ? at[c][k] : least;
            most = at[c][k] > most ? at[c][k] : most;
        }
        for (int c = 0; c < n; c++)
            at[c][k] -= least;
        extent[k] = most - least + 1;
    }
}

int *poly_rows_find(const struct poly_raw *r, int extent[3])
{
    struct walk w = {.r = r};

    w.face = alloc_zeroed((size_t)r->n_cells, sizeof *w.face);
    w.at = alloc_zeroed((size_t)r->n_cells, sizeof *w.at);
    w.reached = alloc_zeroed((size_t)r->n_cells, 1);
    const int all = take_faces(&w) && poly_rows_walk_on(&w) == r->n_cells;

    if (all) shift(w.at, r->n_cells, extent);
    free(w.face);
    free(w.reached);
    if (all) return &w.at[0][0];
    free(w.at);
    return NULL;
}
