/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/digits.h"

#include "base/alloc.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Past a string or a comment that begins here; else the same place. */
static const char *skip(const char *t)
{
    const char *end;

    if (*t == '"') {
        for (t++; *t != '\0' && *t != '"'; t++)
            if (*t == '\\' && t[1] != '\0') t++;
        return *t == '"' ? t + 1 : t;
    }
    if (*t == '#' || (t[0] == '/' && t[1] == '/')) return t + strcspn(t, "\n");
    if (t[0] == '/' && t[1] == '*') {
        end = strstr(t + 2, "*/");
        return end != NULL ? end + 2 : t + strlen(t);
    }
    return t;
}

/* Names, and numbers with point, exponent or L, are no plain whole numbers. */
static int is_part_of_word(char c)
{
    return isalnum((unsigned char)c) || c == '_' || c == '.';
}

static int is_too_large(const char *word)
{
    const size_t n = strspn(word, "0123456789");
    char *end;
    long long value;

    if (n == 0 || is_part_of_word(word[n])) return 0;
    errno = 0;
    value = strtoll(word, &end, 10);
    return errno == ERANGE || value > INT_MAX;
}

/* Past whatever begins here: a string, a comment, a word, one character. */
static const char *step(const char *t)
{
    const char *const next = skip(t);

    if (next != t) return next;
    if (!is_part_of_word(*t)) return t + 1;
    while (is_part_of_word(*t))
        t++;
    return t;
}

const char *digits_find(const char *text, int *line)
{
    *line = 1;
    while (*text != '\0') {
        const char *const next = step(text);

        if (is_too_large(text)) return text;
        for (; text < next; text++)
            *line += *text == '\n';
    }
    return NULL;
}

int digits_check_file(const char *file)
{
    FILE *const in = fopen(file, "r");
    struct stat info;
    const char *found;
    char *text;
    int line;

    if (in == NULL || fstat(fileno(in), &info) != 0) {
        fprintf(stderr, "winnow: %s: %s\n", file, strerror(errno));
        if (in != NULL) fclose(in);
        return 4;
    }
    text = alloc_zeroed((size_t)info.st_size + 1, 1);
    text[fread(text, 1, (size_t)info.st_size, in)] = '\0';
    fclose(in);
    found = digits_find(text, &line);
    if (found != NULL)
        fprintf(stderr,
                "winnow: %s:%d: %.*s is too large for a whole number; write "
                "it with a point or an exponent\n",
                file, line, (int)strspn(found, "0123456789"), found);
    free(text);
    return found != NULL ? 2 : 0;
}
