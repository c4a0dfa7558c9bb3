/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/texts.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

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
