/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/cg.h"

#include "base/alloc.h"
#include "linear/reduce.h"

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

/* r = b - A x; returns r.r */
static double residual(const struct csr *A, const struct multigrid *mg,
                       const double *b, const double *x, double *r)
{
    const int n = A->n;

    multiply(A, mg, x, r);
#pragma omp parallel for schedule(static) if (n > REDUCE_THREADED)
    for (int i = 0; i < n; i++)
        r[i] = b[i] - r[i];
    return reduce_dot(n, r, r);
}

/* z = M r; returns r.z */
static double precondition(const struct csr *A, struct multigrid *mg,
                           const double *r, double *z)
{
    const int n = A->n;

    if (mg != NULL) return multigrid_apply(mg, r, z);
#pragma omp parallel for schedule(static) if (n > REDUCE_THREADED)
    for (int i = 0; i < n; i++)
        z[i] = r[i] / A->diag[i];
    return reduce_dot(n, r, z);
}

/* p = z + beta p */
static void turn(int n, double beta, const double *z, double *p)
{
#pragma omp parallel for schedule(static) if (n > REDUCE_THREADED)
    for (int i = 0; i < n; i++)
        p[i] = z[i] + beta * p[i];
}

/* x += alpha p, r -= alpha q; returns r.r */
static double advance(double alpha, const struct cg_work *w, double *x)
{
    double *const r = w->r;
    double strip[REDUCE_STRIPS];

#pragma omp parallel for schedule(static) if (w->n > REDUCE_THREADED)
    for (int s = 0; s < REDUCE_STRIPS; s++) {
        const int first = reduce_strip(w->n, s);
        const int last = reduce_strip(w->n, s + 1);

        for (int i = first; i < last; i++) {
            x[i] += alpha * w->p[i];
            r[i] -= alpha * w->q[i];
        }
        strip[s] = reduce_range(first, last, r, r);
    }
    return reduce_strips(strip);
}

/* The iteration, until |r| <= target. Returns the last |r|. */
static double iterate(const struct csr *A, struct multigrid *mg, double *x,
                      double rr, double target, int max_iterations,
                      struct cg_work *w, int *iterations)
{
    const int n = A->n;
    double rz_old = 1.0;

    for (int it = 0; it < max_iterations && sqrt(rr) > target; it++) {
        const double rz = precondition(A, mg, w->r, w->z);

        turn(n, it == 0 ? 0.0 : rz / rz_old, w->z, w->p);

        const double pq = multiply(A, mg, w->p, w->q);

        if (!(pq > 0.0) || !isfinite(rz / pq)) break; /* A not positive */
        rr = advance(rz / pq, w, x);
        rz_old = rz;
        *iterations = it + 1;
    }
    return sqrt(rr);
}

struct solve_report cg_solve(const struct csr *A, struct multigrid *mg,
                             const double *b, double *x, double tolerance,
                             double absolute, int max_iterations,
                             struct cg_work *w)
{
    struct solve_report report = {0, 0.0, 0.0, 1};
    const double scale = sqrt(reduce_dot(A->n, b, b));

    if (scale == 0.0) {
        memset(x, 0, (size_t)A->n * sizeof *x);
        return report;
    }

    const double target = fmax(tolerance * scale, absolute);
    const double rr = residual(A, mg, b, x, w->r);
    const double after =
        iterate(A, mg, x, rr, target, max_iterations, w, &report.iterations);

    report.before = sqrt(rr) / scale;
    report.after = after / scale;
    report.converged = after <= target;
    return report;
}
