/* random.h -- random numbers without a state.
 *
 * A number follows from four whole numbers: a seed and three that say what it
 * is for, such as a particle's id and a step. So it does not depend on the
 * order in which numbers are asked for, on the number of threads, or on a
 * restart.
 */
#ifndef BASE_RANDOM_RANDOM_H
#define BASE_RANDOM_RANDOM_H

/* 0 <= u < 1, by the mixer of SplitMix64 [Steele14]. */
double random_uniform(unsigned long seed, long i, long j, int which);

/* Of the normal distribution with mean 0 and standard deviation 1; the same
 * mixer, through the inverse of the distribution. Within +-8.2. */
double random_normal(unsigned long seed, long i, long j, int which);

#endif
