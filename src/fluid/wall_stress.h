/* wall_stress.h -- the stress of the fluid on its boundary faces.
 * Chapter "Averaged flow".
 *
 * On a face with the area vector S out of the fluid
 *
 *   F_p = (p + G . x) S,   F_v = mu SS / S.d (u_c - u_w) + mu |S| Omega x n
 *
 * with G the mean gradient of the pressure where there is one. F_v is the
 * viscous force in the momentum equation of the cell, and the term that a
 * rotating wall adds: that equation has mu lap u, which has the same sum over
 * all boundaries as the stress mu (grad u + grad u^T) and another one on each
 * of them.
 */
#ifndef FLUID_WALL_STRESS_H
#define FLUID_WALL_STRESS_H

#include "fluid/fluid.h"

struct wall_stress {
    double pressure[3]; /* [N] of the pressure on the face */
    double viscous[3];  /* [N] of viscosity */
    double shear[3];    /* [Pa] F_v / |S| without its normal part */
    double area;        /* [m^2] */
    double y_plus;      /* [-] distance y of the cell's centre from the wall:
                           y sqrt(|shear| / rho) rho / mu */
};

/* Of face j of a patch that is a wall, slip or not. */
struct wall_stress wall_stress(const struct fluid *fl, int patch, int j);

/* 1 if nothing flows through the patch. */
int wall_stress_is_wall(const struct fluid *fl, int patch);

#endif
