/* boundary_condition.h -- what a case says about a side of the box or a patch
 * of its mesh, and the descriptor of a boundary condition.
 * Chapter "Averaged flow".
 *
 * A case chooses a condition by its name or, where it has keys, by a group with
 * the first of them.
 */
#ifndef FLUID_BOUNDARY_CONDITION_H
#define FLUID_BOUNDARY_CONDITION_H

#include "base/file.h"
#include "base/model.h"
#include "fluid/boundary.h"
#include "mesh/mesh.h"

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
};

/* All of them, ended by NULL. */
extern const struct boundary_condition boundary_rotating_wall;
extern const struct boundary_condition *const boundary_conditions[];

#endif
