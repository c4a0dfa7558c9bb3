/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

void *alloc_zeroed(size_t n, size_t size)
{
    const size_t bytes = (n * size + 64) / 64 * 64; /* never 0 */
    void *const p = n > (size_t)-1 / 2 / size ? NULL : aligned_alloc(64, bytes);

    if (p == NULL) {
        fprintf(stderr, "winnow: out of memory: %zu items of %zu bytes\n", n,
                size);
        exit(4);
    }
    return memset(p, 0, bytes);
}

/* A negative number is one that does not fit into an int. */
static size_t counted(int n)
{
    if (n >= 0) return (size_t)n;
    fprintf(stderr, "winnow: out of memory: an array of more than %d numbers\n",
            INT_MAX);
    exit(4);
}

double *alloc_doubles(int n)
{
    return alloc_zeroed(counted(n), sizeof(double));
}

int *alloc_ints(int n)
{
    return alloc_zeroed(counted(n), sizeof(int));
}

void *alloc_grown(void *old, int used, int n, size_t size)
{
    void *const grown = alloc_zeroed(counted(n), size);

    if (used > 0) memcpy(grown, old, (size_t)used * size);
    free(old);
    return grown;
}

double alloc_peak(void)
{
    struct rusage used;

    return getrusage(RUSAGE_SELF, &used) == 0 ? 1024.0 * (double)used.ru_maxrss
                                              : 0.0;
}
