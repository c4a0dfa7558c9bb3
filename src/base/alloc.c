/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

double *alloc_doubles(int n)
{
    return alloc_zeroed((size_t)n, sizeof(double));
}

int *alloc_ints(int n)
{
    return alloc_zeroed((size_t)n, sizeof(int));
}
