/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/text/digits.h"

#include "case/scan.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A name, or a number with a point, an exponent or an L, is not whole. */
static int is_too_large(const char *word)
{
    const size_t n = strspn(word, "0123456789");
    char *end;
    long long value;

    if (n == 0 || scan_is_word(word[n])) return 0;
    errno = 0;
    value = strtoll(word, &end, 10);
    return errno == ERANGE || value > INT_MAX;
}

const char *digits_find(const char *text, int *line)
{
    *line = 1;
    while (*text != '\0') {
        const char *const next = scan_next(text);

        if (is_too_large(text)) return text;
        for (; text < next; text++)
            *line += *text == '\n';
    }
    return NULL;
}

int digits_check(const char *file, const char *text)
{
    int line;
    const char *const found = digits_find(text, &line);

    if (found == NULL) return 0;
    fprintf(stderr,
            "winnow: %s:%d: %.*s is too large for a whole number, at most "
            "%d; a real one has a point or an exponent\n",
            file, line, (int)strspn(found, "0123456789"), found, INT_MAX);
    return 2;
}
