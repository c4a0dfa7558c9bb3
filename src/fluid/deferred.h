/* deferred.h -- explicit terms that use the gradients of cells.
 * Chapter "The flow, verified".
 *
 * Where the links of a mesh are not normal to their faces, or miss the middles
 * of these, and in a scheme of convection that uses more than two cells, the
 * equations have terms with gradients. They are computed from the values known
 * so far and added to the explicit side (deferred correction). In a box, with
 * the other schemes, there are none. The files are those of deferred/.
 */
#ifndef FLUID_DEFERRED_H
#define FLUID_DEFERRED_H

#include "fluid/fluid.h"

struct fluid;

struct deferred {
    double *reach; /* [m] from the centre of a cell to where the velocity of its
                      boundary face holds, 3 a boundary face
                      (schemes.h); NULL: to the middle */
    double *slope; /* [1/s] gradient of the velocity, 9 a cell */
    double *u_boundary; /* [m/s] the velocity on the boundary, 3 a face */
    double *off; /* [m] of where a link misses the middle; NULL for a mesh
                    without */
    double *normal_equations; /* [1/m^2] of least squares, likewise; NULL
                                 without tetrahedra */
};

/* NULL where the mesh and the schemes of the fluid need none. */
struct deferred *deferred_create(const struct fluid *fl);

/* Adds the terms to the right-hand side of the momentum equation [N]. */
void deferred_add_to_momentum(struct deferred *d, struct fluid *fl);
/* Adds the terms to the fluxes without the pressure [m^3/s]. */
void deferred_add_to_fluxes(const struct deferred *d, struct fluid *fl);
/* Adds the terms to p_face [Pa] and computes grad_p from it. */
void deferred_set_gradient(const struct deferred *d, struct fluid *fl);

/* non_orthogonal.c: adds to the fluxes what the pressure gradient drives
 * through the part of the area vector that is not along the link. */
void deferred_add_oblique_fluxes(struct fluid *fl);

/* Where the velocity of a boundary face holds, and the
 * velocity gradient of a flow with it. */

/* From the centre of the cell to where the velocity of its boundary face holds
 * [m], 3 a boundary face: the middle of the face, or the foot of the centre at
 * slip walls and outlets, which have the velocity of the cell, and at walls
 * that rotate. NULL: the middle everywhere. */
double *boundary_reach(const struct mesh *m, const struct boundary *b);

/* The gradient of u, a velocity of all cells, with u_b on the boundary faces
 * (schemes.h) [1/s]. */
void boundary_reach_gradient(const struct fluid *fl, const double *u,
                             const double *u_b, double *slope);

#endif
