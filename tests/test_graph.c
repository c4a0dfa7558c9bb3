/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/graph.h"

#include "facts.h"
#include "linear_case.h"

static struct graph *graph_of(const struct links *b)
{
    return graph_create(b->n, b->n_links, b->owner, b->neighbour, b->strength,
                        b->link, b->V);
}

/* Aggregates of two cells in direction x: the root and offset of each cell. */
static void pairs_along_x(const struct links *b, double h, int *root,
                          double *offset)
{
    for (int i = 0; i < b->n; i++) {
        const int odd = i % b->cells[0] % 2;
        root[i] = i - odd;
        offset[3 * i] = odd * h;
    }
}

/* Cells of 1 x 2 x 4 m in a box of 3 x 3 x 3 of them. */
static const double h[3] = {1.0, 2.0, 4.0};

FACT(a_cell_inside_has_no_wall_and_one_in_a_corner_has_three)
{
    struct links b = links_box(3, 3, 3, h, (int[3]){0, 0, 0});
    struct graph *const g = graph_of(&b);

    ck_assert_double_eq(graph_depth(g, 13), 0.0); /* the middle one */
    ck_assert_double_eq(g->wall[0], 8.0);         /* S = V / h */
    ck_assert_double_eq(g->wall[1], 4.0);
    ck_assert_double_eq(g->wall[2], 2.0);
    ck_assert_double_eq_tol(graph_depth(g, 0), 8.0 / sqrt(84.0), 1e-15);
    ck_assert_double_eq(graph_depth(g, 12), 1.0); /* beside a wall at x = 0 */
    owner_free(g);
    links_free(&b);
}

FACT(a_periodic_box_has_no_walls)
{
    struct links b = links_box(3, 4, 5, h, (int[3]){1, 1, 1});
    struct graph *const g = graph_of(&b);

    for (int i = 0; i < b.n; i++)
        ck_assert_double_eq(graph_depth(g, i), 0.0);
    owner_free(g);
    links_free(&b);
}

/* Pairs along x of a box are a box of cells twice as long: half the strength in
 * x, twice in y and z, in which two links lie side by side. All numbers are
 * powers of two, so nothing is rounded. */
FACT(pairs_of_a_box_are_the_box_of_longer_cells)
{
    struct links b = links_box(4, 3, 2, h, (int[3]){0, 0, 0});
    struct links B =
        links_box(2, 3, 2, (double[3]){2.0, 2.0, 4.0}, (int[3]){0, 0, 0});
    struct graph *const g = graph_of(&b), *const exact = graph_of(&B);
    int *const root = alloc_ints(b.n), *const parent = alloc_ints(b.n);
    int *const coarse = alloc_ints(b.n_links);
    double *const offset = alloc_doubles(3 * b.n);

    pairs_along_x(&b, h[0], root, offset);
    struct graph *const big = graph_aggregated(g, root, offset, parent, coarse);
    ck_assert_int_eq(big->n, exact->n);
    ck_assert_int_eq(big->n_links, exact->n_links);
    for (int i = 0; i < big->n; i++) {
        ck_assert_double_eq(big->V[i], exact->V[i]);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq(big->wall[3 * i + k], exact->wall[3 * i + k]);
    }
    for (int l = 0; l < big->n_links; l++) {
        int same = 0; /* links of the exact box with these ends */
        for (int e = 0; e < exact->n_links; e++)
            if (exact->owner[e] == big->owner[l] &&
                exact->neighbour[e] == big->neighbour[l]) {
                same++;
                ck_assert_double_eq(big->strength[l], exact->strength[e]);
                for (int k = 0; k < 3; k++)
                    ck_assert_double_eq(big->distance[3 * l + k],
                                        exact->distance[3 * e + k]);
            }
        ck_assert_int_eq(same, 1);
    }
    for (int l = 0; l < b.n_links; l++) { /* inside an aggregate: no link */
        const int P = parent[b.owner[l]], Q = parent[b.neighbour[l]];
        ck_assert_int_eq(coarse[l] < 0, P == Q);
        if (P == Q) continue;
        ck_assert_int_eq(big->owner[coarse[l]] + big->neighbour[coarse[l]],
                         P + Q);
    }
    for (int i = 0; i < b.n; i++) /* to the cell from the centroid */
        ck_assert_double_eq(fabs(offset[3 * i]), 0.5);
    free(root);
    free(parent);
    free(coarse);
    free(offset);
    owner_free(g);
    owner_free(exact);
    owner_free(big);
    links_free(&b);
    links_free(&B);
}

/* Two aggregates in a ring touch on both sides: one link would have the length
 * zero. */
FACT(links_that_lead_opposite_ways_are_not_joined)
{
    struct links b = links_box(4, 1, 1, h, (int[3]){1, 0, 0});
    struct graph *const g = graph_of(&b);
    int root[4], parent[4], coarse[4];
    double offset[12] = {0.0};

    ck_assert_int_eq(b.n_links, 4);
    pairs_along_x(&b, h[0], root, offset);
    struct graph *const big = graph_aggregated(g, root, offset, parent, coarse);
    ck_assert_int_eq(big->n, 2);
    ck_assert_int_eq(big->n_links, 2);
    for (int l = 0; l < 2; l++)
        ck_assert_double_eq(graph_length(big, l), 2.0);
    ck_assert_double_eq(big->distance[0], -big->distance[3]);
    owner_free(g);
    owner_free(big);
    links_free(&b);
}
