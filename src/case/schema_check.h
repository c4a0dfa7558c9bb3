/* schema_check.h -- checks a tree against the tables of keys.
 *
 * Every setting must have a row, the type of the row and a value it allows;
 * every required key of a group that the case has must be given, and the case
 * must have the groups that a row needs. Then the defaults are filled in.
 */
#ifndef CASE_SCHEMA_CHECK_H
#define CASE_SCHEMA_CHECK_H

#include "base/key.h"

#include <libconfig.h>

/* 0, or 2 after a message for the first text, of whatever key, with a control
 * character in it: texts end in scripts, pages and terminals. */
int schema_check_texts(const config_t *tree);

/* 0, or 2 after one message about the first thing that is wrong. */
int schema_check_check(config_t *tree, const struct key *const *tables);

/* Adds the default of every key that is left out of a group of the case. */
void schema_check_fill(config_t *tree, const struct key *const *tables);

#endif
