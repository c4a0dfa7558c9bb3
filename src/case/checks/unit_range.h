/* unit_range.h -- which magnitudes a number of a case can have, by its unit.
 *
 * A number that no physical quantity of its unit has is a slip, or it would
 * overflow where it is squared: a diameter of 1e-300 m has no volume.
 */
#ifndef CASE_CHECKS_UNIT_RANGE_H
#define CASE_CHECKS_UNIT_RANGE_H

#include "base/key.h"

struct config_setting_t;

/* 0, or 2 after a message: a number of the value that its unit cannot have. */
int unit_range_check(const struct key *key, const char *path,
                     const struct config_setting_t *value);

#endif
