/* SPDX-License-Identifier: GPL-3.0-or-later */
/* diffusion_steps.c -- the diffusion by implicit steps in pseudo-time.
 * Chapter "Averaging".
 *
 * With K the mesh Laplacian of [SX15 5a] times -V:
 *
 *   crank-nicolson  as [SX15]: second order; undershoots if the steps are few
 *   implicit-euler  first order; never undershoots
 *   sdirk2          second order, L-stable; two stages a step
 */
#include <gsl/gsl_math.h>
#include <limits.h>
#include <string.h>

#include "averaging/averaging.h"
#include "averaging/diffusion.h"
#include "base/alloc.h"
#include "base/number.h"
#include "linear/solvers.h"
#include "linear/matrix.h"
#include "mesh/measures.h"

enum { MAX_ITERATIONS = 1000 };

struct diffusion_steps {
    const struct mesh *mesh; /* borrowed */
    double implicit;         /* [-] share of dtau K in A */
    void (*step)(struct diffusion_steps *, int m, double *u,
                 struct averaging_report *r);
    int steps;        /* [-] */
    int fields;       /* [-] fields for which the arrays below are allocated */
    double tolerance; /* [-] of the solver */
    double dtau;      /* [m^2] T / steps */
    struct csr *K;    /* [m] -V times div (D grad) */
    struct csr *A;    /* [m^3] V + implicit dtau K */
    struct cg_many_work *work;
    double *rhs;   /* [m^3 times the field] */
    double *stage; /* of a step, as wide */
    double *wide;  /* a field padded to `fields` */
};

double diffusion_safe_steps(const struct mesh *m, double b)
{
    return 0.5 * diffusion_time(b) * mesh_diffusion_rate(m);
}

/* rhs = V u - factor K y, for m fields side by side. */
static void right_side(struct diffusion_steps *d, int m, double factor,
                       const double *u, const double *y)
{
    const double *const V = d->mesh->V;
    const int n = d->mesh->n_cells;

    if (factor > 0.0) csr_multiply_many(d->K, m, y, d->rhs);
#pragma omp parallel for schedule(static)
    for (int c = 0; c < n; c++)
        for (int k = m * c; k < m * c + m; k++)
            d->rhs[k] = V[c] * u[k] - (factor > 0.0 ? factor * d->rhs[k] : 0.0);
}

/* Keeps the worse of two reports of a solver: most iterations, largest
 * residual. */
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
static void solve(struct diffusion_steps *d, double *u,
                  struct averaging_report *r)
{
    const struct solve_report one =
        cg_many_solve(d->A, d->mesh->V, d->rhs, u, d->tolerance, 0.0,
                      MAX_ITERATIONS, d->work);
    worse_of(&r->worst, &one);
    r->products += one.iterations + 1;
}

/* Crank-Nicolson or implicit Euler: A u_new = V u - what is explicit. */
static void theta_step(struct diffusion_steps *d, int m, double *u,
                       struct averaging_report *r)
{
    const double factor = (1.0 - d->implicit) * d->dtau;

    right_side(d, m, factor, u, u);
    r->products += factor > 0.0;
    solve(d, u, r);
}

/* Two stages with one matrix; the second is the step:
 *     A y = V u,  A u_new = V u - (1 - gamma) dtau K y,  A = V + gamma dtau K.
 * The scheme is of second order for gamma = 1 - 1/sqrt 2, and L-stable. */
static void sdirk2_step(struct diffusion_steps *d, int m, double *u,
                        struct averaging_report *r)
{
    const int n = m * d->mesh->n_cells;
    const double factor = (1.0 - d->implicit) * d->dtau;

    memcpy(d->stage, u, (size_t)n * sizeof *u);
    right_side(d, m, 0.0, u, u);
    solve(d, d->stage, r);
    right_side(d, m, factor, u, d->stage);
    r->products++;
    solve(d, u, r);
}

static void apply_steps(struct diffusion_steps *d, int m, double *u,
                        struct averaging_report *r)
{
    r->products = 0;
    r->worst = (struct solve_report){.converged = 1};
    for (int step = 0; step < d->steps; step++)
        d->step(d, m, u, r);
}

/* The work space of the solver has a fixed number of fields; unused ones are
 * zero, and the solver does no iterations for them. */
static void apply_padded(void *state, int m, double *u,
                         struct averaging_report *r)
{
    struct diffusion_steps *const d = state;
    const int n = d->mesh->n_cells, all = d->fields;
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

static void *diffusion_steps_create(const struct diffusion_scheme *scheme,
                                    const struct mesh *m,
                                    const struct averaging_options *o)
{
    struct diffusion_steps *const d = owner_create(sizeof *d);
    const int n = m->n_cells;

    d->mesh = m;
    d->implicit = scheme->implicit;
    d->step = scheme->stages == 1 ? theta_step : sdirk2_step;
    d->steps = o->steps;
    d->fields = o->fields;
    d->tolerance = o->tolerance;
    d->dtau = diffusion_time(o->bandwidth) / o->steps;
    d->K = owner_join(d, csr_create(n, m->n_internal, m->owner, m->neighbour));
    d->A = owner_join(d, csr_create(n, m->n_internal, m->owner, m->neighbour));
    d->work = owner_join(d, cg_many_work_create(n, d->fields));
    d->rhs = owner_doubles(d, n * d->fields);
    d->stage = owner_doubles(d, n * d->fields);
    d->wide = owner_doubles(d, n * d->fields);
    return d;
}

static void diffusion_steps_fill(void *state, const double *D)
{
    struct diffusion_steps *const d = state;

    diffusion_matrix_fill(d->K, d->mesh, NULL, 1.0, D);
    diffusion_matrix_fill(d->A, d->mesh, d->mesh->V, d->implicit * d->dtau, D);
}

static int crank_nicolson_safe_steps(const struct mesh *m, double b)
{
    /* 12.000000001 is 12 */
    return number_clamped(ceil(diffusion_safe_steps(m, b) * (1.0 - 1e-9)), 0,
                          INT_MAX);
}

static const struct diffusion_stepping stepping = {
    diffusion_steps_create, diffusion_steps_fill, apply_padded, NULL};
static const struct diffusion_stepping crank_nicolson_stepping = {
    diffusion_steps_create, diffusion_steps_fill, apply_padded,
    crank_nicolson_safe_steps};

static const struct key steps_keys[] = {
    {"averaging.steps", KEY_INT, "-", ">= 1, <= 1000", "3",
     "steps of the diffusion in pseudo-time", "SX15 5", "",
     KEY_AT(averaging_options, steps)},
    KEY_END};

const struct diffusion_scheme diffusion_crank_nicolson = {
    .name = "crank-nicolson",
    .what = "second order; undershoots if the steps are few",
    .equations = "SX15 5",
    .function = "theta_step",
    .keys = {steps_keys},
    .stepping = &crank_nicolson_stepping,
    .stages = 1,
    .implicit = 0.5,
};

const struct diffusion_scheme diffusion_implicit_euler = {
    .name = "implicit-euler",
    .what = "first order; never undershoots",
    .equations = "",
    .function = "theta_step",
    .keys = {steps_keys},
    .stepping = &stepping,
    .stages = 1,
    .implicit = 1.0,
};

const struct diffusion_scheme diffusion_sdirk2 = {
    .name = "sdirk2",
    .what = "second order, L-stable; undershoots little",
    .equations = "",
    .function = "sdirk2_step",
    .keys = {steps_keys},
    .stepping = &stepping,
    .stages = 2,
    .implicit = 1.0 - M_SQRT1_2,
};
