/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/summary.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"

struct summary {
    struct file *file;
    FILE *out;
    int depth; /* [-] open groups, the outermost braces not counted */
    int first; /* [-] 1: the next entry is the first of its group */
};

/* Bytes of the UTF-8 character that begins at p, or 0 if none does. */
static int character_length(const char *p)
{
    const unsigned char c = (unsigned char)p[0];
    const int length = c < 0x80                ? 1
                       : c >= 0xc2 && c < 0xe0 ? 2
                       : c >= 0xe0 && c < 0xf0 ? 3
                       : c >= 0xf0 && c < 0xf5 ? 4
                                               : 0;

    for (int i = 1; i < length; i++)
        if (((unsigned char)p[i] & 0xc0) != 0x80) return 0;
    return length;
}

/* Writes the text in quotes. Bytes that are not UTF-8, as in a title in another
 * encoding, become the sign for an unknown character. */
static void summary_put_text(FILE *out, const char *text)
{
    fputc('"', out);
    for (const char *p = text; *p;) {
        const int length = character_length(p);

        if (length == 0)
            fputs("\\ufffd", out);
        else if (*p == '"' || *p == '\\')
            fprintf(out, "\\%c", *p);
        else if ((unsigned char)*p < 0x20)
            fprintf(out, "\\u%04x", (unsigned)*p);
        else
            fwrite(p, 1, (size_t)length, out);
        p += length ? length : 1;
    }
    fputc('"', out);
}

static void put_line_start(struct summary *s)
{
    fputc('\n', s->out);
    for (int i = 0; i <= s->depth; i++)
        fputs("  ", s->out);
}

static FILE *put_key(struct summary *s, const char *key)
{
    if (!s->first) fputc(',', s->out);
    s->first = 0;
    put_line_start(s);
    summary_put_text(s->out, key);
    fputs(": ", s->out);
    return s->out;
}

struct summary *summary_create(const char *path)
{
    struct file *const f = file_create(path);

    if (f == NULL) return NULL;
    struct summary *const s = alloc_zeroed(1, sizeof *s);
    s->file = f;
    s->out = file_stream(f);
    s->first = 1;
    fputc('{', s->out);
    return s;
}

void summary_number(struct summary *s, const char *key, double value)
{
    char text[NUMBER_LENGTH];

    if (s)
        fputs(isfinite(value) ? number_text(value, text) : "null",
              put_key(s, key));
}

void summary_count(struct summary *s, const char *key, long long value)
{
    if (s) fprintf(put_key(s, key), "%lld", value);
}

void summary_text(struct summary *s, const char *key, const char *value)
{
    if (s) summary_put_text(put_key(s, key), value);
}

void summary_begin(struct summary *s, const char *key)
{
    if (s == NULL) return;
    fputc('{', put_key(s, key));
    s->depth++;
    s->first = 1;
}

void summary_end(struct summary *s)
{
    if (s == NULL) return;
    assert(s->depth > 0);
    s->depth--;
    if (!s->first) put_line_start(s);
    fputc('}', s->out);
    s->first = 0;
}

int summary_commit(struct summary *s)
{
    if (s == NULL) return 1;
    assert(s->depth == 0);
    fputs("\n}\n", s->out);
    const int failed = file_commit(s->file);
    free(s);
    return failed;
}

/* --- read summary --------------------------------------------------------- */

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
