/* effect_columns.h -- columns of history.csv that an effect adds.
 * Chapter "Beds, compared with measurements".
 */
#ifndef COUPLING_EFFECT_COLUMNS_H
#define COUPLING_EFFECT_COLUMNS_H

struct simulation;

struct effect_columns {
    const char *const *names; /* with units, "mixing [-]"; ended by NULL */
    /* Their values now; returns how many. */
    int (*row)(void *memory, const struct simulation *sim, double *values);
};

#endif
