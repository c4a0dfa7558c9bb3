/* SPDX-License-Identifier: GPL-3.0-or-later */
/* vtk_blocks.c -- the bytes of one array, compressed by zlib in blocks.
 *
 * The format that VTK reads after <AppendedData> (every word a UInt64):
 *
 *     number of blocks
 *     size of a full block, before compression
 *     size of the last block if it is not full, else 0
 *     size of each block, after compression
 *     the compressed blocks
 *
 * Once a block of an array shrinks by less than a tenth, as those of particle
 * velocities do, the following blocks are stored uncompressed (zlib's level 0);
 * until then they are compressed lightly (level 1).
 */
#include "output/compressed/vtk_blocks.h"

#include "base/alloc.h"

#include <assert.h>
#include <stdint.h>
#include <stdlib.h>
#include <zlib.h>

/* Full block, before compression [bytes]. */
enum { VTK_BLOCK = 65536 };

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

static void vtk_blocks_make_room(struct vtk_blocks *b, size_t n)
{
    if (n <= b->n_size) return;
    free(b->size);
    b->size = alloc_zeroed(2 * n, sizeof b->size[0]);
    b->n_size = 2 * n;
}

struct vtk_blocks *vtk_blocks_create(void)
{
    struct vtk_blocks *const b = alloc_zeroed(1, sizeof *b);

    compressor_init(&b->light, 1);
    compressor_init(&b->stored, 0);
    assert(deflateBound(&b->stored, VTK_BLOCK) <= PACKED_ROOM);
    assert(deflateBound(&b->light, VTK_BLOCK) <= PACKED_ROOM);
    vtk_blocks_make_room(b, 16);
    return b;
}

void vtk_blocks_free(struct vtk_blocks *b)
{
    deflateEnd(&b->light);
    deflateEnd(&b->stored);
    free(b->size);
    free(b);
}

/* b->plain to b->packed; returns the compressed size [bytes]. */
static size_t vtk_blocks_pack(struct vtk_blocks *b, z_stream *z, size_t bytes)
{
    deflateReset(z);
    z->next_in = b->plain;
    z->avail_in = (unsigned)bytes;
    z->next_out = b->packed;
    z->avail_out = PACKED_ROOM;
    const int done = deflate(z, Z_FINISH) == Z_STREAM_END;
    assert(done); /* the buffer was large enough */
    return done ? (size_t)z->total_out : 0;
}

static void put_words(FILE *out, const uint64_t *word, size_t n)
{
    fwrite(word, sizeof word[0], n, out);
}

/* Writes the blocks behind a header that is not filled in yet. */
static void put_blocks(struct vtk_blocks *b, FILE *out,
                       const struct vtk_array *a, size_t n_values)
{
    const size_t per_block = VTK_BLOCK / vtk_array_width(a);
    z_stream *z = &b->light;

    for (size_t k = 0; k * per_block < n_values; k++) {
        const size_t first = k * per_block;
        const size_t left = n_values - first;
        const size_t n = left < per_block ? left : per_block;
        const size_t bytes = n * vtk_array_width(a);

        vtk_array_copy(a, first, n, b->plain);
        b->size[k] = vtk_blocks_pack(b, z, bytes);
        fwrite(b->packed, 1, (size_t)b->size[k], out);
        if (10 * b->size[k] > 9 * bytes) z = &b->stored;
    }
}

void vtk_blocks_write(struct vtk_blocks *b, FILE *out,
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
