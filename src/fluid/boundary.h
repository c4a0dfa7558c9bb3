/* boundary.h -- what happens on a patch of the fluid's boundary.  Chapter 5.
 *
 * no-slip: u is that of the wall, which may move along itself.  slip: no flux,
 * no tangential stress.  inlet: a superficial velocity normal to the patch,
 * which may vary in time and over the patch.  outlet: a pressure; the velocity
 * leaves unchanged, and what flows back in enters at rest.
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
    const double *profile;  /* [-] of an inlet: velocity over its mean, one a
                               face of the patch, borrowed; NULL: uniform */
    double wall[3];         /* [m/s] of a no-slip wall, no part of it normal */
};

/* The mean superficial velocity of an inlet at time t [m/s]. */
double boundary_inlet_velocity(const struct boundary *b, double t);

/* What a stretch a .. b of a channel 0 .. 1 gets of a parabola that vanishes
 * at both ends: mean over the stretch, over that of the channel [-]. */
double boundary_parabola(double a, double b);

#endif
