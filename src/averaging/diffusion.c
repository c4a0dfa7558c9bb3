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
#include "averaging/diffusion_variants.h"
#include "base/alloc.h"
#include "linear/chebyshev.h"
#include "linear/csr.h"

struct diffusion {
    const struct cell_of_particle *h; /* borrowed */
    const struct diffusion_scheme *scheme;
    const struct diffusion_variation *variation;
    struct bandwidth *vary; /* NULL: everywhere the same */
    int fields;             /* [-] most in a call */
    double T;               /* [m^2] */
    double tolerance;       /* [-] */
    double *smooth;         /* a copy of the field to be gathered */
    /* The field is smoothed by steps, by the exponential or by its series; the
     * others are NULL. */
    void *steps; /* state of scheme->stepping */
    const struct diffusion_operator *direct;
    void *exponential; /* state of direct */
    struct chebyshev *series;
    struct csr *K;    /* [m] of the series: -V div (D grad) */
    double largest_D; /* [-] for which the series holds */
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

static void smooth(struct diffusion *d, int m, double *u,
                   struct averaging_report *r)
{
    if (d->steps != NULL)
        d->scheme->stepping->apply(d->steps, m, u, r);
    else
        apply_exponential(d, m, u, r);
}

int diffusion_needed_steps(const struct mesh *mesh,
                           const struct averaging_options *o)
{
    const struct diffusion_stepping *const by =
        diffusion_scheme_named(o->scheme)->stepping;
    const int n = by == NULL || by->safe_steps == NULL
                      ? 0
                      : by->safe_steps(mesh, o->bandwidth);

    return o->steps < n ? n : 0;
}

const struct model bandwidth_uniform = {
    .name = "uniform",
    .what = "the same everywhere, but for regions",
    .equations = "",
    .function = "fill_matrix",
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

static int report_unknown(const char *what, const char *name,
                          const char *expected)
{
    return fprintf(stderr,
                   "winnow: the diffusion has no %s \"%s\"; expected %s\n",
                   what, name, expected);
}

/* 0, or non-zero after a message that says what is wrong. */
static int wrong_options(const struct averaging_options *o)
{
    if (diffusion_scheme_named(o->scheme) == NULL)
        return report_unknown(
            "scheme", o->scheme,
            "exponential, series, crank-nicolson, implicit-euler or "
            "sdirk2");
    if (!is_uniform(o) && variation_of(o) == NULL)
        return report_unknown("variation of its bandwidth",
                              o->n_regions > 0 ? "regions" : o->vary,
                              "uniform, cells or grains");
    if (o->steps < 1)
        return fprintf(stderr,
                       "winnow: the diffusion has %d steps; "
                       "expected 1 or more [-]\n",
                       o->steps);
    return 0;
}

static void fill_matrix(struct diffusion *d)
{
    const double *const D = d->vary != NULL ? d->variation->D(d->vary) : NULL;

    if (d->steps != NULL)
        d->scheme->stepping->fill(d->steps, D);
    else
        diffusion_matrix_fill(d->K, d->h->mesh, NULL, 1.0, D);
}

/* Creates the series for the matrix with the largest possible D on all faces;
 * fill_matrix then sets the actual coefficients of K. */
static void make_series(struct diffusion *d, double largest)
{
    const struct mesh *const m = d->h->mesh;

    d->largest_D = largest;
    diffusion_matrix_fill(d->K, m, NULL, d->largest_D, NULL);
    chebyshev_free(d->series);
    d->series = chebyshev_create(d->K, m->V, d->T, d->tolerance, d->fields);
}

/* Finds an operator that applies the exponential directly, where D is the same
 * on all lines of cells. */
static void find_direct(struct diffusion *d, const struct averaging_options *o)
{
    const double b = d->vary != NULL ? o->bandwidth : 0.0;

    if (!d->scheme->directly) return;
    if (d->vary != NULL && !d->variation->is_by_lines(o)) return;
    for (int i = 0; diffusion_operators[i] != NULL; i++) {
        d->direct = diffusion_operators[i];
        d->exponential = d->direct->create(d->h->mesh, d->T, b, o->tolerance);
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
    d->scheme = diffusion_scheme_named(o->scheme);
    d->fields = o->fields;
    d->tolerance = o->tolerance;
    /* rounded as the sum of the steps of the other schemes */
    d->T = diffusion_time(o->bandwidth) / o->steps * o->steps;
    d->variation = variation_of(o);
    d->vary = is_uniform(o) ? NULL : d->variation->create(h, o);
    d->smooth = alloc_doubles(m->n_cells * d->fields);
    find_direct(d, o);
    if (d->exponential != NULL) return d;
    if (d->scheme->stepping != NULL) {
        d->steps = d->scheme->stepping->create(d->scheme, m, o);
    } else {
        d->K = csr_create(m->n_cells, m->n_internal, m->owner, m->neighbour);
        make_series(d, d->vary != NULL ? d->variation->largest(d->vary) : 1.0);
    }
    fill_matrix(d);
    return d;
}

/* The next power of two. */
static double rounded_up(double D)
{
    int exponent;
    const double part = frexp(D, &exponent);

    return ldexp(1.0, part > 0.5 ? exponent : exponent - 1);
}

/* Updates the matrix where the bandwidth depends on the particles. The series
 * also holds for smaller coefficients: its bound is a power of two, which
 * seldom changes, and follows from the present particles alone, as after a
 * resume. */
static void diffusion_bind(void *state, struct averaging_report *r)
{
    struct diffusion *const d = state;

    (void)r;
    if (d->vary == NULL || !d->variation->bind(d->vary)) return;
    if (d->series != NULL) {
        const double bound = rounded_up(d->variation->largest(d->vary));
        if (bound != d->largest_D) make_series(d, bound);
    }
    fill_matrix(d);
}

static void diffusion_free(void *state)
{
    struct diffusion *const d = state;

    if (d->vary != NULL) d->variation->free(d->vary);
    if (d->exponential != NULL) d->direct->free(d->exponential);
    if (d->steps != NULL) d->scheme->stepping->free(d->steps);
    csr_free(d->K);
    chebyshev_free(d->series);
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
