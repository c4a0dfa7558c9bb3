/* graph.h -- cells and the links between them, and the coarser graphs whose
 * cells are aggregates of cells.
 * Chapter "Linear solvers".
 *
 * Pairwise aggregation of cells, by geometry alone.
 *
 *
 * One coarsening takes the directions x, y, z in turn and joins cells in pairs
 * along the links closest to that direction, in the order of their numbers; a
 * cell without a partner joins a neighbouring pair. Only strong links are used,
 * those whose S/d is at least 0.4 of the largest of either cell. Flat cells are
 * therefore joined across their large faces first, until they are about as long
 * as wide (semi-coarsening), because the smoother alone converges slowly in
 * that direction.
 */
#ifndef LINEAR_MULTIGRID_GRAPH_H
#define LINEAR_MULTIGRID_GRAPH_H

struct graph {
    int n, n_links;
    int *owner, *neighbour; /* [-] of each link */
    double *strength;       /* [m] S/d of each link */
    double *distance;       /* [m] from owner to neighbour, 3 a link */
    double *V;              /* [m^3] of each cell */
    double *wall;           /* [m^2] area of each cell that no link leads
                               through, by direction, 3 a cell */
    int *strong;            /* [-] 1: the link may join cells */
};

/* A graph with copies of these arrays, no link marked strong. */
struct graph *graph_create(int n, int n_links, const int *owner,
                           const int *neighbour, const double *strength,
                           const double *link, const double *V);

/* Length of link l [m]. */
double graph_length(const struct graph *g, int l);

/* Distance through cell i to the wall beside it, V over wall area [m]; 0 for a
 * cell without a wall. */
double graph_depth(const struct graph *g, int i);

/* The graph of aggregates. root[i] is the first cell of the aggregate of i,
 * offset the vector from there to i [m]; it becomes the vector from the
 * centroid of the aggregate. parent[i] becomes the aggregate of i, bundle[l]
 * the coarse link that link l is part of, or -1 if it lies within an aggregate.
 * Links between the same two aggregates are one coarse link if they lead the
 * same way: through a periodic side they may not. */
struct graph *graph_aggregated(const struct graph *g, const int *root,
                               double *offset, int *parent, int *bundle);

/* The next coarser graph, with parent and bundle as in graph_aggregated. */
struct graph *graph_coarsened(struct graph *g, int *parent, int *bundle);

#endif
