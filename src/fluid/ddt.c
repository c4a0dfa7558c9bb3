/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ddt.c -- the time derivative: contributions of the previous steps.
 *
 * Implicit Euler without outer iterations convects momentum with the flux of
 * the previous step, and with the masses of that step: both satisfy continuity
 * together. This is of first order in time. A two-step scheme, or a step with
 * outer iterations, uses the masses of the new time and the flux extrapolated
 * to it or, in an outer iteration, the latest flux.
 * Chapter "The flow, verified".
 */
#include "fluid/piso.h"

#include <math.h>
#include <string.h>

#include "base/model.h"
#include "base/parallel_ranges.h"
#include "fluid/systems.h"
#include "fluid/schemes.h"

static const struct time_scheme *scheme(const struct fluid_options *o)
{
    return o->time != NULL ? o->time : time_schemes[0];
}

int ddt_uses_new_time(const struct fluid_options *o)
{
    return o->outer_correctors > 0 || scheme(o)->time_levels > 1;
}

static void choose_masses(struct fluid *fl)
{
    struct time_levels *const levels = fl->levels;
    const int is_new = ddt_uses_new_time(&fl->options);

    levels->eps_new = is_new ? fl->eps : fl->eps_n;
    levels->eps_old = is_new ? fl->eps_n : fl->eps_nm1;
    levels->eps_older = levels->ddt_older != NULL ? fl->eps_nm1 : NULL;
}

/* Sets the old-time terms of the time derivative, with the signs that they have
 * on the right-hand side. */
static void set_old_time_source(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double rho = fl->options.rho, dt = fl->options.dt;
    struct time_levels *const levels = fl->levels;
    const double *restrict u = fl->u;
    double *restrict old_time_source = levels->old_time_source;

    for (int c = first; c < last; c++) {
        const double ddt =
            rho * levels->eps_old[c] * m->V[c] / dt * levels->weights.old;
        levels->ddt[c] = ddt;
        for (int k = 0; k < 3; k++)
            old_time_source[3 * c + k] = ddt * u[3 * c + k];
    }
    if (levels->ddt_older == NULL) return;
    for (int c = first; c < last; c++) {
        levels->ddt_older[c] =
            -rho * levels->eps_older[c] * m->V[c] / dt * levels->weights.older;
        for (int k = 0; k < 3; k++)
            levels->old_time_source[3 * c + k] +=
                levels->ddt_older[c] * fl->u_older[3 * c + k];
    }
}

/* to = x + ahead (x - older). */
static void extrapolate(int n, double ahead, const double *x,
                        const double *older, double *to)
{
    for (int i = 0; i < n; i++)
        to[i] = x[i] + ahead * (x[i] - older[i]);
}

/* An impulse of 1 in this step moves the fluid by 1 / now at once, and that by
 * `pending` in the steps after it. The weight is 1 where the steps are as long
 * as the one before, and 3/2 in the first one of BDF2, which is one of Euler:
 * whoever gives the impulse has to know. What was gained before is weighted
 * anew where the step has changed. */
static void weigh_impulses(struct fluid *fl)
{
    struct time_levels *const l = fl->levels;
    const double pending = scheme(&fl->options)->pending;

    fl->impulse_weight = (1.0 + pending) / l->weights.now;
    for (int k = 0; k < 3; k++)
        l->reweighted[k] = fl->momentum_gained[k] *
                           (fl->impulse_weight * l->weights.older - pending);
}

/* The residual of the last step is an impulse, so as a force it changes with
 * the time step, and with the weight of the step. */
static void rescale_residual(struct fluid *fl)
{
    const double ratio = fl->dt_older / fl->options.dt / fl->impulse_weight;

    if (fl->dt_older == 0.0 || ratio == 1.0) return;
    for (int i = 0; i < 3 * fl->mesh->n_cells; i++)
        fl->momentum->residual[i] *= ratio;
}

/* phi_old = phi. Where nothing reads the fluxes of the inner faces before they
 * are new, only those of the boundary stay in phi. */
static void keep_flux(struct fluid *fl)
{
    double *const phi = fl->phi, *const free = fl->levels->phi_old;
    const int swaps = piso_alone(fl) && !ddt_uses_new_time(&fl->options);
    const int first = swaps ? fl->mesh->n_internal : 0;

    if (swaps) {
        fl->phi = free;
        fl->levels->phi_old = phi;
    }
    memcpy(free + first, phi + first,
           (size_t)(fl->faces->n - first) * sizeof *phi);
}

void ddt_begin(struct fluid *fl)
{
    const int n = fl->mesh->n_cells, faces = fl->mesh->n_faces;
    struct time_levels *const levels = fl->levels;
    double r = fl->dt_older > 0.0 ? fl->options.dt / fl->dt_older : 0.0;

    levels->weights = scheme(&fl->options)->weights(r);
    weigh_impulses(fl);
    rescale_residual(fl);
    choose_masses(fl);
    PARALLEL_RANGES(n, 8, set_old_time_source, fl);
    keep_flux(fl);
    levels->convecting_flux = levels->phi_old;
    if (levels->convecting_flux_own == NULL) return;
    if (fl->phi_older == NULL) {
        ddt_renew_flux(fl);
        return;
    }
    extrapolate(3 * n, levels->weights.ahead, fl->u, fl->u_older,
                levels->u_known);
    extrapolate(faces, levels->weights.ahead, fl->phi, fl->phi_older,
                levels->convecting_flux_own);
    memcpy(fl->u_older, fl->u, 3 * (size_t)n * sizeof *fl->u);
    boundary_face_inlet_fluxes(fl, levels->convecting_flux_own);
    levels->convecting_flux = levels->convecting_flux_own;
}

void ddt_renew_flux(struct fluid *fl)
{
    struct time_levels *const levels = fl->levels;

    memcpy(levels->convecting_flux_own, fl->phi,
           (size_t)fl->mesh->n_faces * sizeof *fl->phi);
    boundary_face_inlet_fluxes(fl, levels->convecting_flux_own);
    levels->convecting_flux = levels->convecting_flux_own;
    if (levels->u_known != NULL)
        memcpy(levels->u_known, fl->u,
               3 * (size_t)fl->mesh->n_cells * sizeof *fl->u);
}

static void set_momentum_gained(struct fluid *fl)
{
    for (int k = 0; k < 3; k++) {
        double gained = 0.0;
        for (int c = 0; c < fl->mesh->n_cells; c++)
            gained += fl->options.rho * fl->mesh->V[c] *
                      (fl->levels->eps_new[c] * fl->u[3 * c + k] -
                       fl->levels->eps_old[c] * fl->u_older[3 * c + k]);
        fl->momentum_gained[k] = gained;
    }
}

/* Moves the time levels on by one: new becomes old, old becomes older. */
void ddt_end(struct fluid *fl)
{
    const int n = fl->mesh->n_cells;
    double *const oldest = fl->eps_nm1;

    if (fl->u_older != NULL) {
        double *const phi = fl->phi_older;
        set_momentum_gained(fl);
        fl->phi_older = fl->levels->phi_old;
        fl->levels->phi_old = phi;
    }
    fl->eps_nm1 = fl->eps_n;
    fl->eps_n = oldest;
    if (fl->options.coupled)
        memcpy(fl->eps_n, fl->eps, (size_t)n * sizeof *fl->eps);
    fl->dt_older = fl->options.dt;
    for (int i = 0; i < 3 * n && fl->impulse_weight != 1.0; i++)
        fl->momentum->residual[i] *= fl->impulse_weight;
}

double ddt_pending(const struct fluid *fl)
{
    return scheme(&fl->options)->pending;
}

static struct time_weights weights_euler(double r)
{
    (void)r;
    return (struct time_weights){1.0, 1.0, 0.0, 0.0};
}

const struct time_scheme time_scheme_euler = {
    .name = "euler",
    .what = "implicit Euler: first order, never rings",
    .equations = "XS11",
    .function = "weights_euler",
    .time_levels = 1,
    .weights = weights_euler,
};

/* The derivative at the end of the parabola through three time levels. With r =
 * 0 it is that of the line through the last two: the first step is implicit
 * Euler. */
static struct time_weights weights_bdf2(double r)
{
    return (struct time_weights){(1.0 + 2.0 * r) / (1.0 + r), 1.0 + r,
                                 r * r / (1.0 + r), r};
}

const struct time_scheme time_scheme_bdf2 = {
    .name = "bdf2",
    .what = "backward differences over two steps: second order",
    .equations = "Curtiss52",
    .function = "weights_bdf2",
    .time_levels = 2,
    .pending = 0.5, /* 1/3 + 1/9 + ... */
    .weights = weights_bdf2,
};

const struct time_scheme *const time_schemes[] = {&time_scheme_euler,
                                                  &time_scheme_bdf2, NULL};

MODEL_NAMED(time_scheme)
