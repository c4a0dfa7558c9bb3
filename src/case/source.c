/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/source.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/text.h"

static const char source_default[] = "default";

/* The path of a file as libconfig names it: the case by its path, an included
 * file perhaps only by its name. The file itself if there is none. */
static void source_locate(const config_t *tree, const char *name,
                          const char *file, char path[SOURCE_TEXT])
{
    const char *const folder = config_get_include_dir(tree);
    const size_t n = folder != NULL ? strlen(folder) : 0;

    if (name == NULL || name[0] == '\0')
        snprintf(path, SOURCE_TEXT, "%s", file);
    else if (folder == NULL || strncmp(name, folder, n) == 0)
        snprintf(path, SOURCE_TEXT, "%s", name);
    else
        snprintf(path, SOURCE_TEXT, "%s/%s", folder, name);
}

/* Prints a line of a file, without the blanks before it. */
static void print_source_line(const char *file, int number)
{
    FILE *const in = fopen(file, "r");
    char line[SOURCE_TEXT] = "";

    if (in == NULL) return;
    for (int i = 0; i < number; i++)
        if (fgets(line, sizeof line, in) == NULL) line[0] = '\0';
    fclose(in);
    line[strcspn(line, "\r\n")] = '\0';
    text_blank(line);
    if (line[0] != '\0')
        fprintf(stderr, "    %s\n", line + strspn(line, " \t"));
}

/* A hint for a message of libconfig that does not say what to change. */
static const char *advice(const char *complaint)
{
    if (strstr(complaint, "mismatched element") != NULL)
        return "; write all numbers alike, as in [0.0, -9.81, 0.0]";
    if (strstr(complaint, "syntax error") != NULL)
        return "; is a ; or a brace missing here or just before? A value is "
               "a number alone, as 1.2e-3, or a text in quotes";
    if (strstr(complaint, "memory exhausted") != NULL)
        return ": groups or lists within one another are too deep";
    if (strstr(complaint, "duplicate") != NULL)
        return "; a group has each name once";
    return "";
}

static int wrong_syntax(const config_t *tree, const char *file)
{
    const char *const complaint = config_error_text(tree);
    char in[SOURCE_TEXT];

    source_locate(tree, config_error_file(tree), file, in);
    fprintf(stderr, "winnow: %s:%d: %s%s\n", in, config_error_line(tree),
            complaint, advice(complaint));
    print_source_line(in, config_error_line(tree));
    return 2;
}

/* libconfig looks for included files in one folder: that of the case. */
static void include_beside(config_t *tree, const char *file)
{
    const char *const slash = strrchr(file, '/');
    char folder[SOURCE_TEXT];

    if (slash == NULL) return;
    snprintf(folder, sizeof folder, "%.*s",
             slash == file ? 1 : (int)(slash - file), file);
    config_set_include_dir(tree, folder);
}

int source_read(config_t *tree, struct inputs **files, const char *file)
{
    config_init(tree);
    include_beside(tree, file);
    const int code = scan_file(files, file, config_get_include_dir(tree));
    if (code != 0) return code;
    char *const text = strdup(input_kept(files, file)->text);
    scan_mixed(text);
    const int good = config_read_string(tree, text);
    free(text);
    config_setting_set_hook(config_root_setting(tree), (void *)file);
    return good ? 0 : wrong_syntax(tree, file);
}

int source_is_default(const config_setting_t *setting)
{
    return config_setting_get_hook(setting) == source_default;
}

double source_number(const config_setting_t *s)
{
    return config_setting_type(s) == CONFIG_TYPE_FLOAT
               ? config_setting_get_float(s)
               : (double)config_setting_get_int64(s);
}

void source_place(const config_setting_t *at, char text[SOURCE_TEXT])
{
    const config_t *const tree = at->config;
    const size_t longest = SOURCE_TEXT - 16;
    const char *const file = config_setting_get_hook(tree->root);
    const char *name = NULL;

    for (const config_setting_t *s = at; s != NULL;
         s = config_setting_parent(s)) {
        if (config_setting_get_hook(s) != NULL && !source_is_default(s) &&
            !config_setting_is_root(s)) {
            snprintf(text, SOURCE_TEXT, "option -s %s",
                     (const char *)config_setting_get_hook(s));
            return;
        }
        if (name == NULL) name = config_setting_source_file(s);
    }
    source_locate(tree, name, file != NULL ? file : "the case", text);
    if (!config_setting_is_root(at) && strlen(text) < longest)
        sprintf(text + strlen(text), ":%u",
                (unsigned)config_setting_source_line(at));
}

void source_path(char below[SOURCE_TEXT], const char *path,
                 const config_setting_t *member)
{
    const char *const name = config_setting_name(member); /* not in a list */

    snprintf(below, SOURCE_TEXT, "%.*s%s%s", SOURCE_TEXT / 2, path,
             path[0] != '\0' && name != NULL ? "." : "",
             name != NULL ? name : "");
}

char *source_place_of(const config_setting_t *in, const char *path,
                      const char *text)
{
    char of[SOURCE_TEXT], place[SOURCE_TEXT], *found = NULL;

    for (int i = 0; i < config_setting_length(in) && found == NULL; i++) {
        const config_setting_t *const s = source_element(in, i);
        source_path(of, path, s);
        if (config_setting_is_aggregate(s)) {
            found = source_place_of(s, of, text);
        } else if (config_setting_get_string(s) == text) {
            source_place(s, place);
            found = alloc_zeroed(strlen(place) + strlen(of) + 5, 1);
            sprintf(found, "%s: %s: ", place, of);
        }
    }
    return found;
}

int source_wrong(const config_setting_t *at, const char *format, ...)
{
    char where[SOURCE_TEXT], message[4 * SOURCE_TEXT];
    va_list values;

    source_place(at, where);
    va_start(values, format);
    vsnprintf(message, sizeof message, format, values);
    va_end(values);
    text_blank(where);
    text_blank(message);
    fprintf(stderr, "winnow: %s: %s\n", where, message);
    return 2;
}

/* Appends to a text of at most SOURCE_TEXT bytes. */
static void source_append(char text[SOURCE_TEXT], const char *format, ...)
{
    const size_t used = strlen(text);
    va_list values;

    va_start(values, format);
    vsnprintf(text + used, SOURCE_TEXT - used, format, values);
    va_end(values);
}

/* Of few digits; its point shows that it is written as a real number. */
static int is_whole_number(const config_setting_t *s)
{
    const double x = config_setting_get_float(s);

    return x == trunc(x) && fabs(x) < 1e6;
}

static void append_scalar(char text[SOURCE_TEXT], const config_setting_t *s)
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_FLOAT:
        source_append(text, is_whole_number(s) ? "%.1f" : "%g",
                      config_setting_get_float(s));
        break;
    case CONFIG_TYPE_STRING:
        source_append(text, "the text \"%.200s\"",
                      config_setting_get_string(s));
        break;
    case CONFIG_TYPE_BOOL:
        source_append(text, config_setting_get_bool(s) ? "true" : "false");
        break;
    case CONFIG_TYPE_GROUP:
        source_append(text, "a group");
        break;
    case CONFIG_TYPE_ARRAY:
    case CONFIG_TYPE_LIST:
        source_append(text, "a list");
        break;
    default:
        source_append(text, "%lld", config_setting_get_int64(s));
    }
}

/* One, or two between parentheses, as a time and its value. */
static void append_pair(char text[SOURCE_TEXT], const config_setting_t *s)
{
    const int pair =
        !config_setting_is_group(s) && config_setting_length(s) == 2;

    if (pair) source_append(text, "(");
    append_scalar(text, pair ? config_setting_get_elem(s, 0) : s);
    if (pair) source_append(text, ", ");
    if (pair) append_scalar(text, config_setting_get_elem(s, 1));
    if (pair) source_append(text, ")");
}

void source_value(const config_setting_t *s, char text[SOURCE_TEXT])
{
    text[0] = '\0';
    if (config_setting_is_group(s) || config_setting_is_scalar(s)) {
        append_scalar(text, s);
        return;
    }
    source_append(text, "[");
    for (int i = 0; i < config_setting_length(s) && i < 4; i++) {
        source_append(text, i == 0 ? "" : ", ");
        append_pair(text, source_element(s, i));
    }
    source_append(text, config_setting_length(s) > 4 ? ", ...]" : "]");
}

/* --- overrides and defaults ----------------------------------------------- */

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
            const config_setting_t *const one = source_element(from, i);
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

void source_add_default(config_setting_t *group, const char *name,
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
    const char *const wrong = scan_value(value);
    config_t tree;
    int code;

    if (wrong != NULL) return report_wrong(text, wrong);
    if (strcmp(value, "off") == 0) { /* as if the case did not name the key */
        if (config_setting_is_group(group)) config_setting_remove(group, name);
        return 0;
    }
    if (read_value(&tree, value))
        code = override_put(group, name, text, config_lookup(&tree, "value"));
    else
        code = report_wrong(text, "the text after = is not one value of a case "
                                  "file; quote a text with blanks");
    config_destroy(&tree);
    return code;
}

int source_override(config_t *tree, const char *text)
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
