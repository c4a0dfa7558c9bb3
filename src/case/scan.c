/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/source.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"

/* Of a word or a number. */
static int is_of_word(char c)
{
    return isalnum((unsigned char)c) || c == '_' || c == '.';
}

static const char *past_string(const char *t)
{
    for (t++; *t != '\0' && *t != '"'; t++)
        if (*t == '\\' && t[1] != '\0') t++;
    return *t == '"' ? t + 1 : t;
}

/* Past a string or a comment that begins here; else the same place. */
static const char *skip(const char *t)
{
    const char *end;

    if (*t == '"') return past_string(t);
    if (*t == '#' || (t[0] == '/' && t[1] == '/')) return t + strcspn(t, "\n");
    if (t[0] == '/' && t[1] == '*') {
        end = strstr(t + 2, "*/");
        return end != NULL ? end + 2 : t + strlen(t);
    }
    return t;
}

/* Past whatever begins here: a string, a comment, a word or number, or one
 * other sign. At the end of the text the same place. */
static const char *past_piece(const char *t)
{
    const char *const next = skip(t);

    if (next != t || *t == '\0') return next;
    if (!is_of_word(*t)) return t + 1;
    while (is_of_word(*t))
        t++;
    return t;
}

void scan_mixed(char *text)
{
    char *open = NULL;
    int whole = 0, real = 0;

    for (; *text != '\0'; text += past_piece(text) - text) {
        const int n = (int)(past_piece(text) - text);
        if (*text == '[') {
            open = text;
            whole = real = 0;
        } else if (isdigit((unsigned char)*text) || *text == '.') {
            int is_real = 0;
            for (int i = 0; i < n; i++)
                is_real |= strchr(".eE", text[i]) != NULL;
            whole |= !is_real;
            real |= is_real;
        } else if (*text == ']' && open != NULL && whole && real) {
            *open = '(';
            *text = ')';
        }
    }
}

/* --- whole numbers -------------------------------------------------------- */

/* A name, or a number with a point, an exponent or an L, is not whole. */
static int is_too_large(const char *word)
{
    const size_t n = strspn(word, "0123456789");
    char *end;
    long long value;

    if (n == 0 || is_of_word(word[n])) return 0;
    errno = 0;
    value = strtoll(word, &end, 10);
    return errno == ERANGE || value > INT_MAX;
}

const char *scan_digits(const char *text, int *line)
{
    *line = 1;
    while (*text != '\0') {
        const char *const next = past_piece(text);

        if (is_too_large(text)) return text;
        for (; text < next; text++)
            *line += *text == '\n';
    }
    return NULL;
}

static int digits_check(const char *file, const char *text)
{
    int line;
    const char *const found = scan_digits(text, &line);

    if (found == NULL) return 0;
    const int n = (int)strspn(found, "0123456789"), shown = n < 40 ? n : 40;
    fprintf(stderr,
            "winnow: %s:%d: %.*s%s is too large for a whole number, at most "
            "%d; a real one has a point or an exponent\n",
            file, line, shown, found, n > shown ? "..." : "", INT_MAX);
    return 2;
}

/* --- files ---------------------------------------------------------------- */

/* libconfig says itself what is wrong with deeper ones. Ten in each of so deep
 * ones would be more than there is time for. */
enum { DEEPEST = 10, MOST_INCLUDED = 1000, PATH = 4096 };

/* Where the files are kept that are read, and the folder of those that are
 * included. */
struct scan {
    struct inputs **files;
    const char *folder;
    int n; /* [-] of all so far */
};

/* Where a file was named, for messages. */
struct place {
    const char *file; /* NULL for the case itself */
    int line;
};

static int unreadable(const struct place *at, const char *file, const char *why)
{
    char longer[PATH];

    snprintf(longer, sizeof longer, "%s.cfg", file);
    if (at->file == NULL)
        fprintf(stderr, "winnow: %s: cannot read the case: %s%s%s%s\n", file,
                why, input_wrong(longer) == NULL ? "; did you mean " : "",
                input_wrong(longer) == NULL ? longer : "",
                input_wrong(longer) == NULL ? "?" : "");
    else
        fprintf(stderr, "winnow: %s:%d: cannot read what is included, %s: %s\n",
                at->file, at->line, file, why);
    return at->file == NULL ? 4 : 2;
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

static int include_check(struct scan *s, const char *file, struct place at,
                         int depth);

/* Looks at the files that a text includes. */
static int check_text(struct scan *s, const char *text, const char *file,
                      int depth)
{
    const char *const folder = s->folder;
    struct place at = {file, 1};
    int begins = 1, code = 0; /* a line, but for blanks */

    while (*text != '\0' && code == 0) {
        const char *const next = past_piece(text);
        char name[PATH], path[2 * PATH];

        if (begins && *text == '@' && included(text, name)) {
            snprintf(path, sizeof path, "%s%s%s", folder != NULL ? folder : "",
                     folder != NULL ? "/" : "", name);
            code = include_check(s, path, at, depth + 1);
        }
        if (*text != ' ' && *text != '\t') begins = *text == '\n';
        for (; text < next; text++)
            at.line += *text == '\n';
    }
    return code;
}

static int include_check(struct scan *s, const char *file, struct place at,
                         int depth)
{
    if (depth > DEEPEST) return 0;
    if (s->n++ > MOST_INCLUDED)
        return 2 * text_wrong(at.file, at.line,
                              "more than %d files are included", MOST_INCLUDED);
    const struct input *const in = input_kept(s->files, file);
    if (in->text == NULL) return unreadable(&at, file, in->why);
    int code = is_no_text(file, in->text, in->length);
    if (code == 0) code = digits_check(file, in->text);
    return code != 0 ? code : check_text(s, in->text, file, depth);
}

int scan_file(struct inputs **files, const char *file, const char *folder)
{
    struct scan s = {files, folder, 0};

    return include_check(&s, file, (struct place){NULL, 0}, 0);
}

const char *scan_value(const char *value)
{
    int line;

    if (scan_digits(value, &line) == NULL) return NULL;
    return "too large for a whole number, at most 2147483647; a real one has a "
           "point or an exponent";
}
