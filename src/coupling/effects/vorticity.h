/* vorticity.h -- curl u of the fluid, at the particles.
 * Chapter "Further forces".
 *
 * The lift forces and the torque of the fluid need it. The gradient in the
 * cells is that of the case (fluid.gradient), and the interpolation to the
 * particles the adjoint of the averaging, as for the other derivatives of the
 * flow.
 */
#ifndef COUPLING_EFFECTS_VORTICITY_H
#define COUPLING_EFFECTS_VORTICITY_H

#include "coupling/simulation.h"

struct vorticity {
    double *u_b;      /* [m/s] at the boundary, 3 a face */
    double *gradient; /* [1/s] of u, 9 a cell */
    double *curl;     /* [1/s] 3 a cell */
    double *at;       /* [1/s] interpolated to the particles, 3 each */
};

/* `name` is that of the attached array `at` (particles.h); borrowed. */
struct vorticity *vorticity_create(struct simulation *sim, const char *name);

/* Hooks of the effects whose memory is a struct vorticity (effect.h): the
 * second fills curl and at from the velocity of the fluid now. */
void vorticity_free(void *memory);
void vorticity_update(void *memory, struct simulation *sim);

/* The spin of particle i against half of the curl [rad/s]. */
void vorticity_relative_spin(const struct vorticity *v,
                             const struct particles *ps, int i,
                             double Omega[3]);

#endif
