/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/override.h"

#include "base/alloc.h"
#include "case/text/include.h"
#include "case/scan.h"
#include "case/source.h"

#include <assert.h>
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Copies a value and all below it under a parent. */
static config_setting_t *override_copy(config_setting_t *parent,
                                       const char *name,
                                       const config_setting_t *from)
{
    const int type = config_setting_type(from);
    config_setting_t *const to = config_setting_add(parent, name, type);

    if (to == NULL) return NULL;
    if (type == CONFIG_TYPE_STRING)
        config_setting_set_string(to, config_setting_get_string(from));
    else if (type == CONFIG_TYPE_BOOL)
        config_setting_set_bool(to, config_setting_get_bool(from));
    else if (type == CONFIG_TYPE_FLOAT)
        config_setting_set_float(to, config_setting_get_float(from));
    else if (type == CONFIG_TYPE_INT)
        config_setting_set_int(to, config_setting_get_int(from));
    else if (type == CONFIG_TYPE_INT64)
        config_setting_set_int64(to, config_setting_get_int64(from));
    else
        for (int i = 0; i < config_setting_length(from); i++) {
            const config_setting_t *const one =
                config_setting_get_elem(from, (unsigned)i);
            override_copy(to, config_setting_name(one), one);
        }
    return to;
}

/* 1 for a word that needs no quotes: a name or a path. */
static int is_bare(const char *value)
{
    if (!isalpha((unsigned char)*value) && *value != '.' && *value != '/')
        return 0;
    for (; *value != '\0'; value++)
        if (!isalnum((unsigned char)*value) && strchr("./_-+", *value) == NULL)
            return 0;
    return 1;
}

/* Reads "value = (quote)(text)(quote);" as a file of one setting. */
static int read_quoted(config_t *tree, const char *quote, const char *value)
{
    const size_t size = strlen(value) + 16;
    char *const text = alloc_zeroed(size, 1);
    int good;

    config_init(tree);
    snprintf(text, size, "value = %s%s%s;", quote, value, quote);
    scan_mixed(text);
    good = config_read_string(tree, text) &&
           config_setting_length(config_root_setting(tree)) == 1;
    free(text);
    return good;
}

/* Reads one value as a case would write it, or a bare word as a text, under
 * the name "value". */
static int read_value(config_t *tree, const char *value)
{
    if (read_quoted(tree, "", value)) return 1;
    if (!is_bare(value)) return 0;
    config_destroy(tree);
    return read_quoted(tree, "\"", value);
}

void override_default(config_setting_t *group, const char *name,
                      const char *value)
{
    config_t tree;
    const int good = read_value(&tree, value);
    config_setting_t *const s =
        good ? override_copy(group, name, config_lookup(&tree, "value")) : NULL;

    assert(s != NULL); /* a table of keys holds a default that is none */
    config_setting_set_hook(s, (void *)source_default);
    config_destroy(&tree);
}

static int report_wrong(const char *text, const char *why)
{
    fprintf(stderr, "winnow: option -s %s: %s\n", text, why);
    return 2;
}

/* The member of that name, or the element of that number: digits alone, and no
 * more of them than any list has elements. */
static config_setting_t *override_below(config_setting_t *s, const char *name)
{
    const size_t digits = strspn(name, "0123456789");

    if (config_setting_is_group(s)) return config_setting_get_member(s, name);
    if (config_setting_is_aggregate(s) && digits > 0 && digits < 10 &&
        name[digits] == '\0')
        return config_setting_get_elem(s, (unsigned)atoi(name));
    return NULL;
}

/* Puts the value in the place of an old one. */
static int override_put(config_setting_t *group, const char *name,
                        const char *text, const config_setting_t *value)
{
    config_setting_t *s;

    if (!config_setting_is_group(group))
        return report_wrong(text, "only a key of a group can be set");
    config_setting_remove(group, name);
    s = override_copy(group, name, value);
    if (s == NULL) return report_wrong(text, "not a name that a key can have");
    config_setting_set_hook(s, (void *)text);
    return 0;
}

/* The group of the last name of the path; missing groups are created. NULL if
 * the path leads through something else. */
static config_setting_t *group_of(config_t *tree, const char *text, char *path,
                                  char **last)
{
    config_setting_t *at = config_root_setting(tree);

    *last = path;
    for (char *dot; (dot = strchr(*last, '.')) != NULL; *last = dot + 1) {
        config_setting_t *next;

        *dot = '\0';
        next = override_below(at, *last);
        if (next == NULL && config_setting_is_group(at)) {
            next = config_setting_add(at, *last, CONFIG_TYPE_GROUP);
            if (next != NULL) config_setting_set_hook(next, (void *)text);
        }
        if (next == NULL || config_setting_is_scalar(next)) return NULL;
        at = next;
    }
    return at;
}

/* Sets the last name of the path to what stands after the equal sign. */
static int override_set(config_setting_t *group, const char *name,
                        const char *text, const char *value)
{
    const char *const wrong = include_check_value(value);
    config_t tree;
    int code;

    if (wrong != NULL) return report_wrong(text, wrong);
    if (read_value(&tree, value))
        code = override_put(group, name, text, config_lookup(&tree, "value"));
    else
        code = report_wrong(
            text, "the text after = is not one value of a case file; quote "
                  "a text with blanks");
    config_destroy(&tree);
    return code;
}

int override_apply(config_t *tree, const char *text)
{
    const char *const equal = strchr(text, '=');
    config_setting_t *group;
    char *path, *last;
    int code;

    if (equal == NULL || equal == text)
        return report_wrong(text, "expected path.to.key=value");
    path = strndup(text, (size_t)(equal - text));
    group = group_of(tree, text, path, &last);
    code =
        group != NULL
            ? override_set(group, last, text, equal + 1)
            : report_wrong(
                  text, "a part of the path does not exist or is not a group");
    free(path);
    return code;
}
