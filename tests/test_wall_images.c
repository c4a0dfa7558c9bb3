/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/poly/facets.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/diffusion.h"
#include "base/alloc.h"
#include "base/vector.h"
#include "facts.h"
#include "blocks.h"

/* The wall images of a mesh, with the data that they are made from. */
struct hall {
    struct mesh *mesh;
    struct facets *facets;
    struct wall_images *mirrors;
};

static struct hall hall_of(struct mesh *m, double reach)
{
    struct hall h = {m, facets_create(m), NULL};

    h.mirrors = wall_images_create(h.facets, reach);
    return h;
}

static void hall_free(struct hall *h)
{
    wall_images_free(h->mirrors);
    owner_free(h->facets);
    mesh_free(h->mesh);
}

/* The image of cell c that is nearest to x from its centre. */
static const struct wall_image *image_at(const struct hall *h, int c,
                                         const double x[3])
{
    const struct wall_images *const m = h->mirrors;

    for (int i = m->start[c]; i < m->start[c + 1]; i++) {
        double r[3];
        vector_between(m->images[i].offset, x, r);
        if (vector_length(r) < 1e-9) return &m->images[i];
    }
    return NULL;
}

/* Of three walls at right angles: one image in each, in each two, in all. From
 * farther inside those in two are beyond the reach. */
FACT(ew18_21_a_corner_of_a_box_has_seven_images)
{
    const struct blocks cubes = {.n = {4, 4, 4}};
    struct hall h = hall_of(blocks_create(&cubes), 1.6);
    const int c = mesh_cell_at(h.mesh, 0.5, 0.5, 0.5);

    ck_assert_int_eq(h.mirrors->start[c + 1] - h.mirrors->start[c], 7);
    for (int k = 1; k < 8; k++) {
        const double x[3] = {-(k & 1), -(k >> 1 & 1), -(k >> 2)};
        const struct wall_image *const q = image_at(&h, c, x);
        ck_assert_ptr_nonnull(q);
        ck_assert_double_eq_tol(q->weight, 1.0, 1e-12);
        for (int e = 0; e < 9; e++)
            ck_assert_double_eq_tol(q->rotation[e],
                                    e % 4 > 0         ? 0.0
                                    : x[e / 4] < -0.5 ? -1.0
                                                      : 1.0,
                                    1e-12);
    }
    const int inner = mesh_cell_at(h.mesh, 1.5, 1.5, 1.5);
    ck_assert_int_eq(h.mirrors->start[inner + 1] - h.mirrors->start[inner], 3);
    hall_free(&h);
}

/* Between two walls of distance 1 an image every 1, every second one turned. */
FACT(between_two_walls_images_have_images)
{
    const struct blocks slot = {.n = {9, 9, 1}};
    struct hall h = hall_of(blocks_create(&slot), 3.2);
    const int c = mesh_cell_at(h.mesh, 4.5, 4.5, 0.5);

    ck_assert_int_eq(h.mirrors->start[c + 1] - h.mirrors->start[c], 6);
    for (int k = -3; k <= 3; k++) {
        const double x[3] = {0.0, 0.0, k};
        if (k == 0) continue;
        const struct wall_image *const q = image_at(&h, c, x);
        ck_assert_ptr_nonnull(q);
        ck_assert_double_eq_tol(q->weight, 1.0, 1e-12);
        ck_assert_double_eq_tol(q->rotation[8], k % 2 == 0 ? 1.0 : -1.0, 1e-12);
    }
    hall_free(&h);
}

/* A quarter of it is left out: a corner that juts into the domain. */
static int step_there(const int at[3])
{
    return at[0] < 8 || at[1] < 8;
}

static void sheared(double x[3])
{
    x[0] += 0.5 * x[1];
}

static void slanted(double x[3])
{
    x[0] += x[1];
}

static const struct {
    struct blocks blocks;
    double off; /* [-] measured, and half of it again */
} rooms[] = {
    {{{16, 16, 1}, NULL, NULL}, 2e-5},
    {{{16, 16, 1}, step_there, NULL}, 2e-5},
    {{{16, 16, 1}, NULL, sheared}, 5e-2},
    {{{16, 16, 1}, NULL, slanted}, 5e-2},
};
enum { ROOMS = sizeof rooms / sizeof *rooms };

/* A Gaussian around any place, summed over all cells and all images, is one:
 * the images fill the space behind the walls exactly once. b of two cells.
 * Where angles are not right ones a cell and its image meet at a wall or at a
 * bisector as no two cells do, and the sum of values at centres is less exact.
 */
FACT_FOR_EACH(the_images_of_all_cells_fill_the_space_once, ROOMS)
{
    const double b = 2.0;
    struct hall h = hall_of(blocks_create(&rooms[_i].blocks), 3.0 * b);
    const struct mesh *const m = h.mesh;
    double lo = INFINITY, hi = 0.0;

    for (int i = 0; i < m->n_cells; i++) {
        double sum = 0.0;
        for (int c = 0; c < m->n_cells; c++) {
            double r[3], s[3];
            vector_between(&m->centre[3 * c], &m->centre[3 * i], r);
            sum += m->V[c] * diffusion_kernel(vector_length(r), b);
            for (int k = h.mirrors->start[c]; k < h.mirrors->start[c + 1];
                 k++) {
                vector_along(r, 1.0, h.mirrors->images[k].offset, s);
                sum += m->V[c] * h.mirrors->images[k].weight *
                       diffusion_kernel(vector_length(s), b);
            }
        }
        lo = fmin(lo, sum);
        hi = fmax(hi, sum);
    }
    ck_assert_double_lt(1.0 - lo, rooms[_i].off);
    ck_assert_double_lt(hi - 1.0, rooms[_i].off);
    hall_free(&h);
}
