/* clock.h -- wall-clock and processor time. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

#include <time.h>

static inline double clock_seconds(clockid_t which)
{
    struct timespec t;
    clock_gettime(which, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds since some moment in the past [s]. */
static inline double clock_now(void)
{
    return clock_seconds(CLOCK_MONOTONIC);
}

/* Processor seconds of this program so far, of all its threads [s]. */
static inline double clock_processor(void)
{
    return clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

/* Adds the time since *since to *sum and moves *since to now. */
static inline void clock_add(double *sum, double *since)
{
    const double now = clock_now();
    *sum += now - *since;
    *since = now;
}

#endif
