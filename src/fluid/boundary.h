/* boundary.h -- boundary conditions of the fluid on a patch.
 * Chapter "Averaged flow".
 *
 * no-slip: u is that of the wall, which may move along itself or rotate. slip:
 * no flux, no tangential stress. inlet: a superficial velocity normal to the
 * patch, which may vary in time and over the patch. outlet: a given pressure;
 * the velocity has zero normal gradient, and backflow enters with zero velocity
 * or, where the pressure is that of an inlet, with the velocity of its flux.
 */
#ifndef FLUID_BOUNDARY_H
#define FLUID_BOUNDARY_H

enum boundary_kind {
    BOUNDARY_NO_SLIP,
    BOUNDARY_SLIP,
    BOUNDARY_INLET,
    BOUNDARY_OUTLET
};

struct boundary {
    enum boundary_kind kind;
    double pressure;    /* [Pa] of an outlet, without the hydrostatic part */
    int enters;         /* [-] of an outlet: 1 if what flows in has the velocity
                           of its flux, normal to the face; 0: none */
    int n_points;       /* [-] of an inlet: points of its time series */
    const double *time; /* [s] ascending, borrowed */
    const double *velocity; /* [m/s] superficial, inward; linear in between,
                               constant before the first and after the last */
    double *series;         /* allocated for time and velocity, or NULL */
    const double *profile;  /* [-] of an inlet: velocity over its mean, one a
                               face of the patch, borrowed; NULL: uniform */
    double wall[3];         /* [m/s] of a no-slip wall, no part of it normal */
    const double *walls;    /* [m/s] the same where it differs between the faces
                               of the patch, 3 a face, at the foot of the centre
                               of the cell; NULL: `wall` */
    double rotation[3];     /* [rad/s] of a rigid wall, in `walls` already */
    /* [-] the profile of face j of an inlet at time t [s], where it varies in
     * time; NULL: `profile`. */
    double (*varying)(const struct boundary *b, int j, double t);
    /* Memory that was allocated for the other members, or NULL; and the
     * function that frees it, or NULL if free() does. */
    void *memory;
    void (*release)(struct boundary *b);
};

/* The mean superficial velocity of an inlet at time t [m/s]. */
double boundary_inlet_velocity(const struct boundary *b, double t);

/* The velocity of face j of an inlet at time t over its mean [-]. */
double boundary_inlet_profile(const struct boundary *b, int j, double t);

/* The velocity of face j of a no-slip wall [m/s], 3. */
const double *boundary_wall_velocity(const struct boundary *b, int j);

/* Frees b->series and b->memory. */
void boundary_release(struct boundary *b);

#endif
