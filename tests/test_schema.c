/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/source.h"
#include "case/schema.h"
#include "case/case_file.h"
#include "facts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct key table[] = {
    {"poisson", KEY_REAL, "-", ">= 0, <= 0.5", NULL, "ratio", "", ""},
    {"skin", KEY_REAL, "m", "auto | > 0", "auto", "margin", "", ""},
    {"law", KEY_NAME, "", "linear | hertz", NULL, "law", "", ""},
    {"fluid.<patch>", KEY_PATCH, "", "no-slip | slip", "", "side", "", ""},
    {"fluid.<patch>.inlet", KEY_SERIES, "m/s", ">= 0", "", "in", "", ""},
    KEY_END};

static const struct key *const tables[] = {table, NULL};

FACT(conditions_on_a_number_hold_all)
{
    ck_assert(schema_allow_number(&table[0], 0.0));
    ck_assert(schema_allow_number(&table[0], 0.5));
    ck_assert(!schema_allow_number(&table[0], -1e-300));
    ck_assert(!schema_allow_number(&table[0], 0.5000001));
    ck_assert(schema_allow_number(&table[1], 1e-300));
    ck_assert(!schema_allow_number(&table[1], 0.0));
}

FACT(words_are_whole_words)
{
    ck_assert(schema_allow_word(&table[2], "hertz"));
    ck_assert(schema_allow_word(&table[2], "linear"));
    ck_assert(!schema_allow_word(&table[2], "line"));
    ck_assert(!schema_allow_word(&table[2], ""));
    ck_assert(!schema_allow_word(&table[2], "linear | hertz"));
    ck_assert(schema_allow_word(&table[1], "auto"));
    ck_assert(!schema_allow_word(&table[1], "> 0"));
}

FACT(each_side_of_the_box_matches_the_row_of_sides)
{
    for (int i = 0; schema_patches[i] != NULL; i++) {
        char path[64];

        snprintf(path, sizeof path, "fluid.%s.inlet", schema_patches[i]);
        ck_assert_ptr_eq(schema_find(tables, path), &table[4]);
    }
    ck_assert_ptr_null(schema_find(tables, "fluid.middle"));
    ck_assert_ptr_null(schema_find(tables, "fluid.leftover"));
    ck_assert_ptr_null(schema_find(tables, "fluid.lef"));
    ck_assert_ptr_null(schema_find(tables, "fluid."));
    ck_assert_ptr_null(schema_find(tables, "fluid.<patch>"));
    ck_assert_ptr_null(schema_find(tables, "flu"));
}

FACT(expectation_names_kind_condition_and_unit)
{
    char text[SCHEMA_TEXT];

    schema_expected(&table[1], text);
    ck_assert_str_eq(text, "a number > 0 [m] or auto");
    schema_expected(&table[2], text);
    ck_assert_str_eq(text, "linear or hertz");
}

/* Whatever group an unknown key stands in, the key that is proposed has a row:
 * the last name of every row of the program, at the root, under another group
 * and in a group that is not there. */
FACT(every_key_that_is_proposed_for_an_unknown_one_exists)
{
    static const char *const groups[] = {"", "fluid.", "output.", "nothing."};
    const struct key *all[CASE_FILE_TABLES];

    case_file_tables(all);
    SCHEMA_EACH (k, all)
        for (int g = 0; g < 4; g++) {
            const char *const last = strrchr(k->path, '.');
            char path[2 * SCHEMA_TEXT], nearest[SCHEMA_TEXT];
            snprintf(path, sizeof path, "%s%s", groups[g],
                     last == NULL ? k->path : last + 1);
            const struct key *const row = schema_nearest(all, path, nearest);
            ck_assert_msg(row != NULL, "%s", path);
            ck_assert_ptr_eq(schema_find(all, nearest), row);
        }
}

/* Every row of the program itself: complete, in a group that has a row, its
 * default allowed by itself. */
FACT(every_row_of_the_tables_is_complete)
{
    const struct key *all[CASE_FILE_TABLES];

    case_file_tables(all);
    SCHEMA_EACH (k, all) {
        const char *const dot = strrchr(k->path, '.');
        char group[SCHEMA_TEXT];

        ck_assert_msg(k->unit != NULL && k->allowed != NULL &&
                          k->source != NULL && k->needs != NULL &&
                          k->what != NULL && k->what[0] != '\0',
                      "%s", k->path);
        if (k->type == KEY_REAL || k->type == KEY_INT ||
            k->type == KEY_VECTOR || k->type == KEY_SERIES)
            ck_assert_msg(k->unit[0] != '\0', "%s has no unit", k->path);
        if (k->type == KEY_NAME && schema_has_default(k)) {
            char value[SCHEMA_TEXT];
            schema_default(k, value);
            ck_assert_msg(schema_allow_word(k, value), "%s", k->path);
        }
        if (dot == NULL) continue;
        snprintf(group, sizeof group, "%.*s", (int)(dot - k->path), k->path);
        if (strstr(group, "<patch>") == NULL)
            ck_assert_msg(schema_find(all, group) != NULL, "%s", k->path);
    }
}

/* What fills a member is of its type, and no key is read into nothing: but for
 * those of effects, which become numbers in the order of their rows, and for a
 * side, which is a condition. */
FACT(every_key_has_a_member_of_its_type)
{
    static const char *const fits[KEY_PATCH + 1] = {
        [KEY_REAL] = "d",   [KEY_INT] = "i",   [KEY_BOOL] = "i",
        [KEY_TEXT] = "t",   [KEY_FILE] = "t",  [KEY_VECTOR] = "v",
        [KEY_COUNTS] = "n", [KEY_FLAGS] = "n", [KEY_SERIES] = "s",
        [KEY_CURVE] = "s"};
    const struct key *all[CASE_FILE_TABLES];

    case_file_tables(all);
    SCHEMA_EACH (k, all) {
        const int simple =
            k->type != KEY_GROUP && k->type != KEY_LIST && k->type != KEY_PATCH;
        const char *const own = strstr(k->path, "effects.");
        const char *const fit = k->type != KEY_NAME  ? fits[k->type]
                                : k->models != NULL  ? "o"
                                : k->choices != NULL ? "i"
                                                     : "t";
        if (simple && k->at > 0)
            ck_assert_msg(k->member == fit[0], "%s: member of kind %c", k->path,
                          k->member);
        ck_assert_msg(!simple || k->at > 0 || own != NULL, "%s", k->path);
    }
}

FACT(numbers_too_large_for_an_int_are_found_outside_strings_only)
{
    const char *const text = "# 99999999999\n/* 99999999999\n */ a = "
                             "\"99999999999\"; // 99999999999\n"
                             "q = \"a \\\" 99999999999\";"
                             "b = 99999999999.0; c = 9e99; x99999999999 = 1;\n"
                             "d = 2147483647;\ne = -2147483648;";
    int line;
    const char *const found = scan_digits(text, &line);

    ck_assert_ptr_nonnull(found);
    ck_assert_int_eq(strncmp(found, "2147483648", 10), 0);
    ck_assert_int_eq(line, 6);
    ck_assert_ptr_null(scan_digits("\"unfinished", &line));
    ck_assert_ptr_null(scan_digits("/* unfinished", &line));
    ck_assert_ptr_null(scan_digits("\"ends in \\", &line));
}
