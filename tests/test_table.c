/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/table.h"
#include "facts.h"
#include "kept.h"
#include "scratch.h"

#include <math.h>
#include <signal.h>
#include <sys/resource.h>

FACTS_IN_A_FOLDER;

static const char *const names[2] = {"time [s]", "pressure_drop [Pa]"};

static const char *history(void)
{
    return scratch_path(dir, "history.csv");
}

FACT(the_first_line_names_columns_with_units)
{
    struct table *const t = table_create(history(), 2, names);

    scratch_assert_text(history(), "time [s],pressure_drop [Pa]\n");
    table_free(t);
}

FACT(each_row_is_in_the_file_at_once)
{
    struct table *const t = table_create(history(), 2, names);

    ck_assert_int_eq(table_add(t, (double[2]){0.1, -1e-300}), 0);
    scratch_assert_text(history(),
                        "time [s],pressure_drop [Pa]\n0.1,-1e-300\n");
    ck_assert_int_eq(table_add(t, (double[2]){0.2, NAN}), 0);
    scratch_assert_text(history(), "time [s],pressure_drop [Pa]\n"
                                   "0.1,-1e-300\n0.2,nan\n");
    table_free(t);
    table_free(NULL);
}

FACT(names_with_commas_and_quotes_are_quoted)
{
    const char *const odd[3] = {"a, b [m]", "the \"c\"", "d"};

    ck_assert_int_eq(
        table_write(history(), 3, odd, 1, (double[3]){1.0, 2.0, 3.0}), 0);
    scratch_assert_text(history(), "\"a, b [m]\",\"the \"\"c\"\"\",d\n1,2,3\n");
}

/* As after a power cut in the middle of a row. */
FACT(a_resumed_table_goes_on_after_the_rows_of_its_state)
{
    struct kept *const kept = kept_create();
    struct table *t = table_create(history(), 2, names);

    ck_assert_int_eq(table_add(t, (double[2]){0.1, 1.0}), 0);
    table_state(t, &kept->state);
    ck_assert_int_eq(table_add(t, (double[2]){0.2, 2.0}), 0);
    table_free(t);
    scratch_write(history(), "time [s],pressure_drop [Pa]\n0.1,1\n0.2,2\n0.3");
    t = table_open(history(), 2, names);
    ck_assert_ptr_nonnull(t);
    table_state(t, kept_load(kept));
    ck_assert_int_eq(kept->state.failed, 0);
    ck_assert_int_eq(table_add(t, (double[2]){0.2, 4.0}), 0);
    table_free(t);
    scratch_assert_text(history(), "time [s],pressure_drop [Pa]\n"
                                   "0.1,1\n0.2,4\n");
    kept_free(kept);
}

FACT(a_table_that_has_lost_rows_is_not_resumed)
{
    struct kept *const kept = kept_create();
    struct table *t = table_create(history(), 2, names);

    scratch_listen(dir);
    ck_assert_int_eq(table_add(t, (double[2]){0.1, 1.0}), 0);
    table_state(t, &kept->state);
    table_free(t);
    scratch_write(history(), "time [s],pressure_drop [Pa]\n");
    t = table_open(history(), 2, names);
    table_state(t, kept_load(kept));
    ck_assert_int_eq(kept->state.failed, 1);
    table_free(t);
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "has only 28 of its 34 bytes"));
    free(said);
    kept_free(kept);
}

FACT(a_restart_refuses_a_missing_file_and_other_columns)
{
    scratch_listen(dir);
    ck_assert_ptr_null(table_open(history(), 2, names));
    scratch_write(history(), "time [s],cfl [-]\n0.1,1\n");
    ck_assert_ptr_null(table_open(history(), 2, names));
    scratch_assert_text(history(), "time [s],cfl [-]\n0.1,1\n");
    ck_assert(!scratch_exists(scratch_path(dir, "history.csv.partial")));
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "cannot read"));
    ck_assert_ptr_nonnull(strstr(said, "other columns"));
    free(said);
}

/* The disk ends within the second row; the first stays the last. */
FACT(a_full_disk_is_reported_and_leaves_whole_rows)
{
    struct rlimit limit, small;

    scratch_listen(dir);
    struct table *const t = table_create(history(), 2, names);
    ck_assert_int_eq(table_add(t, (double[2]){0.1, 1.0}), 0);
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit);
    small = limit;
    small.rlim_cur = 28 + 6 + 3;
    setrlimit(RLIMIT_FSIZE, &small);
    const int failed = table_add(t, (double[2]){0.2, 2.0});
    setrlimit(RLIMIT_FSIZE, &limit);
    ck_assert_int_ne(failed, 0);
    scratch_assert_text(history(), "time [s],pressure_drop [Pa]\n0.1,1\n");
    ck_assert_int_eq(table_add(t, (double[2]){0.3, 3.0}), 0);
    scratch_assert_text(history(),
                        "time [s],pressure_drop [Pa]\n0.1,1\n0.3,3\n");
    table_free(t);
}
