/* grid.h -- particles sorted into cells, and the pairs found there.  Chapter 3.
 *
 * The cells are as wide as the farthest pair of the vicinity, so that a
 * particle's partners are in its own cell and the 26 around. The particles are
 * numbered cell by cell, the slowest direction being the longest of the box:
 * what is near in space is then near in memory.
 */
#ifndef GRID_H
#define GRID_H

#include "particles/particles.h"
#include "particles/strip.h"

struct grid;

struct grid *grid_create(int capacity, const struct domain *box);
void grid_free(struct grid *g);

/* Finds the order of the particles with cells of at least `reach` [m]: the
 * particle at order[i] belongs to place i. Borrowed; until the next call. */
const int *grid_order(struct grid *g, const struct particles *ps, double reach);

/* Fills the vicinity of a strip with pairs and walls closer than skin [m].
 * The bodies are in the order that grid_order said. */
void grid_find(const struct grid *g, struct strip *s, const struct bodies *b,
               double skin);

/* Who of the pair owns it: the first of the two or, where the slowest
 * direction is periodic, the one from which the other is sooner reached. */
int grid_owns(const struct grid *g, int i, int j, int n);

#endif
