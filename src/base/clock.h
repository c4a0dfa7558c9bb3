/* clock.h -- wall-clock time. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

/* Seconds since some moment in the past [s]. */
double clock_now(void);

/* Adds the time since *since to *sum and moves *since to now. */
void clock_add(double *sum, double *since);

#endif
