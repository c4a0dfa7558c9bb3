/* pairs.h -- which cells to join, by geometry alone.  Chapter 7.
 *
 * One coarsening takes the directions x, y, z in turn and joins cells in pairs
 * along the links closest to that direction, in the order of their numbers; a
 * cell left over joins the pair beside it. Only strong links count, those whose
 * S/d is a good part of the largest of a cell they join: flat cells are joined
 * across their flat sides first, until they are round (semi-coarsening), for
 * across these the smoother alone is slow.
 */
#ifndef PAIRS_H
#define PAIRS_H

#include "linear/graph.h"

/* The next coarser graph, with parent and bundle as in graph_joined. */
struct graph *pairs_coarser(struct graph *g, int *parent, int *bundle);

#endif
