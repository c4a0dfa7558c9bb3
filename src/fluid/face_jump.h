/* face_jump.h -- jumps of the pressure at faces where eps or the drag jumps.
 * Chapter "Pressure".
 */
#ifndef FLUID_FACE_JUMP_H
#define FLUID_FACE_JUMP_H

#include "fluid/piso.h"

/* Exists only with particles. */
struct face_jump {
    /* The pressure jump by inertia where eps jumps has a part in the cell on
     * either side of the face [Pa]. These two and upwind_bias are not needed
     * any more when the velocity is predicted (systems.c). */
    double *owner_part, *neighbour_part;
    double *pressure_jump; /* [Pa] by both, of p from owner to neighbour */
    double *upwind_bias;   /* [-] of momentum's owner_weight */
    double *inertia;       /* [N] force of the jumps on each cell, 3 each */
    double *smooth_force;  /* [N/m^3] force of convection and viscosity on a
                              cell without the jumps, 3 each; NULL if no face
                              uses it */
    /* gradient.c: p_f minus the linear mean is pressure_offset [Pa], by drag
     * and inertia, minus pressure_per_flux [Pa s/m^3] times the flux. */
    double *pressure_offset, *pressure_per_flux;
};

/* p_f minus the pressure on the owner's side of face f [Pa], that is the
 * owner's part of the jump. */
static inline double face_jump_above_owner(const struct fluid *fl, int f,
                                           int owner)
{
    return fl->jump->owner_part[f] / piso_gamma(fl, owner);
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
