/* field_names.h -- the fields of a snapshot by the names that cases use. */
#ifndef RECORD_FIELD_NAMES_H
#define RECORD_FIELD_NAMES_H

#include "output/means/profile.h"
#include "case/settings.h"
#include "record/snapshot.h"

/* All of them, as the row of a key allows them. */
#define FIELD_NAMES "eps_f | eps_s | p | u_x | u_y | u_z | us_x | us_y | us_z"

/* The field that a case calls `name`; values NULL if the case has none. Mean
 * velocities of the particles are weighted by the solids fraction. */
struct profile_field field_names_find(const struct snapshot *s,
                                      const char *name);

/* Whether the case has the field that a group of a list names: 0, or 2 after a
 * message. */
int field_names_check(const struct settings *s, const char *list,
                      const char *field);

#endif
