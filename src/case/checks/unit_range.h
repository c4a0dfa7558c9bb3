/* unit_range.h -- which magnitudes a number of a case can have, by its unit.
 *
 * A number that no physical quantity of its unit has is a slip, or it would
 * overflow where it is squared: a diameter of 1e-300 m has no volume.
 */
#ifndef CASE_UNIT_RANGE_H
#define CASE_UNIT_RANGE_H

#include "base/key.h"

struct unit_range {
    const char *unit;
    double least, most; /* [unit] of the magnitude, where it is not 0 */
};

const struct unit_range *unit_range_of(const char *unit);

/* 1 if x is 0 or of a magnitude within the range. */
int unit_range_holds(const struct unit_range *r, double x);

#endif
