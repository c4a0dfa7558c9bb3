/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/standing.h"

#include "case/case_file.h"
#include "case/override.h"
#include "case/schema_check.h"
#include "case/source.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_number(const config_setting_t *s)
{
    const int type = config_setting_type(s);

    return type == CONFIG_TYPE_INT || type == CONFIG_TYPE_INT64 ||
           type == CONFIG_TYPE_FLOAT;
}

static double number(const config_setting_t *s)
{
    return config_setting_type(s) == CONFIG_TYPE_FLOAT
               ? config_setting_get_float(s)
               : (double)config_setting_get_int64(s);
}

static int are_equal(const config_setting_t *a, const config_setting_t *b);

/* Groups are equal in any order, lists in theirs. */
static int have_equal_parts(const config_setting_t *a,
                            const config_setting_t *b)
{
    const int n = config_setting_length(a);
    int equal = config_setting_length(b) == n;

    for (int i = 0; i < n && equal; i++) {
        const config_setting_t *const one =
            config_setting_get_elem(a, (unsigned)i);
        const config_setting_t *const other =
            config_setting_is_group(b)
                ? config_setting_get_member(b, config_setting_name(one))
                : config_setting_get_elem(b, (unsigned)i);
        equal = other != NULL && are_equal(one, other);
    }
    return equal;
}

static int are_equal(const config_setting_t *a, const config_setting_t *b)
{
    if (is_number(a) && is_number(b)) return number(a) == number(b);
    if (config_setting_type(a) != config_setting_type(b)) return 0;
    if (config_setting_is_aggregate(a)) return have_equal_parts(a, b);
    if (config_setting_type(a) == CONFIG_TYPE_BOOL)
        return config_setting_get_bool(a) == config_setting_get_bool(b);
    return strcmp(config_setting_get_string(a), config_setting_get_string(b)) ==
           0;
}

/* The case with what a variant sets, or only with what all set; its defaults
 * filled in. */
static void read_tree(config_t *tree, const char *file, int n,
                      char *const *overrides)
{
    const struct key *tables[CASE_FILE_TABLES];

    source_read(tree, file);
    for (int i = 0; i < n; i++)
        override_apply(tree, overrides[i]);
    case_file_tables(tables);
    schema_check_fill(tree, tables);
}

/* Moves what all runs have to the front; returns how many these are. */
static int common_first(const struct choices *c, char **overrides)
{
    int at = 0, common = 0;

    for (int i = 0; i < c->n; i++)
        for (int k = 0; k < c->of[i].n_keys; k++, at++)
            if (c->of[i].n == 1) {
                char *const text = overrides[at];
                overrides[at] = overrides[common];
                overrides[common++] = text;
            }
    return common;
}

static int is_standing(const char *case_file, const struct choices *c, int v)
{
    config_t own, with;
    int n;
    char **const overrides = choices_overrides(c, v, &n);
    const int common = common_first(c, overrides);

    read_tree(&own, case_file, common, overrides);
    read_tree(&with, case_file, n, overrides);
    const int equal =
        are_equal(config_root_setting(&own), config_root_setting(&with));
    config_destroy(&own);
    config_destroy(&with);
    for (int i = 0; i < n; i++)
        free(overrides[i]);
    free(overrides);
    return equal;
}

int standing_variant(const char *case_file, const struct choices *c)
{
    for (int v = 0; v < choices_variants(c); v++)
        if (is_standing(case_file, c, v)) return v;
    return -1;
}
