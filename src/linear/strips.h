/* strips.h -- loops over all unknowns, shared by the threads, with the same
 * bits for any number of them.
 *
 * A loop is a function f(first, last, ...) over a range of unknowns. A long
 * one is cut into a fixed number of strips, whoever computes them, and sums
 * are added strip by strip, in order; a short one is called as it is, because
 * even an OpenMP region of one thread costs more (measured: 0.3 microseconds)
 * than a coarse level of multigrid.
 */
#ifndef STRIPS_H
#define STRIPS_H

enum {
    STRIPS = 64,
    STRIPS_LEAST = 256, /* [-] unknowns in a strip: what is begun anew in each
                           should be little beside it */
    STRIPS_WORTH_IT = 16384, /* [-] numbers; a loop over fewer is short */
};

/* Unknowns in a strip: a multiple of 16, for it to begin with a cache line. */
static inline int strips_length(int n)
{
    const int length = ((n + STRIPS - 1) / STRIPS + 15) / 16 * 16;

    return length > STRIPS_LEAST ? length : STRIPS_LEAST;
}

/* The first of n unknowns in strip s; strip STRIPS begins at n. */
static inline int strips_first(int n, int s)
{
    const long first = (long)s * strips_length(n);

    return first < n ? (int)first : n;
}

/* Strips that are not empty. Threads share these: the last of 64 strips of a
 * small mesh are empty, and who had only those would be idle. */
static inline int strips_filled(int n)
{
    return (n + strips_length(n) - 1) / strips_length(n);
}

/* The strip that begins with this unknown. */
static inline int strips_of(int n, int first)
{
    return first / strips_length(n);
}

/* f(first, last, ...) for all n unknowns of m numbers each. */
#define STRIPS_RUN(n, m, f, ...)                                               \
    do {                                                                       \
        if ((n) < STRIPS_WORTH_IT / (m)) {                                     \
            f(0, n, __VA_ARGS__);                                              \
            break;                                                             \
        }                                                                      \
        const int filled_ = strips_filled(n);                                  \
        _Pragma("omp parallel for schedule(static)") for (int s_ = 0;          \
                                                          s_ < filled_; s_++)  \
            f(strips_first(n, s_), strips_first(n, s_ + 1), __VA_ARGS__);      \
    } while (0)

/* The same for a function that returns a double; their sum goes to result. */
#define STRIPS_SUM(result, n, m, f, ...)                                       \
    do {                                                                       \
        double part_[STRIPS];                                                  \
        if ((n) < STRIPS_WORTH_IT / (m)) {                                     \
            result = f(0, n, __VA_ARGS__);                                     \
            break;                                                             \
        }                                                                      \
        const int filled_ = strips_filled(n);                                  \
        _Pragma("omp parallel for schedule(static)") for (int s_ = 0;          \
                                                          s_ < filled_; s_++)  \
            part_[s_] =                                                        \
                f(strips_first(n, s_), strips_first(n, s_ + 1), __VA_ARGS__);  \
        result = 0.0;                                                          \
        for (int s_ = 0; s_ < filled_; s_++)                                   \
            result += part_[s_];                                               \
    } while (0)

#endif
