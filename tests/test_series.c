/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/series.h"
#include "facts.h"
#include "kept.h"
#include "scratch.h"

FACTS_IN_A_FOLDER;

#define HEAD                                                                   \
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "                   \
    "version=\"1.0\">\n<Collection>\n"
#define TAIL "</Collection>\n</VTKFile>\n"

FACT(a_collection_lists_each_file_with_its_time)
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

/* Paths are as the folder has them, but the collection names them as XML. */
FACT(names_are_escaped)
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
}

/* The collection on the disk is cut as well. */
FACT(a_resumed_series_has_the_files_of_its_state)
{
    struct kept *const kept = kept_create();
    struct series *s = series_create(dir, "fluid", "vtr");

    for (int i = 0; i < 2; i++) {
        scratch_write(series_next(s), "");
        ck_assert_int_eq(series_add(s, i * 0.1), 0);
    }
    series_state(s, &kept->state);
    char *const was = scratch_read(scratch_path(dir, "fluid.pvd"), NULL);
    ck_assert_int_eq(series_add(s, 0.2), 0);
    series_free(s);
    s = series_create(dir, "fluid", "vtr");
    series_state(s, kept_load(kept));
    ck_assert_int_eq(kept->state.failed, 0);
    ck_assert_int_eq(series_count(s), 2);
    ck_assert_str_eq(series_next(s),
                     scratch_path(dir, "fluid/fluid_000002.vtr"));
    scratch_assert_text(scratch_path(dir, "fluid.pvd"), was);
    series_free(s);
    kept_free(kept);
    free(was);
}

FACT(a_series_that_has_lost_a_file_is_not_resumed)
{
    struct kept *const kept = kept_create();
    struct series *const s = series_create(dir, "fluid", "vtr");

    scratch_listen(dir);
    ck_assert_int_eq(series_add(s, 0.0), 0);
    series_state(s, &kept->state);
    series_state(s, kept_load(kept));
    ck_assert_int_eq(kept->state.failed, 1);
    char *const said = scratch_heard(dir);
    ck_assert_ptr_nonnull(strstr(said, "fluid_000000.vtr, which "));
    free(said);
    series_free(s);
    kept_free(kept);
}

FACT(a_folder_that_cannot_be_made_is_reported)
{
    scratch_listen(dir);
    scratch_write(scratch_path(dir, "fluid"), "a file");
    ck_assert_ptr_null(series_create(dir, "fluid", "vtr"));
    series_free(NULL);
}
