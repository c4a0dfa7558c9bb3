/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

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

/* The lower of two limits; the second may be absent. */
static double lower(double most, double limit)
{
    return limit > 0.0 && limit < most ? limit : most;
}

/* The first number in a file, or 0. A group of processes may have less memory
 * than the machine. */
static double limit_in(const char *file)
{
    FILE *const in = fopen(file, "r");
    double limit = 0.0;

    if (in == NULL) return 0.0;
    if (fscanf(in, "%lf", &limit) != 1) limit = 0.0;
    fclose(in);
    return limit;
}

double alloc_most(void)
{
    struct rlimit own;
    double most = HUGE_VAL;

    most = lower(most, (double)sysconf(_SC_PHYS_PAGES) *
                           (double)sysconf(_SC_PAGESIZE));
    most = lower(most, limit_in("/sys/fs/cgroup/memory.max"));
    most = lower(most, limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"));
    if (getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY)
        most = lower(most, (double)own.rlim_cur);
    return most;
}

double alloc_peak(void)
{
    struct rusage used;

    return getrusage(RUSAGE_SELF, &used) == 0 ? 1024.0 * (double)used.ru_maxrss
                                              : 0.0;
}
