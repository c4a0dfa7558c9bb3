/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/page.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"

#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

static int open_inside(int folder, const char *name, int how)
{
    return openat(folder, name, how | O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
}

char *vtk_read_text(int folder, const char *name, size_t *length)
{
    const char *const slash = strchr(name, '/');
    char path[64] = "";
    const char *why;

    if (slash != NULL && (size_t)(slash - name) < sizeof path)
        memcpy(path, name, (size_t)(slash - name));
    const int below =
        slash != NULL ? open_inside(folder, path, O_DIRECTORY) : folder;
    const char *const last = slash != NULL ? slash + 1 : name;
    const int file =
        below < 0 || strchr(last, '/') != NULL || strcmp(path, "..") == 0
            ? -1
            : open_inside(below, last, O_NONBLOCK);

    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    char *const text = file < 0 ? NULL : input_text(path, length, &why);
    if (file >= 0) close(file);
    if (slash != NULL && below >= 0) close(below);
    return text;
}

int vtk_read_open(struct vtk_read *f, int folder, const char *name)
{
    static const char begin[] = "<AppendedData encoding=\"raw\">";

    *f = (struct vtk_read){0};
    f->text = vtk_read_text(folder, name, &f->length);
    const char *const at = f->text != NULL ? strstr(f->text, begin) : NULL;
    f->data = at != NULL ? strchr(at, '_') : NULL;
    if (f->data == NULL || strstr(f->text, "=\"LittleEndian\"") == NULL ||
        strstr(f->text, " header_type=\"UInt64\" compressor=\"vtkZLib") ==
            NULL) {
        vtk_read_close(f);
        return 1;
    }
    f->text[at - f->text] = '\0';
    f->data++;
    return 0;
}

void vtk_read_close(struct vtk_read *f)
{
    free(f->text);
    *f = (struct vtk_read){0};
}

/* The tag of an array, up to its end; NULL if there is none. */
static const char *tag_of(const struct vtk_read *f, const char *name)
{
    char quoted[80];

    snprintf(quoted, sizeof quoted, " Name=\"%s\"", name);
    for (const char *at = f->text; (at = strstr(at, "<DataArray ")) != NULL;
         at++) {
        const char *const end = strchr(at, '>'), *const found =
                                                     strstr(at, quoted);
        if (end == NULL) return NULL;
        if (found != NULL && found < end) return at;
    }
    return NULL;
}

/* What stands behind ATTRIBUTE=" in a tag; "" if it has none. */
static const char *vtk_read_attribute(const char *tag, const char *name)
{
    const char *const found = strstr(tag, name), *const end = strchr(tag, '>');
    return found != NULL && found < end ? found + strlen(name) : "";
}

static uint64_t vtk_word(const char *at)
{
    uint64_t w;
    memcpy(&w, at, sizeof w);
    return w;
}

/* The blocks at `at`, of which `left` bytes are there, unpacked. deflate makes
 * no more than 1032 bytes of one. */
static unsigned char *unpack_blocks(const char *at, size_t left, size_t *length)
{
    if (left < 24) return NULL;
    const uint64_t blocks = vtk_word(at), full = vtk_word(at + 8),
                   last = vtk_word(at + 16);
    if (blocks > (left - 24) / 8 || full > 1 << 24 || last > full) return NULL;
    const uint64_t size =
        blocks == 0 ? 0 : (blocks - 1) * full + (last > 0 ? last : full);
    if (size / 1032 > left || 10.0 * (double)size > alloc_left()) return NULL;
    unsigned char *const bytes = alloc_zeroed(size + 1, 1);
    size_t in = 24 + 8 * blocks;

    for (uint64_t k = 0; k < blocks; k++) {
        const uint64_t packed = vtk_word(at + 24 + 8 * k);
        uLongf room = k + 1 < blocks || last == 0 ? full : last;
        const uLongf whole = room;
        if (packed > left - in ||
            uncompress(bytes + k * full, &room, (const Bytef *)at + in,
                       packed) != Z_OK ||
            room != whole) {
            free(bytes);
            return NULL;
        }
        in += packed;
    }
    *length = size;
    return bytes;
}

/* Bytes of a number of the type that begins here; 0 for others. */
static size_t vtk_read_width(const char *type)
{
    return strncmp(type, "Float64\"", 8) == 0 ? 8
           : strncmp(type, "Float32\"", 8) == 0 ||
                   strncmp(type, "Int32\"", 6) == 0
               ? 4
           : strncmp(type, "UInt8\"", 6) == 0 ? 1
                                              : 0;
}

static double vtk_number(const unsigned char *at, const char *type)
{
    double wide;
    float narrow;
    int32_t whole;

    if (type[0] == 'U') return *at;
    if (type[0] == 'I') return memcpy(&whole, at, 4), whole;
    if (type[5] == '3') return (double)*(float *)memcpy(&narrow, at, 4);
    return *(double *)memcpy(&wide, at, 8);
}

double *vtk_read_array(const struct vtk_read *f, const char *name,
                       int components, size_t *n)
{
    const char *const tag = tag_of(f, name);
    const size_t all = f->length - (size_t)(f->data - f->text);

    *n = 0;
    if (tag == NULL) return NULL;
    const char *const type = vtk_read_attribute(tag, "type=\"");
    const size_t width = vtk_read_width(type);
    const unsigned long long offset =
        strtoull(vtk_read_attribute(tag, "offset=\""), NULL, 10);
    if (width == 0 || offset > all ||
        atoi(vtk_read_attribute(tag, "NumberOfComponents=\"")) != components)
        return NULL;
    size_t length = 0;
    unsigned char *const bytes =
        unpack_blocks(f->data + offset, all - offset, &length);
    if (bytes == NULL || length % (width * (size_t)components) != 0) {
        free(bytes);
        return NULL;
    }
    *n = length / width;
    double *const value = alloc_zeroed(*n, sizeof *value);
    for (size_t i = 0; i < *n; i++)
        value[i] = vtk_number(bytes + i * width, type);
    free(bytes);
    return value;
}

int vtk_read_shapes(struct vtk_shapes *s, const struct vtk_read *f)
{
    s->x = vtk_read_array(f, "position", 3, &s->n_x);
    s->corner = vtk_read_array(f, "connectivity", 1, &s->n_corner);
    s->end = vtk_read_array(f, "offsets", 1, &s->n);
    return s->x == NULL || s->corner == NULL || s->end == NULL;
}

void vtk_read_shapes_free(struct vtk_shapes *s)
{
    free(s->x);
    free(s->corner);
    free(s->end);
}

const double *vtk_read_corner(const struct vtk_shapes *s, size_t i, size_t q)
{
    const double first = i > 0 ? s->end[i - 1] : 0.0;
    const int at = number_clamped(first + (double)q, -1, INT_MAX);

    if (!(at >= 0 && at < s->end[i] && (size_t)at < s->n_corner)) return NULL;
    const int p = number_clamped(s->corner[at], -1, INT_MAX / 3 - 1);
    return p >= 0 && 3 * (size_t)p + 3 <= s->n_x ? s->x + 3 * p : NULL;
}
