/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/dpvm.h"

#include <check.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "base/alloc.h"
#include "cloud.h"

/* One amount of 1 for each particle, averaged; field times volume. */
static void shares_of(const char *method, const struct mesh *m,
                      const struct particles *ps, double *share)
{
    const struct averaging_options o = {.cap = 0.0};
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
START_TEST(a_sphere_across_a_face_is_divided_by_its_cap)
{
    const struct box_spec spec = {
        {2.0, 2.0, 2.0}, {2, 1, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
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
END_TEST

/* In a closed corner three eighths of the diameter off: what would be beyond
 * the walls is shared out like the rest, that is, it stays in the one cell. A
 * period divides: a sphere on its corner is in eight cells. */
START_TEST(a_sphere_in_a_corner_is_divided_where_there_are_cells)
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
END_TEST

/* Spheres of diameter 1 in a cubic packing, cells of 0.3: pcm puts 0.52 into
 * 0.027, twenty times too much; divided, no cell is more than full, and those
 * within a sphere are full to rounding. */
START_TEST(divided_no_cell_gets_more_than_it_has_room_for)
{
    const struct box_spec spec = {
        {3.0, 3.0, 3.0}, {10, 10, 10}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
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
END_TEST

/* Eight cells in the place of one have together what the one has: exact
 * overlaps do not know of the mesh. Spheres smaller and larger than cells,
 * anywhere inside, none over a wall. */
START_TEST(the_share_of_a_region_does_not_depend_on_the_cells_in_it)
{
    const struct box_spec coarse = {
        {6.0, 6.0, 6.0}, {3, 3, 3}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct box_spec fine = {
        {6.0, 6.0, 6.0}, {6, 6, 6}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const one = mesh_create_box(&coarse);
    struct mesh *const eight = mesh_create_box(&fine);
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
END_TEST

int main(void)
{
    Suite *const s = suite_create("dpvm");
    TCase *const t = tcase_create("core");

    suite_add_tcase(s, t);
    tcase_add_test(t, a_sphere_across_a_face_is_divided_by_its_cap);
    tcase_add_test(t, a_sphere_in_a_corner_is_divided_where_there_are_cells);
    tcase_add_test(t, divided_no_cell_gets_more_than_it_has_room_for);
    tcase_add_loop_test(
        t, the_share_of_a_region_does_not_depend_on_the_cells_in_it, 0, 2);
    SRunner *const r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    const int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
