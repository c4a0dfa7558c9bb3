/* SPDX-License-Identifier: GPL-3.0-or-later */
/* blocks.h -- meshes of bricks, some left out, all mapped to other positions:
 * boxes with steps, wedges, tubes. For tests. */
#ifndef BLOCKS_H
#define BLOCKS_H

#include "base/alloc.h"
#include "mesh/poly/poly.h"

#include <check.h>
#include <stdio.h>

struct blocks {
    int n[3];                      /* bricks, of width 1 before the move */
    int (*there)(const int at[3]); /* or NULL: all of them */
    void (*move)(double x[3]);     /* or NULL: not moved */
};

/* The number of bricks among the first n. */
static inline int blocks_count(const struct blocks *b, int n)
{
    int count = 0;

    for (int e = 0; e < n; e++) {
        const int at[3] = {e % b->n[0], e / b->n[0] % b->n[1],
                           e / b->n[0] / b->n[1]};
        count += b->there == NULL || b->there(at);
    }
    return count;
}

/* The number of the cell, or -1. */
static inline int blocks_number(const struct blocks *b, const int at[3])
{
    for (int k = 0; k < 3; k++)
        if (at[k] < 0 || at[k] >= b->n[k]) return -1;
    if (b->there != NULL && !b->there(at)) return -1;
    return blocks_count(b, at[0] + b->n[0] * (at[1] + b->n[1] * at[2]));
}

/* The face of brick `at` on one side of direction k, its normal out of it. */
static inline void blocks_face(const struct blocks *b, struct poly_raw *r,
                               const int at[3], int k, int upper)
{
    static const int round[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

    for (int c = 0; c < 4; c++) {
        const int *const t = round[upper ? c : 3 - c];
        int p[3];
        p[k] = at[k] + upper;
        p[(k + 1) % 3] = at[(k + 1) % 3] + t[0];
        p[(k + 2) % 3] = at[(k + 2) % 3] + t[1];
        r->corner[4 * r->n_faces + c] =
            p[0] + (b->n[0] + 1) * (p[1] + (b->n[1] + 1) * p[2]);
    }
    r->owner[r->n_faces++] = blocks_number(b, at);
    r->start[r->n_faces] = 4 * r->n_faces;
}

/* All inner faces, or all of the boundary. */
static inline void blocks_faces(const struct blocks *b, struct poly_raw *r,
                                int inner)
{
    for (int e = 0; e < 6 * b->n[0] * b->n[1] * b->n[2]; e++) {
        const int i = e / 6, k = e % 6 / 2, upper = e % 2;
        const int at[3] = {i % b->n[0], i / b->n[0] % b->n[1],
                           i / b->n[0] / b->n[1]};
        int next[3] = {at[0], at[1], at[2]};
        next[k] += upper ? 1 : -1;
        if (blocks_number(b, at) < 0) continue;
        const int other = blocks_number(b, next);
        if ((other >= 0) != inner || (inner && !upper)) continue;
        if (inner) r->neighbour[r->n_faces] = other;
        blocks_face(b, r, at, k, upper);
    }
}

static inline struct mesh *blocks_create(const struct blocks *b)
{
    const int nx = b->n[0] + 1, ny = b->n[1] + 1, nz = b->n[2] + 1;
    struct poly_raw r = {.n_points = nx * ny * nz, .n_parts = 1};

    r.n_cells = blocks_count(b, b->n[0] * b->n[1] * b->n[2]);
    r.point = alloc_doubles(3 * r.n_points);
    for (int p = 0; p < r.n_points; p++) {
        double *const x = &r.point[3 * p];
        x[0] = p % nx;
        x[1] = p / nx % ny;
        x[2] = p / nx / ny;
        if (b->move != NULL) b->move(x);
    }
    r.part = alloc_zeroed(1, sizeof *r.part);
    r.start = alloc_ints(6 * r.n_cells + 1);
    r.corner = alloc_ints(24 * r.n_cells);
    r.owner = alloc_ints(6 * r.n_cells);
    r.neighbour = alloc_ints(6 * r.n_cells);
    blocks_faces(b, &r, 1);
    r.n_inner = r.part[0].first = r.n_faces;
    blocks_faces(b, &r, 0);
    r.part[0].n = r.n_faces - r.n_inner;
    snprintf(r.part[0].name, sizeof r.part[0].name, "walls");
    snprintf(r.part[0].type, sizeof r.part[0].type, "wall");
    struct mesh *const m = poly_build(&r, "blocks");
    ck_assert_ptr_nonnull(m);
    poly_raw_release(&r);
    return m;
}

#endif
