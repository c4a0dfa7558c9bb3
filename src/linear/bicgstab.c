/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/bicgstab.h"

#include "base/alloc.h"
#include "linear/reduce.h"
#include "linear/strips.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The vectors of the method [Saad03, 9.5]: residual r (also s, its half-way
 * value), shadow residual, direction p, v = A ph and t = A sh with ph and sh
 * the preconditioned p and s. */
struct bicgstab_work {
    int n;
    double *r, *shadow, *p, *ph, *v, *sh, *t;
    double *inverse; /* one over diag3 */
};

/* One number a component. */
struct triple {
    double at[3];
};

/* A residual whose cosine with the shadow is less gives no direction. */
static const double square = 1e-14;

/* The same for eight rows: loops over 24 numbers run at vector speed. */
enum { LANES = 24 };
struct lanes {
    double at[LANES];
};

struct bicgstab_work *bicgstab_work_create(int n)
{
    struct bicgstab_work *const w = alloc_zeroed(1, sizeof *w);

    w->n = n;
    w->r = alloc_doubles(3 * n);
    w->shadow = alloc_doubles(3 * n);
    w->p = alloc_doubles(3 * n);
    w->ph = alloc_doubles(3 * n);
    w->v = alloc_doubles(3 * n);
    w->sh = alloc_doubles(3 * n);
    w->t = alloc_doubles(3 * n);
    w->inverse = alloc_doubles(3 * n);
    return w;
}

void bicgstab_work_free(struct bicgstab_work *w)
{
    if (w == NULL) return;
    free(w->r);
    free(w->shadow);
    free(w->p);
    free(w->ph);
    free(w->v);
    free(w->sh);
    free(w->t);
    free(w->inverse);
    free(w);
}

static struct lanes spread(const struct triple *c)
{
    struct lanes l;

    for (int q = 0; q < LANES; q++)
        l.at[q] = c->at[q % 3];
    return l;
}

/* p = r + beta (p - omega v), ph = p / diag. */
static inline void turn_rows(int width, long i, const struct bicgstab_work *w,
                             const double *beta, const double *omega)
{
    const double *restrict r = w->r + i, *restrict v = w->v + i;
    const double *restrict inverse = w->inverse + i;
    double *restrict p = w->p + i, *restrict ph = w->ph + i;

    for (int q = 0; q < width; q++) {
        p[q] = r[q] + beta[q] * (p[q] - omega[q] * v[q]);
        ph[q] = p[q] * inverse[q];
    }
}

static void turn(int first, int last, const struct bicgstab_work *w,
                 const struct triple *beta, const struct triple *omega)
{
    const struct lanes b = spread(beta), o = spread(omega);
    long i = 3L * first;

    for (; i + LANES <= 3L * last; i += LANES)
        turn_rows(LANES, i, w, b.at, o.at);
    for (; i < 3L * last; i += 3)
        turn_rows(3, i, w, b.at, o.at);
}

/* s = r - alpha v in the place of r, sh = s / diag. */
static inline void half_rows(int width, long i, const struct bicgstab_work *w,
                             const double *alpha)
{
    const double *restrict v = w->v + i, *restrict inverse = w->inverse + i;
    double *restrict r = w->r + i, *restrict sh = w->sh + i;

    for (int q = 0; q < width; q++) {
        r[q] -= alpha[q] * v[q];
        sh[q] = r[q] * inverse[q];
    }
}

static void half(int first, int last, const struct bicgstab_work *w,
                 const struct triple *alpha)
{
    const struct lanes a = spread(alpha);
    long i = 3L * first;

    for (; i + LANES <= 3L * last; i += LANES)
        half_rows(LANES, i, w, a.at);
    for (; i < 3L * last; i += 3)
        half_rows(3, i, w, a.at);
}

/* x += alpha ph + omega sh, r = s - omega t. */
static inline void move_rows(int width, long i, const struct bicgstab_work *w,
                             const double *alpha, const double *omega,
                             double *restrict x)
{
    const double *restrict ph = w->ph + i, *restrict sh = w->sh + i;
    const double *restrict t = w->t + i;
    double *restrict r = w->r + i;

    for (int q = 0; q < width; q++) {
        x[i + q] += alpha[q] * ph[q] + omega[q] * sh[q];
        r[q] -= omega[q] * t[q];
    }
}

static void move(int first, int last, const struct bicgstab_work *w,
                 const struct triple *alpha, const struct triple *omega,
                 double *x)
{
    const struct lanes a = spread(alpha), o = spread(omega);
    long i = 3L * first;

    for (; i + LANES <= 3L * last; i += LANES)
        move_rows(LANES, i, w, a.at, o.at, x);
    for (; i < 3L * last; i += 3)
        move_rows(3, i, w, a.at, o.at, x);
}

/* r = b - r, and with it the first shadow and direction. */
static void begin_rows(int first, int last, const struct bicgstab_work *w,
                       const double *b, const double *diag)
{
    for (long i = 3L * first; i < 3L * last; i++) {
        const double r = b[i] - w->r[i];

        w->inverse[i] = 1.0 / diag[i];
        w->r[i] = w->shadow[i] = w->p[i] = r;
        w->ph[i] = r * w->inverse[i];
    }
}

static struct triple dot(int n, const double *x, const double *y)
{
    struct triple sum;

    reduce_dot_many(n, 3, x, y, sum.at);
    return sum;
}

/* Where an iteration stands. */
struct state {
    struct triple rr, rho;      /* r.r, shadow.r */
    struct triple alpha, omega; /* the last steps */
    double start;               /* |r| of the worst component at begin */
};

static double worst(const struct triple *rr)
{
    double most = 0.0;

    for (int k = 0; k < 3 && !isnan(most); k++)
        if (!(rr->at[k] <= most)) most = rr->at[k]; /* NaN is the worst */
    return sqrt(most);
}

static void begin(const struct csr *A, const double *diag3, const double *b3,
                  const double *x3, struct bicgstab_work *w, struct state *s)
{
    csr_multiply_each(A, 3, diag3, x3, w->r);
    STRIPS_RUN(w->n, 3, begin_rows, w, b3, diag3);
    s->rr = s->rho = dot(w->n, w->r, w->r);
    s->start = worst(&s->rr);
}

/* top / bottom for the components still at work; 0 for those that rest,
 * because their residual is below target, and where the method breaks down. */
static struct triple ratio(const struct triple *top,
                           const struct triple *bottom, const struct triple *rr,
                           double target)
{
    struct triple c = {{0.0}};

    for (int k = 0; k < 3; k++) {
        const double q = top->at[k] / bottom->at[k];

        if (sqrt(rr->at[k]) > target && isfinite(q)) c.at[k] = q;
    }
    return c;
}

/* From one residual to the next, without a new direction. */
static void step(const struct csr *A, const double *diag3, double *x3,
                 double target, struct bicgstab_work *w, struct state *s)
{
    csr_multiply_each(A, 3, diag3, w->ph, w->v);

    const struct triple sv = dot(w->n, w->shadow, w->v);

    s->alpha = ratio(&s->rho, &sv, &s->rr, target);
    s->omega = (struct triple){{0.0}};
    STRIPS_RUN(w->n, 3, half, w, &s->alpha);
    s->rr = dot(w->n, w->r, w->r);
    if (worst(&s->rr) > target) {
        csr_multiply_each(A, 3, diag3, w->sh, w->t);

        const struct triple ts = dot(w->n, w->t, w->r);
        const struct triple tt = dot(w->n, w->t, w->t);

        s->omega = ratio(&ts, &tt, &s->rr, target);
    }
    STRIPS_RUN(w->n, 3, move, w, &s->alpha, &s->omega, x3);
    s->rr = dot(w->n, w->r, w->r);
}

/* The next direction, or 0 if a component at work has none: its step was zero,
 * or its residual has turned square to the shadow. */
static int redirect(double target, struct bicgstab_work *w, struct state *s)
{
    const struct triple rho = dot(w->n, w->shadow, w->r);
    struct triple beta = {{0.0}};

    for (int k = 0; k < 3; k++) {
        const double r = sqrt(s->rr.at[k]);
        const double b =
            rho.at[k] / s->rho.at[k] * s->alpha.at[k] / s->omega.at[k];

        if (r <= target) continue;
        if (!isfinite(b) || fabs(rho.at[k]) < square * r * s->start) return 0;
        beta.at[k] = b;
    }
    s->rho = rho;
    STRIPS_RUN(w->n, 3, turn, w, &beta, &s->omega);
    return 1;
}

struct solve_report bicgstab_solve(const struct csr *A, const double *diag3,
                                   const double *b3, double *x3,
                                   double tolerance, double absolute,
                                   int max_iterations, struct bicgstab_work *w)
{
    struct solve_report report = {0, 0.0, 0.0, 1};
    const double scale = sqrt(reduce_dot(3 * w->n, b3, b3));
    const double target = fmax(tolerance * scale, absolute);
    struct state s;

    if (scale == 0.0) {
        memset(x3, 0, 3 * (size_t)w->n * sizeof *x3);
        return report;
    }
    begin(A, diag3, b3, x3, w, &s);
    report.before = s.start / scale;
    while (worst(&s.rr) > target && report.iterations < max_iterations) {
        const double before = worst(&s.rr);

        step(A, diag3, x3, target, w, &s);
        report.iterations++;
        if (!(worst(&s.rr) > target)) break;
        if (redirect(target, w, &s)) continue;
        if (worst(&s.rr) == before) break; /* afresh it would be the same */
        begin(A, diag3, b3, x3, w, &s);
    }
    report.after = worst(&s.rr) / scale;
    report.converged = worst(&s.rr) <= target;
    return report;
}
