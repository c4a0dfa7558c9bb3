/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/shapes/shapes.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

/* Integrals over the shape of 1, x and x x^T. */
struct moments {
    double V, first[3], second[6];
};

/* The parallel columns of a union of spheres, a side [-]. */
enum { COLUMNS = 512 };

/* The centres in a tree of boxes; to it each is a triangle of no extent. */
struct clump {
    struct body_outline outline; /* first, because the body gives it back */
    double (*corner)[3][3];
    struct triangle_tree *tree;
    double widest; /* [m] radius */
    int *last;     /* [-] the nearest of the last point */
};

static void plant(struct clump *c)
{
    const struct body_ball *const ball = c->outline.ball;

    for (int i = 0; i < 9 * c->outline.n_balls; i++) {
        c->corner[i / 9][i / 3 % 3][i % 3] = ball[i / 9].at[i % 3];
        c->widest = fmax(c->widest, ball[i / 9].R);
    }
    c->tree = triangle_tree_create(c, c->outline.n_balls, c->corner);
}

/* --- distance ------------------------------------------------------------- */

struct near {
    const struct clump *c;
    const double *y;
    double least; /* [m] */
    int found;
};

static double from_ball(const struct clump *c, int i, const double y[3])
{
    double r[3];

    vector_between(y, c->outline.ball[i].at, r);
    return vector_length(r) - c->outline.ball[i].R;
}

static double nearness(void *by, const double lo[3], const double hi[3])
{
    const struct near *const s = by;
    const double far = sqrt(box_apart(3, s->y, lo, hi));
    return far - s->c->widest < s->least ? far : HUGE_VAL;
}

static void clump_compare(void *by, int i)
{
    struct near *const s = by;
    const double now = from_ball(s->c, i, s->y);

    if (now >= s->least) return;
    s->least = now;
    s->found = i;
}

static double clump_distance(const struct body_outline *o, const double y[3])
{
    static const struct triangle_tree_search search = {nearness, clump_compare};
    const struct clump *const c = (const struct clump *)o;
    struct near s = {c, y, from_ball(c, *c->last, y), *c->last};

    triangle_tree_walk(c->tree, &search, &s);
    *c->last = s.found;
    return s.least;
}

/* --- moments -------------------------------------------------------------- */

struct meeting {
    const struct clump *c;
    int i, any;
};

static double meets(void *by, const double lo[3], const double hi[3])
{
    const struct meeting *const s = by;
    const struct body_ball *const b = &s->c->outline.ball[s->i];
    const double far = sqrt(box_apart(3, b->at, lo, hi));
    return !s->any && far < b->R + s->c->widest ? far : HUGE_VAL;
}

static void meet(void *by, int j)
{
    struct meeting *const s = by;
    const struct body_ball *const ball = s->c->outline.ball;
    double r[3];

    if (j == s->i) return;
    vector_between(ball[s->i].at, ball[j].at, r);
    s->any |= vector_length(r) < ball[s->i].R + ball[j].R;
}

static int any_overlap(const struct clump *c)
{
    static const struct triangle_tree_search search = {meets, meet};
    struct meeting s = {.c = c};

    for (; s.i < c->outline.n_balls && !s.any; s.i++)
        triangle_tree_walk(c->tree, &search, &s);
    return s.any;
}

static void add_sphere(struct moments *m, const struct body_ball *b)
{
    const double V = 4.0 / 3.0 * M_PI * b->R * b->R * b->R, *const x = b->at;
    const double own = 0.2 * b->R * b->R;

    m->V += V;
    for (int k = 0; k < 3; k++)
        m->first[k] += V * x[k];
    m->second[0] += V * (x[0] * x[0] + own);
    m->second[1] += V * x[0] * x[1];
    m->second[2] += V * x[0] * x[2];
    m->second[3] += V * (x[1] * x[1] + own);
    m->second[4] += V * x[1] * x[2];
    m->second[5] += V * (x[2] * x[2] + own);
}

/* The piece of a column at (x, y) with the cross-section dA between heights. */
static void clump_add_piece(struct moments *m, double x, double y,
                            const double z[2], double dA)
{
    const double V = dA * (z[1] - z[0]),
                 Vz = 0.5 * dA * (z[1] * z[1] - z[0] * z[0]),
                 Vzz = dA * (z[1] * z[1] * z[1] - z[0] * z[0] * z[0]) / 3.0;

    m->V += V;
    m->first[0] += V * x, m->first[1] += V * y, m->first[2] += Vz;
    m->second[0] += V * x * x, m->second[1] += V * x * y;
    m->second[2] += Vz * x, m->second[3] += V * y * y;
    m->second[4] += Vz * y, m->second[5] += Vzz;
}

/* A way along z at x[0], x[1] through the spheres. */
struct column {
    const struct clump *c;
    double x[2];
    double z[2]; /* [m] ends of the piece at hand */
    double past; /* [m] end of the piece before */
    int end[2];  /* [-] where it began and ended in the column before: looked at
                    first, because that is near */
};

/* Half of the way through the largest sphere in a box of centres [m]. */
static double half_way(const struct column *s, const double lo[3],
                       const double hi[3])
{
    const double R = s->c->widest;
    return sqrt(fmax(R * R - box_apart(2, s->x, lo, hi), 0.0));
}

/* Where the column is in sphere i; 0: nowhere. */
static int clump_cut(const struct column *s, int i, double z[2])
{
    const struct body_ball *const b = &s->c->outline.ball[i];
    const double dx = s->x[0] - b->at[0], dy = s->x[1] - b->at[1],
                 left = b->R * b->R - dx * dx - dy * dy;

    if (left <= 0.0) return 0;
    z[0] = b->at[2] - sqrt(left);
    z[1] = b->at[2] + sqrt(left);
    return 1;
}

static double clump_begins(void *by, const double lo[3], const double hi[3])
{
    const struct column *const s = by;
    const double half = half_way(s, lo, hi);
    return half > 0.0 && hi[2] + half > s->past && lo[2] - half < s->z[0]
               ? lo[2] - half
               : HUGE_VAL;
}

/* The lowest beginning beyond the piece before. */
static void clump_begin(void *by, int i)
{
    struct column *const s = by;
    double z[2];

    if (!clump_cut(s, i, z) || z[0] <= s->past || z[0] >= s->z[0]) return;
    memcpy(s->z, z, sizeof z);
    s->end[0] = i;
}

static double clump_goes_on(void *by, const double lo[3], const double hi[3])
{
    const struct column *const s = by;
    const double half = half_way(s, lo, hi);
    return half > 0.0 && lo[2] - half <= s->z[1] && hi[2] + half > s->z[1]
               ? -(hi[2] + half)
               : HUGE_VAL;
}

static void go_on(void *by, int i)
{
    struct column *const s = by;
    double z[2];

    if (!clump_cut(s, i, z) || z[0] > s->z[1] || z[1] <= s->z[1]) return;
    s->z[1] = z[1];
    s->end[1] = i;
}

static int next_piece(struct column *s)
{
    static const struct triangle_tree_search first = {clump_begins,
                                                      clump_begin},
                                             last = {clump_goes_on, go_on};
    double before;

    s->z[0] = HUGE_VAL;
    clump_begin(s, s->end[0]);
    triangle_tree_walk(s->c->tree, &first, s);
    if (s->z[0] == HUGE_VAL) return 0;
    go_on(s, s->end[1]);
    do {
        before = s->z[1];
        triangle_tree_walk(s->c->tree, &last, s);
    } while (s->z[1] > before);
    s->past = s->z[1];
    return 1;
}

/* The stretches of columns that are in some sphere, united. Exact along z, by
 * columns across it: 1e-5 of a volume. */
static void add_union(struct moments *m, const struct clump *c,
                      const double lo[3], const double hi[3])
{
    const double dx = (hi[0] - lo[0]) / COLUMNS, dy = (hi[1] - lo[1]) / COLUMNS;
    struct column s = {.c = c};

    for (int i = 0; i < COLUMNS * COLUMNS; i++) {
        s.x[0] = lo[0] + (i / COLUMNS + 0.5) * dx;
        s.x[1] = lo[1] + (i % COLUMNS + 0.5) * dy;
        s.past = -HUGE_VAL;
        while (next_piece(&s))
            clump_add_piece(m, s.x[0], s.x[1], s.z, dx * dy);
    }
}

struct body_outline *clump_create(int n, const struct body_ball *ball)
{
    struct clump *const c = owner_create(sizeof *c);
    struct body_outline *const o = &c->outline;
    double lo[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL},
           hi[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    struct moments m = {0};

    o->distance = clump_distance;
    o->n_balls = n;
    o->ball = owner_zeroed(c, (size_t)n, sizeof *o->ball);
    memcpy(o->ball, ball, (size_t)n * sizeof *o->ball);
    c->corner = owner_zeroed(c, (size_t)n, sizeof *c->corner);
    c->last = owner_ints(c, 1);
    plant(c);
    for (int i = 0; i < 3 * n; i++) {
        const struct body_ball *const b = &ball[i / 3];
        lo[i % 3] = fmin(lo[i % 3], b->at[i % 3] - b->R);
        hi[i % 3] = fmax(hi[i % 3], b->at[i % 3] + b->R);
    }
    if (any_overlap(c))
        add_union(&m, c, lo, hi);
    else
        for (int i = 0; i < n; i++)
            add_sphere(&m, &ball[i]);
    body_outline_set_moments(o, m.V, m.first, m.second);
    for (int k = 0; k < 3; k++) {
        o->half[k] = fmax(hi[k] - o->centre[k], o->centre[k] - lo[k]);
        for (int i = 0; i < n; i++)
            o->ball[i].at[k] -= o->centre[k];
    }
    plant(c);
    return o;
}
