/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/xml.h"

static const struct entity {
    char character;
    const char *name;
} entities[] = {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};

enum { N_ENTITIES = sizeof entities / sizeof entities[0] };

static void put_character(FILE *out, char c)
{
    for (int i = 0; i < N_ENTITIES; i++)
        if (c == entities[i].character) {
            fputs(entities[i].name, out);
            return;
        }
    fputc(c, out);
}

void xml_put(FILE *out, const char *text)
{
    for (const char *p = text; *p; p++)
        put_character(out, *p);
}
