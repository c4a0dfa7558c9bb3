/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/solvers.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "linear/field_groups.h"
#include "linear/reduce.h"

struct cg_work {
    int n;
    double *r, *p, *q; /* residual, direction, A p */
};

struct cg_work *cg_work_lent(int n, double *const space[3])
{
    struct cg_work *const w = owner_create(sizeof *w);

    *w = (struct cg_work){n, space[0], space[1], space[2]};
    return w;
}

struct cg_work *cg_work_create(int n)
{
    struct cg_work *const w = owner_create(sizeof *w);

    *w = (struct cg_work){n, owner_doubles(w, n), owner_doubles(w, n),
                          owner_doubles(w, n)};
    return w;
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

/* --- cg many -------------------------------------------------------------- */

struct cg_many_work {
    int n, m;
    double *r, *p, *q; /* residuals, directions, A p: m side by side */
    double *inverse;   /* one over the weight of each row */
};

/* A number for each field. */
struct fields {
    double at[CG_MANY_FIELDS];
};

static void range_fields(int first, int last, int n, int m, const double *x,
                         const double *y, double (*partial)[REDUCE_FIELDS])
{
    reduce_range_many(first, last, m, x, y,
                      partial[parallel_ranges_of(n, first)]);
}

void cg_many_dot(int n, int m, const double *x, const double *y, double *dot)
{
    double partial[PARALLEL_RANGES_COUNT][REDUCE_FIELDS] = {{0.0}};

    assert(m >= 1 && m <= REDUCE_FIELDS);
    PARALLEL_RANGES(n, m, range_fields, n, m, x, y, partial);
    for (int k = 0; k < m; k++)
        dot[k] = 0.0;
    for (int s = 0; s < PARALLEL_RANGES_COUNT; s++)
        for (int k = 0; k < m; k++)
            dot[k] += partial[s][k];
}

struct cg_many_work *cg_many_work_create(int n, int m)
{
    struct cg_many_work *const w = owner_create(sizeof *w);

    assert(m >= 1 && m <= CG_MANY_FIELDS);
    w->n = n;
    w->m = m;
    w->r = owner_doubles(w, n * m);
    w->p = owner_doubles(w, n * m);
    w->q = owner_doubles(w, n * m);
    w->inverse = owner_doubles(w, n);
    return w;
}

static void cg_many_subtract(int first, int last, int m, const double *b,
                             double *r)
{
    for (long i = (long)m * first; i < (long)m * last; i++)
        r[i] = b[i] - r[i];
}

static void cg_many_invert(int first, int last, const double *weight,
                           double *inverse)
{
    for (int i = first; i < last; i++)
        inverse[i] = 1.0 / weight[i];
}

/* p = z + beta p with z = r / weight, for `width` fields from the k-th on. */
FIELD_GROUPS_KERNEL cg_many_update_direction_rows(int width, int k, int first,
                                                  int last,
                                                  const struct cg_many_work *w,
                                                  const struct fields *beta)
{
    double b[FIELD_GROUPS_WIDTH], p[FIELD_GROUPS_WIDTH];

    for (int f = 0; f < width; f++)
        b[f] = beta->at[k + f];
    for (int i = first; i < last; i++) {
        const long at = (long)w->m * i + k;
        const double inverse = w->inverse[i];

        for (int f = 0; f < width; f++)
            p[f] = inverse * w->r[at + f] + b[f] * w->p[at + f];
        for (int f = 0; f < width; f++)
            w->p[at + f] = p[f];
    }
}

static void cg_many_update_direction(int first, int last,
                                     const struct cg_many_work *w,
                                     const struct fields *beta)
{
    FOR_FIELD_GROUPS(w->m, cg_many_update_direction_rows, first, last, w, beta);
}

/* The scalar products of each field. */
struct sums {
    struct fields rz, rr; /* r.z, r.r */
};

/* x += alpha p, r -= alpha q, and adds the scalar products of the new residual
 * to the sums. */
FIELD_GROUPS_KERNEL advance_rows(int width, int k, int first, int last,
                                 const struct cg_many_work *w,
                                 const struct fields *alpha, double *x,
                                 struct sums *sums)
{
    double rr[FIELD_GROUPS_WIDTH] = {0.0}, rz[FIELD_GROUPS_WIDTH] = {0.0};
    double a[FIELD_GROUPS_WIDTH], s[FIELD_GROUPS_WIDTH];

    for (int f = 0; f < width; f++)
        a[f] = alpha->at[k + f];
    for (int i = first; i < last; i++) {
        const long at = (long)w->m * i + k;
        const double inverse = w->inverse[i];
        double *const r = w->r + at, *const y = x + at;

        for (int f = 0; f < width; f++) {
            s[f] = r[f] - a[f] * w->q[at + f];
            rr[f] += s[f] * s[f];
            rz[f] += s[f] * s[f] * inverse;
        }
        for (int f = 0; f < width; f++)
            r[f] = s[f];
        for (int f = 0; f < width; f++)
            s[f] = y[f] + a[f] * w->p[at + f];
        for (int f = 0; f < width; f++)
            y[f] = s[f];
    }
    for (int f = 0; f < width; f++) {
        sums->rr.at[k + f] = rr[f];
        sums->rz.at[k + f] = rz[f];
    }
}

static void cg_many_advance(int first, int last, const struct cg_many_work *w,
                            const struct fields *alpha, double *x,
                            struct sums *partial)
{
    struct sums *const sums = partial + parallel_ranges_of(w->n, first);

    FOR_FIELD_GROUPS(w->m, advance_rows, first, last, w, alpha, x, sums);
}

/* Takes a step of each field along its direction; returns the sums of the
 * residuals. */
static struct sums advance_all(const struct cg_many_work *w,
                               const struct fields *alpha, double *x)
{
    struct sums partial[PARALLEL_RANGES_COUNT] = {{{{0.0}}, {{0.0}}}};
    struct sums sum = {{{0.0}}, {{0.0}}};

    PARALLEL_RANGES(w->n, w->m, cg_many_advance, w, alpha, x, partial);
    for (int s = 0; s < PARALLEL_RANGES_COUNT; s++)
        for (int k = 0; k < w->m; k++) {
            sum.rz.at[k] += partial[s].rz.at[k];
            sum.rr.at[k] += partial[s].rr.at[k];
        }
    return sum;
}

/* r = b - A x; returns its scalar products, which a step of length zero
 * computes. */
static struct sums cg_many_begin(const struct csr *A, const double *weight,
                                 const double *b, double *x,
                                 struct cg_many_work *w)
{
    const struct fields none = {{0.0}};

    csr_multiply_many(A, w->m, x, w->r);
    PARALLEL_RANGES(w->n, w->m, cg_many_subtract, w->m, b, w->r);
    PARALLEL_RANGES(w->n, 1, cg_many_invert, weight != NULL ? weight : A->diag,
                    w->inverse);
    memset(w->p, 0, (size_t)w->n * (size_t)w->m * sizeof *w->p);
    memset(w->q, 0, (size_t)w->n * (size_t)w->m * sizeof *w->q);
    return advance_all(w, &none, x);
}

/* The largest residual over its scale [-]; a field whose scale is 0 counts as
 * solved. */
static double cg_many_worst(int m, const double *rr, const double *bb)
{
    double most = 0.0;

    for (int k = 0; k < m && !isnan(most); k++) {
        const double share = bb[k] == 0.0 ? 0.0 : sqrt(rr[k] / bb[k]);

        if (!(share <= most)) most = share; /* NaN is the worst */
    }
    return most;
}

static int all_below(int m, const double *rr, const struct fields *target)
{
    for (int k = 0; k < m; k++)
        if (!(sqrt(rr[k]) <= target->at[k])) return 0;
    return 1;
}

/* One iteration. Fields whose residual has vanished, or that broke down, take
 * no step; returns the number of those that did. */
static int cg_many_step(const struct csr *A, double *x, struct cg_many_work *w,
                        struct sums *sum, const struct fields *beta)
{
    struct fields alpha = {{0.0}};
    double pq[CG_MANY_FIELDS];
    int moved = 0;

    PARALLEL_RANGES(w->n, w->m, cg_many_update_direction, w, beta);
    csr_multiply_many(A, w->m, w->p, w->q);
    cg_many_dot(w->n, w->m, w->p, w->q, pq);
    for (int k = 0; k < w->m; k++) {
        const double a = sum->rz.at[k] / pq[k];

        if (!(pq[k] > 0.0) || !isfinite(a)) continue;
        alpha.at[k] = a;
        moved++;
    }
    *sum = advance_all(w, &alpha, x);
    return moved;
}

/* Sets the solution of a field whose right-hand side is zero to zero. */
static void clear_empty(int n, int m, const double *bb, double *x)
{
    for (int k = 0; k < m; k++)
        if (bb[k] == 0.0)
            for (int i = 0; i < n; i++)
                x[(long)m * i + k] = 0.0;
}

struct solve_report cg_many_solve(const struct csr *A, const double *weight,
                                  const double *b, double *x, double tolerance,
                                  double absolute, int max_iterations,
                                  struct cg_many_work *w)
{
    struct solve_report report = {0, 0.0, 0.0, 0};
    struct fields target, beta = {{0.0}};
    double bb[CG_MANY_FIELDS];
    const double least = sqrt(DBL_MIN); /* smaller ones count as zero (cg.c) */

    cg_many_dot(w->n, w->m, b, b, bb);
    clear_empty(w->n, w->m, bb, x);
    for (int k = 0; k < w->m; k++)
        target.at[k] = fmax(fmax(tolerance * sqrt(bb[k]), absolute), least);

    struct sums sum = cg_many_begin(A, weight, b, x, w);

    report.before = cg_many_worst(w->m, sum.rr.at, bb);
    while (!all_below(w->m, sum.rr.at, &target) &&
           report.iterations < max_iterations) {
        const struct fields rz = sum.rz;

        if (cg_many_step(A, x, w, &sum, &beta) == 0) break;
        for (int k = 0; k < w->m; k++)
            beta.at[k] = rz.at[k] > 0.0 ? sum.rz.at[k] / rz.at[k] : 0.0;
        report.iterations++;
    }
    report.after = cg_many_worst(w->m, sum.rr.at, bb);
    report.converged = all_below(w->m, sum.rr.at, &target);
    return report;
}
