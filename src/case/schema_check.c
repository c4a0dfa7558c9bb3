/* SPDX-License-Identifier: GPL-3.0-or-later */
/* schema_check.c -- checks a tree against the tables of keys. */
#include "case/schema.h"

#include "case/models.h"
#include "base/text.h"
#include "case/source.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MAX_PATCH_KEYS = 8 };

static int schema_check_is_real(const struct key *key,
                                const config_setting_t *s)
{
    return config_setting_is_number(s) && isfinite(source_number(s)) &&
           schema_allow_number(key, source_number(s));
}

static int is_count(const struct key *key, const config_setting_t *s)
{
    return config_setting_type(s) == CONFIG_TYPE_INT &&
           schema_allow_number(key, source_number(s));
}

static int is_flag(const struct key *key, const config_setting_t *s)
{
    (void)key;
    return config_setting_type(s) == CONFIG_TYPE_BOOL;
}

static int is_word(const struct key *key, const config_setting_t *s)
{
    return config_setting_type(s) == CONFIG_TYPE_STRING &&
           schema_allow_word(key, config_setting_get_string(s));
}

static int is_triple(const struct key *key, const config_setting_t *s,
                     int (*is)(const struct key *, const config_setting_t *))
{
    if ((!config_setting_is_array(s) && !config_setting_is_list(s)) ||
        config_setting_length(s) != 3)
        return 0;
    for (unsigned i = 0; i < 3; i++)
        if (!is(key, config_setting_get_elem(s, i))) return 0;
    return 1;
}

/* ((t, value), ...) with t rising; the condition is on the values. */
static int is_series(const struct key *key, const config_setting_t *s)
{
    double last = -INFINITY;

    if (!config_setting_is_list(s) || config_setting_length(s) == 0)
        return schema_check_is_real(key, s);
    for (int i = 0; i < config_setting_length(s); i++) {
        const config_setting_t *const point = source_element(s, i);
        const config_setting_t *time;

        if (config_setting_is_scalar(point) ||
            config_setting_length(point) != 2)
            return 0;
        time = config_setting_get_elem(point, 0);
        if (!config_setting_is_number(time) || !isfinite(source_number(time)) ||
            source_number(time) <= last ||
            !schema_check_is_real(key, config_setting_get_elem(point, 1)))
            return 0;
        last = source_number(time);
    }
    return 1;
}

/* A word, or a group with the first key of one model of a patch and with other
 * keys of that model. */
static int schema_check_is_patch(const struct key *key,
                                 const config_setting_t *s)
{
    const char *name[MAX_PATCH_KEYS];
    const int n = config_setting_is_group(s) ? config_setting_length(s) : 0;

    if (!config_setting_is_group(s)) return is_word(key, s);
    for (int i = 0; i < n && i < MAX_PATCH_KEYS; i++)
        name[i] = config_setting_name(source_element(s, i));
    return n <= MAX_PATCH_KEYS && models_make_patch(n, name);
}

static int fits(const struct key *key, const config_setting_t *s)
{
    switch (key->type) {
    case KEY_GROUP:
        return config_setting_is_group(s);
    case KEY_LIST:
        return config_setting_is_list(s);
    case KEY_REAL:
        return schema_check_is_real(key, s) || is_word(key, s);
    case KEY_INT:
        return is_count(key, s) || is_word(key, s);
    case KEY_BOOL:
        return is_flag(key, s);
    case KEY_NAME:
        return is_word(key, s);
    case KEY_TEXT:
        return config_setting_type(s) == CONFIG_TYPE_STRING;
    case KEY_FILE:
        return config_setting_type(s) == CONFIG_TYPE_STRING &&
               config_setting_get_string(s)[0] != '\0';
    case KEY_VECTOR:
        return is_triple(key, s, schema_check_is_real);
    case KEY_COUNTS:
        return is_triple(key, s, is_count);
    case KEY_FLAGS:
        return is_triple(key, s, is_flag);
    case KEY_SERIES:
        return is_series(key, s);
    case KEY_CURVE:
        return config_setting_is_list(s) && is_series(key, s);
    case KEY_PATCH:
        return schema_check_is_patch(key, s);
    }
    return 0;
}

/* 1 for a whole number, or one of three, that is written as a real one. */
static int is_count_as_real(const struct key *key, const config_setting_t *s)
{
    if (key->type == KEY_COUNTS)
        for (int i = 0; i < config_setting_length(s); i++)
            if (config_setting_type(source_element(s, i)) == CONFIG_TYPE_FLOAT)
                return 1;
    return key->type == KEY_INT && config_setting_type(s) == CONFIG_TYPE_FLOAT;
}

static int report_misfit(const struct key *key, const char *path,
                         const config_setting_t *s)
{
    char expected[SCHEMA_TEXT], found[SOURCE_TEXT], nearest[SCHEMA_TEXT];
    const int is_text = config_setting_type(s) == CONFIG_TYPE_STRING;

    schema_expected(key, expected);
    source_value(s, found);
    if (is_count_as_real(key, s))
        return source_wrong(s,
                            "%s: expected %s, at most %d and without point or "
                            "exponent, found %s",
                            path, expected, INT_MAX, found);
    if (is_text &&
        schema_nearest_word(key, config_setting_get_string(s), nearest))
        return source_wrong(s, "%s: expected %s, found %s; did you mean %s?",
                            path, expected, found, nearest);
    return source_wrong(s, "%s: expected %s, found %s", path, expected, found);
}

static int schema_check_report_unknown(const struct key *const *tables,
                                       const char *path,
                                       const config_setting_t *s)
{
    char nearest[SCHEMA_TEXT], expected[SCHEMA_TEXT];
    const struct key *const key = schema_nearest(tables, path, nearest);
    const char *const dot = strrchr(path, '.');

    if (key == NULL)
        return source_wrong(s, "%s: no such key; see winnow list keys%s%.*s",
                            path, dot != NULL ? " " : "",
                            dot != NULL ? (int)(dot - path) : 0, path);
    schema_expected(key, expected);
    return source_wrong(s, "%s: no such key; did you mean %s, %s?", path,
                        nearest, expected);
}

/* --- magnitudes ----------------------------------------------------------- */

/* Which magnitudes a number can have, by its unit [unit], unless it is 0. One
 * that no physical quantity of its unit has is a slip, or it would overflow
 * where it is squared: a diameter of 1e-300 m has no volume. */
struct unit_range {
    const char *unit;
    double least, most;
};

/* The last row is that of all other units. */
static const struct unit_range ranges[] = {
    {"m", 1e-12, 1e12},      /* a hundredth of an atom, the orbit of Saturn */
    {"m/s", 1e-20, 3e8},     /* an atom in a century, light */
    {"kg/m^3", 1e-12, 1e20}, /* the best vacuum, more than a nucleus */
    {"s", 1e-20, HUGE_VAL},  /* light through an atom; the steps are counted */
    {"", 1e-30, 1e30}};
enum { RANGES = sizeof ranges / sizeof *ranges };

static const struct unit_range *unit_range_of(const char *unit)
{
    int i = 0;

    while (i < RANGES - 1 && strcmp(ranges[i].unit, unit) != 0)
        i++;
    return &ranges[i];
}

static int unit_range_holds(const struct unit_range *r, double x)
{
    return x == 0.0 || (fabs(x) >= r->least && fabs(x) <= r->most);
}

/* A component of a point or of a direction may be a 0 with a rounding error. */
static int may_be_tiny(const struct key *key)
{
    return key->type == KEY_VECTOR && strchr(key->allowed, '>') == NULL;
}

/* The first number in s whose magnitude the unit of its key cannot have; 0 if
 * there is none. The times of a series may be any. */
static double extreme(const struct key *key, const config_setting_t *s)
{
    const int whole = key->type == KEY_INT || key->type == KEY_COUNTS;
    const struct unit_range *const r = unit_range_of(key->unit);
    const int n = config_setting_is_array(s) || config_setting_is_list(s)
                      ? config_setting_length(s)
                      : 0;
    double x = 0.0;

    if (config_setting_is_number(s) && !whole &&
        !unit_range_holds(r, source_number(s)) &&
        !(may_be_tiny(key) && fabs(source_number(s)) < r->least))
        return source_number(s);
    for (int i = key->type == KEY_SERIES && n == 2 &&
                 config_setting_is_number(config_setting_get_elem(s, 0));
         i < n && x == 0.0; i++)
        x = extreme(key, source_element(s, i));
    return x;
}

/* 0, or 2 after a message: a number that its unit cannot have. */
static int unit_range_check(const struct key *key, const char *path,
                            const config_setting_t *s)
{
    const struct unit_range *const r = unit_range_of(key->unit);
    const double x = extreme(key, s);

    if (x == 0.0) return 0;
    return source_wrong(
        s, "%s: expected 0 or a magnitude between %g and %g [%s], found %g",
        path, r->least, r->most, key->unit, x);
}

/* --- the tree ------------------------------------------------------------- */

/* 2 after a message for the first required key that the group leaves out. */
static int check_required(const struct key *const *tables, const char *path,
                          const config_setting_t *group)
{
    char expected[SCHEMA_TEXT];

    SCHEMA_EACH (k, tables) {
        const char *const name = schema_member(k, path);

        if (name == NULL || k->fallback != NULL ||
            config_setting_get_member(group, name) != NULL)
            continue;
        schema_expected(k, expected);
        return source_wrong(group, "%s is missing: expected %s, %s", k->path,
                            expected, k->what);
    }
    return 0;
}

/* 1 if the case has one of the groups "a|b". */
static int has_one_of(const config_setting_t *s, char *groups)
{
    int found = 0;

    for (char *bar; !found && groups != NULL; groups = bar) {
        bar = strchr(groups, '|');
        if (bar != NULL) *bar++ = '\0';
        found = config_lookup(s->config, groups) != NULL;
    }
    return found;
}

/* 2 after a message for the first group that a row needs and the case does not
 * have, or that the row excludes, as "!group", and the case has. */
static int check_needs(const struct key *key, const config_setting_t *s)
{
    const char *rest = key->needs;
    char group[SCHEMA_TEXT];
    int used;

    for (; sscanf(rest, "%255s%n", group, &used) == 1; rest += used)
        if (group[0] == '!') {
            if (has_one_of(s, group + 1))
                return source_wrong(s,
                                    "%s takes the place of %s: leave one out",
                                    key->path, group + 1);
        } else if (!has_one_of(s, group)) /* which leaves the first of them */
            return source_wrong(s, "%s needs %s, which the case does not have",
                                key->path, group);
    return 0;
}

static int check_group(const struct key *const *tables, const char *path,
                       const config_setting_t *group);

static int check_setting(const struct key *const *tables, const char *path,
                         const config_setting_t *s)
{
    const struct key *const key = schema_find(tables, path);
    int code = 0;

    if (key == NULL) return schema_check_report_unknown(tables, path, s);
    /* The keys of the group of a patch are checked before the group. */
    const int is_patch_group =
        key->type == KEY_PATCH && config_setting_is_group(s);
    if (!is_patch_group && !fits(key, s)) return report_misfit(key, path, s);
    if ((code = check_needs(key, s)) != 0) return code;
    if (key->type != KEY_LIST) code = unit_range_check(key, path, s);
    if (code != 0) return code;
    if (config_setting_is_group(s)) code = check_group(tables, path, s);
    if (is_patch_group && code == 0 && !fits(key, s))
        return report_misfit(key, path, s);
    if (key->type == KEY_LIST)
        for (int i = 0; i < config_setting_length(s) && code == 0; i++) {
            const config_setting_t *const one = source_element(s, i);
            code = config_setting_is_group(one) ? check_group(tables, path, one)
                                                : report_misfit(key, path, one);
        }
    return code;
}

static int check_group(const struct key *const *tables, const char *path,
                       const config_setting_t *group)
{
    char child[SCHEMA_TEXT];
    int code = 0;

    for (int i = 0; i < config_setting_length(group) && code == 0; i++) {
        const config_setting_t *const s = source_element(group, i);
        source_path(child, path, s);
        code = check_setting(tables, child, s);
    }
    return code != 0 ? code : check_required(tables, path, group);
}

static int check_texts(const char *path, const config_setting_t *s)
{
    const char *const text = config_setting_get_string(s);
    char child[SCHEMA_TEXT];
    int code = 0;

    if (text != NULL && text_control(text) != NULL)
        return source_wrong(s,
                            "%s: expected a text of one line, found the "
                            "control character %d in it",
                            path, (unsigned char)*text_control(text));
    for (int i = 0; i < config_setting_length(s) && code == 0; i++) {
        const config_setting_t *const one = source_element(s, i);
        source_path(child, path, one);
        code = check_texts(child, one);
    }
    return code;
}

int schema_check_texts(const config_t *tree)
{
    return check_texts("", config_root_setting(tree));
}

int schema_check_check(config_t *tree, const struct key *const *tables)
{
    return check_group(tables, "", config_root_setting(tree));
}

static void fill_group(const struct key *const *tables, const char *path,
                       config_setting_t *group)
{
    SCHEMA_EACH (k, tables) {
        const char *const name = schema_member(k, path);
        char value[SCHEMA_TEXT];

        if (name == NULL || !schema_has_default(k) ||
            config_setting_get_member(group, name) != NULL)
            continue;
        schema_default(k, value);
        source_add_default(group, name, value);
    }
}

/* Fills the groups of a list, the members of a group, and the group. */
static void schema_check_fill_group(const struct key *const *tables,
                                    const char *path, config_setting_t *s)
{
    char child[SCHEMA_TEXT];

    for (int i = 0; i < config_setting_length(s); i++) {
        config_setting_t *const one = source_element(s, i);

        source_path(child, path, one);
        if (config_setting_is_group(one) || config_setting_is_list(one))
            schema_check_fill_group(tables, child, one);
    }
    if (config_setting_is_group(s)) fill_group(tables, path, s);
}

void schema_check_fill(config_t *tree, const struct key *const *tables)
{
    schema_check_fill_group(tables, "", config_root_setting(tree));
}
