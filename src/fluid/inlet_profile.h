/* inlet_profile.h -- how the velocity varies over the faces of an inlet.
 * Chapter "Averaged flow".
 *
 * The velocity of a face is that of the inlet at this time, times the mean of
 * the profile over the face. A profile is one descriptor; all but the uniform
 * one are in inlets/.
 */
#ifndef FLUID_INLET_PROFILE_H
#define FLUID_INLET_PROFILE_H

#include "fluid/boundary_condition.h"

struct inlet_profile {
    MODEL_MEMBERS;    /* base/model.h */
    const char *asks; /* its first key, which it cannot do without and messages
                         are about; NULL: none */
    /* Sets b->profile, or b->varying, and b->memory. Non-zero if that cannot
     * be; `wrong` then says why. */
    int (*create)(const struct boundary_request *r, struct boundary *b,
                  char wrong[BOUNDARY_TEXT]);
};

extern const struct inlet_profile inlet_profile_uniform, parabola_profile,
    formula_profile, table_profile, file_profile;
extern const struct inlet_profile *const inlet_profiles[]; /* ended by NULL */

/* 1 if the case gives the key that the profile asks for, if it asks for any. */
int inlet_profile_is_given(const struct inlet_profile *profile,
                           const struct boundary_options *o);

#endif
