/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "capture.h"
#include "facts.h"

static int is_zero(const void *p, size_t bytes)
{
    const char *const c = p;

    for (size_t i = 0; i < bytes; i++)
        if (c[i] != 0) return 0;
    return 1;
}

struct thing {
    double a[9];
    int *list;
};

FACT(an_owner_and_its_arrays_are_zero_and_aligned_also_those_of_no_entry)
{
    struct thing *const t = owner_create(sizeof *t);

    ck_assert(is_zero(t, sizeof *t) && (uintptr_t)t % 64 == 0);
    for (int n = 0; n < 3; n++) {
        double *const x = owner_doubles(t, n);
        ck_assert(is_zero(x, (size_t)n * sizeof *x) && (uintptr_t)x % 64 == 0);
    }
    owner_free(t);
}

/* More than the list of an owner has room for at first, and an owner within
 * another; a sanitizer sees what is not freed. */
FACT(arrays_of_an_owner_stay_until_it_is_freed)
{
    enum { N = 200 };
    struct thing *const t = owner_create(sizeof *t);
    int *x[N];

    for (int k = 0; k < N; k++) {
        x[k] = owner_ints(t, 1);
        *x[k] = k;
    }
    for (int k = 0; k < N; k++)
        ck_assert_int_eq(*x[k], k);
    owner_free(t);
    owner_free(NULL);
}

/* Each owner takes tens of megabytes, itself, from elsewhere or by a part of
 * it, all together more than the most that one may: what is not released adds
 * up. */
FACT(arrays_and_parts_are_released_with_their_owner)
{
    enum { N = 1 << 22, TIMES = 10 };
    double first = 0.0;

    for (int k = 0; k < TIMES; k++) {
        struct thing *const t = owner_create(sizeof *t);
        void *const part = owner_join(t, owner_create(sizeof *t));
        if (k % 3 == 0)
            owner_doubles(t, N);
        else if (k % 3 == 1)
            owner_take(t, alloc_doubles(N));
        else
            owner_doubles(part, N);
        owner_free(t);
        if (k == 0) first = alloc_peak();
    }
#ifndef __SANITIZE_ADDRESS__ /* which keeps what is freed */
    ck_assert_double_lt(alloc_peak() - first, N * sizeof(double));
#endif
    ck_assert_double_gt(first, N * sizeof(double));
}

FACT(a_negative_number_of_entries_ends_the_program_with_code_4)
{
    char said[CAPTURE_TEXT];
    void *const owner = owner_create(8);
    struct capture capture = capture_begin(2);
    const pid_t child = fork();
    int status = 0;

    if (child == 0) owner_doubles(owner, -1);
    if (child == 0) _exit(0);
    waitpid(child, &status, 0);
    capture_end(&capture, said);
    owner_free(owner);
    ck_assert(WIFEXITED(status) && WEXITSTATUS(status) == 4);
    ck_assert_ptr_nonnull(strstr(said, "an array of more than"));
}

FACT(a_list_with_room_keeps_its_entries)
{
    int room = 0, *list = NULL;

    for (int n = 0; n < 1000; n++) {
        list = alloc_room(list, n, &room, sizeof *list);
        ck_assert_int_gt(room, n);
        list[n] = n;
    }
    for (int n = 0; n < 1000; n++)
        ck_assert_int_eq(list[n], n);
    free(list);
}
