/* inlet_builder.h -- inlets whose velocity varies over their faces. */
#ifndef CASE_BOUNDARIES_INLET_BUILDER_H
#define CASE_BOUNDARIES_INLET_BUILDER_H

#include "case/settings.h"
#include "fluid/boundary.h"

/* Times of a run, besides 0, at which a profile that varies is looked at. */
enum { INLET_BUILDER_TIMES = 64 };

/* Gives the boundary of a patch the profile that the case names. 0, or 2 after
 * a message. And 1 if that must be done to be checked. */
int inlet_builder_add(const struct settings *s, const struct mesh *m,
                      const struct patch *p, struct boundary *b);
int inlet_builder_is_checked(const struct settings *s, const struct patch *p);

/* The velocity of an inlet over what the case gives, as its profile makes it
 * [-]: the mean over the patch and the largest of a face, at any time of the
 * run. */
void inlet_builder_shares(const struct settings *s, const char *patch,
                          double *mean, double *peak);

#endif
