/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly.h"
#include "averaging/averaging.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"
#include "cloud.h"
#include "warped.h"

/* One amount of 1 for each particle, averaged; field times volume. */
static void shares_of(const char *method, const struct mesh *m,
                      const struct particles *ps, double *share)
{
    const struct averaging_options o = {.bandwidth = 0.17};
    struct averaging *const a =
        averaging_create(averaging_method_named(method), m, ps, &o);
    double *const q = alloc_doubles(ps->n);

    for (int i = 0; i < ps->n; i++)
        q[i] = 1.0;
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, 1, q, share);
    for (int c = 0; c < m->n_cells; c++)
        share[c] *= m->V[c];
    averaging_free(a);
    free(q);
}

/* Two cells, the face at x = 1; a sphere of diameter 1 whose centre is 0.3
 * before it. The cap beyond has the height 0.2 = 0.4 R: its share is
 * 0.4^2 (3 - 0.4) / 4. Of the cube it is a fifth. */
FACT(a_sphere_across_a_face_is_divided_by_its_cap)
{
    struct mesh *const m = closed_box(2.0, 2.0, 2.0, 2, 1, 1);
    struct particles *const ps = particles_create(1);
    double share[2];

    cloud_place(ps, 0.7, 1.0, 1.0, 1.0);
    shares_of("dpvm", m, ps, share);
    ck_assert_double_eq_tol(share[1], 0.16 * 2.6 / 4.0, 1e-14);
    shares_of("cube", m, ps, share);
    ck_assert_double_eq_tol(share[1], 0.2, 1e-14);
    particles_free(ps);
    mesh_free(m);
}

/* In a closed corner three eighths of the diameter off: the part beyond the
 * walls is distributed like the rest, that is, it stays in the one cell. A
 * period divides: a sphere on its corner is in eight cells. */
FACT(a_sphere_in_a_corner_is_divided_where_there_are_cells)
{
    for (int periodic = 0; periodic < 2; periodic++) {
        const struct box_spec spec = {{4.0, 4.0, 4.0},
                                      {4, 4, 4},
                                      {1.0, 1.0, 1.0},
                                      {periodic, periodic, periodic}};
        struct mesh *const m = mesh_create_box(&spec);
        struct particles *const ps = particles_create(1);
        double share[64];
        cloud_place(ps, 0.0, 0.0, 0.0, 0.8);
        shares_of("dpvm", m, ps, share);
        ck_assert_double_eq_tol(share[0], periodic ? 0.125 : 1.0, 1e-14);
        ck_assert_double_eq_tol(share[63], periodic ? 0.125 : 0.0, 1e-14);
        particles_free(ps);
        mesh_free(m);
    }
}

/* Spheres of diameter 1 in a cubic packing, cells of 0.3: pcm puts 0.52 into
 * 0.027, twenty times too much; divided, no cell is more than full, and those
 * within a sphere are full to rounding. */
FACT(dpvm_fills_no_cell_beyond_its_volume)
{
    struct mesh *const m = closed_box(3.0, 3.0, 3.0, 10, 10, 10);
    struct particles *const ps = particles_create(27);
    double share[1000], highest = 0.0, pcm = 0.0;

    for (int i = 0; i < 27; i++)
        cloud_place(ps, 0.5 + i % 3, 0.5 + i / 3 % 3, 0.5 + i / 9, 1.0);
    shares_of("dpvm", m, ps, share);
    for (int c = 0; c < 1000; c++)
        highest = fmax(highest, M_PI / 6.0 * share[c] / m->V[c]);
    ck_assert_double_eq_tol(highest, 1.0, 1e-13);
    shares_of("pcm", m, ps, share);
    for (int c = 0; c < 1000; c++)
        pcm = fmax(pcm, M_PI / 6.0 * share[c] / m->V[c]);
    ck_assert_double_gt(pcm, 19.0);
    particles_free(ps);
    mesh_free(m);
}

/* Eight cells in the place of one have together what the one has: exact
 * overlaps do not depend on the mesh. Spheres smaller and larger than cells,
 * anywhere inside, none over a wall. */
FACT_FOR_EACH(the_part_in_a_region_does_not_depend_on_the_cells_in_it, 2)
{
    struct mesh *const one = closed_box(6.0, 6.0, 6.0, 3, 3, 3);
    struct mesh *const eight = closed_box(6.0, 6.0, 6.0, 6, 6, 6);
    struct particles *const ps = particles_create(20);
    double a[27], b[216];
    uint64_t state = 3;

    for (int i = 0; i < 20; i++) {
        const double d = 0.2 + 2.8 * cloud_random(&state);
        const double x = 0.5 * d + (6.0 - d) * cloud_random(&state);
        const double y = 0.5 * d + (6.0 - d) * cloud_random(&state);
        cloud_place(ps, x, y, 0.5 * d + (6.0 - d) * cloud_random(&state), d);
    }
    shares_of(_i == 0 ? "dpvm" : "cube", one, ps, a);
    shares_of(_i == 0 ? "dpvm" : "cube", eight, ps, b);
    for (int c = 0; c < 216; c++)
        a[c / 2 % 3 + 3 * (c / 6 / 2 % 3) + 9 * (c / 36 / 2)] -= b[c];
    for (int c = 0; c < 27; c++)
        ck_assert_double_eq_tol(a[c], 0.0, 1e-12);
    particles_free(ps);
    mesh_free(one);
    mesh_free(eight);
}

/* A box from points and faces is cut by other code than a box, and the shares
 * are the same: of bodies smaller and larger than cells, at walls, in corners,
 * round periods that are one cell wide or more. */
FACT_FOR_EACH(a_box_from_files_divides_as_a_box, 3 * CLOUD_SHAPES)
{
    static const char *const methods[] = {"dpvm", "cube", "two-grid"};
    const struct box_spec *const spec = &cloud_shapes[_i % CLOUD_SHAPES];
    const char *const method = methods[_i / CLOUD_SHAPES];
    struct mesh *const box = mesh_create_box(spec);
    struct mesh *const m =
        mesh_create_sheared(spec, (const double[3]){0.0, 0.0, 0.0});
    struct particles *const ps = cloud_create(box, 100);
    double *const a = alloc_doubles(box->n_cells);
    double *const b = alloc_doubles(box->n_cells);
    double worst = 0.0;

    for (int i = 0; i < ps->n; i++) {
        ps->d[i] *= 0.5 * (1 + i % 30);
        if (_i < 2 * CLOUD_SHAPES) continue;
        /* the second grid depends on the cell of the centre, which rounding
         * decides on its edges */
        ps->x[i] += 0.01 * (spec->size[0] - 1.7 * ps->x[i]);
        ps->y[i] += 0.01 * (spec->size[1] - 1.7 * ps->y[i]);
        ps->z[i] += 0.01 * (spec->size[2] - 1.7 * ps->z[i]);
    }
    shares_of(method, box, ps, a);
    shares_of(method, m, ps, b);
    for (int c = 0; c < m->n_cells; c++) {
        const double *const x = &m->centre[3 * c];
        const int at = mesh_cell_at(box, x[0], x[1], x[2]);
        worst = fmax(worst, fabs(b[c] - a[at]));
    }
    ck_assert_double_lt(worst, 1e-12);
    free(a);
    free(b);
    particles_free(ps);
    mesh_free(m);
    mesh_free(box);
}

/* Of points in a sphere, one in each of 80^3 small boxes, a cell gets as many
 * as its share says: the search for the cell of a point and the cutting of the
 * sphere are independent computations. A bent face is a mean plane to the
 * former. Then cells of many faces, and a period, each at a wall. */
FACT_FOR_EACH(the_overlap_of_a_cell_is_that_of_the_points_in_the_sphere, 3)
{
    enum { N = 80 };
    struct mesh *const m = _i == 0 ? warped()
                           : _i == 1
                               ? poly_read("tests/data/poly/dual", NULL)
                               : poly_read("tests/data/poly/cyclic", NULL);
    struct particles *const ps = particles_create(1);
    double *const share = alloc_doubles(m->n_cells);
    double *const points = alloc_doubles(m->n_cells);
    const double d = 0.35, at[3] = {_i == 2 ? 0.05 : 0.6, 0.45, 0.15};
    uint64_t state = 4;
    int all = 0;

    cloud_place(ps, at[0], at[1], at[2], d);
    shares_of("dpvm", m, ps, share);
    for (int i = 0; i < N * N * N; i++) {
        const double x = (i % N + cloud_random(&state)) / N - 0.5;
        const double y = (i / N % N + cloud_random(&state)) / N - 0.5;
        const double z = (i / N / N + cloud_random(&state)) / N - 0.5;
        if (x * x + y * y + z * z > 0.25) continue;
        const int c =
            mesh_cell_at(m, at[0] + d * x, at[1] + d * y, at[2] + d * z);
        if (c < 0) continue; /* beyond a wall */
        points[c] += 1.0;
        all++;
    }
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq_tol(points[c] / all, share[c],
                                _i == 0 ? 5e-3 : 1e-3);
    ck_assert_int_gt(all, 180000);
    free(share);
    free(points);
    particles_free(ps);
    mesh_free(m);
}
