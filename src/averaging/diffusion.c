/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/diffusion.h"

#include <gsl/gsl_math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"
#include "averaging/more/bandwidth.h"
#include "averaging/more/separable.h"
#include "base/alloc.h"
#include "base/model.h"
#include "linear/chebyshev.h"
#include "linear/matrix.h"

struct diffusion {
    const struct cell_of_particle *h; /* borrowed */
    const struct diffusion_scheme *scheme;
    struct bandwidth *vary; /* NULL: everywhere the same */
    int fields;             /* [-] most in a call */
    double T;               /* [m^2] */
    double tolerance;       /* [-] */
    double *smooth;         /* a copy of the field to be gathered */
    /* The field is smoothed by steps, by the exponential or by its series; the
     * others are NULL. */
    void *steps;                 /* state of scheme->stepping */
    struct separable *separable; /* NULL: this mesh or bandwidth has none */
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

/* exp(-T L): directly where that is possible, else by the series. */
static void diffusion_apply_exponential(struct diffusion *d, int m, double *u,
                                        struct averaging_report *r)
{
    if (d->separable != NULL)
        separable_apply(d->separable, m, u);
    else
        chebyshev_apply(d->series, m, u);
    r->products = d->separable != NULL ? 0 : chebyshev_products(d->series);
    r->worst = (struct solve_report){.converged = 1};
}

/* Diffuses m fields u in place by the scheme of the case, in steps or
 * exponentially. */
static void diffusion_smooth(struct diffusion *d, int m, double *u,
                             struct averaging_report *r)
{
    if (d->steps != NULL)
        d->scheme->stepping->apply(d->steps, m, u, r);
    else
        diffusion_apply_exponential(d, m, u, r);
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
    return strcmp(o->vary, bandwidth_uniform.name) == 0 && o->regions.n == 0;
}

static int diffusion_report_unknown(const char *what, const char *name,
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
        return diffusion_report_unknown(
            "scheme", o->scheme,
            "exponential, series, crank-nicolson, implicit-euler or sdirk2");
    if (!bandwidth_has_rule(o->vary))
        return diffusion_report_unknown("variation of its bandwidth",
                                        o->regions.n > 0 ? "regions" : o->vary,
                                        "uniform, cells or grains");
    if (o->steps < 1)
        return fprintf(
            stderr,
            "winnow: the diffusion has %d steps; expected 1 or more [-]\n",
            o->steps);
    return 0;
}

static void fill_matrix(struct diffusion *d)
{
    const double *const D = d->vary != NULL ? bandwidth_D(d->vary) : NULL;

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
    owner_free(d->series);
    d->series = chebyshev_create(d->K, m->V, d->T, d->tolerance, d->fields);
}

/* The exponential applied directly, where the mesh is a box and D is the same
 * on all lines of its cells. */
static void find_separable(struct diffusion *d,
                           const struct averaging_options *o)
{
    const double b = d->vary != NULL ? o->bandwidth : 0.0;

    if (d->scheme->directly && (d->vary == NULL || bandwidth_is_by_lines(o)))
        d->separable = owner_join(
            d, separable_create(&d->h->mesh->box, d->T, b, o->tolerance));
}

static void *diffusion_create(const struct cell_of_particle *h,
                              const struct averaging_options *o)
{
    if (wrong_options(o)) return NULL;
    struct diffusion *const d = owner_create(sizeof *d);
    const struct mesh *const m = h->mesh;

    d->h = h;
    d->scheme = diffusion_scheme_named(o->scheme);
    d->fields = o->fields;
    d->tolerance = o->tolerance;
    /* rounded as the sum of the steps of the other schemes */
    d->T = diffusion_time(o->bandwidth) / o->steps * o->steps;
    if (!is_uniform(o)) d->vary = owner_join(d, bandwidth_create(h, o));
    d->smooth = owner_doubles(d, m->n_cells * d->fields);
    find_separable(d, o);
    if (d->separable != NULL) return d;
    if (d->scheme->stepping != NULL) {
        d->steps = owner_join(d, d->scheme->stepping->create(d->scheme, m, o));
    } else {
        d->K = owner_join(
            d, csr_create(m->n_cells, m->n_internal, m->owner, m->neighbour));
        make_series(d, d->vary != NULL ? bandwidth_largest(d->vary) : 1.0);
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
    if (d->vary == NULL || !bandwidth_bind(d->vary)) return;
    if (d->series != NULL) {
        const double bound = rounded_up(bandwidth_largest(d->vary));
        if (bound != d->largest_D) make_series(d, bound);
    }
    fill_matrix(d);
}

static void diffusion_free(void *state)
{
    struct diffusion *const d = state;

    owner_free(d->series);
    owner_free(d);
}

static void diffusion_spread(void *state, int m, const double *q, double *field,
                             struct averaging_report *r)
{
    struct diffusion *const d = state;

    cell_of_particle_sum(d->h, m, q, field); /* [SX15 5b] */
    diffusion_smooth(d, m, field, r);
}

/* exp(-T V^-1 K) is its own adjoint in the inner product weighted by V, so to
 * gather is to smooth the field and to take the cell's value. */
static void diffusion_gather(void *state, int m, const double *field, double *q,
                             struct averaging_report *r)
{
    struct diffusion *const d = state;
    const int n = m * d->h->mesh->n_cells;

    memcpy(d->smooth, field, (size_t)n * sizeof *field);
    diffusion_smooth(d, m, d->smooth, r);
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

const struct model *const bandwidth_rules[] = {
    &bandwidth_uniform, &bandwidth_cells, &bandwidth_grains, NULL};

/* Coefficient of the flux through internal face f: g (phi_N - phi_P) [m]. */
static double diffusion_coefficient(const struct mesh *m, int f)
{
    const double *const S = mesh_S(m, f), *const d = mesh_d(m, f);
    const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
    const double Sd = S[0] * d[0] + S[1] * d[1] + S[2] * d[2];
    return SS / Sd;
}

/* A = diag + factor times the Laplacian of [SX15 5a]; only internal faces have
 * a flux [SX15 5c]. D: one more factor for each face, or NULL. */
void diffusion_matrix_fill(struct csr *A, const struct mesh *m,
                           const double *diag, double factor, const double *D)
{
    for (int c = 0; c < m->n_cells; c++)
        A->diag[c] = diag != NULL ? diag[c] : 0.0;
    for (int f = 0; f < m->n_internal; f++) {
        const double g =
            factor * diffusion_coefficient(m, f) * (D != NULL ? D[f] : 1.0);
        A->a[A->upper[f]] = A->a[A->lower[f]] = -g;
        A->diag[m->owner[f]] += g;
        A->diag[m->neighbour[f]] += g;
    }
}

/* The keys and the descriptors of diffusion.c.
 * Chapter "Averaging". */

#define AT(member) KEY_AT(averaging_options, member)
#define REGION(member) KEY_AT(averaging_region, member)

const struct key diffusion_keys[] = {
    {"averaging.scheme", KEY_NAME, "", "", "exponential",
     "time scheme of the diffusion", "SX15 5", "", AT(scheme)},
    {"averaging.tolerance", KEY_REAL, "-", ">= 1e-15, < 1", "1e-6",
     "relative residual of the diffusion solver; with an implicit scheme about "
     "the relative error of the exchanged momentum",
     "", "", AT(tolerance)},
    {"averaging.bandwidth_variation", KEY_NAME, "", "", "uniform",
     "how the bandwidth of the diffusion varies in space", "SX15 section 2.2.3",
     "", AT(vary)},
    {"averaging.regions", KEY_LIST, "", "", KEY_OPTIONAL,
     "boxes with a bandwidth of their own, each { low, high, bandwidth }",
     "SX15 section 2.2.3", "", AT(regions),
     .size = sizeof(struct averaging_region)},
    {"averaging.regions.low", KEY_VECTOR, "m", "", NULL, "lowest corner", "",
     "", REGION(low)},
    {"averaging.regions.high", KEY_VECTOR, "m", "", NULL, "highest corner", "",
     "", REGION(high)},
    {"averaging.regions.bandwidth", KEY_REAL, "m", ">= 0", NULL,
     "its bandwidth; 0: what pcm gives stays", "", "", REGION(bandwidth)},
    KEY_END};

const struct diffusion_scheme diffusion_exponential = {
    .name = "exponential",
    .what = "the matrix exponential; no steps",
    .equations = "",
    .function = "diffusion_apply_exponential",
    .directly = 1,
};

const struct diffusion_scheme diffusion_series = {
    .name = "series",
    .what = "the same, always by its series",
    .equations = "",
    .function = "chebyshev_apply",
};

const struct diffusion_scheme *const diffusion_schemes[] = {
    &diffusion_exponential,    &diffusion_series, &diffusion_crank_nicolson,
    &diffusion_implicit_euler, &diffusion_sdirk2, NULL};

MODEL_NAMED(diffusion_scheme)
