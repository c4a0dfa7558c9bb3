/* vtk_blocks.h -- the bytes of one array of a VTK file, compressed in blocks.
 */
#ifndef OUTPUT_COMPRESSED_VTK_BLOCKS_H
#define OUTPUT_COMPRESSED_VTK_BLOCKS_H

#include "output/vtk_array.h"

#include <stdio.h>

struct vtk_blocks;

struct vtk_blocks *vtk_blocks_create(void);
void vtk_blocks_free(struct vtk_blocks *b);

/* Writes the array of n points or cells at the present position of the stream,
 * in which an error remains set. */
void vtk_blocks_write(struct vtk_blocks *b, FILE *out,
                      const struct vtk_array *a, int n);

#endif
