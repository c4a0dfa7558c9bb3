/* mutate.h -- texts changed a little, in the ways that break readers of files.
 *
 * Knows nothing of what it changes, but that files are made of bytes, words,
 * numbers and lines. The generator is an argument: the same seed makes the
 * same changes.
 */
#ifndef MUTATE_H
#define MUTATE_H

#include <ctype.h>
#include <gsl/gsl_rng.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MUTATE_MOST = 1 << 19 }; /* bytes of a text; none grows beyond */

struct text {
    char *byte; /* n of them and a zero */
    size_t n;
};

static const char *const mutate_numbers[] = {
    "0",          "-1",          "1",           "2",
    "0.0",        "-0.0",        "1e300",       "-1e300",
    "1e-300",     "1e308",       "4.9e-324",    "nan",
    "inf",        "-inf",        "1e999",       "2147483647",
    "2147483648", "-2147483648", "4294967296",  "9223372036854775807",
    "65536",      "1000000000",  "0x7fffffffL", "1e9",
    "1e10",       "1e-9",        "0.5",         "99999999999999999999"};

static const char *const mutate_words[] = {"",
                                           " ",
                                           "{",
                                           "}",
                                           "(",
                                           ")",
                                           "[",
                                           "]",
                                           ";",
                                           "=",
                                           "\"",
                                           ",",
                                           ".",
                                           "..",
                                           "/",
                                           "\\",
                                           "#",
                                           "//",
                                           "/*",
                                           "*/",
                                           "\r\n",
                                           "\n",
                                           "{}",
                                           "()",
                                           "[]",
                                           "[0.0, 0.0, 0.0]",
                                           "[1e300, -1e300, nan]",
                                           "[1, 1, 1]",
                                           "true",
                                           "\"\"",
                                           "\"\\x00\"",
                                           "@include \"case.cfg\"\n",
                                           "@include \".\"\n",
                                           "%s%n",
                                           "-s",
                                           "-j",
                                           "-o",
                                           "--quiet",
                                           "--",
                                           "-",
                                           "\xff",
                                           "\xef\xbb\xbf",
                                           "auto",
                                           "cyclic",
                                           "none",
                                           "((0.0, 1.0), (1.0, 2.0))"};

#define MUTATE_ANY(list, r)                                                    \
    ((list)[mutate_below(r, sizeof(list) / sizeof *(list))])

/* A number below n, 0 if n is 0. */
static inline size_t mutate_below(gsl_rng *r, size_t n)
{
    return n > 0 ? gsl_rng_uniform_int(r, n) : 0;
}

static inline struct text text_of(const void *byte, size_t n)
{
    struct text t = {malloc(n + 1), n};

    memcpy(t.byte, byte, n);
    t.byte[n] = '\0';
    return t;
}

/* Puts m bytes in the place of those from `at` to `end`. */
static inline void text_replace(struct text *t, size_t at, size_t end,
                                const void *byte, size_t m)
{
    if (t->n + m > MUTATE_MOST) return;
    struct text new = {malloc(t->n - (end - at) + m + 1), 0};

    new.n = t->n - (end - at) + m;
    memcpy(new.byte, t->byte, at);
    memcpy(new.byte + at, byte, m);
    memcpy(new.byte + at + m, t->byte + end, t->n - end);
    new.byte[new.n] = '\0';
    free(t->byte);
    *t = new;
}

static inline int mutate_is_word(char c)
{
    return isalnum((unsigned char)c) || strchr("_.+-", c) != NULL;
}

/* The ends of a word near a random place, a number if asked for; an empty one
 * where there is none. */
static inline void mutate_word(const struct text *t, gsl_rng *r, int number,
                               size_t *at, size_t *end)
{
    *at = mutate_below(r, t->n + 1);
    for (int turn = 0; turn < 400 && *at < t->n; turn++, ++*at)
        if (number ? isdigit((unsigned char)t->byte[*at])
                   : t->byte[*at] != '\0' && mutate_is_word(t->byte[*at]))
            break;
    *end = *at;
    while (*at > 0 && t->byte[*at - 1] != '\0' &&
           mutate_is_word(t->byte[*at - 1]))
        --*at;
    while (*end < t->n && t->byte[*end] != '\0' &&
           mutate_is_word(t->byte[*end]))
        ++*end;
}

static inline void mutate_line(const struct text *t, gsl_rng *r, size_t *at,
                               size_t *end)
{
    *at = *end = mutate_below(r, t->n + 1);
    while (*at > 0 && t->byte[*at - 1] != '\n')
        --*at;
    while (*end < t->n && t->byte[*end] != '\n')
        ++*end;
    *end += *end < t->n;
}

/* --- one change each ------------------------------------------------------ */

static inline void change_bytes(struct text *t, gsl_rng *r)
{
    static const char nasty[] = "\0\n\r\t\"\\{}()[];,=.-+eE09#/@\x7f\x80\xff";
    const size_t at = mutate_below(r, t->n + 1);
    const size_t gone = at < t->n ? mutate_below(r, 2) : 0;
    const char c = mutate_below(r, 2) ? nasty[mutate_below(r, sizeof nasty - 1)]
                                      : (char)mutate_below(r, 256);

    text_replace(t, at, at + gone, &c, mutate_below(r, 4) ? 1 : 0);
}

/* Four bytes as a whole number or a float of a binary file. */
static inline void change_four(struct text *t, gsl_rng *r)
{
    static const unsigned nasty[] = {0,          1,          0xffffffff,
                                     0x7fffffff, 0x80000000, 0x7f800000,
                                     0x7fc00000, 0x7f7fffff, 0x00000001};
    const size_t at = mutate_below(r, t->n > 4 ? t->n - 3 : 0);
    const unsigned x = MUTATE_ANY(nasty, r);

    if (t->n >= 4) text_replace(t, at, at + 4, &x, 4);
}

/* A nasty number in the place of one, or the same a thousand times larger or
 * smaller, or a little so. */
static inline void change_number(struct text *t, gsl_rng *r)
{
    static const double by[] = {1e-3, 0.1, 0.5, 0.999999, 1.000001, 2, 10, 1e3};
    const double factor = MUTATE_ANY(by, r);
    const char *const nasty = MUTATE_ANY(mutate_numbers, r);
    char scaled[40];
    size_t at, end;

    mutate_word(t, r, 1, &at, &end);
    snprintf(scaled, sizeof scaled, "%.9g",
             factor * strtod(t->byte + at, NULL));
    const char *const new = mutate_below(r, 2) ? nasty : scaled;
    text_replace(t, at, end, new, strlen(new));
}

static inline void change_word(struct text *t, gsl_rng *r)
{
    const char *const nasty = MUTATE_ANY(mutate_words, r);
    size_t at, end;

    mutate_word(t, r, 0, &at, &end);
    if (mutate_below(r, 2)) end = at;
    text_replace(t, at, end, nasty, strlen(nasty));
}

/* One word to the place of another, of the same text or of other's. */
static inline void change_words(struct text *t, const struct text *other,
                                gsl_rng *r)
{
    size_t at, end, from, to;

    mutate_word(t, r, 0, &at, &end);
    mutate_word(other, r, 0, &from, &to);
    text_replace(t, at, end, other->byte + from, to - from);
}

static inline void change_lines(struct text *t, const struct text *other,
                                gsl_rng *r)
{
    const size_t what = mutate_below(r, 3);
    size_t at, end, from, to;

    mutate_line(t, r, &at, &end);
    mutate_line(other, r, &from, &to);
    text_replace(t, at, what == 0 ? at : end, other->byte + from,
                 what == 2 ? 0 : to - from);
}

static inline void change_end(struct text *t, gsl_rng *r)
{
    text_replace(t, mutate_below(r, t->n + 1), t->n, "", 0);
}

/* A piece many times over: long words, deep nesting. */
static inline void change_length(struct text *t, gsl_rng *r)
{
    static const char *const pieces[] = {"a",  "9", "(",  "[",  "a={",
                                         "((", " ", "0.", "x.", "\n",
                                         "\"", "/", "1 "};
    static const size_t many[] = {40, 64, 256, 300, 1024, 5000, 70000};
    const char *const piece = MUTATE_ANY(pieces, r);
    const size_t n = MUTATE_ANY(many, r), m = strlen(piece);
    char *const all = malloc(n * m);
    size_t at, end;

    for (size_t i = 0; i < n; i++)
        memcpy(all + i * m, piece, m);
    mutate_word(t, r, 0, &at, &end);
    text_replace(t, end, end, all, n * m);
    free(all);
}

/* The habits of other systems: a mark at the beginning, other line ends. */
static inline void change_system(struct text *t, gsl_rng *r)
{
    if (mutate_below(r, 2)) text_replace(t, 0, 0, "\xef\xbb\xbf", 3);
    for (size_t i = 0; i < t->n && t->n < 10000; i++)
        if (t->byte[i] == '\n') text_replace(t, i, i, "\r", 1), i++;
}

/* One change of a text; other is a text of the same kind, perhaps the same. */
static inline void mutate(struct text *t, const struct text *other, gsl_rng *r)
{
    switch (mutate_below(r, 16)) {
    case 0:
    case 1:
        change_bytes(t, r);
        break;
    case 2:
        change_four(t, r);
        break;
    case 3:
        change_end(t, r);
        break;
    case 4:
        change_length(t, r);
        break;
    case 5:
        change_system(t, r);
        break;
    case 6:
    case 7:
        change_lines(t, other, r);
        break;
    case 8:
    case 9:
        change_words(t, other, r);
        break;
    case 10:
    case 11:
        change_word(t, r);
        break;
    default:
        change_number(t, r);
    }
}

#endif
