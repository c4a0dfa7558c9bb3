/* effect_count.h -- the number of events that an effect has counted. */
#ifndef COUPLING_EFFECT_COUNT_H
#define COUPLING_EFFECT_COUNT_H

struct effect_count {
    const char *name; /* as in summary.json */
    long value;       /* [-] in the run so far */
};
enum { EFFECT_COUNTS = 4 }; /* of one effect, at most */

#endif
