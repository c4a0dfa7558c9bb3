/* fields.h -- the fields of a snapshot by the names that cases use. */
#ifndef FIELDS_H
#define FIELDS_H

#include "output/profile.h"
#include "scene/snapshot.h"

/* The field that a case calls `name`; values NULL if the scene has none. Mean
 * velocities of the particles are weighted by how much of them there is. */
struct profile_field fields_named(const struct snapshot *s, const char *name);

#endif
