/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/triangles.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"
#include "base/vector.h"

enum { HEAD = 80, RECORD = 50, WORD = 64, MOST = 50000000 };

/* The whole file in memory, ended by a zero byte, and where we are in it. */
struct source {
    const struct input *file;
    const char *text;
    size_t length;
    const char *at;
    int line;
};

#define stl_wrong(in, ...) input_refuse((in)->file, (in)->line, __VA_ARGS__)

/* One more triangle, unless it has no area. */
static void stl_add(struct stl *s, int *room, double corner[3][3])
{
    double n[3];

    triangle_normal((const double(*)[3])corner, n);
    if (!(vector_length(n) > 0.5)) {
        s->dropped++;
        return;
    }
    s->corner = alloc_room(s->corner, s->n, room, sizeof *s->corner);
    memcpy(s->corner[s->n++], corner, sizeof *s->corner);
}

/* --- binary --------------------------------------------------------------- */

/* Little-endian, whatever this machine is. */
static uint32_t four_bytes(const char *p)
{
    const unsigned char *const b = (const unsigned char *)p;

    return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 |
           (uint32_t)b[3] << 24;
}

static double float_at(const char *p)
{
    const uint32_t bits = four_bytes(p);
    float x;

    memcpy(&x, &bits, sizeof x);
    return (double)x;
}

static double announced(const struct source *in)
{
    return in->length < HEAD + 4 ? -1.0 : (double)four_bytes(in->text + HEAD);
}

static int is_binary(const struct source *in)
{
    return (double)in->length == HEAD + 4 + RECORD * announced(in);
}

/* Twelve numbers, the normal first, and two unused bytes. */
static int read_binary(struct source *in, struct stl *s)
{
    const int n = number_clamped(announced(in), 0, MOST);
    int room = 0;

    for (int t = 0; t < n; t++) {
        const char *const record = in->text + HEAD + 4 + (size_t)t * RECORD;
        double corner[3][3];
        for (int k = 0; k < 9; k++) {
            corner[k / 3][k % 3] = float_at(record + 12 + 4 * k);
            if (!isfinite(corner[k / 3][k % 3]))
                return stl_wrong(
                    in, "corner %d of triangle %d (byte %zu) is not a number",
                    k / 3, t, HEAD + 4 + (size_t)t * RECORD);
        }
        stl_add(s, &room, corner);
    }
    return 0;
}

/* --- text ----------------------------------------------------------------- */

/* The next word; "" at the end; of a long one its first WORD - 1 letters. */
static void next_word(struct source *in, char word[WORD])
{
    size_t n = 0;

    for (; isspace((unsigned char)*in->at); in->at++)
        in->line += *in->at == '\n';
    while (in->at[n] != '\0' && !isspace((unsigned char)in->at[n]))
        n++;
    snprintf(word, WORD, "%.*s", (int)(n < WORD ? n : WORD - 1), in->at);
    in->at += n;
}

static int expect(struct source *in, const char *what)
{
    char word[WORD];

    next_word(in, word);
    if (strcasecmp(word, what) == 0) return 0;
    return stl_wrong(
        in, "expected \"%s\", found %s%s%s", what, word[0] ? "\"" : "",
        word[0] ? word : "the end of the file", word[0] ? "\"" : "");
}

static int three_numbers(struct source *in, double x[3])
{
    for (int k = 0; k < 3; k++) {
        char word[WORD], *end;
        next_word(in, word);
        x[k] = strtod(word, &end);
        if (word[0] == '\0' || *end != '\0' || !isfinite(x[k]) ||
            strlen(word) == WORD - 1)
            return stl_wrong(
                in, "expected a number, found %s%s%s", word[0] ? "\"" : "",
                word[0] ? word : "the end of the file", word[0] ? "\"" : "");
    }
    return 0;
}

/* From behind "facet" to its end. The normal may be anything, even "nan". */
static int read_facet(struct source *in, struct stl *s, int *room)
{
    double corner[3][3];
    char word[WORD];

    if (expect(in, "normal") != 0) return 1;
    for (int k = 0; k < 3; k++)
        next_word(in, word);
    if (expect(in, "outer") != 0 || expect(in, "loop") != 0) return 1;
    for (int c = 0; c < 3; c++)
        if (expect(in, "vertex") != 0 || three_numbers(in, corner[c]) != 0)
            return 1;
    stl_add(s, room, corner);
    return expect(in, "endloop") != 0 || expect(in, "endfacet") != 0;
}

static int stl_read_text(struct source *in, struct stl *s)
{
    int room = 0, open = 0;
    char word[WORD];

    in->line = 1;
    for (next_word(in, word); word[0] != '\0'; next_word(in, word)) {
        const int solid = strcasecmp(word, "solid") == 0;
        if (open && strcasecmp(word, "facet") == 0) {
            if (read_facet(in, s, &room) != 0) return 1;
        } else if (solid != open &&
                   (solid || strcasecmp(word, "endsolid") == 0)) {
            open = solid;
            in->at += strcspn(in->at, "\n"); /* a name may have spaces */
        } else {
            return stl_wrong(in, "expected %s, found \"%s\"",
                             open ? "\"facet\" or \"endsolid\"" : "\"solid\"",
                             word);
        }
    }
    return open ? stl_wrong(in, "the file ends before \"endsolid\"") : 0;
}

/* --- both ----------------------------------------------------------------- */

static int begins_with_solid(const struct source *in)
{
    const char *p = in->text;

    while (isspace((unsigned char)*p))
        p++;
    return strncasecmp(p, "solid", 5) == 0;
}

static int read_either(struct source *in, struct stl *s)
{
    if (is_binary(in)) {
        if (announced(in) > MOST)
            return stl_wrong(in, "%.0f triangles are more than the %d that fit",
                             announced(in), MOST);
        return read_binary(in, s);
    }
    if (begins_with_solid(in)) return stl_read_text(in, s);
    if (in->length < HEAD + 4)
        return stl_wrong(in, "not an STL file: neither \"solid\" nor the 84 "
                             "bytes of a binary header");
    return stl_wrong(in,
                     "not an STL file, or truncated: its header announces %.0f "
                     "triangles, which make %.0f bytes; it has %zu",
                     announced(in), HEAD + 4 + RECORD * announced(in),
                     in->length);
}

int stl_parse(const struct input *file, struct stl *s)
{
    struct source in = {.file = file,
                        .text = file->text,
                        .at = file->text,
                        .length = file->length};

    *s = (struct stl){0, NULL, 0};
    int failed = in.text == NULL
                     ? stl_wrong(&in, "cannot be read: %s", file->why)
                     : read_either(&in, s);
    in.line = 0;
    if (!failed && s->n == 0)
        failed = stl_wrong(&in, "there is no triangle%s in it",
                           s->dropped > 0 ? " with an area" : "");
    if (failed) stl_release(s);
    return failed;
}

void stl_release(struct stl *s)
{
    free(s->corner);
    *s = (struct stl){0, NULL, 0};
}
