/* clock.h -- wall-clock time. */
#ifndef CLOCK_H
#define CLOCK_H

/* Seconds since some moment in the past [s]. */
double clock_now(void);

/* Adds the time since *since to *sum and moves *since to now. */
void clock_add(double *sum, double *since);

#endif
