/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/vtk.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"

#include <assert.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

/* --- the numbers of an array ---------------------------------------------- */

static int vtk_array_is_real(const struct vtk_array *a)
{
    return a->values != NULL || a->split[0] != NULL;
}

const char *vtk_array_type(const struct vtk_array *a)
{
    if (a->bytes != NULL || a->same) return "UInt8";
    if (!vtk_array_is_real(a)) return "Int32";
    return a->single ? "Float32" : "Float64";
}

/* Bytes of one number in the file. */
static size_t vtk_array_width(const struct vtk_array *a)
{
    if (a->bytes != NULL || a->same) return 1;
    return vtk_array_is_real(a) && !a->single ? 8 : 4;
}

/* Number v of the array: component v % components of point v / components. */
static double real_at(const struct vtk_array *a, size_t v)
{
    const size_t components = (size_t)a->components;

    return a->values ? a->values[v] : a->split[v % components][v / components];
}

static void copy_whole(const struct vtk_array *a, size_t first, size_t n,
                       int *out)
{
    for (size_t v = 0; v < n; v++)
        out[v] = a->ints ? a->ints[first + v] : a->from + (int)(first + v);
}

/* Copies n numbers from number `first` on, in the type of the file. */
static void vtk_array_copy(const struct vtk_array *a, size_t first, size_t n,
                           void *bytes)
{
    double *const wide = bytes;
    float *const narrow = bytes;

    assert(a->values != NULL || a->split[0] == NULL || a->components <= 3);
    if (a->same)
        memset(bytes, a->from, n);
    else if (a->bytes != NULL)
        memcpy(bytes, a->bytes + first, n);
    else if (!vtk_array_is_real(a))
        copy_whole(a, first, n, bytes);
    else if (a->single)
        for (size_t v = 0; v < n; v++)
            narrow[v] = (float)real_at(a, first + v);
    else
        for (size_t v = 0; v < n; v++)
            wide[v] = real_at(a, first + v);
}

/* --- the bytes of one array, compressed by zlib in blocks.
 *
 * The format that VTK reads after <AppendedData> (every word a UInt64):
 *
 *     number of blocks
 *     size of a full block, before compression
 *     size of the last block if it is not full, else 0
 *     size of each block, after compression
 *     the compressed blocks
 *
 * A block is compressed lightly (level 1). If a sample of it shrinks by less
 * than a tenth, as those of particle velocities do, it is stored as it is
 * (zlib's level 0), which takes a tenth of the time. */

/* Full block, before compression, and the sample in its middle [bytes]. */
enum { VTK_BLOCK = 65536, VTK_SAMPLE = 4096 };

/* A stored block grows by some bytes for every 16 KiB; zlib's own bound for
 * 64 KiB is well below this. */
enum { PACKED_ROOM = VTK_BLOCK + VTK_BLOCK / 8 };

struct vtk_blocks {
    unsigned char plain[VTK_BLOCK];
    unsigned char packed[PACKED_ROOM];
    uint64_t *size; /* [bytes] of each block of the array, compressed */
    size_t n_size;  /* capacity of size; grows with the largest array */
    z_stream light, stored;
};

static void *room_for_zlib(void *unused, unsigned n, unsigned size)
{
    (void)unused;
    return alloc_zeroed(n, size);
}

static void free_for_zlib(void *unused, void *p)
{
    (void)unused;
    free(p);
}

static void compressor_init(z_stream *z, int level)
{
    z->zalloc = room_for_zlib;
    z->zfree = free_for_zlib;
    if (deflateInit(z, level) != Z_OK) {
        fprintf(stderr, "winnow: zlib %s does not start\n", zlibVersion());
        exit(4);
    }
}

/* Makes the list of block sizes long enough for n. */
static void vtk_blocks_make_room(struct vtk_blocks *b, size_t n)
{
    if (n <= b->n_size) return;
    free(b->size);
    b->size = alloc_zeroed(2 * n, sizeof b->size[0]);
    b->n_size = 2 * n;
}

static struct vtk_blocks *vtk_blocks_create(void)
{
    struct vtk_blocks *const b = alloc_zeroed(1, sizeof *b);

    compressor_init(&b->light, 1);
    compressor_init(&b->stored, 0);
    assert(deflateBound(&b->stored, VTK_BLOCK) <= PACKED_ROOM);
    assert(deflateBound(&b->light, VTK_BLOCK) <= PACKED_ROOM);
    vtk_blocks_make_room(b, 16);
    return b;
}

static void vtk_blocks_free(struct vtk_blocks *b)
{
    deflateEnd(&b->light);
    deflateEnd(&b->stored);
    free(b->size);
    free(b);
}

/* So many bytes of b->plain to b->packed; returns the compressed size [bytes].
 */
static size_t vtk_blocks_pack(struct vtk_blocks *b, z_stream *z, size_t first,
                              size_t bytes)
{
    deflateReset(z);
    z->next_in = b->plain + first;
    z->avail_in = (unsigned)bytes;
    z->next_out = b->packed;
    z->avail_out = PACKED_ROOM;
    const int done = deflate(z, Z_FINISH) == Z_STREAM_END;
    assert(done); /* the buffer was large enough */
    return done ? (size_t)z->total_out : 0;
}

/* The first bytes of b->plain; a short block is its own sample. */
static size_t vtk_blocks_pack_all(struct vtk_blocks *b, size_t bytes)
{
    const size_t sample = bytes < VTK_SAMPLE ? bytes : VTK_SAMPLE;
    const size_t packed =
        vtk_blocks_pack(b, &b->light, (bytes - sample) / 2, sample);

    if (sample == bytes) return packed;
    return vtk_blocks_pack(b, 10 * packed > 9 * sample ? &b->stored : &b->light,
                           0, bytes);
}

/* Writes n numbers of eight bytes. */
static void put_words(FILE *out, const uint64_t *word, size_t n)
{
    fwrite(word, sizeof word[0], n, out);
}

/* Writes the blocks behind a header that is not filled in yet. */
static void put_blocks(struct vtk_blocks *b, FILE *out,
                       const struct vtk_array *a, size_t n_values)
{
    const size_t per_block = VTK_BLOCK / vtk_array_width(a);

    for (size_t k = 0; k * per_block < n_values; k++) {
        const size_t first = k * per_block;
        const size_t left = n_values - first;
        const size_t n = left < per_block ? left : per_block;

        vtk_array_copy(a, first, n, b->plain);
        b->size[k] = vtk_blocks_pack_all(b, n * vtk_array_width(a));
        fwrite(b->packed, 1, (size_t)b->size[k], out);
    }
}

/* Writes the array of n points or cells at the present position of the stream,
 * in which an error remains set. */
static void vtk_blocks_write(struct vtk_blocks *b, FILE *out,
                             const struct vtk_array *a, int n)
{
    const size_t n_values = (size_t)n * (size_t)a->components;
    const size_t bytes = n_values * vtk_array_width(a);
    const size_t n_blocks = (bytes + VTK_BLOCK - 1) / VTK_BLOCK;
    const uint64_t head[3] = {n_blocks, VTK_BLOCK, bytes % VTK_BLOCK};

    vtk_blocks_make_room(b, n_blocks);
    put_words(out, head, 3);
    const off_t sizes = ftello(out);
    put_words(out, b->size, n_blocks);
    put_blocks(b, out, a, n_values);
    const off_t end = ftello(out);
    fseeko(out, sizes, SEEK_SET);
    put_words(out, b->size, n_blocks);
    fseeko(out, end, SEEK_SET);
}

/* --- the file ------------------------------------------------------------- */

/* Blanks for an offset and the quote after it: some readers look for the text
 * of the number, without zeros before it. */
enum { OFFSET = 17 };
/* An array whose bytes are still to be written. */
struct pending {
    struct vtk_array array;
    int n;    /* [-] points or cells */
    off_t at; /* [bytes] position of its offset in the file */
};

struct vtk_file {
    struct vtk_blocks *blocks;
    struct file *file;
    FILE *out;
    const char *kind;
    int n_pending;
    struct pending pending[VTK_FILE_ARRAYS];
};

struct vtk_file *vtk_file_create(void)
{
    struct vtk_file *const f = alloc_zeroed(1, sizeof *f);

    f->blocks = vtk_blocks_create();
    return f;
}

void vtk_file_free(struct vtk_file *f)
{
    if (f == NULL) return;
    vtk_blocks_free(f->blocks);
    free(f);
}

static const char *byte_order(void)
{
    const int one = 1;
    return *(const char *)&one ? "LittleEndian" : "BigEndian";
}

static void put_time(FILE *out, double time)
{
    char text[NUMBER_LENGTH];

    fprintf(out,
            "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" "
            "NumberOfTuples=\"1\" format=\"ascii\">%s</DataArray>\n"
            "</FieldData>\n",
            number_text(time, text));
}

int vtk_file_begin(struct vtk_file *f, const char *path, const char *kind,
                   const char *extent, double time)
{
    f->file = file_create(path);
    if (f->file == NULL) return 1;
    f->out = file_stream(f->file);
    f->kind = kind;
    f->n_pending = 0;
    fprintf(f->out,
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"%s\" version=\"1.0\" byte_order=\"%s\" "
            "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
            "<%s%s>\n",
            kind, byte_order(), kind, extent);
    put_time(f->out, time);
    return 0;
}

FILE *vtk_file_stream(struct vtk_file *f)
{
    return f->out;
}

void vtk_file_array(struct vtk_file *f, const struct vtk_array *a, int n)
{
    assert(f->n_pending < VTK_FILE_ARRAYS);
    assert(a->components >= 1 && a->components <= 9);
    struct pending *const next = &f->pending[f->n_pending++];

    fprintf(f->out, "<DataArray type=\"%s\" Name=\"", vtk_array_type(a));
    text_put(f->out, a->name, TEXT_XML);
    fprintf(f->out,
            "\" NumberOfComponents=\"%d\" format=\"appended\" offset=\"",
            a->components);
    *next = (struct pending){*a, n, ftello(f->out)};
    fprintf(f->out, "%*s/>\n", OFFSET, "");
}

/* VTK silently drops one of two arrays of the same name. */
static int names_differ(int n_arrays, const struct vtk_array *arrays)
{
    for (int i = 0; i < n_arrays; i++)
        for (int j = 0; j < i; j++)
            if (strcmp(arrays[i].name, arrays[j].name) == 0) return 0;
    return 1;
}

void vtk_file_section(struct vtk_file *f, const char *name, int n, int n_arrays,
                      const struct vtk_array *arrays)
{
    assert(names_differ(n_arrays, arrays));
    fprintf(f->out, "<%s>\n", name);
    for (int i = 0; i < n_arrays; i++)
        vtk_file_array(f, &arrays[i], n);
    fprintf(f->out, "</%s>\n", name);
}

int vtk_file_end(struct vtk_file *f)
{
    fprintf(f->out, "</%s>\n<AppendedData encoding=\"raw\">\n_", f->kind);
    const off_t start = ftello(f->out);

    for (int i = 0; i < f->n_pending; i++) {
        const struct pending *const a = &f->pending[i];
        const off_t here = ftello(f->out);

        fseeko(f->out, a->at, SEEK_SET);
        fprintf(f->out, "%lld\"", (long long)(here - start));
        fseeko(f->out, here, SEEK_SET);
        vtk_blocks_write(f->blocks, f->out, &a->array, a->n);
    }
    fprintf(f->out, "\n</AppendedData>\n</VTKFile>\n");
    return file_commit(f->file);
}
