/* SPDX-License-Identifier: GPL-3.0-or-later */
/* face_jump.c -- inertia where the void fraction jumps.
 *
 * A stream of phi / A through a face has the velocity phi / (eps A) on either
 * side. If eps jumps there, momentum does too, by
 *
 *   j = rho (phi / A)^2 (1 / eps_O - 1 / eps_N)       [Pa]
 *
 * and the pressure must jump with it (Bernoulli's equation at the surface of a
 * bed). The convection scheme gives the fraction 1 - s of this force to cell O
 * and the fraction s to N. If it acted on the cells as a whole it would be
 * smeared over their length, and the velocity would oscillate over several
 * cells; therefore the flux and the pressure of the face include it as a jump
 * at the face.
 *
 * The remaining force of convection and viscosity per volume, t, has no jump.
 * But with model A the pressure gradient t / gamma that balances it has one,
 * and with a mean of the two gradients a central scheme amplifies waves at the
 * surface of a bed. Therefore a face has one t, and each side uses it with its
 * own gamma:
 *
 *   p_N - p_O = ... + d t_f ((1 - w) / gamma_O + w / gamma_N)
 *   t_f = (1 - w) t_O + w t_N
 *
 * In addition, j must not amplify itself: between neighbouring faces, a flux
 * that is slightly too large increases j, and j increases the flux, before the
 * convection of the cells can counteract it. A dissipative scheme suppresses
 * this; a nondissipative one amplifies waves along the surface of a bed. For
 * such a scheme the jump is computed with the velocities of the cells,
 *
 *   j = rho (phi / A) q (1 / eps_O - 1 / eps_N)
 *   q = w eps_O u_O + (1 - w) eps_N u_N
 *
 * and the weights are biased upwind by 2 |eps_O - eps_N| / (eps_O + eps_N).
 * Where eps is smooth this bias is of first order in the cell size and its
 * error of second order. Bernoulli's pressure is unchanged; waves of a purely
 * central scheme still occur but decay.
 */
#include "fluid/face_jump.h"

#include <math.h>
#include <stddef.h>

#include "base/vector.h"
#include "linear/faces.h"
#include "fluid/systems.h"
#include "fluid/piso.h"

void face_jump_bias_upwind(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double *const convecting_flux = fl->levels->convecting_flux;
    double *const owner_weight = fl->momentum->owner_weight;

    for (int f = first; f < last; f++) {
        const double a = fl->eps[m->owner[f]], b = fl->eps[m->neighbour[f]];
        const double bias = fmin(1.0, 2.0 * fabs(a - b) / (a + b));
        fl->jump->upwind_bias[f] =
            bias * ((convecting_flux[f] >= 0.0 ? 1.0 : 0.0) - owner_weight[f]);
        owner_weight[f] += fl->jump->upwind_bias[f];
    }
}

/* Splits the jump j of a face between its two cells, for the velocity of a flux
 * q [m^3/s]; s is the neighbour's fraction. */
static inline void split_jump(const struct fluid *fl, int f, int o, int n,
                              double s, double q)
{
    const struct face_jump *const jump = fl->jump;
    const double j = fl->options.rho * fl->levels->convecting_flux[f] * q /
                     piso_square(fl, f) * (1.0 / fl->eps[o] - 1.0 / fl->eps[n]);

    jump->owner_part[f] = (1.0 - s) * j;
    jump->neighbour_part[f] = s * j;
    jump->pressure_jump[f] =
        face_jump_above_owner(fl, f, o) + s * j / piso_gamma(fl, n);
}

FACE_KERNEL split_by_cell_velocities(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const double w = fl->mesh->w[f], *const S = mesh_S(fl->mesh, f);
    const double q = w * fl->eps[o] * vector_dot(&fl->u[3 * o], S) +
                     (1.0 - w) * fl->eps[n] * vector_dot(&fl->u[3 * n], S);

    split_jump(fl, f, o, n,
               fl->momentum->owner_weight[f] - fl->jump->upwind_bias[f], q);
}

FACE_KERNEL split_by_flux(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    split_jump(fl, f, o, n, fl->momentum->owner_weight[f],
               fl->levels->convecting_flux[f]);
}

/* Splits the inertia of each face between its cells, by velocities or by the
 * flux. */
static void split_jumps(struct fluid *fl)
{
    if (piso_nondissipative(fl))
        FOR_EACH_FACE(fl->faces, 8, split_by_cell_velocities, fl);
    else
        FOR_EACH_FACE(fl->faces, 8, split_by_flux, fl);
}

/* Sums the forces of the jumps on the cells: the part of the cell times S. */
static void inertia_rows(int first, int last, const struct fluid *fl)
{
    const struct face_jump *const jump = fl->jump;

    faces_sum_vectors(fl->faces, first, last, fl->faces->n_inner,
                      jump->owner_part, 1.0, jump->neighbour_part,
                      jump->inertia);
}

/* Moves the part of the jump forces that the bias gives to the other cell back
 * to the cell in which the unbiased scheme has it. */
static void restore_jump_force(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct face_jump *const jump = fl->jump;
    const struct momentum_system *const momentum = fl->momentum;

    for (int f = 0; f < m->n_internal; f++) {
        const double j = jump->owner_part[f] + jump->neighbour_part[f];
        for (int k = 0; k < 3; k++) {
            const double force = jump->upwind_bias[f] * j * mesh_S(m, f)[k];
            momentum->b[3 * m->owner[f] + k] += force;
            momentum->b[3 * m->neighbour[f] + k] -= force;
        }
    }
}

void face_jump_update(struct fluid *fl)
{
    split_jumps(fl);
    PARALLEL_RANGES(fl->mesh->n_cells, 12, inertia_rows, fl);
    if (piso_nondissipative(fl)) restore_jump_force(fl);
}

/* The force of convection and viscosity on a cell per volume, without the
 * jumps, with the present H and u [N/m^3]. */
static void smooth_force_rows(int first, int last, struct fluid *fl)
{
    const struct face_jump *const jump = fl->jump;
    const struct time_levels *const levels = fl->levels;
    const struct momentum_system *const momentum = fl->momentum;

    for (int c = first; c < last; c++) {
        const double V = fl->mesh->V[c];
        const double older =
            levels->ddt_older != NULL ? levels->ddt_older[c] : 0.0;
        const double own =
            momentum->diag[c] - levels->ddt[c] - older - fl->K[c] * V;
        for (int k = 0; k < 3; k++) {
            const int i = 3 * c + k;
            jump->smooth_force[i] =
                (momentum->H[i] - jump->inertia[i] - own * fl->u[i]) / V -
                fl->F[i];
        }
    }
}

/* w (1 - w) d (1 / gamma_O - 1 / gamma_N), over the area [m^-1] */
static inline double gamma_jump_factor(const struct fluid *fl, int f, int o,
                                       int n)
{
    const double w = fl->mesh->w[f];
    const double Sd = vector_dot(mesh_S(fl->mesh, f), mesh_d(fl->mesh, f));
    return w * (1.0 - w) * Sd / piso_square(fl, f) *
           (1.0 / piso_gamma(fl, o) - 1.0 / piso_gamma(fl, n));
}

static inline double normal_force(const struct fluid *fl, int c, int f)
{
    return vector_dot(&fl->jump->smooth_force[3 * c], mesh_S(fl->mesh, f));
}

/* Adds the flux that the contribution to p_N - p_O drives. */
FACE_KERNEL gamma_flux(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    fl->phi[f] += fl->pressure->conductance[f] *
                  (gamma_jump_factor(fl, f, o, n) *
                   (normal_force(fl, n, f) - normal_force(fl, o, f)));
}

void face_jump_add_gamma_fluxes(struct fluid *fl)
{
    PARALLEL_RANGES(fl->mesh->n_cells, 12, smooth_force_rows, fl);
    if (fl->immersed != NULL && fl->immersed->smooth_forces != NULL)
        fl->immersed->smooth_forces(fl->immersed, fl);
    FOR_EACH_FACE(fl->faces, 8, gamma_flux, fl);
}

FACE_KERNEL gamma_pressure(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const double w = fl->mesh->w[f];

    fl->p_face[f] +=
        gamma_jump_factor(fl, f, o, n) *
        ((1.0 - w) * normal_force(fl, o, f) + w * normal_force(fl, n, f));
}

void face_jump_add_gamma_pressures(struct fluid *fl)
{
    FOR_EACH_FACE(fl->faces, 8, gamma_pressure, fl);
}
