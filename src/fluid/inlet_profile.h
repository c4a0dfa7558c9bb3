/* inlet_profile.h -- how the velocity varies over the faces of an inlet.
 * Chapter "Averaged flow".
 *
 * The velocity of a face is that of the inlet at this time, times the mean of
 * the profile over the face. A profile is one descriptor.
 */
#ifndef FLUID_INLET_PROFILE_H
#define FLUID_INLET_PROFILE_H

#include "fluid/boundary.h"

struct inlet_profile {
    MODEL_MEMBERS;    /* base/model.h */
    const char *asks; /* its first key, which it cannot do without and messages
                         are about; NULL: none */
    /* Sets b->profile, or b->varying, and b->memory. Non-zero if that cannot
     * be; `wrong` then says why. */
    int (*create)(const struct boundary_request *r, struct boundary *b,
                  char wrong[BOUNDARY_TEXT]);
};

extern const struct inlet_profile inlet_profile_uniform, inlet_profile_parabola,
    file_profile; /* inlets/file_profile.c */
extern const struct inlet_profile *const inlet_profiles[]; /* ended by NULL */

/* 1 if the case gives the key that the profile asks for, if it asks for any. */
int inlet_profile_is_given(const struct inlet_profile *profile,
                           const struct boundary_options *o);

/* The mean of the function g(of, x), x [m], over boundary face f. The face is
 * divided into triangles about the middle of its corners; the mean is exact for
 * polynomials of degree 5. */
double inlet_profile_face_mean(const struct mesh *m, int f,
                               double (*g)(const void *of, const double x[3]),
                               const void *of);

/* Mean of a parabolic profile, zero at both ends of a channel 0 .. 1, over the
 * interval a .. b, divided by its mean over the channel [-]. */
double inlet_profile_parabola_mean(double a, double b);

/* --- formula -------------------------------------------------------------- */

/* Formulas of x, y, z and t that a case writes.
 *
 * Numbers, pi, + - * / ^, parentheses, and the functions abs, sqrt, exp, log,
 * sin, cos, tan, sinh, cosh, tanh, erf, min(a, b), max(a, b). A formula is
 * translated once into steps on a stack; to evaluate it is a loop over them. */

struct formula;

/* Translates a formula; NULL if it is wrong, and `wrong` then says what and
 * where. */
struct formula *formula_create(const char *text, char *wrong, int room);
void formula_free(struct formula *f);

/* The value of the formula at x [m] and t [s]. */
double formula_value(const struct formula *f, const double x[3], double t);

/* 1 if t stands in it. */
int formula_varies(const struct formula *f);

#endif
