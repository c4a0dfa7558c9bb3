/* parallel_ranges.h -- parallel loops over all unknowns, with the same bits for
 * any number of threads.
 *
 * A loop is a function f(first, last, ...) over a range of unknowns. A long
 * loop is divided into a fixed number of ranges, independent of the number of
 * threads, and the sums of the ranges are added in order. A short loop is
 * called once without OpenMP, because even a parallel region of one thread
 * costs more (measured: 0.3 microseconds) than a coarse level of multigrid.
 */
#ifndef BASE_PARALLEL_RANGES_H
#define BASE_PARALLEL_RANGES_H

enum {
    PARALLEL_RANGES_COUNT = 64,
    PARALLEL_RANGES_MIN_LENGTH =
        256, /* [-] unknowns in a range, at least: the cost of starting a range
                should be small beside the work in it */
    PARALLEL_RANGES_MIN_WORK =
        16384,                   /* [-] numbers; a loop over fewer is short */
    PARALLEL_RANGES_BLOCK = 512, /* [-] unknowns in a block */
};

/* Unknowns in a range: a multiple of 16, so that each range begins at a cache
 * line. */
static inline int parallel_ranges_length(int n)
{
    const int length =
        ((n + PARALLEL_RANGES_COUNT - 1) / PARALLEL_RANGES_COUNT + 15) / 16 *
        16;

    return length > PARALLEL_RANGES_MIN_LENGTH ? length
                                               : PARALLEL_RANGES_MIN_LENGTH;
}

/* The first of n unknowns in range s; range number PARALLEL_RANGES_COUNT begins
 * at n. */
static inline int parallel_ranges_first(int n, int s)
{
    const long first = (long)s * parallel_ranges_length(n);

    return first < n ? (int)first : n;
}

/* Number of ranges that are not empty. Only these are divided among the
 * threads: on a small mesh the last of the 64 ranges are empty, and a thread
 * that had only those would be idle. */
static inline int parallel_ranges_filled(int n)
{
    return (n + parallel_ranges_length(n) - 1) / parallel_ranges_length(n);
}

/* The range that begins with this unknown. */
static inline int parallel_ranges_of(int n, int first)
{
    return first / parallel_ranges_length(n);
}

/* f(first, last, ...) for all n unknowns of m numbers each. */
#define PARALLEL_RANGES(n, m, f, ...) PARALLEL_PARTS(n, n, m, f, __VA_ARGS__)

/* The same for a function that passes over its unknowns several times: each
 * range in blocks, whose numbers fit into the first-level cache. */
#define PARALLEL_BLOCKS(n, m, f, ...)                                          \
    PARALLEL_PARTS(PARALLEL_RANGES_BLOCK, n, m, f, __VA_ARGS__)

#define PARALLEL_PARTS(length, n, m, f, ...)                                   \
    do {                                                                       \
        if ((n) < PARALLEL_RANGES_MIN_WORK / (m)) {                            \
            f(0, n, __VA_ARGS__);                                              \
            break;                                                             \
        }                                                                      \
        const int filled_ = parallel_ranges_filled(n), length_ = (length);     \
        _Pragma("omp parallel for schedule(static)") for (                     \
            int s_ = 0; s_ < filled_;                                          \
            s_++) for (int at_ = parallel_ranges_first(n, s_),                 \
                       end_ = parallel_ranges_first(n, s_ + 1);                \
                       at_ < end_; at_ += length_)                             \
            f(at_, end_ - at_ < length_ ? end_ : at_ + length_, __VA_ARGS__);  \
    } while (0)

/* The same for a function that returns a double; their sum goes to result. */
#define PARALLEL_SUM(result, n, m, f, ...)                                     \
    do {                                                                       \
        double part_[PARALLEL_RANGES_COUNT];                                   \
        if ((n) < PARALLEL_RANGES_MIN_WORK / (m)) {                            \
            result = f(0, n, __VA_ARGS__);                                     \
            break;                                                             \
        }                                                                      \
        const int filled_ = parallel_ranges_filled(n);                         \
        _Pragma("omp parallel for schedule(static)") for (int s_ = 0;          \
                                                          s_ < filled_; s_++)  \
            part_[s_] = f(parallel_ranges_first(n, s_),                        \
                          parallel_ranges_first(n, s_ + 1), __VA_ARGS__);      \
        result = 0.0;                                                          \
        for (int s_ = 0; s_ < filled_; s_++)                                   \
            result += part_[s_];                                               \
    } while (0)

#endif
