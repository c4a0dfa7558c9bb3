/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/among/mirrors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"
#include "resolved/body_cells.h"

enum { CORNERS = 8 };

/* A cell in a body, and the open cells around its mirror image. */
struct mirror {
    int cell, n;
    int to[CORNERS];
    double w[CORNERS]; /* [-] sum 1 */
};

struct mirrors {
    struct averaging_wall wall; /* first, because the averaging gives it back */
    const struct mesh *mesh;    /* borrowed */
    struct mirror *list;
    int n, capacity, stuck;
    char *closed;     /* [-] of each cell: 1 in a body */
    double *extended; /* a field, continued; 8 a cell at most */
    int width;        /* [-] numbers a cell that there is room for */
};

static void move_out(const struct averaging_wall *self, int m, double *field)
{
    const struct mirrors *const all = (const struct mirrors *)self;
    const double *const V = all->mesh->V;

    for (int j = 0; j < all->n; j++) {
        const struct mirror *const one = &all->list[j];
        double *const from = &field[m * one->cell];
        for (int e = 0; e < one->n; e++) {
            const double share = one->w[e] * V[one->cell] / V[one->to[e]];
            for (int k = 0; k < m; k++)
                field[m * one->to[e] + k] += share * from[k];
        }
        for (int k = 0; k < m; k++)
            from[k] = 0.0;
    }
}

static const double *extend(struct averaging_wall *self, int m,
                            const double *field)
{
    struct mirrors *const all = (struct mirrors *)self;
    const int cells = all->mesh->n_cells;

    if (m > all->width) {
        free(all->extended);
        all->width = m;
        all->extended = alloc_doubles(m * cells);
    }
    memcpy(all->extended, field,
           (size_t)m * (size_t)cells * sizeof *all->extended);
    for (int j = 0; j < all->n; j++) {
        const struct mirror *const one = &all->list[j];
        for (int k = 0; k < m; k++) {
            double sum = 0.0;
            for (int e = 0; e < one->n; e++)
                sum += one->w[e] * field[m * one->to[e] + k];
            all->extended[m * one->cell + k] = sum;
        }
    }
    return all->extended;
}

struct mirrors *mirrors_create(const struct mesh *mesh)
{
    struct mirrors *const m = alloc_zeroed(1, sizeof *m);

    m->wall = (struct averaging_wall){.move_out = move_out, .extend = extend};
    m->mesh = mesh;
    m->closed = alloc_zeroed((size_t)mesh->n_cells, 1);
    return m;
}

void mirrors_free(struct mirrors *m)
{
    if (m == NULL) return;
    free(m->list);
    free(m->closed);
    free(m->extended);
    free(m);
}

struct averaging_wall *mirrors_wall(struct mirrors *m)
{
    return &m->wall;
}

int mirrors_stuck(const struct mirrors *m)
{
    return m->stuck;
}

/* The eight cells whose centres lie around x, at weights that make linear
 * fields exact; those beyond a wall of the mesh count as the last before it.
 * Closed ones are left out. Returns the sum of the weights. */
static double weigh(const struct mirrors *all, const double x[3],
                    struct mirror *one)
{
    const struct box *const b = &all->mesh->box;
    int low[3];
    double share[3], sum = 0.0;

    for (int k = 0; k < 3; k++) {
        const double h = (b->edge[k][b->n[k]] - b->edge[k][0]) / b->n[k];
        const double at = (x[k] - b->edge[k][0]) / h - 0.5;
        low[k] = number_clamped(floor(at), -b->n[k], 2 * b->n[k]);
        share[k] = at - low[k];
    }
    one->n = 0;
    for (int corner = 0; corner < CORNERS; corner++) {
        int in[3];
        double w = 1.0;
        for (int k = 0; k < 3; k++) {
            const int up = corner >> k & 1, n = b->n[k];
            in[k] = low[k] + up;
            w *= up ? share[k] : 1.0 - share[k];
            if (b->periodic[k])
                in[k] = (in[k] % n + n) % n;
            else
                in[k] = in[k] < 0 ? 0 : in[k] >= n ? n - 1 : in[k];
        }
        const int c = in[0] + b->n[0] * (in[1] + b->n[1] * in[2]);
        if (w <= 0.0 || all->closed[c]) continue;
        one->to[one->n] = c;
        one->w[one->n++] = w;
        sum += w;
    }
    return sum;
}

/* Where no cell around the image is open, the next one farther out. */
static void add_mirror(struct mirrors *all, int c,
                       const struct body_shape *shape, const double centre[3],
                       const double r[3], double s)
{
    const double h = cbrt(all->mesh->V[c]), far = 4.0 * (h - s);
    struct mirror *const one = &all->list[all->n++];
    double n[3], x[3], sum = 0.0;

    body_shape_normal(shape, r, n);
    for (double way = -2.0 * s; sum <= 1e-3 && way < far; way += 0.5 * h) {
        for (int k = 0; k < 3; k++)
            x[k] = centre[k] + r[k] + way * n[k];
        sum = weigh(all, x, one);
    }
    one->cell = c;
    for (int e = 0; e < one->n; e++)
        one->w[e] /= sum;
    if (one->n > 0) return;
    all->n--;
    all->stuck++;
}

static void mirrors_make_room(struct mirrors *all)
{
    if (all->n < all->capacity) return;
    const int room = 2 * all->n + 1024;
    struct mirror *const more = alloc_zeroed((size_t)room, sizeof *more);

    if (all->n > 0) memcpy(more, all->list, (size_t)all->n * sizeof *more);
    free(all->list);
    all->list = more;
    all->capacity = room;
}

struct closing {
    struct mirrors *all;
    const struct solid_bodies *b;
};

static void close_cell(void *by, int i, int c, const double r[3], double s)
{
    (void)i, (void)r;
    if (s <= 0.0) ((struct closing *)by)->all->closed[c] = 1;
}

/* A closed cell gets one mirror, of the first body around it. */
static void mirror_cell(void *by, int i, int c, const double r[3], double s)
{
    struct mirrors *const all = ((struct closing *)by)->all;
    const struct solid_bodies *const b = ((struct closing *)by)->b;
    const double x[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};

    if (s > 0.0 || all->closed[c] != 1) return;
    mirrors_make_room(all);
    all->closed[c] = 2;
    add_mirror(all, c, &b->shape[i], x, r, s);
}

void mirrors_update(struct mirrors *m, const struct solid_bodies *b)
{
    struct closing by = {m, b};

    memset(m->closed, 0, (size_t)m->mesh->n_cells);
    m->n = m->stuck = 0;
    for (int i = 0; i < b->ps->n; i++)
        body_cells_each(b, m->mesh, i, close_cell, &by);
    for (int i = 0; i < b->ps->n; i++)
        body_cells_each(b, m->mesh, i, mirror_cell, &by);
}
