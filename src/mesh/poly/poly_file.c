/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/number.h"
#include "base/file.h"
#include "base/text.h"

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

static void poly_file_skip_line(struct poly_file *p)
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
            poly_file_skip_line(p);
        else if (t[0] == '/' && t[1] == '*')
            skip_comment(p);
        else if (isspace((unsigned char)t[0]))
            p->at++;
        else
            return;
    }
}

/* What follows up to a blank or a sign of the grammar, which is a word itself;
 * its length. */
static int plain_word(struct poly_file *p, char word[POLY_WORD])
{
    int n = 0;

    while (p->text[p->at] != '\0' && n < POLY_WORD - 1) {
        const char c = p->text[p->at];
        const int sign = strchr("(){};", c) != NULL;
        if (isspace((unsigned char)c) || (sign && n > 0)) break;
        word[n++] = c;
        p->at++;
        if (sign) break;
    }
    word[n] = '\0';
    return n;
}

/* The end of a text in quotes that begins at `at`. */
static long end_of_text(const struct poly_file *p, long at)
{
    for (at++; p->text[at] != '\0' && p->text[at] != '"';)
        at += 1 + (p->text[at] == '\\' && p->text[at + 1] != '\0');
    return at + (p->text[at] == '"');
}

void poly_file_word(struct poly_file *p, char word[POLY_WORD])
{
    word[0] = '\0';
    if (p->failed) return;
    skip_blanks(p);
    if (p->text[p->at] == '"') {
        const long end = end_of_text(p, p->at);
        const long most = end - p->at < POLY_WORD ? end - p->at : POLY_WORD;
        snprintf(word, POLY_WORD, "%.*s", (int)most, &p->text[p->at]);
        p->at = end;
    } else if (plain_word(p, word) == 0) {
        poly_file_wrong(p, "the file ends too early");
    }
    text_blank(word); /* messages quote it */
}

void poly_file_expect(struct poly_file *p, const char *expected)
{
    char word[POLY_WORD];

    poly_file_word(p, word);
    if (!p->failed && strcmp(word, expected) != 0)
        poly_file_wrong(p, "expected %s, found %s", expected, word);
}

void poly_file_begin(struct poly_file *p, int n)
{
    char word[POLY_WORD];

    if (n == 0 && p->is_binary) { /* of an empty list there may be no sign */
        skip_blanks(p);
        if (p->text[p->at] != '(') return;
    }
    poly_file_word(p, word);
    if (strcmp(word, "{") == 0 && n > 0)
        p->same = p->at;
    else if (!p->failed && strcmp(word, "(") != 0)
        poly_file_wrong(p, "expected (, found %s", word);
    p->in_bytes = p->is_binary && p->same == 0;
}

void poly_file_end(struct poly_file *p, int n)
{
    p->in_bytes = 0;
    if (n == 0 && p->is_binary && p->text[p->at] != ')') return;
    poly_file_expect(p, p->same > 0 ? "}" : ")");
    p->same = 0;
}

/* The bytes of the next number, whose width is one of two; NULL if the file
 * ends. */
static const char *poly_file_bytes_of(struct poly_file *p, int width)
{
    const char *const at = &p->text[p->at];

    if (width > p->size - p->at) poly_file_wrong(p, "the file ends too early");
    p->at += p->failed ? 0 : width;
    return p->failed ? NULL : at;
}

static long whole_of_bytes(struct poly_file *p)
{
    int32_t narrow = 0;
    int64_t wide = 0;
    const int is_wide = p->label == sizeof wide;
    const char *const at = poly_file_bytes_of(p, p->label);

    if (at == NULL) return 0;
    memcpy(is_wide ? (void *)&wide : (void *)&narrow, at, (size_t)p->label);
    return is_wide ? wide : narrow;
}

static double real_of_bytes(struct poly_file *p)
{
    float narrow = 0.0f;
    double wide = 0.0;
    const int is_wide = p->scalar == sizeof wide;
    const char *const at = poly_file_bytes_of(p, p->scalar);

    if (at == NULL) return 0.0;
    memcpy(is_wide ? (void *)&wide : (void *)&narrow, at, (size_t)p->scalar);
    return is_wide ? wide : (double)narrow;
}

int poly_file_int(struct poly_file *p)
{
    char word[POLY_WORD] = "", *end = word;

    errno = 0;
    if (p->same > 0) p->at = p->same;
    if (!p->in_bytes) poly_file_word(p, word);
    const long value = p->in_bytes ? whole_of_bytes(p) : strtol(word, &end, 10);
    if (p->failed) return 0;
    if (*end == '\0' && errno == 0 && value >= 0 && value <= INT_MAX)
        return (int)value;
    if (p->in_bytes) snprintf(word, sizeof word, "%ld", value);
    poly_file_wrong(p, "expected a whole number >= 0, found %s", word);
    return 0;
}

int poly_file_count(struct poly_file *p, int least)
{
    const int n = poly_file_int(p);

    if (p->failed || (n <= INT_MAX / 4 && (least == 0 || n <= p->size / least)))
        return n;
    poly_file_wrong(p, "%d entries are more than the file can hold", n);
    return 0;
}

double poly_file_real(struct poly_file *p)
{
    char word[POLY_WORD] = "", *end = word;

    if (!p->in_bytes) poly_file_word(p, word);
    const double value = p->in_bytes ? real_of_bytes(p) : strtod(word, &end);
    if (p->failed) return 0.0;
    if (*end == '\0' && number_is_coordinate(value)) return value;
    if (p->in_bytes) snprintf(word, sizeof word, "%g", value);
    poly_file_wrong(p, "expected a number [m] of at most 1e12, found %s", word);
    return 0.0;
}

/* "LSB;label=32;scalar=64": the order of the bytes, and the widths in bits. */
static void read_arch(struct poly_file *p, const char *arch)
{
    static const int one = 1;
    const char *const order = *(const char *)&one ? "LSB" : "MSB";
    const char *const label = strstr(arch, "label=");
    const char *const scalar = strstr(arch, "scalar=");

    if (label != NULL) p->label = atoi(label + 6) / 8;
    if (scalar != NULL) p->scalar = atoi(scalar + 7) / 8;
    if (strstr(arch, order) == NULL || (p->label != 4 && p->label != 8) ||
        (p->scalar != 4 && p->scalar != 8))
        poly_file_wrong(p,
                        "arch %s is not read, only %s with labels and scalars "
                        "of 32 or 64 bits; foamFormatConvert writes ascii",
                        arch, order);
}

/* Reads the header, FoamFile { format ascii; ... }, if there is one. */
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
        char value[POLY_WORD];
        poly_file_word(p, word);
        if (strcmp(word, "format") != 0 && strcmp(word, "arch") != 0 &&
            strcmp(word, "class") != 0)
            continue;
        poly_file_word(p, value);
        if (word[0] == 'a') read_arch(p, value);
        if (word[0] == 'c') p->is_compact = strstr(value, "Compact") != NULL;
        if (word[0] != 'f') continue;
        p->is_binary = strcmp(value, "binary") == 0;
        if (!p->is_binary && strcmp(value, "ascii") != 0)
            poly_file_wrong(p, "format %s is not read, only ascii and binary",
                            value);
    }
}

void poly_file_open(struct poly_file *p, struct inputs **files, const char *dir,
                    const char *name)
{
    *p = (struct poly_file){.line = 1, .label = 4, .scalar = 8};
    snprintf(p->path, sizeof p->path, "%s/%s.gz", dir, name);
    const int packed = access(p->path, F_OK) == 0;
    snprintf(p->path, sizeof p->path, "%s/%s", dir, name);
    if (packed && access(p->path, F_OK) != 0) strcat(p->path, ".gz");
    const struct input *const in =
        input_kept(files != NULL ? files : &p->own, p->path);
    const char *why = in->why;
    size_t size = in->length;
    p->text = in->text;
    if (p->text != NULL && input_is_packed(in))
        p->text = p->unpacked = input_unpacked(in, &size, &why);
    p->size = (long)size;
    if (p->text == NULL)
        poly_file_wrong(p, "cannot be read: %s", why);
    else
        read_header(p);
}

void poly_file_close(struct poly_file *p)
{
    input_forget(&p->own);
    free(p->unpacked);
    p->text = p->unpacked = NULL;
}
