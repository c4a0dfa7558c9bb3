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

#include "base/file.h"
#include "base/model.h"
#include "mesh/mesh.h"

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

/* --- boundary condition --------------------------------------------------- */

/* What a case says about a side of the box or a patch of its mesh, and the
 * descriptor of a boundary condition.
 *
 * A case chooses a condition by its name or, where it has keys, by a group
 * with the first of them. */

struct inlet_profile;

/* One side or patch that a case describes. What it does not say is 0 or NULL.
 */
struct boundary_options {
    const char *key; /* "fluid.left" */
    const struct boundary_condition *condition;
    struct key_series inlet; /* [s], [m/s] superficial, into the mesh */
    double pressure;         /* [Pa] of an outlet or an inlet of pressure */
    double wall[3];          /* [m/s] */
    double rotation[3];      /* [rad/s] about the axis through */
    double centre[3];        /* [m] */
    const struct inlet_profile *profile;
    const char *formula;     /* of the profile */
    const char *file;        /* beside the case */
    struct key_series table; /* [m], [-] */
    double along[3];         /* [-] the direction of the table */
    /* [-] 1: the case gives it */
    int has_profile, has_formula, has_file, has_table;
};

enum { BOUNDARY_TEXT = 256 };
/* Times of a run, besides 0, at which a profile that varies is looked at. */
enum { BOUNDARY_TIMES = 64 };

/* What a boundary is built of; all borrowed. */
struct boundary_request {
    const struct boundary_options *says;
    const struct mesh *mesh; /* a whole one, with all its arrays */
    const struct patch *patch;
    int between_walls[3]; /* [-] of a box: 1 if both ends of the direction are
                             no-slip walls */
    const struct input *file; /* NULL: none */
    double end;               /* [s] of the run */
};

struct boundary_condition {
    MODEL_MEMBERS; /* base/model.h */
    enum boundary_kind kind;
    /* Any of these may be NULL. Both return NULL or, if something is wrong, the
     * key of the side that it is about, "" for the side itself; `wrong` then
     * says why. check needs only an outline of the mesh; build completes a
     * boundary of the kind. */
    const char *(*check)(const struct boundary_options *o, const struct mesh *m,
                         const struct patch *p, char wrong[BOUNDARY_TEXT]);
    const char *(*build)(const struct boundary_request *r, struct boundary *b,
                         char wrong[BOUNDARY_TEXT]);
    /* 1 if that it can be built must be seen before a run. */
    int (*is_doubtful)(const struct boundary_options *o);
    /* The key for which it is built of the patch as a whole; or NULL. */
    const char *(*whole)(const struct boundary_options *o);
    /* The velocity of a wall at x [m]: u [m/s]. */
    void (*moves)(const struct boundary_options *o, const double x[3],
                  double u[3]);
};

/* All of them, ended by NULL. */
extern const struct boundary_condition *const boundary_conditions[];

#endif
