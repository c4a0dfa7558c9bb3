/* clock.h -- wall-clock and processor time. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

/* Seconds since some moment in the past [s]. */
double clock_now(void);

/* Processor seconds of this program so far, of all its threads [s]. */
double clock_processor(void);

/* Adds the time since *since to *sum and moves *since to now. */
void clock_add(double *sum, double *since);

#endif
