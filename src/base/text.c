/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* Bytes of the control character that begins here, or 0. Terminals take some of
 * U+0080 to U+009F for the start of an escape code. */
static size_t control_length(const char *text)
{
    const unsigned char *const c = (const unsigned char *)text;

    if (c[0] == 0xc2 && c[1] >= 0x80 && c[1] <= 0x9f) return 2;
    return (c[0] < 0x20 && c[0] != '\0') || c[0] == 0x7f;
}

const char *text_control(const char *text)
{
    while (*text != '\0' && control_length(text) == 0)
        text++;
    return *text != '\0' ? text : NULL;
}

void text_blank(char *text)
{
    for (; *text != '\0'; text++)
        memset(text, ' ', control_length(text));
}

int text_wrong(const char *path, int line, const char *format, ...)
{
    char message[1024], where[16] = "";
    va_list values;

    va_start(values, format);
    vsnprintf(message, sizeof message, format, values);
    va_end(values);
    text_blank(message);
    if (line > 0) snprintf(where, sizeof where, ":%d", line);
    fprintf(stderr, "winnow: %s%s: %s\n", path, where, message);
    return 1;
}

/* How a target quotes. */
static const struct quoting {
    const char *around;        /* quote before and behind, "" for none */
    const char *plain;         /* a text of these alone needs no quote */
    const char *written[5][2]; /* a character, and what stands for it */
} quotings[] = {
    [TEXT_PLAIN] = {"", NULL, {{NULL}}},
    [TEXT_SHELL] = {"'",
                    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                    "0123456789_./,=+-",
                    {{"'", "'\\''"}}},
    [TEXT_GNUPLOT] = {"\"", NULL, {{NULL}}},
    [TEXT_DATA] = {"\"", NULL, {{"\"", "'"}}},
    /* LAMMPS goes on reading behind & and after three quotes. */
    [TEXT_LAMMPS] = {"", NULL, {{"&", "+"}, {"\"", "'"}}},
    [TEXT_CASE] = {"\"", NULL, {{"\"", "\\\""}, {"\\", "\\\\"}}},
    [TEXT_CSV] = {"\"", NULL, {{"\"", "\"\""}}},
    [TEXT_PAGE] = {"", NULL, {{"&", "&amp;"}, {"<", "&lt;"}, {"|", "\\|"}}},
    [TEXT_XML] = {
        "",
        NULL,
        {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}}}};

/* Within gnuplot's double quotes all but these and letters may have a meaning,
 * and is written as an octal code. */
static int is_octal(char c, enum text_target target)
{
    return target == TEXT_GNUPLOT && (unsigned char)c < 0x80 &&
           !isalnum((unsigned char)c) && strchr(" .,:;()-+=/", c) == NULL;
}

static void put_character(FILE *out, char c, const struct quoting *q)
{
    for (int i = 0; i < 5 && q->written[i][0] != NULL; i++)
        if (c == *q->written[i][0]) {
            fputs(q->written[i][1], out);
            return;
        }
    fputc(c, out);
}

void text_put(FILE *out, const char *text, enum text_target target)
{
    const struct quoting *const q = &quotings[target];
    const int bare = target == TEXT_CSV
                         ? strpbrk(text, ",\"") == NULL
                         : q->plain != NULL && *text != '\0' &&
                               text[strspn(text, q->plain)] == '\0';

    if (!bare) fputs(q->around, out);
    for (; *text != '\0'; text++) {
        const size_t control = control_length(text);
        if (control == 0 && is_octal(*text, target))
            fprintf(out, "\\%03o", (unsigned)*text);
        else
            put_character(out, control > 0 ? ' ' : *text, q);
        text += control > 1;
    }
    if (!bare) fputs(q->around, out);
}

void text_line(const char *name, double value, const char *unit,
               const char *remark)
{
    printf("  %-38s %10.4g %-4s %s\n", name, value, unit, remark);
}

const char *texts_add(struct texts *t, const char *format, ...)
{
    va_list values;
    char *text;
    size_t length;
    FILE *const out = open_memstream(&text, &length);

    va_start(values, format);
    vfprintf(out, format, values);
    va_end(values);
    fclose(out);
    t->text = realloc(t->text, ((size_t)t->n + 2) * sizeof *t->text);
    if (t->text == NULL) exit(4);
    t->text[t->n] = text;
    t->text[++t->n] = NULL;
    return text;
}

void texts_free(struct texts *t)
{
    for (int i = 0; i < t->n; i++)
        free(t->text[i]);
    free(t->text);
    *t = (struct texts){0};
}

/* --- nearest -------------------------------------------------------------- */

static int min(int a, int b)
{
    return a < b ? a : b;
}

/* Upper and lower case count as equal. */
static int nearest_is_same(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* Rows of the table of distances between beginnings of a and b: the one being
 * filled and the two before it, which swapped letters look back to. */
int nearest_edits(const char *a, const char *b)
{
    const int n = (int)strlen(a), m = (int)strlen(b);
    int row[3][NEAREST_TEXT] = {{0}};

    if (n >= NEAREST_TEXT || m >= NEAREST_TEXT) return NEAREST_TEXT;
    for (int j = 0; j <= m; j++)
        row[0][j] = j;
    for (int i = 1; i <= n; i++) {
        int *const now = row[i % 3];
        const int *const last = row[(i + 2) % 3];
        const int *const before = row[(i + 1) % 3];

        now[0] = i;
        for (int j = 1; j <= m; j++) {
            const int same = nearest_is_same(a[i - 1], b[j - 1]);
            now[j] = min(last[j - 1] + !same, 1 + min(last[j], now[j - 1]));
            if (i > 1 && j > 1 && nearest_is_same(a[i - 1], b[j - 2]) &&
                nearest_is_same(a[i - 2], b[j - 1]))
                now[j] = min(now[j], before[j - 2] + 1);
        }
    }
    return row[n % 3][m];
}

/* A third of the word may be wrong, and always one letter of two. */
static int limit(const char *word)
{
    const int n = (int)strlen(word);
    return n < 2 ? 0 : 1 + (n - 1) / 3;
}

void nearest_init(struct nearest *n, const char *wanted)
{
    n->wanted = wanted;
    n->edits = strlen(wanted) < NEAREST_TEXT ? limit(wanted) + 1 : 0;
    n->best[0] = '\0';
}

void nearest_offer(struct nearest *n, const char *known)
{
    const size_t length = strlen(n->wanted);
    const int begins = length > 2 && strncmp(n->wanted, known, length) == 0;
    const int edits = begins ? 1 : nearest_edits(n->wanted, known);

    if (edits < n->edits && strlen(known) < NEAREST_TEXT) {
        n->edits = edits;
        strcpy(n->best, known);
    }
}

const char *nearest_best(const struct nearest *n)
{
    return n->best[0] != '\0' ? n->best : NULL;
}

const char *nearest_hint(const char *name, const char *other,
                         char text[NEAREST_HINT])
{
    if (name == NULL) return other;
    snprintf(text, NEAREST_HINT, "; did you mean %s?", name);
    return text;
}
