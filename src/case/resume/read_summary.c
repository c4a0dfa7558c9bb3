/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resume/read_summary.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/file.h"

/* The place of a value in the text of a summary, or NULL. Each entry has a line
 * of its own, which is indented by two blanks more than the line of its group;
 * no value has an end of line. */
static const char *value_of(const char *text, const char *path)
{
    char entry[160], end[64];

    for (int blanks = 2; *text == '{'; blanks += 2) {
        const int length = (int)strcspn(path, ".");

        snprintf(entry, sizeof entry, "\n%*s\"%.*s\": ", blanks, "", length,
                 path);
        snprintf(end, sizeof end, "\n%*s}", blanks - 2, "");
        const char *const at = strstr(text, entry), *const stop =
                                                        strstr(text, end);
        if (at == NULL || (stop != NULL && at > stop)) return NULL;
        text = at + strlen(entry);
        if (strncmp(text, "{}", 2) == 0) return NULL;
        if (path[length] == '\0') return text;
        path += length + 1;
    }
    return NULL;
}

/* The value of a path in the summary of a folder as a new string, up to the end
 * of the file; NULL if it is not there. */
static char *in_summary(const char *folder, const char *path)
{
    char *const file = file_join(folder, "summary.json");
    const char *why;
    size_t length;
    char *const text = input_text(file, &length, &why);
    const char *const at = text != NULL ? value_of(text, path) : NULL;
    char *const found = at != NULL ? strdup(at) : NULL;

    free(text);
    free(file);
    return found;
}

double read_summary_number(const char *folder, const char *path)
{
    char *const text = in_summary(folder, path), *end = text;
    const double value = text != NULL ? strtod(text, &end) : NAN;
    const int found = end != text;

    free(text);
    return found ? value : NAN;
}

/* The text up to the closing quote; what stood behind a backslash as it is, and
 * a character that is given by its number, \u000a, as that. */
static char *unquoted(const char *at)
{
    char *const text = alloc_zeroed(strlen(at) + 1, 1);

    for (size_t n = 0; *at != '\0' && *at != '"'; at++) {
        const int escaped = *at == '\\' && at[1] != '\0';
        char number[5] = "";

        at += escaped;
        if (escaped && *at == 'u' && strlen(at) > 4) {
            memcpy(number, at + 1, 4);
            at += 4;
            text[n++] = (char)strtol(number, NULL, 16);
        } else
            text[n++] = *at;
    }
    return text;
}

char *read_summary_text(const char *folder, const char *path)
{
    char *const text = in_summary(folder, path);
    char *const found =
        text != NULL && *text == '"' ? unquoted(text + 1) : NULL;

    free(text);
    return found;
}
