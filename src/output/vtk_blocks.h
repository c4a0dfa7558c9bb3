/* vtk_blocks.h -- the bytes of one array, compressed by zlib in blocks.
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
#ifndef OUTPUT_VTK_BLOCKS_H
#define OUTPUT_VTK_BLOCKS_H

#include "output/vtk_array.h"

#include <stdio.h>

/* Full block, before compression [bytes]. */
enum { VTK_BLOCK = 65536 };

/* Room for one block and the two compressors, allocated once. */
struct vtk_blocks;

struct vtk_blocks *vtk_blocks_create(void);
void vtk_blocks_free(struct vtk_blocks *b);

/* Writes the array for n points or cells at the present position. Write errors
 * are not returned; they remain set in the stream. */
void vtk_blocks_write(struct vtk_blocks *b, FILE *out,
                      const struct vtk_array *a, int n);

#endif
