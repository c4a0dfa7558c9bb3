/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/source.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* The hook of a default; the hook of an override is its text. */
static const char default_mark[] = "default";

static int unreadable(const char *file, const char *why)
{
    fprintf(stderr, "winnow: %s: cannot read the case: %s\n", file, why);
    return 4;
}

/* libconfig's own words, and what to do where they are dark. */
static int wrong_syntax(const config_t *tree, const char *file)
{
    const char *const text = config_error_text(tree);
    const char *const in = config_error_file(tree);
    const int mixed = strstr(text, "mismatched element") != NULL;
    const int include = strstr(text, "include file") != NULL;

    fprintf(stderr, "winnow: %s:%d: %s%s\n", in != NULL ? in : file,
            config_error_line(tree), text,
            mixed ? "; write all numbers alike, as in [0.0, -9.81, 0.0]" : "");
    return include ? 4 : 2;
}

int source_read(config_t *tree, const char *file)
{
    const char *const slash = strrchr(file, '/');
    struct stat info;
    FILE *in;

    config_init(tree);
    if (stat(file, &info) != 0) return unreadable(file, strerror(errno));
    if (S_ISDIR(info.st_mode)) /* libconfig's scanner would end the program */
        return unreadable(file, strerror(EISDIR));
    in = fopen(file, "r");
    if (in == NULL) return unreadable(file, strerror(errno));
    fclose(in);

    if (slash != NULL) {
        char *const folder = strdup(file);
        folder[slash - file + (slash == file)] = '\0';
        config_set_include_dir(tree, folder);
        free(folder);
    }
    if (!config_read_file(tree, file)) return wrong_syntax(tree, file);
    return 0;
}

/* Where a setting stands: its override, or its file and line. */
static void place(const config_setting_t *at, char text[SOURCE_TEXT])
{
    const char *file = NULL;

    for (const config_setting_t *s = at; s != NULL; s = s->parent) {
        const char *const hook = config_setting_get_hook(s);
        if (hook != NULL && hook != default_mark) {
            snprintf(text, SOURCE_TEXT, "option -s %s", hook);
            return;
        }
    }
    for (const config_setting_t *s = at; s != NULL && file == NULL;
         s = s->parent)
        file = config_setting_source_file(s);
    if (config_setting_is_root(at) || file == NULL)
        snprintf(text, SOURCE_TEXT, "%s", file != NULL ? file : "the case");
    else
        snprintf(text, SOURCE_TEXT, "%s:%u", file,
                 (unsigned)config_setting_source_line(at));
}

int source_wrong(const config_setting_t *at, const char *format, ...)
{
    char where[SOURCE_TEXT];
    va_list values;

    place(at, where);
    fprintf(stderr, "winnow: %s: ", where);
    va_start(values, format);
    vfprintf(stderr, format, values);
    va_end(values);
    fputc('\n', stderr);
    return 2;
}

void source_value(const config_setting_t *s, char text[SOURCE_TEXT])
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64:
        snprintf(text, SOURCE_TEXT, "%lld", config_setting_get_int64(s));
        break;
    case CONFIG_TYPE_FLOAT:
        snprintf(text, SOURCE_TEXT, "%g", config_setting_get_float(s));
        break;
    case CONFIG_TYPE_STRING:
        snprintf(text, SOURCE_TEXT, "the text \"%.200s\"",
                 config_setting_get_string(s));
        break;
    case CONFIG_TYPE_BOOL:
        snprintf(text, SOURCE_TEXT, "%s",
                 config_setting_get_bool(s) ? "true" : "false");
        break;
    case CONFIG_TYPE_GROUP:
        snprintf(text, SOURCE_TEXT, "a group");
        break;
    default:
        snprintf(text, SOURCE_TEXT, "a list of %d", config_setting_length(s));
    }
}

/* Copies a value and all below it under a parent. */
static config_setting_t *copy(config_setting_t *parent, const char *name,
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
            copy(to, config_setting_name(one), one);
        }
    return to;
}

/* Reads one value as a case would write it, under the name "value". */
static int read_value(config_t *tree, const char *value)
{
    const size_t size = strlen(value) + 16;
    char *const text = malloc(size);
    int good;

    config_init(tree);
    if (text == NULL) return 0;
    snprintf(text, size, "value = %s;", value);
    good = config_read_string(tree, text) &&
           config_setting_length(config_root_setting(tree)) == 1;
    free(text);
    return good;
}

void source_default(config_setting_t *group, const char *name,
                    const char *value)
{
    config_t tree;

    if (read_value(&tree, value)) {
        config_setting_t *const s =
            copy(group, name, config_lookup(&tree, "value"));
        if (s != NULL) config_setting_set_hook(s, (void *)default_mark);
    }
    config_destroy(&tree);
}

int source_is_default(const config_setting_t *setting)
{
    return config_setting_get_hook(setting) == default_mark;
}

/* A word that needs no quotes in an override: a name or a path. */
static int is_bare(const char *value)
{
    if (!isalpha((unsigned char)value[0]) && strchr("./_", value[0]) == NULL)
        return 0;
    for (; *value != '\0'; value++)
        if (!isalnum((unsigned char)*value) && strchr("./_-+", *value) == NULL)
            return 0;
    return 1;
}

static int bad_override(const char *text, const char *why)
{
    fprintf(stderr, "winnow: option -s %s: %s\n", text, why);
    return 2;
}

/* The member of that name, or the element of that number. */
static config_setting_t *below(config_setting_t *s, const char *name)
{
    if (config_setting_is_group(s)) return config_setting_get_member(s, name);
    if (config_setting_is_aggregate(s) && isdigit((unsigned char)name[0]))
        return config_setting_get_elem(s, (unsigned)atoi(name));
    return NULL;
}

/* Puts the value, or a text if value is NULL, in the place of an old one. */
static int put(config_setting_t *group, const char *name, const char *text,
               const config_setting_t *value, const char *bare)
{
    config_setting_t *s;

    if (!config_setting_is_group(group))
        return bad_override(text, "only a key of a group can be set");
    config_setting_remove(group, name);
    s = value != NULL ? copy(group, name, value)
                      : config_setting_add(group, name, CONFIG_TYPE_STRING);
    if (s == NULL) return bad_override(text, "not a name that a key can have");
    if (value == NULL) config_setting_set_string(s, bare);
    config_setting_set_hook(s, (void *)text);
    return 0;
}

/* Walks to the group that holds the last name of the path, making groups. */
static config_setting_t *walk(config_t *tree, const char *text, char *path,
                              char **last)
{
    config_setting_t *at = config_root_setting(tree);

    *last = path;
    for (char *dot; (dot = strchr(*last, '.')) != NULL; *last = dot + 1) {
        config_setting_t *next;

        *dot = '\0';
        next = below(at, *last);
        if (next == NULL && config_setting_is_group(at)) {
            next = config_setting_add(at, *last, CONFIG_TYPE_GROUP);
            if (next != NULL) config_setting_set_hook(next, (void *)text);
        }
        if (next == NULL || config_setting_is_scalar(next)) return NULL;
        at = next;
    }
    return at;
}

int source_override(config_t *tree, const char *text)
{
    const char *const equal = strchr(text, '=');
    config_setting_t *group;
    config_t value;
    char *path, *last;
    int code;

    if (equal == NULL || equal == text)
        return bad_override(text, "expected path.to.key=value");
    path = strndup(text, (size_t)(equal - text));
    group = walk(tree, text, path, &last);
    if (group == NULL)
        code = bad_override(text, "leads through something that is no group");
    else if (read_value(&value, equal + 1))
        code = put(group, last, text, config_lookup(&value, "value"), NULL);
    else if (is_bare(equal + 1))
        code = put(group, last, text, NULL, equal + 1);
    else
        code = bad_override(text, config_error_text(&value) != NULL
                                      ? config_error_text(&value)
                                      : "not a value");
    if (group != NULL) config_destroy(&value);
    free(path);
    return code;
}
