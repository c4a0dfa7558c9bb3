/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

/* The rows of a mesh of hexahedra: the three integers of each cell, which begin
 * at 0, and how many values they have in each direction; the caller frees the
 * list. NULL if a cell is no hexahedron, or not all are reached. */
static int *poly_rows_find(const struct poly_raw *r, int extent[3]);

/* The neighbours of each cell, a row for each. */
static void neighbours_of(const struct poly_raw *r, int *start, int *beside)
{
    int *const used = alloc_ints(r->n_cells);

    for (int f = 0; f < r->n_inner; f++) {
        start[r->owner[f] + 1]++;
        start[r->neighbour[f] + 1]++;
    }
    for (int c = 0; c < r->n_cells; c++)
        start[c + 1] += start[c];
    for (int f = 0; f < r->n_inner; f++) {
        const int o = r->owner[f], n = r->neighbour[f];
        beside[start[o] + used[o]++] = n;
        beside[start[n] + used[n]++] = o;
    }
    free(used);
}

/* Numbers the cells as Cuthill and McKee do, breadth-first from one cell; if
 * cells remain, it starts again from the first of these. */
static int *number_in_waves(const struct poly_raw *r)
{
    int *const start = alloc_ints(r->n_cells + 1);
    int *const beside = alloc_ints(2 * r->n_inner);
    int *const queue = alloc_ints(r->n_cells);
    int *const number = alloc_ints(r->n_cells);
    int n = 0, done = 0;

    neighbours_of(r, start, beside);
    for (int c = 0; c < r->n_cells; c++)
        number[c] = -1;
    for (int first = 0; first < r->n_cells; first++) {
        if (number[first] >= 0) continue;
        queue[n] = first;
        number[first] = n++;
        for (; done < n; done++)
            for (int e = start[queue[done]]; e < start[queue[done] + 1]; e++) {
                const int c = beside[e];
                if (number[c] >= 0) continue;
                queue[n] = c;
                number[c] = n++;
            }
    }
    free(start);
    free(beside);
    free(queue);
    return number;
}

/* The sum over the inner faces of the differences of the numbers of their
 * cells. */
static double poly_order_spread(const struct poly_raw *r, const int *number)
{
    double sum = 0.0;

    for (int f = 0; f < r->n_inner; f++)
        sum += abs(number[r->neighbour[f]] - number[r->owner[f]]);
    return sum;
}

/* 0, 1, ... n - 1. */
static int *in_order(int n)
{
    int *const order = alloc_ints(n);

    for (int i = 0; i < n; i++)
        order[i] = i;
    return order;
}

/* Sorts the numbers in `order` by their keys 0 .. n_keys - 1; those with equal
 * keys stay in their order. */
static void sort_by(const int *key, int n_keys, int n, int *order)
{
    int *const next = alloc_ints(n_keys + 1), *const old = alloc_ints(n);

    memcpy(old, order, (size_t)n * sizeof *order);
    for (int i = 0; i < n; i++)
        next[key[order[i]] + 1]++;
    for (int k = 0; k < n_keys; k++)
        next[k + 1] += next[k];
    for (int i = 0; i < n; i++)
        order[next[key[old[i]]]++] = old[i];
    free(next);
    free(old);
}

enum { ROW = 8 }; /* least average number of faces in a row */

/* By the difference, and where it is equal, by the lower number; but not where
 * too few faces in this order form rows. */
int *poly_face_order(int n, int n_cells, const int *a, const int *b,
                     int *in_rows)
{
    int *const least = alloc_ints(n), *const distance = alloc_ints(n);
    int *order = in_order(n), rows = 0;

    for (int i = 0; i < n; i++) {
        least[i] = a[i] < b[i] ? a[i] : b[i];
        distance[i] = abs(b[i] - a[i]);
    }
    sort_by(least, n_cells, n, order);
    sort_by(distance, n_cells, n, order);
    for (int i = 0; i < n; i++)
        rows += i == 0 || distance[order[i]] != distance[order[i - 1]] ||
                least[order[i]] != least[order[i - 1]] + 1;
    *in_rows = (long)rows * ROW <= n;
    if (!*in_rows) {
        free(order);
        order = in_order(n);
        sort_by(least, n_cells, n, order);
    }
    free(least);
    free(distance);
    return order;
}

static int has_rows(const struct poly_raw *r, const int *number)
{
    int *const a = alloc_ints(r->n_inner), *const b = alloc_ints(r->n_inner);
    int found;

    for (int f = 0; f < r->n_inner; f++) {
        a[f] = number[r->owner[f]];
        b[f] = number[r->neighbour[f]];
    }
    free(poly_face_order(r->n_inner, r->n_cells, a, b, &found));
    free(a);
    free(b);
    return found;
}

/* Numbers the cells by their three integers, with consecutive numbers along the
 * longest direction; NULL if they have none. */
static int *number_in_rows(const struct poly_raw *r)
{
    int extent[3], by[3] = {0, 1, 2};
    int *const at = poly_rows_find(r, extent);

    if (at == NULL) return NULL;
    int *const order = in_order(r->n_cells), *const key =
                                                 alloc_ints(r->n_cells);
    int *const number = alloc_ints(r->n_cells);
    for (int i = 0; i < 3; i++) /* longest first, else as they come */
        for (int j = i; j > 0 && extent[by[j]] > extent[by[j - 1]]; j--) {
            const int k = by[j];
            by[j] = by[j - 1];
            by[j - 1] = k;
        }
    for (int i = 0; i < 3; i++) {
        for (int c = 0; c < r->n_cells; c++)
            key[c] = at[3 * c + by[i]];
        sort_by(key, extent[by[i]], r->n_cells, order);
    }
    for (int i = 0; i < r->n_cells; i++)
        number[order[i]] = i;
    free(at);
    free(order);
    free(key);
    return number;
}

/* Keeps the numbering that gives neighbours the closer numbers; if both are
 * equal, that of the files. */
void poly_number_cells(struct poly_raw *r)
{
    int *const filed = in_order(r->n_cells), *other = number_in_rows(r);
    const double far = poly_order_spread(r, filed);
    const int rows = has_rows(r, filed);
    int better = other != NULL && has_rows(r, other) &&
                 (!rows || poly_order_spread(r, other) < far);

    if (!better && !rows) {
        free(other);
        other = number_in_waves(r);
        better = poly_order_spread(r, other) < far;
    }
    r->number = better ? other : filed;
    free(better ? filed : other);
}

/* If cells have several faces in a patch, the first faces of all cells come
 * first, then the second ones, so that they form rows, too. */
static void sort_patch(const struct poly_raw *r, int n, int *face, int *key,
                       int *met)
{
    for (int i = 0; i < n; i++)
        key[face[i]] = r->number[r->owner[face[i]]];
    sort_by(key, r->n_cells, n, face);
    for (int i = 0; i < n; i++)
        key[face[i]] = met[r->owner[face[i]]]++;
    for (int i = 0; i < n; i++)
        met[r->owner[face[i]]] = 0;

    int most = 0;

    for (int i = 0; i < n; i++)
        most = key[face[i]] > most ? key[face[i]] : most;
    sort_by(key, most + 1, n, face);
}

int *poly_boundary_order(const struct poly_raw *r)
{
    int *const order = alloc_ints(r->n_faces - r->n_inner);
    int *const key = alloc_ints(r->n_faces), *const met =
                                                 alloc_ints(r->n_cells);
    int n = 0;

    for (int i = 0; i < r->n_parts; i++) {
        const struct poly_part *const part = &r->part[i];
        if (part->periodic_index != 0) continue;
        for (int j = 0; j < part->n; j++)
            order[n + j] = part->first + j;
        sort_patch(r, part->n, order + n, key, met);
        n += part->n;
    }
    free(key);
    free(met);
    return order;
}

/* --- rows
 *
 * A row leads from a cell through a face and then through the face opposite to
 * it. Starting from one cell, every other cell is thus assigned three integers,
 * like the cells of a box, whatever the numbering and the shape of the block.
 *
 * The six faces of each cell. Once it has been reached, face 2 k is the one
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

static int *poly_rows_find(const struct poly_raw *r, int extent[3])
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
