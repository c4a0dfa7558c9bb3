/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/scan.h"

#include <ctype.h>
#include <string.h>

int scan_is_word(char c)
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

const char *scan_next(const char *t)
{
    const char *const next = skip(t);

    if (next != t || *t == '\0') return next;
    if (!scan_is_word(*t)) return t + 1;
    while (scan_is_word(*t))
        t++;
    return t;
}

void scan_mixed(char *text)
{
    char *open = NULL;
    int whole = 0, real = 0;

    for (; *text != '\0'; text += scan_next(text) - text) {
        const int n = (int)(scan_next(text) - text);
        if (*text == '[') {
            open = text;
            whole = real = 0;
        } else if (isdigit((unsigned char)*text) || *text == '.') {
            const int is_whole = (int)strcspn(text, ".eE") >= n;
            whole |= is_whole;
            real |= !is_whole;
        } else if (*text == ']' && open != NULL && whole && real) {
            *open = '(';
            *text = ')';
        }
    }
}
