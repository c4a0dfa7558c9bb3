/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly_file.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/tables/input.h"

void poly_file_wrong(struct poly_file *p, const char *format, ...)
{
    va_list list;

    if (p->failed) return;
    p->failed = 1;
    va_start(list, format);
    fprintf(stderr, "winnow: %s:%d: ", p->path, p->line);
    vfprintf(stderr, format, list);
    fputc('\n', stderr);
    va_end(list);
}

static void skip_line(struct poly_file *p)
{
    while (p->text[p->at] != '\0' && p->text[p->at] != '\n')
        p->at++;
}

static void skip_comment(struct poly_file *p)
{
    for (p->at += 2; p->text[p->at] != '\0'; p->at++) {
        if (p->text[p->at] == '\n') p->line++;
        if (p->text[p->at] == '*' && p->text[p->at + 1] == '/') {
            p->at += 2;
            return;
        }
    }
}

static void skip_blanks(struct poly_file *p)
{
    for (;;) {
        const char *const t = &p->text[p->at];
        if (t[0] == '\n') p->line++;
        if (t[0] == '/' && t[1] == '/')
            skip_line(p);
        else if (t[0] == '/' && t[1] == '*')
            skip_comment(p);
        else if (isspace((unsigned char)t[0]))
            p->at++;
        else
            return;
    }
}

void poly_file_word(struct poly_file *p, char word[POLY_WORD])
{
    int n = 0;

    word[0] = '\0';
    if (p->failed) return;
    skip_blanks(p);
    while (p->text[p->at] != '\0' && n < POLY_WORD - 1) {
        const char c = p->text[p->at];
        const int sign = strchr("(){};", c) != NULL;
        if (isspace((unsigned char)c) || (sign && n > 0)) break;
        word[n++] = c;
        p->at++;
        if (sign) break;
    }
    word[n] = '\0';
    if (n == 0) poly_file_wrong(p, "the file ends too early");
}

void poly_file_expect(struct poly_file *p, const char *expected)
{
    char word[POLY_WORD];

    poly_file_word(p, word);
    if (!p->failed && strcmp(word, expected) != 0)
        poly_file_wrong(p, "expected %s, found %s", expected, word);
}

int poly_file_int(struct poly_file *p)
{
    char word[POLY_WORD], *end;

    poly_file_word(p, word);
    if (p->failed) return 0;
    errno = 0;
    const long value = strtol(word, &end, 10);
    if (*end == '\0' && errno == 0 && value >= 0 && value <= INT_MAX)
        return (int)value;
    poly_file_wrong(p, "expected a whole number >= 0, found %s", word);
    return 0;
}

int poly_file_count(struct poly_file *p, int least)
{
    const int n = poly_file_int(p);

    if (p->failed || (n <= p->size / least && n <= INT_MAX / 4)) return n;
    poly_file_wrong(p, "%d entries are more than the file can hold", n);
    return 0;
}

double poly_file_real(struct poly_file *p)
{
    char word[POLY_WORD], *end;

    poly_file_word(p, word);
    if (p->failed) return 0.0;
    const double value = strtod(word, &end);
    if (*end == '\0' && number_is_coordinate(value)) return value;
    poly_file_wrong(p, "expected a number [m] of at most 1e12, found %s", word);
    return 0.0;
}

/* FoamFile { format ascii; ... }, if there is one. */
static void read_header(struct poly_file *p)
{
    const struct poly_file start = *p;
    char word[POLY_WORD];

    poly_file_word(p, word);
    if (strcmp(word, "FoamFile") != 0) { /* no header: the list begins */
        const int failed = p->failed;
        *p = start;
        p->failed = failed;
        return;
    }
    poly_file_expect(p, "{");
    while (!p->failed && strcmp(word, "}") != 0) {
        poly_file_word(p, word);
        if (strcmp(word, "format") != 0) continue;
        poly_file_word(p, word);
        if (strcmp(word, "ascii") != 0)
            poly_file_wrong(p,
                            "format %s is not read, only ascii; "
                            "foamFormatConvert writes it",
                            word);
    }
}

/* All of a file, be it packed by gzip or not; NULL if it cannot be read. */
static char *unpack(const char *path, long *size)
{
    const gzFile f = input_wrong(path) == NULL ? gzopen(path, "rb") : NULL;
    long room = 1 << 16;
    char *text;
    int n = 0;

    *size = 0;
    if (f == NULL) return NULL;
    text = alloc_zeroed((size_t)room + 1, 1);
    while ((n = gzread(f, &text[*size], (unsigned)(room - *size))) > 0) {
        *size += n;
        if (*size < room) continue;
        char *const more = alloc_zeroed(2 * (size_t)room + 1, 1);
        memcpy(more, text, (size_t)*size);
        free(text);
        text = more;
        room *= 2;
    }
    gzclose(f);
    if (n == 0) return text;
    free(text);
    return NULL;
}

void poly_file_open(struct poly_file *p, const char *dir, const char *name)
{
    *p = (struct poly_file){.line = 1};
    snprintf(p->path, sizeof p->path, "%s/%s", dir, name);
    errno = 0;
    p->text = unpack(p->path, &p->size);
    if (p->text == NULL && errno == ENOENT) {
        snprintf(p->path, sizeof p->path, "%s/%s.gz", dir, name);
        p->text = unpack(p->path, &p->size);
        if (p->text == NULL)
            snprintf(p->path, sizeof p->path, "%s/%s", dir, name);
    }
    if (p->text == NULL)
        poly_file_wrong(p, "cannot be read: %s",
                        input_wrong(p->path) != NULL ? input_wrong(p->path)
                                                     : "damaged");
    else
        read_header(p);
}

void poly_file_close(struct poly_file *p)
{
    free(p->text);
    p->text = NULL;
}
