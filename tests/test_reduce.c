/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/solvers.h"
#include "linear/reduce.h"

#include "base/parallel_ranges.h"
#include "facts.h"
#include "linear_case.h"

#include <omp.h>
#include <stdio.h>
#include <unistd.h>

static void count_block(int first, int last, char *times)
{
    for (int i = first; i < last; i++)
        times[i]++;
}

FACT(parallel_ranges_cover_every_unknown_once)
{
    const int sizes[] = {0, 1, 15, 16, 63, 64, 1000, 1024, 65537, 2000000};

    for (int k = 0; k < 10; k++) {
        const int n = sizes[k];

        ck_assert_int_eq(parallel_ranges_first(n, 0), 0);
        ck_assert_int_eq(parallel_ranges_first(n, PARALLEL_RANGES_COUNT), n);
        for (int s = 0; s < PARALLEL_RANGES_COUNT; s++)
            ck_assert_int_le(parallel_ranges_first(n, s),
                             parallel_ranges_first(n, s + 1));
        for (int s = 0;
             s < PARALLEL_RANGES_COUNT && parallel_ranges_first(n, s) < n; s++)
            ck_assert_int_eq(parallel_ranges_of(n, parallel_ranges_first(n, s)),
                             s);
        for (int s = 0; s < PARALLEL_RANGES_COUNT; s++)
            ck_assert_int_eq(s < parallel_ranges_filled(n),
                             parallel_ranges_first(n, s) <
                                 parallel_ranges_first(n, s + 1));

        char *const times = alloc_zeroed((size_t)n, 1);
        int once = 0;

        PARALLEL_BLOCKS(n, 12, count_block, times);
        for (int i = 0; i < n; i++)
            once += times[i] == 1;
        ck_assert_int_eq(once, n);
        free(times);
    }
}

static void count_mine(int first, int last, int *done)
{
    done[omp_get_thread_num()] += last - first;
}

/* To one range more and a short last one. (Of 64, these fill 15.) */
FACT(two_threads_share_a_small_mesh_evenly)
{
    const int n = 3600;
    int done[2] = {0, 0};

    omp_set_num_threads(2);
    PARALLEL_RANGES(n, 12, count_mine, done);
    ck_assert_int_eq(done[0] + done[1], n);
    ck_assert_int_lt(abs(done[0] - done[1]), 2 * parallel_ranges_length(n));
}

/* Sums of n whole numbers are exact, whatever their order. */
FACT(a_dot_product_counts_every_unknown_once)
{
    const int sizes[] = {1, 31, 32, 33, 5000, 16384, 16385, 70001};

    for (int k = 0; k < 8; k++) {
        const int n = sizes[k];
        double *const x = alloc_doubles(n), *const y = alloc_doubles(n);

        for (int i = 0; i < n; i++)
            x[i] = i % 10, y[i] = 2.0;

        double exact = 0.0;

        for (int i = 0; i < n; i++)
            exact += 2 * (i % 10);
        ck_assert_double_eq(reduce_dot(n, x, y), exact);
        free(x);
        free(y);
    }
}

FACT(fields_side_by_side_have_their_own_dot_products)
{
    for (int m = 1; m <= REDUCE_FIELDS; m++)
        for (int n = 7; n <= 20007; n += 20000) {
            double *const x = alloc_doubles(m * n);
            double dot[REDUCE_FIELDS];

            for (int i = 0; i < n * m; i++)
                x[i] = 1 + i % m;
            cg_many_dot(n, m, x, x, dot);
            for (int k = 0; k < m; k++)
                ck_assert_double_eq(dot[k], (1.0 + k) * (1.0 + k) * n);
            free(x);
        }
}

FACT(threads_do_not_change_a_bit)
{
    const int n = 50021;
    double *const x = noise_vector(3 * n, 1), *const y = noise_vector(3 * n, 2);
    double one[4], two[4];

    for (int threads = 1; threads <= 2; threads++) {
        double *const dot = threads == 1 ? one : two;

        omp_set_num_threads(threads);
        dot[3] = reduce_dot(3 * n, x, y);
        cg_many_dot(n, 3, x, y, dot);
    }
    ck_assert_mem_eq(one, two, sizeof one);
    free(x);
    free(y);
}

/* To the bit: so the vector z need not be stored. */
FACT(a_scaled_vector_in_single_precision_is_summed_as_its_copy)
{
    enum { N = 5003 };
    double *const x = noise_vector(N, 1), *const z = noise_vector(N, 2);
    float y[N];

    for (int i = 0; i < N; i++) {
        y[i] = (float)z[i];
        z[i] = 0.3 * (double)y[i];
    }
    ck_assert(reduce_range_scaled(3, N, x, y, 0.3) == reduce_range(3, N, x, z));
    free(x);
    free(z);
}

/* The flags of the mapping of an address; empty where the system tells none. */
static void flags_of_mapping(const void *address, char flags[256])
{
    FILE *const maps = fopen("/proc/self/smaps", "r");
    unsigned long at = (unsigned long)address, from = 0, to = 0;

    flags[0] = '\0';
    while (maps != NULL && fgets(flags, 256, maps) != NULL) {
        sscanf(flags, "%lx-%lx ", &from, &to);
        if (from <= at && at < to && strncmp(flags, "VmFlags:", 8) == 0) break;
        flags[0] = '\0';
    }
    if (maps != NULL) fclose(maps);
}

/* With small pages a sum of two long vectors takes twice the time. */
FACT(a_long_array_asks_for_large_pages)
{
    enum { N = 1 << 20 };
    double *const x = alloc_doubles(N);
    char flags[256];

    flags_of_mapping(x + N / 2, flags);
    if (access("/sys/kernel/mm/transparent_hugepage", F_OK) == 0)
        ck_assert_ptr_nonnull(strstr(flags, " hg"));
    free(x);
}
