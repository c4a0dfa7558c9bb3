/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/cg.h"

#include "base/alloc.h"
#include "linear/reduce.h"
#include "base/parallel_ranges.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct cg_work {
    int n;
    double *r, *z, *p, *q; /* residual, M r, direction, A p */
};

struct cg_work *cg_work_create(int n)
{
    struct cg_work *const w = alloc_zeroed(1, sizeof *w);

    w->n = n;
    w->r = alloc_doubles(n);
    w->z = alloc_doubles(n);
    w->p = alloc_doubles(n);
    w->q = alloc_doubles(n);
    return w;
}

void cg_work_free(struct cg_work *w)
{
    if (w == NULL) return;
    free(w->r);
    free(w->z);
    free(w->p);
    free(w->q);
    free(w);
}

/* y = A x; returns x.y */
static double multiply(const struct csr *A, const struct multigrid *mg,
                       const double *x, double *y)
{
    if (mg != NULL) return multigrid_multiply(mg, x, y);
    csr_multiply(A, x, y);
    return reduce_dot(A->n, x, y);
}

/* r = b - r over a range; returns its part of r.r */
static double subtract(int first, int last, const double *b, double *r)
{
    for (int i = first; i < last; i++)
        r[i] = b[i] - r[i];
    return reduce_range(first, last, r, r);
}

/* r = b - A x; returns r.r */
static double residual(const struct csr *A, const struct multigrid *mg,
                       const double *b, const double *x,
                       const struct cg_work *w)
{
    double rr;

    multiply(A, mg, x, w->r);
    PARALLEL_SUM(rr, w->n, 1, subtract, b, w->r);
    return rr;
}

/* z = r / diag over a range; returns its part of r.z */
static double jacobi(int first, int last, const double *diag, const double *r,
                     double *z)
{
    for (int i = first; i < last; i++)
        z[i] = r[i] / diag[i];
    return reduce_range(first, last, r, z);
}

/* z = M r; returns r.z */
static double precondition(const struct csr *A, struct multigrid *mg,
                           const double *r, double *z)
{
    double rz;

    if (mg != NULL) return multigrid_apply(mg, r, z);
    PARALLEL_SUM(rz, A->n, 1, jacobi, A->diag, r, z);
    return rz;
}

/* p = z + beta p over a range */
static void update_direction(int first, int last, double beta, const double *z,
                             double *p)
{
    for (int i = first; i < last; i++)
        p[i] = z[i] + beta * p[i];
}

/* x += alpha p, r -= alpha q over a range; returns its part of r.r */
static double advance(int first, int last, double alpha, struct cg_work *w,
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

/* The iteration, until |r| <= target. Returns the last |r|. */
static double iterate(const struct csr *A, struct multigrid *mg, double *x,
                      double rr, double target, int max_iterations,
                      struct cg_work *w, int *iterations)
{
    double rz_old = 1.0;

    for (int it = 0; it < max_iterations && sqrt(rr) > target; it++) {
        const double rz = precondition(A, mg, w->r, w->z);

        PARALLEL_RANGES(w->n, 1, update_direction, it == 0 ? 0.0 : rz / rz_old,
                        w->z, w->p);

        const double pq = multiply(A, mg, w->p, w->q);

        if (!(pq > 0.0) || !isfinite(rz / pq)) break; /* A not positive */
        PARALLEL_SUM(rr, w->n, 1, advance, rz / pq, w, x);
        rz_old = rz;
        *iterations = it + 1;
    }
    return sqrt(rr);
}

/* Until |b - A x| is below a target and below `enough` of what it is at first,
 * whichever is larger. The square of a residual below sqrt(DBL_MIN), 1.5e-154,
 * has lost its digits: the iteration can mend nothing there, and it counts as
 * zero. */
static struct solve_report solve(const struct csr *A, struct multigrid *mg,
                                 const double *b, double *x, double scale,
                                 double target, double enough,
                                 int max_iterations, struct cg_work *w)
{
    struct solve_report report = {0, 0.0, 0.0, 1};
    const double rr = residual(A, mg, b, x, w);
    const double goal = fmax(fmax(target, enough * sqrt(rr)), sqrt(DBL_MIN));
    const double after =
        iterate(A, mg, x, rr, goal, max_iterations, w, &report.iterations);

    report.before = sqrt(rr) / scale;
    report.after = after / scale;
    report.converged = after <= goal;
    return report;
}

struct solve_report cg_solve(const struct csr *A, struct multigrid *mg,
                             const double *b, double *x, double tolerance,
                             double absolute, int max_iterations,
                             struct cg_work *w)
{
    const double scale = sqrt(reduce_dot(w->n, b, b));

    if (scale == 0.0) {
        memset(x, 0, (size_t)A->n * sizeof *x);
        return (struct solve_report){0, 0.0, 0.0, 1};
    }
    return solve(A, mg, b, x, scale, fmax(tolerance * scale, absolute), 0.0,
                 max_iterations, w);
}

struct solve_report cg_reduce(const struct csr *A, struct multigrid *mg,
                              const double *b, double *x, double enough,
                              double absolute, int max_iterations,
                              struct cg_work *w)
{
    const double scale = sqrt(reduce_dot(w->n, b, b));

    return solve(A, mg, b, x, scale > 0.0 ? scale : 1.0, absolute, enough,
                 max_iterations, w);
}
