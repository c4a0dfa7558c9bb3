/* body_method.h -- a way in which bodies hold the fluid.
 * Chapter "Resolving the grains". */
#ifndef RESOLVED_BODY_METHOD_H
#define RESOLVED_BODY_METHOD_H

#include "base/model.h"

struct solid_bodies;

struct body_method {
    MODEL_MEMBERS;                       /* base/model.h */
    void (*set)(struct solid_bodies *b); /* its place in a step of the fluid */
};

/* All of them, ended by NULL; the first is the default. */
extern const struct body_method hold_method, fraction_methods_fictitious,
    fraction_methods_piso_ib;
extern const struct body_method *const body_methods[];

#endif
