/* pairwise_aggregation.h -- pairwise aggregation of cells, by geometry alone.
 *
 * Chapter "Linear solvers".
 *
 * One coarsening takes the directions x, y, z in turn and joins cells in pairs
 * along the links closest to that direction, in the order of their numbers; a
 * cell without a partner joins a neighbouring pair. Only strong links are used,
 * those whose S/d is at least 0.4 of the largest of either cell. Flat cells are
 * therefore joined across their large faces first, until they are about as long
 * as wide (semi-coarsening), because the smoother alone converges slowly in
 * that direction.
 */
#ifndef LINEAR_MULTIGRID_PAIRWISE_AGGREGATION_H
#define LINEAR_MULTIGRID_PAIRWISE_AGGREGATION_H

#include "linear/multigrid/graph.h"

/* The next coarser graph, with parent and bundle as in graph_aggregated. */
struct graph *pairwise_aggregation_coarsen(struct graph *g, int *parent,
                                           int *bundle);

#endif
