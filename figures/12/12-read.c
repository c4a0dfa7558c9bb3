/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads one array of a file that Winnow wrote, with nothing but zlib.
 *
 *     sh figures/run.sh figures/12/12-read.c -- FILE.vtr pressure
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

static void die(const char *what)
{
    fprintf(stderr, "12-read: %s\n", what);
    exit(1);
}

/* The whole file, with a zero behind it. */
static char *contents(const char *path, size_t *size)
{
    FILE *const in = fopen(path, "rb");

    if (in == NULL) die("no such file");
    fseek(in, 0, SEEK_END);
    *size = (size_t)ftell(in);
    rewind(in);

    char *const text = calloc(*size + 1, 1);

    if (text == NULL || fread(text, 1, *size, in) != *size) die("cannot read");
    fclose(in);
    return text;
}

static uint64_t word(const unsigned char *p, size_t i)
{
    uint64_t w;

    memcpy(&w, p + 8 * i, 8);
    return w;
}

/* What stands behind name= in the element that begins at p. */
static const char *attribute(const char *p, const char *name)
{
    const char *const at = strstr(p, name);

    if (at == NULL) die("an attribute is missing");
    return at + strlen(name) + 2; /* ="  */
}

/* The blocks behind the header, unpacked one after the other. */
static unsigned char *unpacked(const unsigned char *head, size_t *size,
                               size_t *stored)
{
    const size_t n = (size_t)word(head, 0), full = (size_t)word(head, 1);
    unsigned char *const plain = calloc(n + 1, full);
    const unsigned char *packed = head + 8 * (3 + n);

    *size = 0;
    for (size_t k = 0; k < n; k++) {
        uLongf room = full;
        const uLong length = (uLong)word(head, 3 + k);

        if (uncompress(plain + *size, &room, packed, length) != Z_OK)
            die("a block is broken");
        *size += room;
        packed += length;
    }
    *stored = (size_t)(packed - head);
    return plain;
}

/* Number v; Float64 or Float32. */
static double real(const unsigned char *plain, int wide, size_t v)
{
    double x;
    float f;

    if (wide) {
        memcpy(&x, plain + 8 * v, 8);
        return x;
    }
    memcpy(&f, plain + 4 * v, 4);
    return (double)f;
}

int main(int argc, char **argv)
{
    size_t size, bytes, stored;
    char name[128];

    if (argc != 3) die("give a file and the name of an array");

    char *const text = contents(argv[1], &size);
    const char *const data = strstr(text, "<AppendedData");

    snprintf(name, sizeof name, "Name=\"%s\"", argv[2]);

    const char *const element = strstr(text, name);

    if (data == NULL || element == NULL) die("no such array");

    const char *const first = strchr(data, '_') + 1;
    const long offset = atol(attribute(element, "offset"));
    const char *type = element; /* stands before the name */

    while (strncmp(type, "type=", 5) != 0)
        type--;

    const int wide = strncmp(type, "type=\"Float64", 13) == 0;
    unsigned char *const plain =
        unpacked((const unsigned char *)first + offset, &bytes, &stored);
    const size_t n = bytes / (wide ? 8 : 4);
    double least = real(plain, wide, 0), most = least, sum = 0.0;

    for (size_t v = 0; v < n; v++) {
        const double x = real(plain, wide, v);

        least = x < least ? x : least;
        most = x > most ? x : most;
        sum += x;
    }
    printf("%s: %zu numbers, %zu bytes in %zu\n", argv[2], n, bytes, stored);
    printf("%s_least = %.6g\n%s_mean = %.15g\n%s_most = %.6g\n", argv[2], least,
           argv[2], sum / (double)n, argv[2], most);
    free(plain);
    free(text);
    return 0;
}
