/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/xml.h"

#include <string.h>

static const struct entity {
    char letter;
    const char *name;
} entities[] = {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};

enum { N_ENTITIES = sizeof entities / sizeof entities[0] };

static void put_letter(FILE *out, char letter)
{
    for (int i = 0; i < N_ENTITIES; i++)
        if (letter == entities[i].letter) {
            fputs(entities[i].name, out);
            return;
        }
    fputc(letter, out);
}

void xml_put(FILE *out, const char *text)
{
    for (const char *p = text; *p; p++)
        put_letter(out, *p);
}

/* Reads one character at *p and moves *p past it. */
static char read_letter(const char **p)
{
    for (int i = 0; i < N_ENTITIES; i++) {
        const size_t length = strlen(entities[i].name);
        if (strncmp(*p, entities[i].name, length) == 0) {
            *p += length;
            return entities[i].letter;
        }
    }
    return *(*p)++;
}

/* Where the value of the attribute begins, or NULL. */
static const char *value_of(const char *line, const char *attribute)
{
    const size_t length = strlen(attribute);

    for (const char *p = strstr(line, attribute); p;
         p = strstr(p + 1, attribute))
        if (p > line && p[-1] == ' ' && strncmp(p + length, "=\"", 2) == 0)
            return p + length + 2;
    return NULL;
}

int xml_attribute(const char *line, const char *attribute, char *value,
                  size_t size)
{
    const char *p = value_of(line, attribute);
    size_t n = 0;

    while (p && *p && *p != '"' && n + 1 < size)
        value[n++] = read_letter(&p);
    value[n] = '\0';
    return p == NULL || *p != '"';
}
