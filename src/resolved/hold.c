/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hold.c -- implicit friction in the momentum equation of the held cells.
 *
 * With a the diagonal without it, the velocity of a cell is
 *
 *   u = theta (H + old_time_source - V grad p) / a + (1 - theta) u_b,
 *   theta = a / (a + hold V)
 *
 * and a flux has the same share of both, with the mean theta of its two cells.
 * A face between two held cells thus follows the body and not the pressure, and
 * a face at the surface does so by half. The friction of a bed of grains is
 * treated otherwise (face_jump.c), by a jump of the pressure gradient: with
 * that, a sphere would be the staircase of its cells.
 */
#include "base/alloc.h"
#include "base/vector.h"
#include "fluid/face_jump.h"
#include "fluid/systems.h"
#include "fluid/piso.h"
#include "resolved/mark.h"
#include "resolved/solid_bodies.h"

#include <math.h>
#include <stdlib.h>

static struct solid_bodies *bodies_of(struct immersed *self)
{
    return (struct solid_bodies *)self;
}

static void clear_impulse(struct immersed *self)
{
    for (int k = 0; k < 3; k++)
        self->impulse[k] = 0.0;
    self->gross = 0.0;
}

/* The multiplier of [EW18 1] is hold (u - u_b)/rho, and u - u_b is 1/C of what
 * presses on it [EW18 4]. The explicit part, hold u_b, is no force of the
 * neighbours and stays out of H: it stands with the old-time terms. */
static void hold_begin(struct immersed *self, struct fluid *fl)
{
    struct solid_bodies *const b = bodies_of(self);
    double *const source = fl->levels->old_time_source;

    mark_bodies(b, fl);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < b->n_cells; j++) {
        const int c = b->cell[j];
        for (int k = 0; k < 3; k++)
            source[3 * c + k] += fl->mesh->V[c] * b->hold_u[3 * c + k];
    }
}

/* The implicit part [EW18 1, 4]. */
static void add_friction(struct immersed *self, struct fluid *fl)
{
    const struct solid_bodies *const b = bodies_of(self);

#pragma omp parallel for schedule(static)
    for (int j = 0; j < b->n_cells; j++) {
        const int c = b->cell[j];
        fl->momentum->diag[c] += b->hold[c] * fl->mesh->V[c];
    }
}

/* What the bodies change in the flux through a face, and what each of its
 * cells has to do with it. */
struct body_share {
    double theta; /* [-] a / (a + hold V) */
    double flux;  /* [m^3/s] (1 - theta) eps u_b . S / 2 */
};

static inline struct body_share body_share(const struct solid_bodies *b,
                                           const struct fluid *fl, int c,
                                           const double S[3])
{
    const double of_cell = fl->mesh->V[c] / fl->momentum->diag[c];

    return (struct body_share){1.0 - of_cell * b->hold[c],
                               0.5 * of_cell * fl->eps[c] *
                                   vector_dot(&b->hold_u[3 * c], S)};
}

/* The resistance has been formed with the whole diagonal; what of the flux does
 * not depend on p is in proportion to the mobility. */
FACE_KERNEL change_face(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const struct solid_bodies *const b = bodies_of(fl->immersed);

    if (b->hold[o] == 0.0 && b->hold[n] == 0.0) return;
    struct pressure_system *const pressure = fl->pressure;
    const double w = fl->mesh->w[f], *const S = mesh_S(fl->mesh, f);
    const struct body_share of_o = body_share(b, fl, o, S);
    const struct body_share of_n = body_share(b, fl, n, S);
    const double r_o = (1.0 - w) * pressure->resistance[o];
    const double r_n = w * pressure->resistance[n];
    const double m =
        0.5 * (of_o.theta + of_n.theta) / (of_o.theta * r_o + of_n.theta * r_n);
    const double factor = m * (r_o + r_n); /* of the mobility */

    pressure->m_face[f] = m;
    pressure->conductance[f] *= factor;
    pressure->explicit_flux[f] =
        factor * pressure->explicit_flux[f] + of_o.flux + of_n.flux;
}

/* Convection and viscosity alone: with the diagonal, face_jump.c has taken away
 * hold u as well. */
static void smooth_forces(struct immersed *self, struct fluid *fl)
{
    const struct solid_bodies *const b = bodies_of(self);

    for (int j = 0; j < b->n_cells; j++) {
        const int c = b->cell[j];
        for (int k = 0; k < 3; k++)
            fl->jump->smooth_force[3 * c + k] += b->hold[c] * fl->u[3 * c + k];
    }
}

/* The faces of the held cells. The pressure makes the fluxes satisfy continuity
 * in all of the box [EW18 5]. */
static void change_faces(struct immersed *self, struct fluid *fl)
{
    (void)self;
    FOR_EACH_FACE(fl->faces, 8, change_face, fl);
}

/* The friction of one body: J = dt sum hold (u - u_b) V [EW18 15], and r x J
 * [EW18 16]. It gets what the fluid loses in all (fluid.h): of this step in
 * lost[0] to lost[2], and their amounts in lost[3] [N s]. */
static void add_impulse(struct solid_bodies *b, const struct fluid *fl, int i,
                        double lost[4])
{
    for (int j = b->start[i]; j < b->end[i]; j++) {
        const struct hold_link *const l = &b->link[j];
        const double scale =
            fl->options.dt * l->hold * fl->mesh->V[l->cell]; /* [kg] */
        double J[3], turn[3];
        for (int k = 0; k < 3; k++) {
            J[k] = scale * (fl->u[3 * l->cell + k] - l->u[k]);
            lost[k] += J[k];
            lost[3] += fabs(J[k]);
            J[k] *= fl->impulse_weight;
            b->impulse[3 * i + k] += J[k];
        }
        vector_cross(l->r, J, turn);
        for (int k = 0; k < 3; k++)
            b->angular[3 * i + k] += turn[k];
    }
}

/* In a body that moves the friction is a thousand times as large as all other
 * terms, and a residual that is small beside it may be larger than they are. */
static double largest_term(const struct immersed *self, const struct fluid *fl)
{
    const struct solid_bodies *const b = (const struct solid_bodies *)self;
    const double *const diag = fl->momentum->diag, *const V = fl->mesh->V;
    double largest = 0.0;

#pragma omp parallel for schedule(static) reduction(max : largest)
    for (int c = 0; c < fl->mesh->n_cells; c++) {
        const double own = diag[c] - b->hold[c] * V[c];
        for (int k = 3 * c; k < 3 * c + 3; k++) {
            const double term = own * fabs(fl->u[k]);
            largest = term > largest ? term : largest;
        }
    }
    return largest;
}

static void hold_end(struct immersed *self, struct fluid *fl)
{
    struct solid_bodies *const b = bodies_of(self);
    double *const lost = alloc_doubles(4 * b->ps->n);

    clear_impulse(self);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < b->ps->n; i++)
        add_impulse(b, fl, i, &lost[4 * i]);
    for (int i = 0; i < b->ps->n; i++) {
        vector_along(self->impulse, -1.0, &lost[4 * i], self->impulse);
        self->gross += lost[4 * i + 3];
    }
    free(lost);
}

const struct body_method hold_method = {
    .name = "hold",
    .what = "friction by distance, implicit in the momentum equation",
    .equations = "EW18 1-5, 15, 16",
    .function = "add_friction",
    .hooks = {.begin = hold_begin,
              .add_friction = add_friction,
              .change_faces = change_faces,
              .smooth_forces = smooth_forces,
              .largest_term = largest_term,
              .end = hold_end},
};

/* --- fraction methods ----------------------------------------------------- */

/* Two older ways to hold the fluid, by solid fractions.
 * Chapter "Resolving the grains".
 *
 * Both set the velocity in a cell by its solid fraction b after the viscous
 * step is done, so that what they give depends on nu dt / h^2. They are here to
 * show that. LS calls the first one a fictitious domain method [LS 5.17-5.20],
 * the second one PISO-IB [LS 5.21]. */

/* Takes the impulse of a force that changes the velocity of a cell by du in
 * this step: rho V du, in a two-step scheme 3/2 of it. */
static void take_impulse(struct solid_bodies *b, const struct fluid *fl, int i,
                         const struct hold_link *l, const double du[3])
{
    const double m =
        fl->levels->weights.now * fl->options.rho * fl->mesh->V[l->cell];
    double J[3], turn[3];

    for (int k = 0; k < 3; k++) {
        J[k] = -m * du[k];
        b->hooks.impulse[k] -= J[k];
        b->hooks.gross += fabs(J[k]);
        J[k] *= fl->impulse_weight;
        b->impulse[3 * i + k] += J[k];
    }
    vector_cross(l->r, J, turn);
    for (int k = 0; k < 3; k++)
        b->angular[3 * i + k] += turn[k];
}

static void fraction_methods_mark(struct immersed *self, struct fluid *fl)
{
    mark_bodies((struct solid_bodies *)self, fl);
}

static void fraction_methods_nothing(struct immersed *self, struct fluid *fl)
{
    (void)self, (void)fl;
}

/* --- fictitious domain -----------------------------------------------------
 */

/* u~ = (1 - b) u^ + b u_b, and the same change in the fluxes; f = rho (u~ -
 * u^)/dt [LS 5.18]. */
static void set_velocity(struct solid_bodies *b, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < b->ps->n; i++)
        for (int j = b->start[i]; j < b->end[i]; j++) {
            const struct hold_link *const l = &b->link[j];
            double *const u = &fl->u[3 * l->cell], du[3];
            for (int k = 0; k < 3; k++) {
                du[k] = l->hold * (l->u[k] - u[k]);
                u[k] += du[k];
            }
            take_impulse(b, fl, i, l, du);
            for (int a = m->cell_start[l->cell]; a < m->cell_start[l->cell + 1];
                 a++) {
                const int f = m->cell_face[a];
                const double share = m->out[a] > 0 ? m->w[f] : 1.0 - m->w[f];
                if (f < m->n_internal)
                    fl->phi[f] += share * vector_dot(du, mesh_S(m, f));
            }
        }
}

/* What a pressure gradient changes in a step [m^3 s/kg]. */
static double step_over_density(const struct fluid *fl)
{
    return fl->options.dt / (fl->levels->weights.now * fl->options.rho);
}

/* dt/rho S.S / S.d of the faces through which the pressure acts. */
static void set_conductances(struct fluid *fl)
{
    struct pressure_system *const pressure = fl->pressure;
    const double scale = step_over_density(fl);

    for (int c = 0; c < fl->mesh->n_cells; c++)
        pressure->boundary_conductance[c] = pressure->divergence[c] = 0.0;
    for (int f = 0; f < fl->mesh->n_faces; f++) {
        const int open = pressure->conductance[f] > 0.0, o = fl->mesh->owner[f];
        pressure->conductance[f] =
            open * scale * fl->geometry->face_coefficient[f];
        pressure->divergence[o] -= fl->phi[f];
        if (f < fl->mesh->n_internal)
            pressure->divergence[fl->mesh->neighbour[f]] += fl->phi[f];
        else
            pressure->boundary_conductance[o] += pressure->conductance[f];
    }
    if (pressure->pinned_cell >= 0)
        pressure->boundary_conductance[pressure->pinned_cell] +=
            scale * cbrt(fl->mesh->V[pressure->pinned_cell]);
}

/* phi and u lose the gradient of q; p gains q. At walls q is that of the
 * cell, at outlets 0. */
static void subtract_gradient(struct fluid *fl, const double *q)
{
    const struct mesh *const m = fl->mesh;
    const double scale = step_over_density(fl);

    for (int f = 0; f < m->n_faces; f++) {
        const int o = m->owner[f], inner = f < m->n_internal;
        const int n = inner ? m->neighbour[f] : o;
        const int outlet = !inner && fl->pressure->conductance[f] > 0.0;
        const double of_n = outlet ? 0.0 : q[n];
        const double face = m->w[f] * q[o] + (1.0 - m->w[f]) * of_n;
        fl->p_face[f] += face;
        fl->phi[f] -= fl->pressure->conductance[f] * (of_n - q[o]);
        for (int k = 0; k < 3; k++) {
            const double g = scale * face * mesh_S(m, f)[k];
            fl->u[3 * o + k] -= g / m->V[o];
            if (inner) fl->u[3 * n + k] += g / m->V[n];
        }
    }
    for (int c = 0; c < m->n_cells; c++)
        fl->p[c] += q[c];
}

/* u = u~ - grad q dt/rho [LS 5.19], with lap q dt/rho = div u~ [LS 5.20]; phi
 * of LS is q dt/rho. Where a body begins to move in a fluid at rest, the step
 * has no scale of its fluxes before: then the divergence is the scale. */
static void project(struct solid_bodies *b, struct fluid *fl)
{
    struct pressure_system *const pressure = fl->pressure;

    set_conductances(fl);
    preconditioned_set(pressure->matrix, pressure->conductance,
                       pressure->boundary_conductance);
    for (int c = 0; c < fl->mesh->n_cells; c++)
        b->hold_u[c] = 0.0; /* work space */
    const double tolerance = fl->options.tolerance;
    const struct solve_report r =
        cg_solve(pressure->matrix, pressure->divergence, b->hold_u,
                 pressure->scale > 0.0 ? 0.0 : tolerance,
                 tolerance * pressure->scale, 500, pressure->cg);
    if (!r.converged) fl->report.pressure = r;
    subtract_gradient(fl, b->hold_u);
}

/* The interim velocity, of the fluid everywhere, is there [LS 5.17]. The
 * boundaries have acted upon that velocity, and the balance of momentum counts
 * them with the final one: their difference is an impulse, too. */
static void fictitious_end(struct immersed *self, struct fluid *fl)
{
    struct solid_bodies *const b = (struct solid_bodies *)self;
    double interim[3], final[3];

    momentum_balance_of_boundaries(fl, interim);
    clear_impulse(self);
    set_velocity(b, fl);
    project(b, fl);
    momentum_balance_of_boundaries(fl, final);
    for (int k = 0; k < 3; k++)
        self->impulse[k] += interim[k] - final[k];
}

/* --- PISO-IB ----------------------------------------------------------------
 */

/* b->hold_u is here the force per mass f [m/s^2], which lasts from step to step
 * where there is still a body. */
static void keep_force(struct immersed *self, struct fluid *fl)
{
    struct solid_bodies *const b = (struct solid_bodies *)self;

    mark_bodies(b, fl);
    for (int c = 0; c < fl->mesh->n_cells; c++)
        for (int k = 0; k < 3 && b->hold[c] == 0.0; k++)
            b->hold_u[3 * c + k] = 0.0;
}

static void add_force(struct immersed *self, struct fluid *fl)
{
    const struct solid_bodies *const b = (struct solid_bodies *)self;

    for (int j = 0; j < b->n_cells; j++) {
        const int c = b->cell[j];
        for (int k = 0; k < 3; k++)
            fl->momentum->b[3 * c + k] +=
                fl->options.rho * fl->mesh->V[c] * b->hold_u[3 * c + k];
    }
}

static const double relaxation = 0.9; /* alpha */

/* f += alpha b (u_b - u)/dt [LS 5.21], in each corrector. */
static void correct_force(struct immersed *self, struct fluid *fl)
{
    struct solid_bodies *const b = (struct solid_bodies *)self;

    for (int i = 0; i < b->ps->n; i++)
        for (int j = b->start[i]; j < b->end[i]; j++) {
            const struct hold_link *const l = &b->link[j];
            for (int k = 0; k < 3; k++) {
                const double df = relaxation * l->hold / fl->options.dt *
                                  (l->u[k] - fl->u[3 * l->cell + k]);
                b->hold_u[3 * l->cell + k] += df;
                fl->momentum->b[3 * l->cell + k] +=
                    fl->options.rho * fl->mesh->V[l->cell] * df;
            }
        }
}

/* The whole f of a cell is of the first body that shares it. */
static void piso_ib_end(struct immersed *self, struct fluid *fl)
{
    struct solid_bodies *const b = (struct solid_bodies *)self;

    clear_impulse(self);
    for (int i = 0; i < b->ps->n; i++)
        for (int j = b->start[i]; j < b->end[i]; j++) {
            const struct hold_link *const l = &b->link[j];
            const double dt = fl->options.dt,
                         share = l->hold / b->hold[l->cell];
            const double *const f = &b->hold_u[3 * l->cell];
            const double du = share * dt / fl->levels->weights.now;
            take_impulse(b, fl, i, l,
                         (double[3]){du * f[0], du * f[1], du * f[2]});
        }
}

const struct body_method fraction_methods_fictitious = {
    .name = "fictitious-domain",
    .what = "velocity set after the step, and projected again",
    .equations = "LS 5.17-5.20",
    .function = "project",
    .by_fraction = 1,
    .hooks = {.begin = fraction_methods_mark,
              .add_friction = fraction_methods_nothing,
              .change_faces = fraction_methods_nothing,
              .end = fictitious_end},
};

const struct body_method fraction_methods_piso_ib = {
    .name = "piso-ib",
    .what = "force accumulated in the correctors of PISO",
    .equations = "LS 5.21",
    .function = "correct_force",
    .by_fraction = 1,
    .hooks = {.begin = keep_force,
              .add_friction = add_force,
              .change_faces = fraction_methods_nothing,
              .corrected = correct_force,
              .end = piso_ib_end},
};
