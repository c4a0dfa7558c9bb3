/* field_names.h -- the fields of a snapshot by the names that cases use. */
#ifndef CASE_FIELD_NAMES_H
#define CASE_FIELD_NAMES_H

#include "output/profile.h"
#include "case/snapshot.h"

/* The field that a case calls `name`; values NULL if the case has none. Mean
 * velocities of the particles are weighted by how much of them there is. */
struct profile_field field_names_find(const struct snapshot *s,
                                      const char *name);

#endif
