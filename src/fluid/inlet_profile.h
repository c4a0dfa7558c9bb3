/* inlet_profile.h -- how the velocity varies over the faces of an inlet.
 * Chapter "Averaged flow".
 *
 * The velocity of a face is that of the inlet at this time, times the mean of
 * the profile over the face. A profile is one descriptor; all but the uniform
 * one are in inlets/.
 */
#ifndef FLUID_INLET_PROFILE_H
#define FLUID_INLET_PROFILE_H

#include "base/key.h"
#include "fluid/boundary.h"
#include "mesh/mesh.h"

/* What a case says about a profile; all borrowed. */
struct inlet_request {
    const struct mesh *mesh; /* a whole one, with all its arrays */
    const struct patch *patch;
    int between_walls[3]; /* [-] of a box: 1 if both ends of the direction are
                             no-slip walls */
    const char *formula;  /* NULL: none */
    const char *file;     /* its path; NULL: none */
    int n_points;         /* [-] of a table */
    const double *s, *u;  /* [m], [-] of a table, s ascending */
    double along[3];      /* [-] the direction of s */
};

enum { INLET_PROFILE_TEXT = 256 };

struct inlet_profile {
    const char *name, *what, *equations, *function;
    const struct key *keys[KEY_TABLES];
    const char *asks; /* the key of the patch that it cannot do without, which
                         messages are about; NULL: none */
    /* Sets b->profile, or b->varying, and b->memory. Non-zero if that cannot
     * be; `wrong` then says why. */
    int (*create)(const struct inlet_request *r, struct boundary *b,
                  char wrong[INLET_PROFILE_TEXT]);
};

extern const struct inlet_profile inlet_profile_uniform, parabola_profile,
    formula_profile, table_profile, file_profile;
extern const struct inlet_profile *const inlet_profiles[]; /* ended by NULL */
const struct inlet_profile *inlet_profile_named(const char *name);

#endif
