/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/source.h"

#include "base/tables/input.h"
#include "base/text.h"
#include "case/text/include.h"
#include "case/scan.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char source_default[] = "default";

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
        return "; is a ; or a brace missing here or just before?";
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
    return config_error_type(tree) == CONFIG_ERR_FILE_IO ||
                   strstr(complaint, "cannot open include") != NULL
               ? 4
               : 2;
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

int source_read(config_t *tree, const char *file)
{
    const char *why;
    size_t length;
    config_init(tree);
    include_beside(tree, file);
    const int code = include_check_file(file, config_get_include_dir(tree));
    if (code != 0) return code;
    char *const text = input_text(file, &length, &why);
    if (text != NULL) scan_mixed(text);
    const int good = text != NULL ? config_read_string(tree, text)
                                  : config_read_file(tree, file);
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

static void append_scalar(char text[SOURCE_TEXT], const config_setting_t *s)
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_FLOAT:
        source_append(text, "%g", config_setting_get_float(s));
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

void source_value(const config_setting_t *s, char text[SOURCE_TEXT])
{
    text[0] = '\0';
    if (config_setting_is_group(s) || config_setting_is_scalar(s)) {
        append_scalar(text, s);
        return;
    }
    for (int i = 0; i < config_setting_length(s) && i < 4; i++) {
        source_append(text, i == 0 ? "[" : ", ");
        append_scalar(text, config_setting_get_elem(s, (unsigned)i));
    }
    source_append(text, config_setting_length(s) > 4 ? ", ...]" : "]");
}
