/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/summary.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

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
