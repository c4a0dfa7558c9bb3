/* field_groups.h -- loops over interleaved fields, in groups whose length is a
 * compile-time constant.
 *
 * The compiler keeps the sums of a loop over m fields in registers, and
 * vectorises the loop, only if m is a constant (measured: five times faster). A
 * kernel therefore works on a group of `width` fields, the first of them field
 * k of m, and is compiled once for each width.
 */
#ifndef LINEAR_FIELD_GROUPS_H
#define LINEAR_FIELD_GROUPS_H

enum { FIELD_GROUPS_WIDTH = 8 }; /* of the widest group */

/* Every kernel is declared with this prefix, because the compiler specialises
 * it only if it is inlined. */
#define FIELD_GROUPS_KERNEL static inline __attribute__((always_inline)) void

/* Calls kernel(width, k, ...) for groups of 8 fields, then of 4, then for the
 * remaining 1 to 3 of m fields. */
#define FOR_FIELD_GROUPS(m, kernel, ...)                                       \
    do {                                                                       \
        int k_ = 0;                                                            \
        for (; (m)-k_ >= 8; k_ += 8)                                           \
            kernel(8, k_, __VA_ARGS__);                                        \
        for (; (m)-k_ >= 4; k_ += 4)                                           \
            kernel(4, k_, __VA_ARGS__);                                        \
        if ((m)-k_ == 3) kernel(3, k_, __VA_ARGS__);                           \
        if ((m)-k_ == 2) kernel(2, k_, __VA_ARGS__);                           \
        if ((m)-k_ == 1) kernel(1, k_, __VA_ARGS__);                           \
    } while (0)

#endif
