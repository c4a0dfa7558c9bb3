/* fields.h -- loops over fields that lie side by side, in groups of a length
 * that the compiler knows.
 *
 * A loop over m fields keeps its sums in registers, and uses vectors, only if
 * m is a constant (measured: five times faster). So a kernel works on a group
 * of width fields, from field k on, of m side by side, and is compiled once
 * for each width.
 */
#ifndef FIELDS_H
#define FIELDS_H

enum { FIELDS_WIDTH = 8 }; /* of the widest group */

/* What a kernel begins with: only inlined it is specialised. */
#define FIELDS_KERNEL static inline __attribute__((always_inline)) void

/* kernel(width, k, ...) for the groups of m fields: eights, a four, the rest.
 */
#define FIELDS_RUN(m, kernel, ...)                                             \
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
