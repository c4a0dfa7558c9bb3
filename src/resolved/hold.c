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
#include "resolved/solid_bodies.h"

#include <math.h>

#include "base/vector.h"
#include "fluid/face_jump.h"
#include "fluid/momentum_system.h"
#include "fluid/piso.h"
#include "fluid/pressure_system.h"
#include "resolved/mark.h"

static struct solid_bodies *bodies_of(struct immersed *self)
{
    return (struct solid_bodies *)self;
}

/* The multiplier of [EW18 1] is hold (u - u_b)/rho, and u - u_b is 1/C of what
 * presses on it [EW18 4]. The explicit part, hold u_b, is no force of the
 * neighbours and stays out of H: it stands with the old-time terms. */
static void hold_begin(struct immersed *self, struct fluid *fl)
{
    struct solid_bodies *const b = bodies_of(self);
    double *const source = fl->levels->old_time_source;

    mark_bodies(b, fl);
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

    for (int j = 0; j < b->n_cells; j++) {
        const int c = b->cell[j];
        fl->momentum->diag[c] += b->hold[c] * fl->mesh->V[c];
    }
}

/* a / (a + hold V) */
static double theta(const struct solid_bodies *b, const struct fluid *fl, int c)
{
    const double diag = fl->momentum->diag[c];
    return (diag - b->hold[c] * fl->mesh->V[c]) / diag;
}

/* The share of cell c in the flux of the bodies through S, (1 - theta) eps u_b
 * . S / 2 [m^3/s]. */
static double body_flux(const struct solid_bodies *b, const struct fluid *fl,
                        int c, double rest, const double S[3])
{
    return b->hold[c] > 0.0 ? 0.5 * (1.0 - rest) * fl->eps[c] *
                                  vector_dot(&b->hold_u[3 * c], S) / b->hold[c]
                            : 0.0;
}

/* The resistance has been formed with the whole diagonal; what of the flux does
 * not depend on p is in proportion to the mobility. */
static void change_face(const struct solid_bodies *b, struct fluid *fl, int f)
{
    struct pressure_system *const pressure = fl->pressure;
    const int o = fl->mesh->owner[f], n = fl->mesh->neighbour[f];
    const double w = fl->mesh->w[f], *const r = pressure->resistance;
    const double of_o = theta(b, fl, o), of_n = theta(b, fl, n);
    const double free = (1.0 - w) * of_o * r[o] + w * of_n * r[n];
    const double m = 0.5 * (of_o + of_n) / free;
    const double factor = m / pressure->m_face[f];
    const double *const S = &fl->mesh->S[3 * f];

    pressure->m_face[f] = m;
    pressure->conductance[f] *= factor;
    pressure->explicit_flux[f] *= factor;
    pressure->explicit_flux[f] +=
        body_flux(b, fl, o, of_o, S) + body_flux(b, fl, n, of_n, S);
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

/* Each face of a held cell once: by its owner, if that is held. The pressure
 * makes the fluxes satisfy continuity in all of the box [EW18 5]. */
static void change_faces(struct immersed *self, struct fluid *fl)
{
    const struct solid_bodies *const b = bodies_of(self);
    const struct mesh *const m = fl->mesh;

    for (int j = 0; j < b->n_cells; j++) {
        const int c = b->cell[j];
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            if (f >= m->n_internal) continue;
            if (m->owner[f] == c || b->hold[m->owner[f]] == 0.0)
                change_face(b, fl, f);
        }
    }
}

/* The friction of one body: J = dt sum hold (u - u_b) V [EW18 15], and r x J
 * [EW18 16]. It gets what the fluid loses in all (fluid.h). */
static void add_impulse(struct solid_bodies *b, const struct fluid *fl, int i)
{
    for (int j = b->start[i]; j < b->start[i + 1]; j++) {
        const struct hold_link *const l = &b->link[j];
        const double scale =
            fl->options.dt * l->hold * fl->mesh->V[l->cell]; /* [kg] */
        double J[3], turn[3];
        for (int k = 0; k < 3; k++) {
            J[k] = scale * (fl->u[3 * l->cell + k] - l->u[k]);
            b->hooks.impulse[k] -= J[k];
            b->hooks.gross += fabs(J[k]);
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

    for (int k = 0; k < 3; k++)
        self->impulse[k] = 0.0;
    self->gross = 0.0;
    for (int i = 0; i < b->ps->n; i++)
        add_impulse(b, fl, i);
}

static void hold_fluid(struct solid_bodies *b)
{
    b->hooks = (struct immersed){.begin = hold_begin,
                                 .add_friction = add_friction,
                                 .change_faces = change_faces,
                                 .smooth_forces = smooth_forces,
                                 .largest_term = largest_term,
                                 .end = hold_end};
}

const struct body_method hold_method = {
    .name = "hold",
    .what = "friction by distance, implicit in the momentum equation",
    .equations = "EW18 1-5, 15, 16",
    .function = "hold_fluid",
    .set = hold_fluid,
};
