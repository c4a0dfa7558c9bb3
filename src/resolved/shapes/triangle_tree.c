/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/shapes/shapes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/triangles.h"

/* Triangles in the smallest boxes, at most. */
enum { FEW = 4 };

struct branch {
    double lo[3], hi[3]; /* [m] */
    int first, n;        /* [-] of its triangles, in order */
    int next;            /* [-] its second half; the first one follows it */
};

/* A triangle while the tree is made. */
struct leaf {
    double at; /* [m] its middle, along the axis at hand */
    int number;
};

struct triangle_tree {
    double (*corner)[3][3];
    struct leaf *order;
    struct branch *branch;
    int n_branches;
};

static int by_middle(const void *a, const void *b)
{
    const struct leaf *const p = a, *const q = b;

    if (p->at != q->at) return p->at < q->at ? -1 : 1;
    return (p->number > q->number) - (p->number < q->number);
}

static void set_box(const struct triangle_tree *t, struct branch *b)
{
    for (int k = 0; k < 3; k++) {
        b->lo[k] = HUGE_VAL;
        b->hi[k] = -HUGE_VAL;
        for (int c = 0; c < 3 * b->n; c++) {
            const double x =
                t->corner[t->order[b->first + c / 3].number][c % 3][k];
            b->lo[k] = fmin(b->lo[k], x);
            b->hi[k] = fmax(b->hi[k], x);
        }
    }
}

/* Halves the triangles across the longest edge of their box, and so on. */
static void triangle_tree_grow(struct triangle_tree *t, int first, int n)
{
    struct branch *const b = &t->branch[t->n_branches++];
    int axis = 0;

    b->first = first;
    b->n = n;
    set_box(t, b);
    if (n <= FEW) return;
    for (int k = 1; k < 3; k++)
        if (b->hi[k] - b->lo[k] > b->hi[axis] - b->lo[axis]) axis = k;
    for (int i = first; i < first + n; i++) {
        const double(*const x)[3] =
            (const double(*)[3])t->corner[t->order[i].number];
        t->order[i].at = x[0][axis] + x[1][axis] + x[2][axis];
    }
    qsort(&t->order[first], (size_t)n, sizeof *t->order, by_middle);
    triangle_tree_grow(t, first, n / 2);
    b->next = t->n_branches;
    triangle_tree_grow(t, first + n / 2, n - n / 2);
}

struct triangle_tree *triangle_tree_create(void *owner, int n,
                                           double (*corner)[3][3])
{
    struct triangle_tree *const t = owner_zeroed(owner, 1, sizeof *t);

    t->corner = corner;
    t->order = owner_zeroed(owner, (size_t)n, sizeof *t->order);
    t->branch = owner_zeroed(owner, 2 * (size_t)n, sizeof *t->branch);
    for (int i = 0; i < n; i++)
        t->order[i].number = i;
    triangle_tree_grow(t, 0, n);
    return t;
}

/* What has been found so far. */
struct search {
    const double *y;
    double square; /* [m^2] of the distance */
    int found;
    double q[3]; /* [m] */
};

static void triangle_tree_compare(const struct triangle_tree *t, int i,
                                  struct search *s)
{
    double q[3], r[3];

    triangle_nearest((const double(*)[3])t->corner[i], s->y, q);
    vector_between(s->y, q, r);
    const double square = vector_dot(r, r);
    if (square >= s->square) return;
    s->square = square;
    s->found = i;
    memcpy(s->q, q, sizeof q);
}

static void descend(const struct triangle_tree *t, int i, struct search *s)
{
    const struct branch *const b = &t->branch[i];

    if (b->n <= FEW) {
        for (int j = 0; j < b->n; j++)
            triangle_tree_compare(t, t->order[b->first + j].number, s);
        return;
    }
    const struct branch *const p = &t->branch[i + 1], *const q =
                                                          &t->branch[b->next];
    const double one = box_apart(3, s->y, p->lo, p->hi),
                 two = box_apart(3, s->y, q->lo, q->hi);
    const int sooner = one <= two ? i + 1 : b->next,
              later = one <= two ? b->next : i + 1;
    if (fmin(one, two) < s->square) descend(t, sooner, s);
    if (fmax(one, two) < s->square) descend(t, later, s);
}

int triangle_tree_nearest(const struct triangle_tree *t, const double y[3],
                          int near, double q[3])
{
    struct search s = {.y = y, .square = HUGE_VAL};

    triangle_tree_compare(t, near, &s);
    descend(t, 0, &s);
    memcpy(q, s.q, sizeof s.q);
    return s.found;
}

static double rank(const struct triangle_tree *t, int i,
                   const struct triangle_tree_search *search, void *by)
{
    return search->rank(by, t->branch[i].lo, t->branch[i].hi);
}

/* What is found in the first half may rule out the second. */
static void walk(const struct triangle_tree *t, int i,
                 const struct triangle_tree_search *search, void *by)
{
    const struct branch *const b = &t->branch[i];

    if (rank(t, i, search, by) == HUGE_VAL) return;
    if (b->n <= FEW) {
        for (int j = 0; j < b->n; j++)
            search->act(by, t->order[b->first + j].number);
        return;
    }
    const int turned =
        rank(t, b->next, search, by) < rank(t, i + 1, search, by);
    walk(t, turned ? b->next : i + 1, search, by);
    walk(t, turned ? i + 1 : b->next, search, by);
}

void triangle_tree_walk(const struct triangle_tree *t,
                        const struct triangle_tree_search *search, void *by)
{
    walk(t, 0, search, by);
}
