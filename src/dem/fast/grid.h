/* grid.h -- particles sorted into cells, and the pairs found there.
 * Chapter "Neighbours".
 *
 * The cells are as wide as the largest distance of a pair in the neighbour
 * list, so that the partners of a particle are in its own cell and the 26
 * around it. The particles are numbered cell by cell, with the longest
 * direction of the box as the slowest index: particles that are close in space
 * are then close in memory.
 */
#ifndef DEM_FAST_GRID_H
#define DEM_FAST_GRID_H

#include "dem/particles.h"
#include "dem/fast/chunk.h"

struct grid;

struct grid *grid_create(int capacity, const struct box_domain *box);
void grid_free(struct grid *g);

/* Finds the order of the particles with cells of at least `reach` [m]: the
 * particle at order[i] belongs to place i. Borrowed; until the next call. */
const int *grid_order(struct grid *g, const struct particles *ps, double reach);

/* Fills the neighbour list of a chunk with pairs and walls closer than skin
 * [m]. The bodies are in the order of grid_order. */
void grid_find(const struct grid *g, struct chunk *s, const struct bodies *b,
               double skin);

/* 1 if particle i owns its pair with j: the particle with the smaller index
 * does or, where the slowest direction is periodic, the one from which the
 * index of the other is reached in fewer steps upward. */
int grid_owns(const struct grid *g, int i, int j, int n);

#endif
