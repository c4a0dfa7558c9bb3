/* tetrahedra.h -- meshes of tetrahedra, for tests: n[0] x n[1] x n[2] blocks of
 * a unit cube, each cut into six along a diagonal, with inner points that are
 * moved about, and then bent into the shape wanted. */
#ifndef TETRAHEDRA_H
#define TETRAHEDRA_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "mesh/poly/poly.h"

/* Three points of a tetrahedron in ascending order, its cell, and its point
 * beyond. */
struct tetrahedra_side {
    int corner[3], cell, beyond;
};

static int tetrahedra_compare(const void *a, const void *b)
{
    const struct tetrahedra_side *const p = a, *const q = b;
    int by = 0;

    for (int k = 0; k < 3 && by == 0; k++)
        by = p->corner[k] - q->corner[k];
    return by != 0 ? by : p->cell - q->cell;
}

static int tetrahedra_ascend(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* The four sides of a cell. */
static void tetrahedra_sides(const int corner[4], int cell,
                             struct tetrahedra_side *to)
{
    for (int i = 0; i < 4; i++) {
        int k = 0;
        for (int j = 0; j < 4; j++)
            if (j != i) to[i].corner[k++] = corner[j];
        qsort(to[i].corner, 3, sizeof(int), tetrahedra_ascend);
        to[i].cell = cell;
        to[i].beyond = corner[i];
    }
}

/* The six ways along the edges of a cube from its first to its last corner make
 * six tetrahedra. */
static int tetrahedra_cut(const int n[3], struct tetrahedra_side *side)
{
    static const int way[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                  {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const int stride[3] = {1, n[0] + 1, (n[0] + 1) * (n[1] + 1)};
    int cells = 0;

    for (int b = 0; b < n[0] * n[1] * n[2]; b++) {
        const int first = b % n[0] * stride[0] + b / n[0] % n[1] * stride[1] +
                          b / (n[0] * n[1]) * stride[2];
        for (int w = 0; w < 6; w++, cells++) {
            int corner[4] = {first, 0, 0, 0};
            for (int k = 0; k < 3; k++)
                corner[k + 1] = corner[k] + stride[way[w][k]];
            tetrahedra_sides(corner, cells, &side[4 * cells]);
        }
    }
    return cells;
}

/* Adds a face of a cell, turned so that its area points out of it. */
static void tetrahedra_face(struct poly_raw *r, const struct tetrahedra_side *s)
{
    const double *const a = &r->point[3 * s->corner[0]];
    const double *const b = &r->point[3 * s->corner[1]];
    const double *const c = &r->point[3 * s->corner[2]];
    const double *const e = &r->point[3 * s->beyond];
    int *const to = &r->corner[3 * r->n_faces];
    double volume = 0.0;

    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        volume += (e[k] - a[k]) * ((b[i] - a[i]) * (c[j] - a[j]) -
                                   (b[j] - a[j]) * (c[i] - a[i]));
    }
    memcpy(to, s->corner, sizeof s->corner);
    if (volume > 0.0) to[0] = s->corner[1], to[1] = s->corner[0];
    r->owner[r->n_faces++] = s->cell;
    r->start[r->n_faces] = 3 * r->n_faces;
}

/* The end of the cube in which all three points lie: 2 k + 1 at the upper end
 * of direction k. */
static int tetrahedra_end(const int n[3], const struct tetrahedra_side *s)
{
    for (int end = 0; end < 6; end++) {
        int all = 1;
        for (int i = 0; i < 3; i++) {
            const int p = s->corner[i], m = (n[0] + 1) * (n[1] + 1);
            const int at[3] = {p % (n[0] + 1), p % m / (n[0] + 1), p / m};
            all = all && at[end / 2] == (end % 2 ? n[end / 2] : 0);
        }
        if (all) return end;
    }
    return -1;
}

static void tetrahedra_faces(struct poly_raw *r, const int n[3],
                             struct tetrahedra_side *side)
{
    static const char *const names[6] = {"left", "right", "bottom",
                                         "top",  "back",  "front"};
    const int sides = 4 * r->n_cells;

    qsort(side, (size_t)sides, sizeof *side, tetrahedra_compare);
    for (int i = 0; i + 1 < sides; i++)
        if (memcmp(side[i].corner, side[i + 1].corner, sizeof side->corner) ==
            0) {
            tetrahedra_face(r, &side[i]);
            r->neighbour[r->n_inner++] = side[++i].cell;
        }
    for (int end = 0; end < 6; end++) {
        struct poly_part *const part = &r->part[r->n_parts++];
        snprintf(part->name, sizeof part->name, "%s", names[end]);
        snprintf(part->type, sizeof part->type, "patch");
        part->first = r->n_faces;
        for (int i = 0; i < sides; i++)
            if (tetrahedra_end(n, &side[i]) == end)
                tetrahedra_face(r, &side[i]);
        part->n = r->n_faces - part->first;
    }
}

/* shake: by how much of a block the inner points are moved, at most [-]; bend:
 * where the points of the unit cube go; NULL: nowhere. */
static struct mesh *tetrahedra_create(const int n[3], double shake,
                                      void (*bend)(double x[3]))
{
    const int blocks = n[0] * n[1] * n[2], points = (n[0] + 1) * (n[1] + 1);
    struct poly_raw r = {.n_cells = 6 * blocks};
    struct tetrahedra_side *const side =
        alloc_zeroed((size_t)(24 * blocks), sizeof *side);
    uint64_t seed = 7;

    r.n_points = points * (n[2] + 1);
    r.point = alloc_doubles(3 * r.n_points);
    r.part = alloc_zeroed(6, sizeof *r.part);
    r.start = alloc_ints(24 * blocks + 1);
    r.corner = alloc_ints(72 * blocks);
    r.owner = alloc_ints(24 * blocks);
    r.neighbour = alloc_ints(24 * blocks);
    for (int p = 0; p < r.n_points; p++) {
        const int at[3] = {p % (n[0] + 1), p % points / (n[0] + 1), p / points};
        for (int k = 0; k < 3; k++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            const double off = (double)(seed >> 11) / 4503599627370496.0 - 1.0;
            const int inner = at[k] > 0 && at[k] < n[k];
            r.point[3 * p + k] = (at[k] + (inner ? shake * off : 0.0)) / n[k];
        }
        if (bend != NULL) bend(&r.point[3 * p]);
    }
    tetrahedra_cut(n, side);
    tetrahedra_faces(&r, n, side);
    struct mesh *const m = poly_build(&r, "tetrahedra");
    poly_raw_release(&r);
    free(side);
    return m;
}

#endif
