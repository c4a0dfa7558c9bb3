/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/diffusion.h"

#include <assert.h>
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"
#include "averaging/diffusion_matrix.h"
#include "averaging/diffusion_parts.h"
#include "base/alloc.h"
#include "linear/cg_many.h"
#include "linear/chebyshev.h"
#include "linear/csr.h"

enum { MAX_ITERATIONS = 1000 };

struct diffusion {
    const struct cell_of_particle *h; /* borrowed */
    const struct scheme *scheme;
    const struct diffusion_variation *variation;
    struct bandwidth *vary; /* NULL: everywhere the same */
    int steps;              /* [-] */
    int fields;       /* [-] fields for which the arrays below are allocated */
    double tolerance; /* [-] */
    double dtau;      /* [m^2] T / steps */
    const struct diffusion_operator *direct;
    void *exponential; /* state of direct; NULL: the series is used */
    struct csr *K;     /* [m] -V times div (D grad) */
    double max_fields; /* [-] largest D for which the series holds */
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

double diffusion_safe_steps(const struct mesh *m, double b)
{
    return 0.5 * diffusion_time(b) * mesh_diffusion_rate(m);
}

/* exp(-T L): directly where that is possible, else by the series. */
static void apply_exponential(struct diffusion *d, int m, double *u,
                              struct averaging_report *r)
{
    if (d->exponential != NULL)
        d->direct->apply(d->exponential, m, u);
    else
        chebyshev_apply(d->series, m, u);
    r->products = d->exponential != NULL ? 0 : chebyshev_products(d->series);
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

/* Solves A u = rhs. The initial u has the same sum, and the solver is
 * preconditioned by V, so the sum of V u is conserved to rounding [SX15 A.5]
 * after any number of iterations. */
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
 * The scheme is of second order for gamma = 1 - 1/sqrt 2, and L-stable. */
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

/* The work space of the solver has a fixed number of fields; unused ones are
 * zero, and the solver does no iterations for them. */
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

const struct model bandwidth_uniform = {
    .name = "uniform",
    .what = "the same everywhere, but for regions",
    .equations = "",
    .function = "fill_matrices",
};

static int is_uniform(const struct averaging_options *o)
{
    return strcmp(o->vary, bandwidth_uniform.name) == 0 && o->n_regions == 0;
}

/* The variation that has the rule of the options, or NULL. */
static const struct diffusion_variation *
variation_of(const struct averaging_options *o)
{
    for (int v = 0; diffusion_variations[v] != NULL; v++)
        if (diffusion_variations[v]->has_rule(o->vary))
            return diffusion_variations[v];
    return NULL;
}

static int refuse(const char *what, const char *name, const char *expected)
{
    return fprintf(stderr,
                   "winnow: the diffusion has no %s \"%s\"; expected %s\n",
                   what, name, expected);
}

/* 0, or non-zero after a message that says what is wrong. */
static int wrong_options(const struct averaging_options *o)
{
    if (scheme_named(o->scheme) == NULL)
        return refuse("scheme", o->scheme,
                      "exponential, series, crank-nicolson, implicit-euler or "
                      "sdirk2");
    if (!is_uniform(o) && variation_of(o) == NULL)
        return refuse("variation of its bandwidth",
                      o->n_regions > 0 ? "regions" : o->vary,
                      "uniform, cells or grains");
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
    const double *const D = d->vary != NULL ? d->variation->D(d->vary) : NULL;

    diffusion_matrix_fill(d->K, m, NULL, 1.0, D);
    if (d->A != NULL)
        diffusion_matrix_fill(d->A, m, m->V, d->scheme->implicit * d->dtau, D);
}

/* Creates the series for the matrix with the largest possible D on all faces; K
 * is then set to its actual coefficients. */
static void make_series(struct diffusion *d)
{
    const struct mesh *const m = d->h->mesh;

    d->max_fields = d->vary != NULL ? d->variation->largest(d->vary) : 1.0;
    diffusion_matrix_fill(d->K, m, NULL, d->max_fields, NULL);
    chebyshev_free(d->series);
    d->series = chebyshev_create(d->K, m->V, d->dtau * d->steps, d->tolerance,
                                 d->fields);
}

/* Creates the matrix and the solver of a scheme with steps. */
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

/* Finds a direct way of the exponential, where D is the same on all lines of
 * cells. */
static void find_direct(struct diffusion *d, const struct averaging_options *o)
{
    const double b = d->vary != NULL ? o->bandwidth : 0.0;

    if (d->scheme != &schemes[0]) return;
    if (d->vary != NULL && !d->variation->is_by_lines(o)) return;
    for (int i = 0; diffusion_operators[i] != NULL; i++) {
        d->direct = diffusion_operators[i];
        d->exponential =
            d->direct->create(d->h->mesh, d->dtau * o->steps, b, o->tolerance);
        if (d->exponential != NULL) return;
    }
}

static void *diffusion_create(const struct cell_of_particle *h,
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
    d->variation = variation_of(o);
    d->vary = is_uniform(o) ? NULL : d->variation->create(h, o);
    d->smooth = alloc_doubles(m->n_cells * d->fields);
    find_direct(d, o);
    if (d->exponential != NULL) return d;
    d->K = csr_create(m->n_cells, m->n_internal, m->owner, m->neighbour);
    if (d->scheme->step != NULL)
        make_solver(d);
    else
        make_series(d);
    fill_matrices(d);
    return d;
}

/* Updates the matrices where the bandwidth depends on the particles. The series
 * also holds for smaller coefficients. */
static void diffusion_bind(void *state, struct averaging_report *r)
{
    struct diffusion *const d = state;

    (void)r;
    if (d->vary == NULL || !d->variation->bind(d->vary)) return;
    if (d->series != NULL && d->variation->largest(d->vary) > d->max_fields)
        make_series(d);
    fill_matrices(d);
}

static void diffusion_free(void *state)
{
    struct diffusion *const d = state;

    if (d->vary != NULL) d->variation->free(d->vary);
    if (d->exponential != NULL) d->direct->free(d->exponential);
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

    cell_of_particle_sum(d->h, m, q, field); /* [SX15 5b] */
    smooth(d, m, field, r);
}

/* exp(-T V^-1 K) is its own adjoint in the inner product weighted by V, so to
 * gather is to smooth the field and to take the cell's value. */
static void diffusion_gather(void *state, int m, const double *field, double *q,
                             struct averaging_report *r)
{
    struct diffusion *const d = state;
    const int n = m * d->h->mesh->n_cells;

    memcpy(d->smooth, field, (size_t)n * sizeof *field);
    smooth(d, m, d->smooth, r);
    cell_of_particle_value(d->h, m, d->smooth, q);
}

const struct averaging_method diffusion_method = {
    .name = "diffusion",
    .what = "the pcm field, smoothed by diffusion",
    .equations = "SX15 5, 6, 9",
    .function = "diffusion_spread",
    .keys = {averaging_bandwidth_keys, averaging_delta_keys, diffusion_keys},
    .gaussian = 1.0,
    .needs_bandwidth = 1,
    .create = diffusion_create,
    .free = diffusion_free,
    .bind = diffusion_bind,
    .spread = diffusion_spread,
    .gather = diffusion_gather,
};
