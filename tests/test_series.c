/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/series.h"
#include "facts.h"
#include "scratch.h"

#include "base/number.h"

static char dir[64];

static void set_up(void)
{
    scratch_make(dir);
}

static void tear_down(void)
{
    scratch_clear(dir);
}

#define HEAD                                                                   \
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "                   \
    "version=\"1.0\">\n<Collection>\n"
#define TAIL "</Collection>\n</VTKFile>\n"

START_TEST(a_collection_lists_each_file_with_its_time)
{
    struct series *const s = series_create(dir, "fluid", "vtr");

    ck_assert_ptr_nonnull(s);
    ck_assert(!scratch_exists(scratch_path(dir, "fluid.pvd")));
    ck_assert_str_eq(series_next(s),
                     scratch_path(dir, "fluid/fluid_000000.vtr"));
    ck_assert_int_eq(series_add(s, 0.0), 0);
    ck_assert_str_eq(series_next(s),
                     scratch_path(dir, "fluid/fluid_000001.vtr"));
    ck_assert_int_eq(series_add(s, 0.1), 0);
    ck_assert_int_eq(series_count(s), 2);
    scratch_assert_text(scratch_path(dir, "fluid.pvd"),
                        HEAD "<DataSet timestep=\"0\" part=\"0\" "
                             "file=\"fluid/fluid_000000.vtr\"/>\n"
                             "<DataSet timestep=\"0.1\" part=\"0\" "
                             "file=\"fluid/fluid_000001.vtr\"/>\n" TAIL);
    ck_assert(!scratch_exists(scratch_path(dir, "fluid.pvd.partial")));
    series_free(s);
}
END_TEST

/* Paths are as the folder has them, but the collection names them as XML. */
START_TEST(names_are_escaped_and_read_back)
{
    struct series *s = series_create(dir, "a&b <\"c\">", "vtp");

    ck_assert_str_eq(series_next(s),
                     scratch_path(dir, "a&b <\"c\">/a&b <\"c\">_000000.vtp"));
    ck_assert_int_eq(series_add(s, 1.0), 0);
    scratch_assert_text(scratch_path(dir, "a&b <\"c\">.pvd"), HEAD
                        "<DataSet timestep=\"1\" part=\"0\" "
                        "file=\"a&amp;b &lt;&quot;c&quot;&gt;/"
                        "a&amp;b &lt;&quot;c&quot;&gt;_000000.vtp\"/>\n" TAIL);
    series_free(s);
    s = series_create(dir, "a&b <\"c\">", "vtp");
    ck_assert_int_eq(series_resume(s, 2.0), 0);
    ck_assert_int_eq(series_count(s), 1);
    series_free(s);
}
END_TEST

/* The times are compared bit for bit, so what was written at the very time of
 * the restart is written again: 7 * 0.1 is not 0.7. */
START_TEST(a_restart_drops_what_is_at_its_time_or_later)
{
    struct series *s = series_create(dir, "fluid", "vtr");
    char text[NUMBER_LENGTH], line[128];

    for (int i = 0; i < 70; i++)
        ck_assert_int_eq(series_add(s, i * 0.1), 0);
    series_free(s);
    s = series_create(dir, "fluid", "vtr");
    ck_assert_int_eq(series_resume(s, 7 * 0.1), 0);
    ck_assert_int_eq(series_count(s), 7);
    ck_assert_str_eq(series_next(s),
                     scratch_path(dir, "fluid/fluid_000007.vtr"));
    ck_assert_int_eq(series_add(s, 7 * 0.1), 0);
    series_free(s);

    char *const pvd = scratch_read(scratch_path(dir, "fluid.pvd"), NULL);
    const char *at = pvd;
    for (int i = 0; i < 8; i++) {
        snprintf(line, sizeof line, "<DataSet timestep=\"%s\" ",
                 number_text(i * 0.1, text));
        at = strstr(at, line);
        ck_assert_ptr_nonnull(at);
    }
    ck_assert_ptr_null(strstr(at + 1, "<DataSet"));
    free(pvd);
}
END_TEST

START_TEST(a_restart_refuses_a_missing_or_foreign_collection)
{
    struct series *const s = series_create(dir, "fluid", "vtr");

    scratch_listen(dir);
    ck_assert_int_ne(series_resume(s, 1.0), 0);
    scratch_write(scratch_path(dir, "fluid.pvd"),
                  HEAD "<DataSet timestep=\"0\" file=\"other.vtu\"/>\n" TAIL);
    ck_assert_int_ne(series_resume(s, 1.0), 0);
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "fluid.pvd: No such file"));
    ck_assert_ptr_nonnull(strstr(said, "fluid.pvd:4: "));
    free(said);
    series_free(s);
}
END_TEST

START_TEST(a_folder_that_cannot_be_made_is_reported)
{
    scratch_listen(dir);
    scratch_write(scratch_path(dir, "fluid"), "a file");
    ck_assert_ptr_null(series_create(dir, "fluid", "vtr"));
    series_free(NULL);
}
END_TEST

FACTS("series")
{
    tcase_add_checked_fixture(facts, set_up, tear_down);
    FACT(a_collection_lists_each_file_with_its_time);
    FACT(names_are_escaped_and_read_back);
    FACT(a_restart_drops_what_is_at_its_time_or_later);
    FACT(a_restart_refuses_a_missing_or_foreign_collection);
    FACT(a_folder_that_cannot_be_made_is_reported);
}
