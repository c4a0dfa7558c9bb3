/* vtk_read.h -- a reader of our own, for what the writer should have written.
 */
#ifndef VTK_READ_H
#define VTK_READ_H

#include <stdint.h>
#include <stdlib.h>
#include <zlib.h>

#include "scratch.h"

/* A file taken apart: its XML, and the bytes behind the "_". */
struct parts {
    char *text;
    const unsigned char *bytes, *end;
};

static inline struct parts parts_of(const char *path)
{
    size_t size = 0;
    struct parts p = {.text = scratch_read(path, &size)};
    static const char close[] = "\n</AppendedData>\n</VTKFile>\n";
    static const char open[] = "<AppendedData encoding=\"raw\">\n_";

    ck_assert_ptr_nonnull(p.text);
    char *const appended = strstr(p.text, open);
    ck_assert_ptr_nonnull(appended);
    p.bytes = (const unsigned char *)appended + strlen(open);
    p.end = (const unsigned char *)p.text + size - strlen(close);
    ck_assert_str_eq((const char *)p.end, close);
    return p;
}

/* The words of a header: bytes need not be aligned. */
static inline uint64_t word(const unsigned char *p, uint64_t i)
{
    uint64_t w;
    memcpy(&w, p + 8 * i, 8);
    return w;
}

static inline const char *element_of(const struct parts *p, const char *name)
{
    char wanted[128];

    snprintf(wanted, sizeof wanted, "Name=\"%s\"", name);
    const char *const at = strstr(p->text, wanted);
    ck_assert_msg(at != NULL, "no array %s", name);
    return at;
}

/* All bytes of an array, decompressed; *next is where its bytes end. */
static inline unsigned char *array_of(const struct parts *p, const char *name,
                                      size_t *size, const unsigned char **next)
{
    const char *const offset = strstr(element_of(p, name), "offset=\"") + 8;
    const size_t digits = strspn(offset, "0123456789");
    const unsigned char *const head = p->bytes + atoll(offset);
    const uint64_t n = word(head, 0), full = word(head, 1);
    const uint64_t last = word(head, 2);
    const unsigned char *packed = head + 8 * (3 + n);
    unsigned char *const plain = malloc((size_t)(n * full) + 1);

    /* Some readers look for the number without zeros before it. */
    ck_assert(offset[digits] == '"' && (digits == 1 || offset[0] != '0'));
    *size = 0;
    for (uint64_t i = 0; i < n; i++) {
        uLongf room = full;
        const uLong length = (uLong)word(head, 3 + i);
        ck_assert_int_eq(uncompress(plain + *size, &room, packed, length),
                         Z_OK);
        ck_assert_uint_eq(room, i == n - 1 && last ? last : full);
        *size += room;
        packed += length;
    }
    *next = packed;
    return plain;
}

#endif
