/* strict.h -- a tree held against the tables of keys.
 *
 * Every setting must have a row, the type of the row and a value it allows;
 * every required key of a group that is there must be given, and the groups a
 * row needs must be there too. Then the defaults are filled in.
 */
#ifndef STRICT_H
#define STRICT_H

#include "base/key.h"

#include <libconfig.h>

/* 0, or 2 after one message about the first thing that is wrong. */
int strict_check(config_t *tree, const struct key *const *tables);

/* Adds the default of every key left out, in every group that is there. */
void strict_fill(config_t *tree, const struct key *const *tables);

#endif
