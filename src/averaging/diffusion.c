/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/diffusion.h"

#include <assert.h>
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/averaging.h"
#include "averaging/bandwidth.h"
#include "averaging/hosts.h"
#include "averaging/separable.h"
#include "base/alloc.h"
#include "linear/cg_many.h"
#include "linear/chebyshev.h"
#include "linear/csr.h"

enum { MAX_ITERATIONS = 1000 };

struct diffusion {
    const struct hosts *h; /* borrowed */
    const struct scheme *scheme;
    struct bandwidth *vary; /* NULL: everywhere the same */
    int steps;              /* [-] */
    int fields;             /* [-] room in the arrays below */
    double tolerance;       /* [-] */
    double dtau;            /* [m^2] T / steps */
    struct separable *box;  /* of a box, see bandwidth_is_by_lines; else NULL */
    struct csr *K;          /* [m] -V times div (D grad) */
    double most;            /* [-] largest D that the series is made for */
    struct chebyshev *series;
    struct csr *A; /* [m^3] V + (a share of) dtau K */
    struct cg_many_work *work;
    double *rhs;    /* [m^3 times the field] */
    double *stage;  /* of a step, as wide */
    double *wide;   /* a field padded to `fields` */
    double *smooth; /* a copy of the field to be gathered */
};

/* How one scheme takes a step on m fields side by side. */
struct scheme {
    const char *name;
    double implicit; /* [-] share of dtau K in A */
    void (*step)(struct diffusion *, int m, double *u,
                 struct averaging_report *r); /* NULL: no steps */
};

double diffusion_kernel(double r, double b)
{
    const double s = b * b * M_PI;
    return exp(-r * r / (b * b)) / (s * sqrt(s)); /* [SX15 6] */
}

double diffusion_time(double b)
{
    return b * b / 4.0;
}

double diffusion_bandwidth(double T)
{
    return sqrt(4.0 * T);
}

/* Coefficient of the flux through internal face f: g (phi_N - phi_P) [m]. */
static double link_strength(const struct mesh *m, int f)
{
    const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
    const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
    const double Sd = S[0] * d[0] + S[1] * d[1] + S[2] * d[2];
    return SS / Sd;
}

double diffusion_safe_steps(const struct mesh *m, double b)
{
    return 0.5 * diffusion_time(b) * mesh_diffusion_rate(m);
}

/* A = diag + factor times the Laplacian of [SX15 5a]; only internal faces have
 * a flux [SX15 5c]. D: one more factor for each face, or NULL. */
static void fill_matrix(struct csr *A, const struct mesh *m, const double *diag,
                        double factor, const double *D)
{
    for (int c = 0; c < m->n_cells; c++)
        A->diag[c] = diag != NULL ? diag[c] : 0.0;
    for (int f = 0; f < m->n_internal; f++) {
        const double g =
            factor * link_strength(m, f) * (D != NULL ? D[f] : 1.0);
        A->a[A->upper[f]] = A->a[A->lower[f]] = -g;
        A->diag[m->owner[f]] += g;
        A->diag[m->neighbour[f]] += g;
    }
}

/* exp(-T L): in a box by its directions, else by the series. */
static void apply_exponential(struct diffusion *d, int m, double *u,
                              struct averaging_report *r)
{
    if (d->box != NULL)
        separable_apply(d->box, m, u);
    else
        chebyshev_apply(d->series, m, u);
    r->products = d->box != NULL ? 0 : chebyshev_products(d->series);
    r->worst = (struct solve_report){.converged = 1};
}

/* rhs = V u - factor K y, for m fields side by side. */
static void right_side(struct diffusion *d, int m, double factor,
                       const double *u, const double *y)
{
    const double *const V = d->h->mesh->V;
    const int n = d->h->mesh->n_cells;

    if (factor > 0.0) csr_multiply_many(d->K, m, y, d->rhs);
#pragma omp parallel for schedule(static)
    for (int c = 0; c < n; c++)
        for (int k = m * c; k < m * c + m; k++)
            d->rhs[k] = V[c] * u[k] - (factor > 0.0 ? factor * d->rhs[k] : 0.0);
}

static void worse_of(struct solve_report *worst, const struct solve_report *one)
{
    const int failed = worst->converged && !one->converged;

    worst->iterations = GSL_MAX_INT(worst->iterations, one->iterations);
    worst->converged = worst->converged && one->converged;
    if (failed || one->after > worst->after) {
        worst->before = one->before;
        worst->after = one->after;
    }
}

/* A u = rhs. The guess in u is a field of the same sum, and the solver is
 * preconditioned by V: then it keeps the sum of V u to rounding [SX15 A.5],
 * however early it stops. */
static void solve(struct diffusion *d, double *u, struct averaging_report *r)
{
    const struct solve_report one =
        cg_many_solve(d->A, d->h->mesh->V, d->rhs, u, d->tolerance, 0.0,
                      MAX_ITERATIONS, d->work);
    worse_of(&r->worst, &one);
    r->products += one.iterations + 1;
}

/* Crank-Nicolson or implicit Euler: A u_new = V u - what is explicit. */
static void theta_step(struct diffusion *d, int m, double *u,
                       struct averaging_report *r)
{
    const double factor = (1.0 - d->scheme->implicit) * d->dtau;

    right_side(d, m, factor, u, u);
    r->products += factor > 0.0;
    solve(d, u, r);
}

/* Two stages with one matrix; the second is the step:
 *     A y = V u,  A u_new = V u - (1 - gamma) dtau K y,  A = V + gamma dtau K.
 * Of second order for gamma = 1 - 1/sqrt 2, and a wave of any length is gone
 * after a step that is long enough (L-stable). */
static void sdirk2_step(struct diffusion *d, int m, double *u,
                        struct averaging_report *r)
{
    const int n = m * d->h->mesh->n_cells;
    const double factor = (1.0 - d->scheme->implicit) * d->dtau;

    memcpy(d->stage, u, (size_t)n * sizeof *u);
    right_side(d, m, 0.0, u, u);
    solve(d, d->stage, r);
    right_side(d, m, factor, u, d->stage);
    r->products++;
    solve(d, u, r);
}

static void apply_steps(struct diffusion *d, int m, double *u,
                        struct averaging_report *r)
{
    r->products = 0;
    r->worst = (struct solve_report){.converged = 1};
    for (int step = 0; step < d->steps; step++)
        d->scheme->step(d, m, u, r);
}

/* The solver's work space has a fixed number of fields: the missing ones are
 * zero, for which it has nothing to do. */
static void apply_padded(struct diffusion *d, int m, double *u,
                         struct averaging_report *r)
{
    const int n = d->h->mesh->n_cells, all = d->fields;
    double *const wide = d->wide;

    if (m == all) {
        apply_steps(d, m, u, r);
        return;
    }
#pragma omp parallel for schedule(static)
    for (int c = 0; c < n; c++)
        for (int k = 0; k < all; k++)
            wide[all * c + k] = k < m ? u[m * c + k] : 0.0;
    apply_steps(d, all, wide, r);
#pragma omp parallel for schedule(static)
    for (int c = 0; c < n; c++)
        for (int k = 0; k < m; k++)
            u[m * c + k] = wide[all * c + k];
}

static const struct scheme schemes[] = {
    {"exponential", 0.0, NULL},
    {"series", 0.0, NULL},
    {"crank-nicolson", 0.5, theta_step},
    {"implicit-euler", 1.0, theta_step},
    {"sdirk2", 1.0 - M_SQRT1_2, sdirk2_step},
};

const char *const diffusion_schemes[] = {"exponential",    "series",
                                         "crank-nicolson", "implicit-euler",
                                         "sdirk2",         NULL};

static void smooth(struct diffusion *d, int m, double *u,
                   struct averaging_report *r)
{
    if (d->scheme->step == NULL)
        apply_exponential(d, m, u, r);
    else
        apply_padded(d, m, u, r);
}

static const struct scheme *scheme_named(const char *name)
{
    for (size_t i = 0; i < sizeof schemes / sizeof *schemes; i++)
        if (name == NULL || strcmp(schemes[i].name, name) == 0)
            return &schemes[i];
    return NULL;
}

static int is_a_rule(const char *name)
{
    for (int i = 0; bandwidth_rules[i] != NULL; i++)
        if (strcmp(bandwidth_rules[i], name) == 0) return 1;
    return 0;
}

/* 0, or non-zero after a message that says what is wrong. */
static int wrong_options(const struct averaging_options *o)
{
    if (scheme_named(o->scheme) == NULL)
        return fprintf(
            stderr,
            "winnow: the diffusion has no scheme \"%s\"; expected "
            "exponential, series, crank-nicolson, implicit-euler or sdirk2\n",
            o->scheme);
    if (!is_a_rule(o->vary))
        return fprintf(stderr,
                       "winnow: the bandwidth of the diffusion cannot vary by "
                       "\"%s\"; expected uniform, cells or grains\n",
                       o->vary);
    if (o->steps < 1)
        return fprintf(stderr,
                       "winnow: the diffusion has %d steps; "
                       "expected 1 or more [-]\n",
                       o->steps);
    return 0;
}

static void fill_matrices(struct diffusion *d)
{
    const struct mesh *const m = d->h->mesh;
    const double *const D = d->vary != NULL ? bandwidth_D(d->vary) : NULL;

    fill_matrix(d->K, m, NULL, 1.0, D);
    if (d->A != NULL)
        fill_matrix(d->A, m, m->V, d->scheme->implicit * d->dtau, D);
}

/* The series for the matrix with the largest D that may come, on all faces; K
 * has its own coefficients afterwards. */
static void make_series(struct diffusion *d)
{
    const struct mesh *const m = d->h->mesh;

    d->most = d->vary != NULL ? bandwidth_largest(d->vary) : 1.0;
    fill_matrix(d->K, m, NULL, d->most, NULL);
    chebyshev_free(d->series);
    d->series = chebyshev_create(d->K, m->V, d->dtau * d->steps, d->tolerance,
                                 d->fields);
}

/* Makes what the solver of a scheme with steps works on. */
static void make_solver(struct diffusion *d)
{
    const struct mesh *const m = d->h->mesh;
    const int n = m->n_cells;

    d->A = csr_create(n, m->n_internal, m->owner, m->neighbour);
    d->work = cg_many_work_create(n, d->fields);
    d->rhs = alloc_doubles(n * d->fields);
    d->stage = alloc_doubles(n * d->fields);
    d->wide = alloc_doubles(n * d->fields);
}

static void *diffusion_create(const struct hosts *h,
                              const struct averaging_options *o)
{
    if (wrong_options(o)) return NULL;
    struct diffusion *const d = alloc_zeroed(1, sizeof *d);
    const struct mesh *const m = h->mesh;

    d->h = h;
    d->scheme = scheme_named(o->scheme);
    d->steps = o->steps;
    d->fields = o->fields;
    d->tolerance = o->tolerance;
    d->dtau = diffusion_time(o->bandwidth) / d->steps;
    d->vary = bandwidth_create(h, o);
    d->smooth = alloc_doubles(m->n_cells * d->fields);
    const double b = d->vary != NULL ? o->bandwidth : 0.0;
    if (d->scheme == &schemes[0] && bandwidth_is_by_lines(o))
        d->box = separable_create(&m->box, d->dtau * o->steps, b, o->tolerance);
    if (d->box != NULL) return d;
    d->K = csr_create(m->n_cells, m->n_internal, m->owner, m->neighbour);
    if (d->scheme->step != NULL)
        make_solver(d);
    else
        make_series(d);
    fill_matrices(d);
    return d;
}

/* Where the bandwidth follows the grains there are new matrices. The series
 * holds for smaller coefficients than it is made for. */
static void diffusion_bind(void *state, struct averaging_report *r)
{
    struct diffusion *const d = state;

    (void)r;
    if (d->vary == NULL || !bandwidth_bind(d->vary)) return;
    if (d->series != NULL && bandwidth_largest(d->vary) > d->most)
        make_series(d);
    fill_matrices(d);
}

static void diffusion_free(void *state)
{
    struct diffusion *const d = state;

    bandwidth_free(d->vary);
    separable_free(d->box);
    csr_free(d->K);
    csr_free(d->A);
    chebyshev_free(d->series);
    cg_many_work_free(d->work);
    free(d->rhs);
    free(d->stage);
    free(d->wide);
    free(d->smooth);
    free(d);
}

static void diffusion_spread(void *state, int m, const double *q, double *field,
                             struct averaging_report *r)
{
    struct diffusion *const d = state;

    hosts_sum(d->h, m, q, field); /* [SX15 5b] */
    smooth(d, m, field, r);
}

/* exp(-T V^-1 K) is its own adjoint in the inner product weighted by V, so to
 * gather is to smooth the field and to take the host's value. */
static void diffusion_gather(void *state, int m, const double *field, double *q,
                             struct averaging_report *r)
{
    struct diffusion *const d = state;
    const int n = m * d->h->mesh->n_cells;

    memcpy(d->smooth, field, (size_t)n * sizeof *field);
    smooth(d, m, d->smooth, r);
    hosts_value(d->h, m, d->smooth, q);
}

const struct averaging_method diffusion_method = {
    .name = "diffusion",
    .cite = "SX15 5, 6, 9",
    .what = "the pcm field, smoothed by diffusion",
    .function = "diffusion_spread",
    .wide = 1,
    .create = diffusion_create,
    .free = diffusion_free,
    .bind = diffusion_bind,
    .spread = diffusion_spread,
    .gather = diffusion_gather,
};
