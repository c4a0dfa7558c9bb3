/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/summary.h"
#include "facts.h"
#include "scratch.h"

#include <math.h>

FACTS_IN_A_FOLDER;

FACT(entries_keep_their_order_and_groups)
{
    const char *const path = scratch_path(dir, "summary.json");
    struct summary *const s = summary_create(path);

    summary_text(s, "title", "bed");
    summary_count(s, "steps", 12345678901LL);
    summary_begin(s, "seconds");
    summary_number(s, "cfd", 0.1);
    summary_begin(s, "inner");
    summary_end(s);
    summary_end(s);
    summary_count(s, "done", 1);
    ck_assert(!scratch_exists(path));
    ck_assert_int_eq(summary_commit(s), 0);
    scratch_assert_text(path, "{\n"
                              "  \"title\": \"bed\",\n"
                              "  \"steps\": 12345678901,\n"
                              "  \"seconds\": {\n"
                              "    \"cfd\": 0.1,\n"
                              "    \"inner\": {}\n"
                              "  },\n"
                              "  \"done\": 1\n"
                              "}\n");
}

FACT(what_is_no_number_is_null)
{
    const char *const path = scratch_path(dir, "summary.json");
    struct summary *const s = summary_create(path);

    summary_number(s, "a", NAN);
    summary_number(s, "b", -INFINITY);
    ck_assert_int_eq(summary_commit(s), 0);
    scratch_assert_text(path, "{\n  \"a\": null,\n  \"b\": null\n}\n");
}

/* The last four are no UTF-8: a lone continuation, an overlong slash, a letter
 * cut off by another, and one cut off by the end. */
FACT(text_is_escaped_and_always_utf_8)
{
    const struct {
        const char *given, *written;
    } pair[] = {{"a \"b\" \\ c", "a \\\"b\\\" \\\\ c"},
                {"tab\tline\n\x01", "tab\\u0009line\\u000a\\u0001"},
                {"M\xc3\xbcller \xe2\x86\x92 \xf0\x9f\x8c\xbe",
                 "M\xc3\xbcller \xe2\x86\x92 \xf0\x9f\x8c\xbe"},
                {"M\xfcller", "M\\ufffdller"},
                {"\x80", "\\ufffd"},
                {"\xc0\xaf", "\\ufffd\\ufffd"},
                {"\xe2\x86x", "\\ufffd\\ufffdx"},
                {"\xe2\x86", "\\ufffd\\ufffd"}};
    const char *const path = scratch_path(dir, "summary.json");
    char expected[128];

    for (size_t i = 0; i < sizeof pair / sizeof pair[0]; i++) {
        struct summary *const s = summary_create(path);
        summary_text(s, "k\"", pair[i].given);
        ck_assert_int_eq(summary_commit(s), 0);
        snprintf(expected, sizeof expected, "{\n  \"k\\\"\": \"%s\"\n}\n",
                 pair[i].written);
        scratch_assert_text(path, expected);
    }
}

FACT(a_summary_that_cannot_be_written_is_reported)
{
    scratch_listen(dir);
    struct summary *const s = summary_create(scratch_path(dir, "none/s.json"));

    ck_assert_ptr_null(s);
    summary_begin(s, "a");
    summary_number(s, "b", 1.0);
    summary_count(s, "b", 1);
    summary_text(s, "b", "c");
    summary_end(s);
    ck_assert_int_ne(summary_commit(s), 0);
}
