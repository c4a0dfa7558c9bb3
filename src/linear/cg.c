/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/cg.h"

#include "base/alloc.h"
#include "linear/reduce.h"
#include "base/parallel_ranges.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

struct cg_work {
    int n;
    double *r, *p, *q; /* residual, direction, A p */
};

struct cg_work *cg_work_create(int n)
{
    struct cg_work *const w = alloc_zeroed(1, sizeof *w);

    w->n = n;
    w->r = alloc_doubles(n);
    w->p = alloc_doubles(n);
    w->q = alloc_doubles(n);
    return w;
}

void cg_work_free(struct cg_work *w)
{
    if (w == NULL) return;
    free(w->r);
    free(w->p);
    free(w->q);
    free(w);
}

/* r = b - r over a range; returns its part of r.r */
static double cg_subtract(int first, int last, const double *b, double *r)
{
    for (int i = first; i < last; i++)
        r[i] = b[i] - r[i];
    return reduce_range(first, last, r, r);
}

/* r = b - A x; returns r.r */
static double cg_residual(struct preconditioned A, const double *b,
                          const double *x, const struct cg_work *w)
{
    double rr;

    A.kind->multiply(A.matrix, x, w->r);
    PARALLEL_SUM(rr, w->n, 1, cg_subtract, b, w->r);
    return rr;
}

/* x += alpha p, r -= alpha q over a range; returns its part of r.r */
static double cg_advance(int first, int last, double alpha, struct cg_work *w,
                         double *x)
{
    const double *const p = w->p, *const q = w->q;
    double *const r = w->r;

    for (int i = first; i < last; i++) {
        x[i] += alpha * p[i];
        r[i] -= alpha * q[i];
    }
    return reduce_range(first, last, r, r);
}

/* Iterates until |r| <= target; returns the last |r|. */
static double iterate(struct preconditioned A, double *x, double rr,
                      double target, int max_iterations, struct cg_work *w,
                      int *iterations)
{
    double rz_old = 1.0;

    for (int it = 0; it < max_iterations && sqrt(rr) > target; it++) {
        const double rz = A.kind->apply(A.matrix, w->r, rr);

        A.kind->direction(A.matrix, w->r, it == 0 ? 0.0 : rz / rz_old, w->p);

        const double pq = A.kind->multiply(A.matrix, w->p, w->q);

        if (!(pq > 0.0) || !isfinite(rz / pq)) break; /* A not positive */
        PARALLEL_SUM(rr, w->n, 1, cg_advance, rz / pq, w, x);
        rz_old = rz;
        *iterations = it + 1;
    }
    return sqrt(rr);
}

/* The square of a residual below sqrt(DBL_MIN), 1.5e-154, has lost its digits:
 * no iteration can reduce it further. */
struct solve_report cg_solve(struct preconditioned A, const double *b,
                             double *x, double reduction, double absolute,
                             int max_iterations, struct cg_work *w)
{
    struct solve_report report = {0, 0.0, 0.0, 1};
    const double size = sqrt(reduce_dot(w->n, b, b));
    const double scale = size > 0.0 ? size : 1.0;
    const double rr = cg_residual(A, b, x, w);
    const double target =
        fmax(fmax(absolute, reduction * sqrt(rr)), sqrt(DBL_MIN));
    const double after =
        iterate(A, x, rr, target, max_iterations, w, &report.iterations);

    report.before = sqrt(rr) / scale;
    report.after = after / scale;
    report.converged = after <= target;
    return report;
}
