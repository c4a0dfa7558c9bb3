/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/graph.h"

#include "facts.h"
#include "linear_case.h"

static const double unit[3] = {1, 1, 1};
static const int closed[3] = {0, 0, 0};

struct step {
    struct links b;
    struct graph *fine, *coarse;
    int *parent, *bundle;
};

static struct step coarsen(struct links b)
{
    struct step s = {.b = b};

    s.fine = graph_create(b.n, b.n_links, b.owner, b.neighbour, b.strength,
                          b.link, b.V);
    s.parent = alloc_ints(b.n);
    s.bundle = alloc_ints(b.n_links);
    s.coarse = graph_coarsened(s.fine, s.parent, s.bundle);
    return s;
}

static void release(struct step *s)
{
    free(s->parent);
    free(s->bundle);
    owner_free(s->fine);
    owner_free(s->coarse);
    links_free(&s->b);
}

/* A box of twice the size: volumes times 8, lengths times 2, S/d times 2. The
 * numbers are sums of powers of two: exact. */
FACT(a_box_becomes_the_box_of_half_as_many_cells)
{
    struct step s = coarsen(links_cube(8, 6, 4));
    struct links half = links_cube(4, 3, 2);

    ck_assert_int_eq(s.coarse->n, half.n);
    ck_assert_int_eq(s.coarse->n_links, half.n_links);
    for (int c = 0; c < s.b.n; c++) {
        const int x = c % 8, y = c / 8 % 6, z = c / 48;

        ck_assert_int_eq(s.parent[c], x / 2 + 4 * (y / 2 + 3 * (z / 2)));
    }
    for (int c = 0; c < half.n; c++)
        ck_assert_double_eq(s.coarse->V[c], 8.0);
    for (int l = 0; l < half.n_links; l++) {
        ck_assert_double_eq(graph_length(s.coarse, l), 2.0);
        ck_assert_double_eq(s.coarse->strength[l], 2.0);
    }
    links_free(&half);
    release(&s);
}

FACT(a_cell_left_over_joins_the_pair_beside_it)
{
    struct step s = coarsen(links_cube(5, 1, 1));
    const int parent[5] = {0, 0, 1, 1, 1};

    ck_assert_int_eq(s.coarse->n, 2);
    ck_assert_mem_eq(s.parent, parent, sizeof parent);
    ck_assert_double_eq_tol(graph_length(s.coarse, 0), 2.5, 1e-15);
    release(&s);
}

/* Cells 4 times as long as wide: S/d is 1/16 along x of that across. */
FACT(flat_cells_are_joined_across_their_flat_sides_only)
{
    const double h[3] = {4, 1, 1};
    struct step s = coarsen(links_box(4, 4, 1, h, closed));

    ck_assert_int_eq(s.coarse->n, 8);
    for (int c = 0; c < 16; c++)
        ck_assert_int_eq(s.parent[c], c % 4 + 4 * (c / 8));
    release(&s);
}

/* In a periodic row of four cells two aggregates touch twice: straight and
 * through the sides. One bundle of both would have length zero. */
FACT(links_through_a_periodic_side_stay_apart)
{
    struct step s = coarsen(links_box(4, 1, 1, unit, (int[3]){1, 0, 0}));

    ck_assert_int_eq(s.coarse->n, 2);
    ck_assert_int_eq(s.coarse->n_links, 2);
    ck_assert_double_eq(s.coarse->distance[0], 2.0);
    ck_assert_double_eq(s.coarse->distance[3],
                        -2.0); /* seen from aggregate 0 */
    release(&s);
}

FACT(every_link_is_within_an_aggregate_or_in_a_bundle_between_two)
{
    struct links b = links_box(9, 7, 5, unit, (int[3]){1, 0, 1});

    links_shuffle(&b, 5);

    struct step s = coarsen(b);

    for (int l = 0; l < b.n_links; l++) {
        const int I = s.parent[b.owner[l]], J = s.parent[b.neighbour[l]];
        const int L = s.bundle[l];

        ck_assert_int_eq(L < 0, I == J);
        if (L < 0) continue;
        ck_assert_int_eq(s.coarse->owner[L], I < J ? I : J);
        ck_assert_int_eq(s.coarse->neighbour[L], I < J ? J : I);
    }
    ck_assert_int_lt(s.coarse->n, b.n / 4);
    release(&s);
}

/* A wall is where no link leads; it is twice as far through an aggregate. */
FACT(the_way_to_a_wall_grows_with_the_aggregate)
{
    struct step s = coarsen(links_box(6, 4, 1, unit, (int[3]){0, 1, 0}));

    for (int c = 0; c < s.b.n; c++) {
        const int at_wall = c % 6 == 0 || c % 6 == 5;

        ck_assert_double_eq(graph_depth(s.fine, c), at_wall ? 1.0 : 0.0);
    }
    for (int c = 0; c < s.coarse->n; c++)
        ck_assert_double_eq(graph_depth(s.coarse, c), c % 3 == 1 ? 0.0 : 2.0);
    release(&s);
}
