/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/solvers.h"

#include "base/alloc.h"
#include "linear/reduce.h"
#include "base/parallel_ranges.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The vectors of the method [Saad03, algorithm 7.7]: residual r, shadow
 * residual, v = A ph and t = A sh, with ph and sh the preconditioned direction
 * p and half-way residual s. p and s are not stored: they are the diagonal
 * times ph and sh. sh takes the place of r until the next residual is known.
 * Each loop also computes the scalar products of the vectors that it has just
 * written. */
struct bicgstab_work {
    int n;
    double *r, *shadow, *ph, *v, *t; /* borrowed */
    const double *diag; /* borrowed, with this many numbers a row */
    int diagonals;
};

/* A number for each component. */
struct component_sums {
    double at[3];
};

/* If the cosine of the angle between residual and shadow residual is smaller,
 * the method restarts [-]. */
static const double least_cosine = 1e-14;

enum {
    LANES = 24, /* eight rows: the compiler vectorises loops of this length */
    BLOCK = 512 /* rows in a block, small enough for the first-level cache */
};
struct lanes {
    double at[LANES];
};

/* The scalar products of each range. */
struct products {
    struct component_sums a[PARALLEL_RANGES_COUNT], b[PARALLEL_RANGES_COUNT];
};

struct bicgstab_work *bicgstab_work_lent(int n, double *const space[5])
{
    struct bicgstab_work *const w = owner_create(sizeof *w);

    *w = (struct bicgstab_work){.n = n,
                                .r = space[0],
                                .shadow = space[1],
                                .ph = space[2],
                                .v = space[3],
                                .t = space[4]};
    return w;
}

static struct lanes bicgstab_spread(const struct component_sums *c)
{
    struct lanes l;

    for (int q = 0; q < LANES; q++)
        l.at[q] = c->at[q % 3];
    return l;
}

static struct component_sums total(const struct component_sums *partial)
{
    struct component_sums sum = {{0.0}};

    for (int s = 0; s < PARALLEL_RANGES_COUNT; s++)
        for (int k = 0; k < 3; k++)
            sum.at[k] += partial[s].at[k];
    return sum;
}

/* Adds x.y of rows first .. last - 1 of n, whose numbers begin at x and y, to
 * the sums of their range. */
static void add_products(int first, int last, int n, const double *x,
                         const double *y, struct component_sums *partial)
{
    double dot[3];

    reduce_range_many(0, last - first, 3, x, y, dot);
    for (int k = 0; k < 3; k++)
        partial[parallel_ranges_of(n, first)].at[k] += dot[k];
}

static int bicgstab_block_end(int first, int last)
{
    return first + BLOCK < last ? first + BLOCK : last;
}

/* The diagonal of `width` numbers from the i-th on. */
static inline void bicgstab_diagonal(int width, long i,
                                     const struct bicgstab_work *w,
                                     double *restrict diag)
{
    if (w->diagonals == 1)
        vec3_spread(width / 3, w->diag + i / 3, diag);
    else
        memcpy(diag, w->diag + i, (size_t)width * sizeof *diag);
}

/* One over it. */
static inline void bicgstab_invert(int width, long i,
                                   const struct bicgstab_work *w,
                                   double *restrict inverse)
{
    const double *restrict diag = w->diag + (w->diagonals == 3 ? i : i / 3);
    double one[LANES / 3];

    for (int q = 0; q < width && w->diagonals == 3; q++)
        inverse[q] = 1.0 / diag[q];
    if (w->diagonals == 3) return;
    for (int q = 0; q < width / 3; q++)
        one[q] = 1.0 / diag[q];
    vec3_spread(width / 3, one, inverse);
}

/* ph = (r + beta (p - omega v)) / diag. */
static void bicgstab_update_direction_rows(int width, long i,
                                           const struct bicgstab_work *w,
                                           const double *beta,
                                           const double *omega)
{
    const double *restrict r = w->r + i, *restrict v = w->v + i;
    double *restrict ph = w->ph + i, inverse[LANES];

    bicgstab_invert(width, i, w, inverse);
    for (int q = 0; q < width; q++)
        ph[q] =
            (r[q] - beta[q] * omega[q] * v[q]) * inverse[q] + beta[q] * ph[q];
}

static void bicgstab_update_direction(int first, int last,
                                      const struct bicgstab_work *w,
                                      const struct component_sums *beta,
                                      const struct component_sums *omega)
{
    const struct lanes b = bicgstab_spread(beta), o = bicgstab_spread(omega);
    long i = 3L * first;

    for (; i + LANES <= 3L * last; i += LANES)
        bicgstab_update_direction_rows(LANES, i, w, b.at, o.at);
    for (; i < 3L * last; i += 3)
        bicgstab_update_direction_rows(3, i, w, b.at, o.at);
}

/* s = r - alpha v, and sh = s / diag in the place of r. */
static inline void half_rows(int width, long i, const struct bicgstab_work *w,
                             const double *alpha, double *restrict s)
{
    const double *restrict v = w->v + i;
    double *restrict r = w->r + i, inverse[LANES];

    bicgstab_invert(width, i, w, inverse);
    for (int q = 0; q < width; q++) {
        s[q] = r[q] - alpha[q] * v[q];
        r[q] = s[q] * inverse[q];
    }
}

/* Computes all rows of a range, and s.s. */
static void half(int first, int last, const struct bicgstab_work *w,
                 const struct component_sums *alpha, struct products *found)
{
    const struct lanes a = bicgstab_spread(alpha);
    double s[3 * BLOCK];

    for (int end; first < last; first = end) {
        const long at = 3L * first;
        long i = at;
        end = bicgstab_block_end(first, last);
        for (; i + LANES <= 3L * end; i += LANES)
            half_rows(LANES, i, w, a.at, s + (i - at));
        for (; i < 3L * end; i += 3)
            half_rows(3, i, w, a.at, s + (i - at));
        add_products(first, end, w->n, s, s, found->a);
    }
}

/* x += alpha ph + omega sh, r = s - omega t. */
static inline void move_rows(int width, long i, const struct bicgstab_work *w,
                             const double *alpha, const double *omega,
                             double *restrict x)
{
    const double *restrict ph = w->ph + i, *restrict t = w->t + i;
    double *restrict r = w->r + i, diag[LANES];

    bicgstab_diagonal(width, i, w, diag);
    for (int q = 0; q < width; q++) {
        x[i + q] += alpha[q] * ph[q] + omega[q] * r[q];
        r[q] = diag[q] * r[q] - omega[q] * t[q];
    }
}

/* Computes all rows of a range, and r.r and shadow.r. */
static void bicgstab_move(int first, int last, const struct bicgstab_work *w,
                          const struct component_sums *alpha,
                          const struct component_sums *omega, double *x,
                          struct products *found)
{
    const struct lanes a = bicgstab_spread(alpha), o = bicgstab_spread(omega);

    for (int end; first < last; first = end) {
        long i = 3L * first;
        end = bicgstab_block_end(first, last);
        for (; i + LANES <= 3L * end; i += LANES)
            move_rows(LANES, i, w, a.at, o.at, x);
        for (; i < 3L * end; i += 3)
            move_rows(3, i, w, a.at, o.at, x);
        add_products(first, end, w->n, w->r + 3L * first, w->r + 3L * first,
                     found->a);
        add_products(first, end, w->n, w->shadow + 3L * first,
                     w->r + 3L * first, found->b);
    }
}

/* r = b - r; sets the first shadow residual and direction of `width` numbers.
 */
static inline void start_rows(int width, long i, const double *b,
                              const struct bicgstab_work *w)
{
    double *restrict r = w->r + i, *restrict shadow = w->shadow + i;
    double *restrict ph = w->ph + i, inverse[LANES];

    bicgstab_invert(width, i, w, inverse);
    for (int q = 0; q < width; q++) {
        r[q] = shadow[q] = b[i + q] - r[q];
        ph[q] = r[q] * inverse[q];
    }
}

/* r = b - A x; sets the first shadow residual and direction, r.r and b.b. */
static void bicgstab_begin_rows(int first, int last, const struct ldu *A,
                                const double *diag, const double *b,
                                const double *x, const struct bicgstab_work *w,
                                struct products *found)
{
    for (int end; first < last; first = end) {
        long i = 3L * first;

        end = bicgstab_block_end(first, last);
        ldu_rows(first, end, A, diag, x, w->r);
        for (; i + LANES <= 3L * end; i += LANES)
            start_rows(LANES, i, b, w);
        for (; i < 3L * end; i += 3)
            start_rows(3, i, b, w);
        add_products(first, end, w->n, w->r + 3L * first, w->r + 3L * first,
                     found->a);
        add_products(first, end, w->n, b + 3L * first, b + 3L * first,
                     found->b);
    }
}

/* v = A ph; computes shadow.v as well. */
static void first_product(int first, int last, const struct ldu *A,
                          const double *diag, const struct bicgstab_work *w,
                          struct products *found)
{
    for (int end; first < last; first = end) {
        end = bicgstab_block_end(first, last);
        ldu_rows(first, end, A, diag, w->ph, w->v);
        add_products(first, end, w->n, w->shadow + 3L * first,
                     w->v + 3L * first, found->a);
    }
}

/* t = A sh; computes t.s and t.t as well. */
static void second_product(int first, int last, const struct ldu *A,
                           const double *diag, const struct bicgstab_work *w,
                           struct products *found)
{
    double s[3 * BLOCK];

    for (int end; first < last; first = end) {
        end = bicgstab_block_end(first, last);
        ldu_rows(first, end, A, diag, w->r, w->t);
        ldu_diagonal_rows(first, end, A, diag, w->r, s);
        add_products(first, end, w->n, w->t + 3L * first, s, found->a);
        add_products(first, end, w->n, w->t + 3L * first, w->t + 3L * first,
                     found->b);
    }
}

/* The state of the iteration. */
struct state {
    struct component_sums rr, rho;      /* r.r, shadow.r */
    struct component_sums alpha, omega; /* the last steps */
    struct component_sums shadow_r;     /* after them */
    double start; /* |r| of the worst component at begin */
};

static double bicgstab_worst(const struct component_sums *rr)
{
    double most = 0.0;

    for (int k = 0; k < 3 && !isnan(most); k++)
        if (!(rr->at[k] <= most)) most = rr->at[k]; /* NaN is the worst */
    return sqrt(most);
}

/* Returns the scale, |b|. */
static double bicgstab_begin(const struct ldu *A, const double *diag,
                             const double *b3, const double *x3,
                             struct bicgstab_work *w, struct state *s)
{
    struct products found = {0};

    w->diag = diag;
    w->diagonals = A->diagonals;
    PARALLEL_RANGES(w->n, 12, bicgstab_begin_rows, A, diag, b3, x3, w, &found);
    s->rr = s->rho = total(found.a);
    s->start = bicgstab_worst(&s->rr);

    const struct component_sums bb = total(found.b);

    return sqrt(bb.at[0] + bb.at[1] + bb.at[2]);
}

/* top / bottom for the components that have not converged; the result is 0 for
 * those whose residual is not above target, and where the method breaks down.
 */
static struct component_sums ratio(const struct component_sums *top,
                                   const struct component_sums *bottom,
                                   const struct component_sums *rr,
                                   double target)
{
    struct component_sums c = {{0.0}};

    for (int k = 0; k < 3; k++) {
        const double q = top->at[k] / bottom->at[k];

        if (sqrt(rr->at[k]) > target && isfinite(q)) c.at[k] = q;
    }
    return c;
}

/* Computes the next x and residual; the direction stays. */
static void bicgstab_step(const struct ldu *A, const double *diag, double *x3,
                          double target, struct bicgstab_work *w,
                          struct state *s)
{
    struct products v = {0}, half_way = {0}, t = {0}, end = {0};

    PARALLEL_RANGES(w->n, 12, first_product, A, diag, w, &v);

    const struct component_sums sv = total(v.a);

    s->alpha = ratio(&s->rho, &sv, &s->rr, target);
    s->omega = (struct component_sums){{0.0}};
    PARALLEL_RANGES(w->n, 3, half, w, &s->alpha, &half_way);
    s->rr = total(half_way.a);
    if (bicgstab_worst(&s->rr) > target) {
        PARALLEL_RANGES(w->n, 12, second_product, A, diag, w, &t);

        const struct component_sums ts = total(t.a), tt = total(t.b);

        s->omega = ratio(&ts, &tt, &s->rr, target);
    }
    PARALLEL_RANGES(w->n, 3, bicgstab_move, w, &s->alpha, &s->omega, x3, &end);
    s->rr = total(end.a);
    s->shadow_r = total(end.b);
}

/* Sets the next direction. Returns 0 if a component that has not converged has
 * none: its step was zero, or its residual is orthogonal to the shadow
 * residual. */
static int choose_direction(double target, struct bicgstab_work *w,
                            struct state *s)
{
    const struct component_sums rho = s->shadow_r;
    struct component_sums beta = {{0.0}};

    for (int k = 0; k < 3; k++) {
        const double r = sqrt(s->rr.at[k]);
        const double b =
            rho.at[k] / s->rho.at[k] * s->alpha.at[k] / s->omega.at[k];

        if (r <= target) continue;
        if (!isfinite(b) || fabs(rho.at[k]) < least_cosine * r * s->start)
            return 0;
        beta.at[k] = b;
    }
    s->rho = rho;
    PARALLEL_RANGES(w->n, 3, bicgstab_update_direction, w, &beta, &s->omega);
    return 1;
}

struct solve_report bicgstab_solve(const struct ldu *A, const double *diag,
                                   const double *b3, double *x3,
                                   double tolerance, double absolute,
                                   int max_iterations, struct bicgstab_work *w)
{
    struct solve_report report = {0, 0.0, 0.0, 1};
    struct state s;
    const double scale = bicgstab_begin(A, diag, b3, x3, w, &s);
    const double target = /* what is smaller counts as zero (cg.c) */
        fmax(fmax(tolerance * scale, absolute), sqrt(DBL_MIN));

    if (scale == 0.0) {
        memset(x3, 0, 3 * (size_t)w->n * sizeof *x3);
        memset(w->r, 0, 3 * (size_t)w->n * sizeof *w->r);
        return report;
    }
    report.before = s.start / scale;
    while (bicgstab_worst(&s.rr) > target &&
           report.iterations < max_iterations) {
        const double before = bicgstab_worst(&s.rr);

        bicgstab_step(A, diag, x3, target, w, &s);
        report.iterations++;
        if (!(bicgstab_worst(&s.rr) > target)) break;
        if (choose_direction(target, w, &s)) continue;
        if (bicgstab_worst(&s.rr) == before)
            break; /* a restart would repeat this step */
        bicgstab_begin(A, diag, b3, x3, w, &s);
    }
    report.after = bicgstab_worst(&s.rr) / scale;
    report.converged = bicgstab_worst(&s.rr) <= target;
    return report;
}

const double *bicgstab_residual(const struct bicgstab_work *w)
{
    return w->r;
}
