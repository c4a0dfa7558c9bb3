/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a small case and counts (tests/free.sh): arrays that are allocated, from
 * the beginning; functions that are entered and pieces of straight code that
 * are run in the steps, by the object files that were compiled to report them.
 *
 *   count CASE STEPS [KEY=VALUE]...
 */
#include <stdio.h>
#include <stdlib.h>

#include "case/build.h"
#include "case/case_file.h"
#include "coupling/coupling.h"

static long allocations, calls, pieces;

void *__real_alloc_zeroed(size_t n, size_t size);
double *__real_alloc_doubles(int n);
int *__real_alloc_ints(int n);
void *__wrap_alloc_zeroed(size_t n, size_t size);
double *__wrap_alloc_doubles(int n);
int *__wrap_alloc_ints(int n);

void *__wrap_alloc_zeroed(size_t n, size_t size)
{
    allocations++;
    return __real_alloc_zeroed(n, size);
}

double *__wrap_alloc_doubles(int n)
{
    allocations++;
    return __real_alloc_doubles(n);
}

int *__wrap_alloc_ints(int n)
{
    allocations++;
    return __real_alloc_ints(n);
}

/* The compiler's names: -finstrument-functions, -fsanitize-coverage. */
void __cyg_profile_func_enter(void *function, void *from);
void __cyg_profile_func_exit(void *function, void *from);
void __sanitizer_cov_trace_pc(void);

void __cyg_profile_func_enter(void *function, void *from)
{
    (void)function, (void)from;
    calls++;
}

void __cyg_profile_func_exit(void *function, void *from)
{
    (void)function, (void)from;
}

void __sanitizer_cov_trace_pc(void)
{
    pieces++;
}

int main(int argc, char **argv)
{
    int code = 2;

    if (argc < 3) return code;
    struct settings *const s = case_file_read(
        argv[1], argc - 3, (const char *const *)(argv + 3), &code);
    if (s == NULL) return code;
    allocations = calls = pieces = 0;
    struct simulation *const sim = build_simulation(s, &code);
    settings_free(s);
    if (sim == NULL || coupling_start(sim) != 0) return 3;
    calls = pieces = 0;
    for (int i = 0; i < atoi(argv[2]); i++)
        if (coupling_step(sim) != 0) return 3;
    printf("%ld %ld %ld\n", allocations, calls, pieces);
    build_free(sim);
    return 0;
}
