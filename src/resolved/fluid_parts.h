/* fluid_parts.h -- the parts of the fluid between bodies.
 * Chapter "Resolving the grains".
 *
 * A part is made of cells without a mark, joined through their faces. Looked at
 * one by one the cells of a large box take longer than what a step does in
 * them, so those that follow each other in a row are taken as one.
 */
#ifndef RESOLVED_FLUID_PARTS_H
#define RESOLVED_FLUID_PARTS_H

#include "mesh/mesh.h"

/* Fluid cells that follow each other in a row, and what is at the ends of the
 * box in the part that they are in: only in its root. */
struct run {
    int first, end;    /* [-] cells first ... end - 1 */
    int root, next;    /* [-] the first run of this part; the next one, or 0 */
    int inlet, outlet; /* [-] 1: the part has one */
};

struct fluid_parts {
    const struct box *box;
    struct run *run;
    int *row, runs; /* [-] the first run of each row; their number */
};

/* The parts of a box; a cell has no mark where mark[c] is 0. */
struct fluid_parts *fluid_parts_find(const struct box *box, const int *mark);

/* The run that cell c, which has no mark, is in. */
int fluid_parts_run(const struct fluid_parts *p, int c);

/* The cells of the part with this root; returns their number. */
int fluid_parts_cells(const struct fluid_parts *p, int root, int *part);

#endif
