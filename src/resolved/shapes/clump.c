/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/shapes/clump.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

/* Integrals over the shape of 1, x and x x^T. */
struct moments {
    double V, first[3], second[6];
};

/* The parallel columns of a union of spheres, a side [-]. */
enum { COLUMNS = 512 };

static double distance(const struct body_outline *o, const double y[3])
{
    double nearest = HUGE_VAL;

    for (int i = 0; i < o->n_balls; i++) {
        double r[3];
        vector_between(y, o->ball[i].at, r);
        nearest = fmin(nearest, vector_length(r) - o->ball[i].R);
    }
    return nearest;
}

static void release(struct body_outline *o)
{
    free(o);
}

static int any_overlap(int n, const struct body_ball *ball)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) {
            double r[3];
            vector_between(ball[i].at, ball[j].at, r);
            if (vector_length(r) < ball[i].R + ball[j].R) return 1;
        }
    return 0;
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
static void add_piece(struct moments *m, double x, double y, const double z[2],
                      double dA)
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

static int by_start(const void *a, const void *b)
{
    const double *const p = a, *const q = b;
    return (p[0] > q[0]) - (p[0] < q[0]);
}

/* The stretches of a column that are in some sphere, united. `cut` is room for
 * n of them. */
static void add_column(struct moments *m, int n, const struct body_ball *ball,
                       double x, double y, double dA, double (*cut)[2])
{
    size_t found = 0;

    for (int i = 0; i < n; i++) {
        const double dx = x - ball[i].at[0], dy = y - ball[i].at[1];
        const double left = ball[i].R * ball[i].R - dx * dx - dy * dy;
        if (left <= 0.0) continue;
        cut[found][0] = ball[i].at[2] - sqrt(left);
        cut[found++][1] = ball[i].at[2] + sqrt(left);
    }
    qsort(cut, found, sizeof *cut, by_start);
    for (size_t i = 0, next; i < found; i = next) {
        for (next = i + 1; next < found && cut[next][0] <= cut[i][1]; next++)
            cut[i][1] = fmax(cut[i][1], cut[next][1]);
        add_piece(m, x, y, cut[i], dA);
    }
}

/* Exact along z, by columns across it: 1e-5 of a volume. */
static void add_union(struct moments *m, int n, const struct body_ball *ball,
                      const double lo[3], const double hi[3])
{
    double(*const cut)[2] = alloc_zeroed((size_t)n, sizeof *cut);
    const double dx = (hi[0] - lo[0]) / COLUMNS, dy = (hi[1] - lo[1]) / COLUMNS;

    for (int i = 0; i < COLUMNS; i++)
        for (int j = 0; j < COLUMNS; j++)
            add_column(m, n, ball, lo[0] + (i + 0.5) * dx,
                       lo[1] + (j + 0.5) * dy, dx * dy, cut);
    free(cut);
}

struct body_outline *clump_create(int n, const struct body_ball *ball)
{
    struct body_outline *const o = alloc_zeroed(1, sizeof *o);
    double lo[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL},
           hi[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    struct moments m = {0};

    o->distance = distance;
    o->free = release;
    o->n_balls = n;
    o->ball = alloc_zeroed((size_t)n, sizeof *o->ball);
    memcpy(o->ball, ball, (size_t)n * sizeof *o->ball);
    for (int i = 0; i < 3 * n; i++) {
        const struct body_ball *const b = &ball[i / 3];
        lo[i % 3] = fmin(lo[i % 3], b->at[i % 3] - b->R);
        hi[i % 3] = fmax(hi[i % 3], b->at[i % 3] + b->R);
    }
    if (any_overlap(n, ball))
        add_union(&m, n, ball, lo, hi);
    else
        for (int i = 0; i < n; i++)
            add_sphere(&m, &ball[i]);
    body_outline_set_moments(o, m.V, m.first, m.second);
    for (int k = 0; k < 3; k++) {
        o->half[k] = fmax(hi[k] - o->centre[k], o->centre[k] - lo[k]);
        for (int i = 0; i < n; i++)
            o->ball[i].at[k] -= o->centre[k];
    }
    return o;
}
