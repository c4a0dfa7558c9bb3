/* SPDX-License-Identifier: GPL-3.0-or-later */
/* storage.c -- what a step inherits from the steps before it.
 *
 * Plain implicit Euler takes the flux of the step before to carry momentum, and
 * with it that step's masses: they meet continuity together, and no repetition
 * is needed. That costs an order in time. A scheme that looks at two steps, or
 * a step that is repeated, takes the masses of its own time, and the flux
 * continued to it or, in a repetition, as just found. Chapter 19.
 */
#include "fluid/piso.h"

#include <math.h>
#include <string.h>

static const struct time_scheme *scheme(const struct fluid_options *o)
{
    return o->time != NULL ? o->time : &time_schemes[0];
}

int storage_is_new(const struct fluid_options *o)
{
    return o->repeats > 0 || scheme(o)->steps > 1;
}

static void choose_masses(struct fluid *fl)
{
    struct piso *const ps = fl->piso;
    const int is_new = storage_is_new(&fl->options);

    ps->eps_new = is_new ? fl->eps : fl->eps_phi;
    ps->eps_old = is_new ? fl->eps_phi : fl->eps_start;
    ps->eps_older = ps->storage_older != NULL ? fl->eps_start : NULL;
}

/* storage u of the past, with the sign it has on the right side. */
static void keep_past(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double rho = fl->options.rho, dt = fl->options.dt;
    struct piso *const ps = fl->piso;
    const double *restrict u = fl->u;
    double *restrict past = ps->past;

    for (int c = first; c < last; c++) {
        const double storage =
            rho * ps->eps_old[c] * m->V[c] / dt * ps->weights.old;
        ps->storage[c] = storage;
        for (int k = 0; k < 3; k++)
            past[3 * c + k] = storage * u[3 * c + k];
    }
    if (ps->storage_older == NULL) return;
    for (int c = first; c < last; c++) {
        ps->storage_older[c] =
            -rho * ps->eps_older[c] * m->V[c] / dt * ps->weights.older;
        for (int k = 0; k < 3; k++)
            ps->past[3 * c + k] +=
                ps->storage_older[c] * fl->u_older[3 * c + k];
    }
}

/* x + ahead (x - older) */
static void continue_in_time(int n, double ahead, const double *x,
                             const double *older, double *to)
{
    for (int i = 0; i < n; i++)
        to[i] = x[i] + ahead * (x[i] - older[i]);
}

/* What the last step left unsolved is an impulse: if the step changes, another
 * force. */
static void rescale_owed(struct fluid *fl)
{
    const double ratio = fl->dt_older / fl->options.dt;

    if (fl->dt_older == 0.0 || ratio == 1.0) return;
    for (int i = 0; i < 3 * fl->mesh->n_cells; i++)
        fl->piso->owed[i] *= ratio;
}

void storage_begin(struct fluid *fl)
{
    const int n = fl->mesh->n_cells, faces = fl->mesh->n_faces;
    struct piso *const ps = fl->piso;
    double r = fl->dt_older > 0.0 ? fl->options.dt / fl->dt_older : 0.0;

    rescale_owed(fl);
    ps->weights = scheme(&fl->options)->weights(r);
    choose_masses(fl);
    STRIPS_RUN(n, 8, keep_past, fl);
    memcpy(ps->phi_old, fl->phi, (size_t)faces * sizeof *fl->phi);
    ps->carry = ps->phi_old;
    if (ps->carry_own == NULL) return;
    if (fl->phi_older == NULL) {
        storage_renew(fl);
        return;
    }
    continue_in_time(3 * n, ps->weights.ahead, fl->u, fl->u_older, ps->u_known);
    continue_in_time(faces, ps->weights.ahead, fl->phi, fl->phi_older,
                     ps->carry_own);
    memcpy(fl->u_older, fl->u, 3 * (size_t)n * sizeof *fl->u);
    edge_inlet_fluxes(fl, ps->carry_own);
    ps->carry = ps->carry_own;
}

void storage_renew(struct fluid *fl)
{
    struct piso *const ps = fl->piso;

    memcpy(ps->carry_own, fl->phi, (size_t)fl->mesh->n_faces * sizeof *fl->phi);
    edge_inlet_fluxes(fl, ps->carry_own);
    ps->carry = ps->carry_own;
    if (ps->u_known != NULL)
        memcpy(ps->u_known, fl->u,
               3 * (size_t)fl->mesh->n_cells * sizeof *fl->u);
}

/* With two steps behind, what a force gives arrives over several steps: now
 * times this step's gain less older times that of the step before is what the
 * forces gave. The rest is ahead of them. */
static void count_ahead(struct fluid *fl)
{
    const struct time_weights *const w = &fl->piso->weights;

    for (int k = 0; k < 3; k++) {
        double gained = 0.0;
        for (int c = 0; c < fl->mesh->n_cells; c++)
            gained += fl->options.rho * fl->mesh->V[c] *
                      (fl->piso->eps_new[c] * fl->u[3 * c + k] -
                       fl->piso->eps_old[c] * fl->u_older[3 * c + k]);
        fl->ahead[k] += (w->now - 1.0) * gained - w->older * fl->gained[k];
        fl->gained[k] = gained;
    }
}

void storage_end(struct fluid *fl)
{
    double *const oldest = fl->eps_start;

    if (fl->u_older != NULL) {
        double *const phi = fl->phi_older;
        count_ahead(fl);
        fl->phi_older = fl->piso->phi_old;
        fl->piso->phi_old = phi;
    }
    fl->eps_start = fl->eps_phi;
    fl->eps_phi = oldest;
    memcpy(fl->eps_phi, fl->eps, (size_t)fl->mesh->n_cells * sizeof *fl->eps);
    fl->dt_older = fl->options.dt;
}
