/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _DEFAULT_SOURCE /* madvise */
#include "base/alloc.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

/* What is large enough to be asked for: the kernel promises more than it has,
 * and ends the program that takes it [byte]. */
enum { LARGE = 1 << 26 };

/* A long array asks for large pages [byte]: a loop over several such arrays
 * would wait for the places of small ones. */
enum { SMALL_PAGE = 1 << 12, LARGE_PAGE = 1 << 21 };

static void ask_for_large_pages(char *p, size_t bytes)
{
#ifdef MADV_HUGEPAGE
    const size_t over = (uintptr_t)p % SMALL_PAGE; /* advice is for pages */

    if (bytes >= LARGE_PAGE) madvise(p - over, bytes + over, MADV_HUGEPAGE);
#else
    (void)p, (void)bytes;
#endif
}

/* The lower of a limit and the number that stands in a file, if it does. */
static double alloc_lower(double most, const char *file, const char *format,
                          double unit)
{
    FILE *const in = fopen(file, "r");
    double limit = 0.0;

    if (in == NULL) return most;
    if (fscanf(in, format, &limit) != 1) limit = 0.0;
    fclose(in);
    return limit > 0.0 ? fmin(most, unit * limit) : most;
}

/* A group of processes may have less memory than the machine. */
double alloc_most(void)
{
    struct rlimit own;
    double most =
        (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);

    most = alloc_lower(most, "/sys/fs/cgroup/memory.max", "%lf", 1.0);
    most = alloc_lower(most, "/sys/fs/cgroup/memory/memory.limit_in_bytes",
                       "%lf", 1.0);
    if (getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY)
        most = fmin(most, (double)own.rlim_cur);
    return most;
}

/* The third line of three words each. */
double alloc_left(void)
{
    return alloc_lower(alloc_most(), "/proc/meminfo",
                       "%*s %*s %*s %*s %*s %*s MemAvailable: %lf", 1024.0);
}

void *alloc_zeroed(size_t n, size_t size)
{
    const size_t bytes = (n * size + 64) / 64 * 64; /* never 0 */
    const int fits = n <= (size_t)-1 / 2 / size &&
                     (bytes < LARGE || (double)bytes <= alloc_left());
    void *const p = fits ? aligned_alloc(64, bytes) : NULL;

    if (p == NULL) {
        fprintf(stderr, "winnow: out of memory: %zu items of %zu bytes\n", n,
                size);
        exit(4);
    }
    ask_for_large_pages(p, bytes);
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

/* n ints, all zero. */
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

void *alloc_room(void *list, int n, int *room, size_t size)
{
    if (n < *room) return list;
    *room = 2 * n + 64;
    return alloc_grown(list, n, *room, size);
}

double alloc_peak(void)
{
    struct rusage used;

    return getrusage(RUSAGE_SELF, &used) == 0 ? 1024.0 * (double)used.ru_maxrss
                                              : 0.0;
}

/* --- owner ---------------------------------------------------------------- */

/* It lies before the object. */
struct owner {
    struct owner *self, *part, *next; /* its first one; the next of its owner */
    void **array;
    int n, room;
};
enum { OWNER_HEAD = 64 }; /* [byte] so that the object is aligned too */

static struct owner *owner_head(void *object)
{
    struct owner *const o = (void *)((char *)object - OWNER_HEAD);

    assert(o->self == o);
    return o;
}

void *owner_create(size_t size)
{
    struct owner *const o = alloc_zeroed(1, OWNER_HEAD + size);

    o->self = o;
    return (char *)o + OWNER_HEAD;
}

void *owner_take(void *owner, void *array)
{
    struct owner *const o = owner_head(owner);

    o->array = alloc_room(o->array, o->n, &o->room, sizeof *o->array);
    return o->array[o->n++] = array;
}

void *owner_join(void *owner, void *part)
{
    if (part == NULL) return NULL;
    struct owner *const o = owner_head(owner), *const p = owner_head(part);
    p->next = o->part;
    o->part = p;
    return part;
}

void *owner_zeroed(void *owner, size_t n, size_t size)
{
    return owner_take(owner, alloc_zeroed(n, size));
}

double *owner_doubles(void *owner, int n)
{
    return owner_zeroed(owner, counted(n), sizeof(double));
}

int *owner_ints(void *owner, int n)
{
    return owner_zeroed(owner, counted(n), sizeof(int));
}

void owner_free(void *owner)
{
    if (owner == NULL) return;
    struct owner *const o = owner_head(owner);
    for (struct owner *p = o->part, *next; p != NULL; p = next) {
        next = p->next;
        owner_free((char *)p + OWNER_HEAD);
    }
    for (int k = 0; k < o->n; k++)
        free(o->array[k]);
    free(o->array);
    free(o->self);
}
