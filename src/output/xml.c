/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/xml.h"

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
