/* face_jump.h -- jumps of the pressure at faces where eps or the drag jumps.
 * Chapter "Pressure".
 */
#ifndef FLUID_FACE_JUMP_H
#define FLUID_FACE_JUMP_H

#include "fluid/piso.h"

/* Exists only with particles. */
struct face_jump {
    double *owner_part; /* [Pa] pressure jump by inertia where eps jumps: the */
    double *neighbour_part; /* [Pa] parts of it in the cells on either side */
    double *upwind_bias;    /* [-] upwind bias of momentum's owner_weight, or
                               NULL */
    double *inertia;        /* [N] force of the jumps on each cell, 3 each */
    double *smooth_force;   /* [N/m^3] force of convection and viscosity on a
                               cell without the jumps, 3 each; NULL if no face
                               uses it */
    double *pressure_offset, *pressure_per_flux; /* [Pa], [Pa s/m^3] p_f minus
                                                    the linear mean: by drag and
                                                    inertia, and per m^3/s of
                                                    flux; gradient.c */
};

/* p_f minus the pressure on the owner's side of face f [Pa], that is the
 * owner's part of the jump; and the jump of p from owner to neighbour. */
static inline double face_jump_above_owner(const struct fluid *fl, int f,
                                           int owner)
{
    return fl->jump->owner_part[f] / piso_gamma(fl, owner);
}

static inline double face_jump_of_pressure(const struct fluid *fl, int f,
                                           int owner, int neighbour)
{
    return face_jump_above_owner(fl, f, owner) +
           fl->jump->neighbour_part[f] / piso_gamma(fl, neighbour);
}

/* Computes the jumps; once a step. For nondissipative schemes,
 * face_jump_bias_upwind also biases the weights of faces first .. last - 1
 * upwind. */
void face_jump_update(struct fluid *fl);
void face_jump_bias_upwind(int first, int last, struct fluid *fl);

/* Where gamma changes: computes the smooth force per volume from the present H
 * and u, and adds the fluxes that it drives to phi; adds its contribution to
 * p_face. */
void face_jump_add_gamma_fluxes(struct fluid *fl);
void face_jump_add_gamma_pressures(struct fluid *fl);

#endif
