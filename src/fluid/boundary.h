/* boundary.h -- what happens on a patch of the fluid's boundary.  Chapter 5.
 *
 * no-slip: u = 0.  slip: no flux, no tangential stress.  inlet: a superficial
 * velocity normal to the patch, which may vary in time.  outlet: a pressure;
 * the velocity leaves unchanged, and what flows back in enters at rest.
 */
#ifndef BOUNDARY_H
#define BOUNDARY_H

enum boundary_kind {
    BOUNDARY_NO_SLIP,
    BOUNDARY_SLIP,
    BOUNDARY_INLET,
    BOUNDARY_OUTLET
};

struct boundary {
    enum boundary_kind kind;
    double pressure;    /* [Pa] of an outlet, without the hydrostatic part */
    int n_points;       /* [-] of an inlet: corners of its course in time */
    const double *time; /* [s] ascending, borrowed */
    const double *velocity; /* [m/s] superficial, inward; linear in between,
                               constant before the first and after the last */
};

/* The superficial velocity of an inlet at time t [m/s]. */
double boundary_inlet_velocity(const struct boundary *b, double t);

#endif
