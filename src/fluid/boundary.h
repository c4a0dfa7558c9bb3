/* boundary.h -- boundary conditions of the fluid on a patch.
 * Chapter "Averaged flow".
 *
 * no-slip: u is that of the wall, which may move along itself. slip: no flux,
 * no tangential stress. inlet: a superficial velocity normal to the patch,
 * which may vary in time and over the patch. outlet: a given pressure; the
 * velocity has zero normal gradient, and backflow enters with zero velocity.
 */
#ifndef FLUID_BOUNDARY_H
#define FLUID_BOUNDARY_H

#include "base/model.h"

enum boundary_kind {
    BOUNDARY_NO_SLIP,
    BOUNDARY_SLIP,
    BOUNDARY_INLET,
    BOUNDARY_OUTLET
};

/* What a case can write for a side or a patch: a word, or, where there are
 * keys, a group with the first of them. Ended by NULL. */
extern const struct model *const boundary_kinds[];

struct boundary {
    enum boundary_kind kind;
    double pressure;    /* [Pa] of an outlet, without the hydrostatic part */
    int n_points;       /* [-] of an inlet: points of its time series */
    const double *time; /* [s] ascending, borrowed */
    const double *velocity; /* [m/s] superficial, inward; linear in between,
                               constant before the first and after the last */
    const double *profile;  /* [-] of an inlet: velocity over its mean, one a
                               face of the patch, borrowed; NULL: uniform */
    double wall[3];         /* [m/s] of a no-slip wall, no part of it normal */
};

/* The mean superficial velocity of an inlet at time t [m/s]. */
double boundary_inlet_velocity(const struct boundary *b, double t);

/* Mean of a parabolic profile, zero at both ends of a channel 0 .. 1, over the
 * interval a .. b, divided by its mean over the channel [-]. */
double boundary_parabola(double a, double b);

#endif
