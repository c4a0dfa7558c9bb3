/* SPDX-License-Identifier: GPL-3.0-or-later */
/* include.c -- the files that a case is made of, looked at before they are
 * read.
 *
 * libconfig ends the program where an included file is a folder, waits for ever
 * where it is a pipe, and reads a whole number that does not fit an int as
 * another one.
 */
#include "case/text/include.h"

#include "base/tables/input.h"
#include "case/text/digits.h"
#include "case/scan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* libconfig says itself what is wrong with deeper ones. */
enum { DEEPEST = 10, PATH = 4096 };

/* Where a file was named, for messages. */
struct place {
    const char *file; /* NULL for the case itself */
    int line;
};

static int unreadable(const struct place *at, const char *file, const char *why)
{
    if (at->file == NULL)
        fprintf(stderr, "winnow: %s: cannot read the case: %s\n", file, why);
    else
        fprintf(stderr, "winnow: %s:%d: cannot read what is included, %s: %s\n",
                at->file, at->line, file, why);
    return 4;
}

/* A byte order mark or a zero byte, which libconfig reports as a syntax error.
 */
static int is_no_text(const char *file, const char *text, size_t length)
{
    const char *const zero = memchr(text, '\0', length);

    if (strncmp(text, "\xEF\xBB\xBF", 3) == 0)
        fprintf(stderr,
                "winnow: %s:1: the file begins with a byte order mark, three "
                "bytes that no case has; save it as UTF-8 without one\n",
                file);
    else if (zero != NULL)
        fprintf(stderr,
                "winnow: %s: byte %zu is 0, so it is no text; expected a case "
                "in ASCII or UTF-8\n",
                file, (size_t)(zero - text));
    else
        return 0;
    return 2;
}

/* The name after @include on a line, between quotes; 0 if there is none. */
static int included(const char *line, char name[PATH])
{
    char closing;

    return sscanf(line, " @include \"%4095[^\"\n]%c", name, &closing) == 2 &&
           closing == '"';
}

static int include_check(const char *file, const char *folder, struct place at,
                         int depth);

/* Looks at the files that a text includes. */
static int check_text(const char *text, const char *file, const char *folder,
                      int depth)
{
    struct place at = {file, 1};
    int begins = 1, code = 0; /* a line, but for blanks */

    while (*text != '\0' && code == 0) {
        const char *const next = scan_next(text);
        char name[PATH], path[2 * PATH];

        if (begins && *text == '@' && included(text, name)) {
            snprintf(path, sizeof path, "%s%s%s", folder != NULL ? folder : "",
                     folder != NULL ? "/" : "", name);
            code = include_check(path, folder, at, depth + 1);
        }
        if (*text != ' ' && *text != '\t') begins = *text == '\n';
        for (; text < next; text++)
            at.line += *text == '\n';
    }
    return code;
}

static int include_check(const char *file, const char *folder, struct place at,
                         int depth)
{
    const char *why;
    size_t length;

    if (depth > DEEPEST) return 0;
    char *const text = input_text(file, &length, &why);
    if (text == NULL) return unreadable(&at, file, why);
    int code = is_no_text(file, text, length);
    if (code == 0) code = digits_check(file, text);
    if (code == 0) code = check_text(text, file, folder, depth);
    free(text);
    return code;
}

int include_check_file(const char *file, const char *folder)
{
    return include_check(file, folder, (struct place){NULL, 0}, 0);
}

const char *include_check_value(const char *value)
{
    int line;

    if (digits_find(value, &line) == NULL) return NULL;
    return "too large for a whole number, at most 2147483647; a real one has a "
           "point or an exponent";
}
