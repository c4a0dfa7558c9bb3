/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spheres against planes, cylinders and triangles. */
#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/surface_contacts.h"
#include "dem/surfaces/triangles.h"
#include "facts.h"
#include "spheres.h"

static const double g = 9.81; /* [m/s^2] */

static struct surface plane(double x, double y, double z, double nx, double ny,
                            double nz)
{
    const double length = sqrt(nx * nx + ny * ny + nz * nz);
    const struct surface s = {
        .name = "plane",
        .shape = &surface_plane,
        .point = {x, y, z},
        .normal = {nx / length, ny / length, nz / length}};
    return s;
}

static struct surface of_triangles(int n, double (*corner)[3][3])
{
    const struct surface s = {.name = "triangles",
                              .shape = &surface_stl,
                              .triangles = triangles_create(n, corner)};
    return s;
}

static void forget(struct surface *s)
{
    owner_free((struct triangles *)(uintptr_t)s->triangles);
}

static struct dem_options with(const struct contact_law *law, double step,
                               const struct surface *s, int n)
{
    struct dem_options o = spheres_options(law, step, 2.0);

    o.material.restitution = 0.8;
    o.material.friction = 0.3;
    o.surfaces = s;
    o.n_surfaces = n;
    return o;
}

/* A sphere of 0.2 m a little above y = 0, thrown along x, spinning. */
static struct particles *thrown(double vx, double vy)
{
    struct particles *const ps = particles_create(1);

    spheres_add(ps, -0.3, 0.1001, 0.01, 0.2);
    spheres_throw(ps, 0, vx, vy, 0.03);
    spheres_spin(ps, 0, 1.0, 2.0, 3.0);
    ps->ey[0] = -g * ps->m[0];
    return ps;
}

/* Where the sphere is after so many steps. */
struct sphere_state {
    double x[9];
};

static struct sphere_state state_after(const struct dem_options *o, double vx,
                                       double vy, int steps)
{
    struct particles *const ps = thrown(vx, vy);
    struct dem *const dem = dem_create(ps, o);
    struct dem_report r;

    ck_assert_int_eq(dem_run(dem, steps, &r), 0);
    const struct sphere_state s = {{ps->x[0], ps->y[0], ps->z[0], ps->vx[0],
                                    ps->vy[0], ps->vz[0], ps->wx[0], ps->wy[0],
                                    ps->wz[0]}};
    dem_free(dem);
    particles_free(ps);
    return s;
}

static void assert_alike(const struct sphere_state *a,
                         const struct sphere_state *b, double tol)
{
    for (int k = 0; k < 9; k++)
        ck_assert_double_eq_tol(a->x[k], b->x[k], tol);
}

/* --- planes and cylinders ------------------------------------------------ */

/* The box's own floor, reached by another way: only rounding differs. With
 * rolling friction, too, and where the walls are of a material of their own. */
FACT_FOR_EACH(plane_is_what_a_wall_of_the_box_is, 4)
{
    const struct contact_law *const law = _i ? &contact_hertz : &contact_linear;
    const struct material steel = {.young = 1e9,
                                   .poisson = 0.3,
                                   .restitution = 0.5,
                                   .friction = 0.1,
                                   .rolling = 0.05};
    const struct materials two = {.n = 2, .further = &steel, .wall = 1};
    struct surface s = plane(0.4, 0.0, 0.1, 0.0, 1.0, 0.0);
    struct dem_options wall = with(law, 1e-5, NULL, 0);
    struct dem_options o = with(law, 1e-5, &s, 1);

    wall.lo[1] = 0.0;
    if (_i >= 2) wall.material.rolling = o.material.rolling = 0.1;
    if (_i == 3) wall.materials = o.materials = &two;
    if (_i == 3) s.material = 1; /* else of material 0, with e = 0.8 */
    const struct sphere_state a = state_after(&wall, 0.5, -1.0, 20000);
    const struct sphere_state b = state_after(&o, 0.5, -1.0, 20000);
    assert_alike(&a, &b, 1e-10);
}

/* The angular momentum about the axis and, without friction and damping, the
 * energy stay what they were, over a hundred collisions: the normal is that of
 * the cylinder to rounding, and the scheme is symplectic. */
FACT(sphere_in_a_smooth_cylinder_keeps_its_angular_momentum)
{
    const struct surface s = {.name = "tube",
                              .shape = &surface_cylinder,
                              .point = {0.1, 0.2, 0.0},
                              .normal = {0.0, 0.0, 1.0},
                              .radius = 0.5,
                              .inside = 1};
    struct dem_options o = with(&contact_linear, 1e-5, &s, 1);
    struct particles *const ps = particles_create(1);
    struct dem_report r;

    o.material.restitution = 1.0;
    o.material.friction = 0.0;
    o.periodic[2] = 1;
    spheres_add(ps, 0.3, 0.2, 0.0, 0.1);
    spheres_throw(ps, 0, 1.0, 3.0, 0.7);
    struct dem *const dem = dem_create(ps, &o);
    for (int k = 0; k < 100; k++) {
        ck_assert_int_eq(dem_run(dem, 1000, &r), 0);
        ck_assert_double_eq_tol((ps->x[0] - 0.1) * ps->vy[0] -
                                    (ps->y[0] - 0.2) * ps->vx[0],
                                0.6, 1e-9);
        /* no deeper than v sqrt(m/k) = 0.032 m */
        ck_assert_double_le(hypot(ps->x[0] - 0.1, ps->y[0] - 0.2), 0.483);
    }
    const double deep = fmax(hypot(ps->x[0] - 0.1, ps->y[0] - 0.2) - 0.45, 0.0);
    const double v2 = ps->vx[0] * ps->vx[0] + ps->vy[0] * ps->vy[0];
    ck_assert_double_eq_tol(ps->m[0] * v2 + 1e4 * deep * deep, 10.0 * ps->m[0],
                            1e-4);
    ck_assert_double_eq_tol(ps->vz[0], 0.7, 1e-12);
    dem_free(dem);
    particles_free(ps);
}

/* The rod has contacts on its outside only. */
FACT(sphere_rebounds_from_a_rod_at_its_radius)
{
    const struct surface s = {.name = "rod",
                              .shape = &surface_cylinder,
                              .point = {0.0, 0.0, 0.0},
                              .normal = {0.6, 0.0, 0.8},
                              .radius = 0.2};
    struct dem_options o = with(&contact_linear, 1e-5, &s, 1);
    struct particles *const ps = particles_create(1);
    struct dem_report r;
    double least = 1.0;

    o.material.restitution = 1.0;
    spheres_add(ps, 0.0, 0.31, 0.0, 0.2);
    spheres_throw(ps, 0, 0.0, -0.1, 0.0);
    struct dem *const dem = dem_create(ps, &o);
    for (int k = 0; k < 3000; k++) {
        ck_assert_int_eq(dem_run(dem, 10, &r), 0);
        least = fmin(least, ps->y[0]);
    }
    /* v sqrt(m/k) deep */
    ck_assert_double_eq_tol(least, 0.3 - 0.1 * sqrt(ps->m[0] / 1e4), 1e-6);
    ck_assert_double_eq_tol(ps->vy[0], 0.1, 1e-5);
    dem_free(dem);
    particles_free(ps);
}

/* --- one triangle -------------------------------------------------------- */

/* q is nearest to y if and only if it is in the triangle and no corner lies in
 * front of the plane through q across y - q. */
FACT(nearest_point_of_a_triangle_has_no_corner_in_front)
{
    uint64_t seed = 7;

    for (int trial = 0; trial < 20000; trial++) {
        double corner[3][3], y[3], q[3], n[3], out[3], total = 0.0;
        for (int k = 0; k < 9; k++)
            corner[k / 3][k % 3] = spheres_random(&seed);
        for (int k = 0; k < 3; k++)
            y[k] = 2.0 * spheres_random(&seed);
        triangle_nearest((const double(*)[3])corner, y, q);
        triangle_normal((const double(*)[3])corner, n);
        vector_between(y, q, out);
        for (int c = 0; c < 3; c++) {
            double to[3], next[3], area[3];
            vector_between(corner[c], q, to);
            vector_between(corner[(c + 1) % 3], q, next);
            ck_assert_double_le(vector_dot(to, out), 1e-12);
            vector_cross(to, next, area);
            ck_assert_double_ge(vector_dot(area, n), -1e-12); /* inside */
            total += fabs(vector_dot(to, n));
        }
        ck_assert_double_le(total, 1e-11); /* in the plane */
    }
}

FACT(a_path_through_a_triangle_is_detected_and_one_beside_it_is_not)
{
    const double corner[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

    ck_assert(triangle_crossed(corner, (double[3]){0.2, 0.3, 1},
                               (double[3]){0.3, 0.2, -1}));
    ck_assert(triangle_crossed(corner, (double[3]){0.3, 0.2, -1},
                               (double[3]){0.2, 0.3, 1}));
    ck_assert(!triangle_crossed(corner, (double[3]){0.2, 0.3, 1},
                                (double[3]){0.3, 0.2, 0.5}));
    ck_assert(!triangle_crossed(corner, (double[3]){0.7, 0.7, 1},
                                (double[3]){0.7, 0.7, -1}));
    ck_assert(!triangle_crossed(corner, (double[3]){-0.1, 0.5, 1},
                                (double[3]){-0.1, 0.5, -1}));
}

/* --- one place of the wall is one contact -------------------------------- */

/* A floor, y = 0, of two triangles whose seam makes an angle with x. */
static struct surface floor_of_two(double angle)
{
    const double a = 3.0 * cos(angle), b = 3.0 * sin(angle);
    double corner[2][3][3] = {{{-a, 0.0, -b}, {a, 0.0, b}, {-b, 0.0, a}},
                              {{-a, 0.0, -b}, {b, 0.0, -a}, {a, 0.0, b}}};
    return of_triangles(2, corner);
}

/* The same with eight about the origin, or twelve that leave hanging corners:
 * a row of large ones beside a row of small ones. */
static struct surface floor_of_eight(void)
{
    double corner[8][3][3] = {{{0}}};

    for (int k = 0; k < 8; k++)
        for (int c = 1; c < 3; c++) {
            const double angle = 0.25 * M_PI * (k + c) + 0.1;
            corner[k][c][0] = 3.0 * cos(angle);
            corner[k][c][2] = 3.0 * sin(angle);
        }
    return of_triangles(8, corner);
}

static struct surface floor_with_hanging_corners(void)
{
    double corner[12][3][3] = {{{0}}};

    for (int k = 0; k < 12; k++) {
        const int large = k < 2;
        const double size = large ? 2.0 : 0.4;
        const double x = large ? 0.0 : -0.4;
        const double z = large ? -1.0 : -1.0 + 0.4 * ((k - 2) / 2);
        const double square[4][2] = {
            {x, z}, {x + size, z}, {x + size, z + size}, {x, z + size}};
        for (int c = 0; c < 3; c++) {
            const int at = k % 2 ? (c + 2) % 4 : c;
            corner[k][c][0] = square[at][0];
            corner[k][c][2] = square[at][1];
        }
    }
    return of_triangles(12, corner);
}

/* It bounces, slides, then rolls across the seam, at seven angles, over a
 * vertex, and where corners of small triangles hang on the side of large ones.
 * The difference is rounding, 1e-10 of what is compared; counting a seam twice
 * for a single step is seen at 1e-4. */
FACT_FOR_EACH(sphere_crosses_a_seam_as_if_there_were_none, 9)
{
    struct surface flat = plane(0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    struct surface s = _i < 7    ? floor_of_two(_i * M_PI / 12.0)
                       : _i == 7 ? floor_of_eight()
                                 : floor_with_hanging_corners();
    const struct dem_options a = with(&contact_hertz, 2e-5, &flat, 1);
    const struct dem_options b = with(&contact_hertz, 2e-5, &s, 1);
    const struct sphere_state one = state_after(&a, 1.6, -0.2, 20000);
    const struct sphere_state two = state_after(&b, 1.6, -0.2, 20000);

    ck_assert_double_gt(one.x[0], 0.05);
    assert_alike(&one, &two, 1e-10);
    forget(&s);
}

/* A box of 12 triangles, from -a to a, whatever the side. */
static struct surface box_of(const double a[3])
{
    static const int face[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                   {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    double corner[12][3][3];

    for (int t = 0; t < 12; t++)
        for (int c = 0; c < 3; c++) {
            const int v = face[t / 2][t % 2 ? (c + 2) % 4 : c];
            for (int k = 0; k < 3; k++)
                corner[t][c][k] = (v >> k & 1) ? a[k] : -a[k];
        }
    return of_triangles(12, corner);
}

/* The number of contacts of a sphere at x, and the force on it. */
static int contacts_at(const struct surface *s, double x, double y, double z,
                       double d, double F[3])
{
    struct dem_options o = with(&contact_linear, 1e-5, s, 1);
    struct particles *const ps = particles_create(1);
    struct dem_report r;

    spheres_add(ps, x, y, z, d);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 0, &r), 0);
    F[0] = ps->cfx[0], F[1] = ps->cfy[0], F[2] = ps->cfz[0];
    dem_free(dem);
    particles_free(ps);
    return r.contacts;
}

/* Outside of a cube: one contact over a face (here on the diagonal that parts
 * its triangles), an edge, a vertex; with the force k (R - r) from the nearest
 * point to the centre. */
FACT_FOR_EACH(convex_body_touches_a_sphere_once, 3)
{
    struct surface s = box_of((double[3]){0.5, 0.5, 0.5});
    const double near = 0.09, each[3] = {near, near / sqrt(2), near / sqrt(3)};
    const double x = 0.5 + each[_i], y = _i >= 1 ? x : 0.2;
    const double z = _i >= 2 ? x : 0.2;
    double F[3];

    ck_assert_int_eq(contacts_at(&s, x, y, z, 0.2, F), 1);
    ck_assert_double_eq_tol(vector_length(F), 1e4 * 0.01, 1e-9);
    ck_assert_double_eq_tol(F[0], 1e4 * 0.01 * each[_i] / near, 1e-9);
    ck_assert_double_eq_tol(F[1], _i >= 1 ? F[0] : 0.0, 1e-9);
    ck_assert_double_eq_tol(F[2], _i >= 2 ? F[0] : 0.0, 1e-9);
    forget(&s);
}

/* Inside: as many as there are faces; each pushes with its own overlap. */
FACT_FOR_EACH(concave_corner_touches_a_sphere_with_each_face, 3)
{
    struct surface s = box_of((double[3]){0.5, 0.5, 0.5});
    const double x = 0.41, y = _i >= 1 ? 0.42 : 0.1, z = _i >= 2 ? 0.43 : 0.1;
    double F[3];

    ck_assert_int_eq(contacts_at(&s, x, y, z, 0.2, F), 1 + _i);
    ck_assert_double_eq_tol(F[0], -1e4 * 0.01, 1e-9);
    ck_assert_double_eq_tol(F[1], _i >= 1 ? -1e4 * 0.02 : 0.0, 1e-9);
    ck_assert_double_eq_tol(F[2], _i >= 2 ? -1e4 * 0.03 : 0.0, 1e-9);
    forget(&s);
}

/* A plate of 12 triangles that is thinner than the overlap: its far side and
 * its rim do not push. */
FACT_FOR_EACH(thin_plate_touches_a_sphere_once, 4)
{
    struct surface s = box_of((double[3]){0.5, 0.001, 0.5});
    const double at[4][2] = {
        {0.0, 0.0}, {0.17, 0.17}, {0.495, 0.1}, {0.495, 0.496}};
    double F[3];

    ck_assert_int_eq(contacts_at(&s, at[_i][0], 0.096, at[_i][1], 0.2, F), 1);
    ck_assert_double_eq_tol(F[1], 1e4 * 0.005, 1e-9);
    ck_assert_double_eq_tol(fabs(F[0]) + fabs(F[2]), 0.0, 1e-9);
    forget(&s);
}

/* Between two plates: one contact each. */
FACT(sphere_between_two_plates_touches_both)
{
    struct surface s = box_of((double[3]){0.5, 0.099, 0.5});
    double F[3];

    ck_assert_int_eq(contacts_at(&s, 0.1, 0.0, 0.1, 0.2, F), 2);
    ck_assert_double_eq_tol(vector_length(F), 0.0, 1e-9);
    forget(&s);
}

/* --- many ----------------------------------------------------------------- */

/* The box of walls and the same box of triangles: a cloud in it moves in the
 * same way, until chaos makes 1e-16 visible. */
static double apart(int threads, struct particles **left)
{
    const double half = 0.6;
    struct surface s = box_of((double[3]){half, half, half});
    struct dem_options o[2];
    struct particles *ps[2];
    double far = 0.0;

    omp_set_num_threads(threads);
    for (int k = 0; k < 2; k++) {
        struct dem_report r;
        ps[k] = spheres_cloud(13, 0.06, 0.4, 0.09, 1.0, 5);
        o[k] = with(&contact_hertz, 2e-5, &s, k);
        o[k].lo[0] = o[k].lo[1] = o[k].lo[2] = k ? -2.0 : -half;
        o[k].hi[0] = o[k].hi[1] = o[k].hi[2] = k ? 2.0 : half;
        struct dem *const dem = dem_create(ps[k], &o[k]);
        ck_assert_int_eq(dem_run(dem, 1500, &r), 0);
        ck_assert_int_gt(r.contacts, 100);
        dem_free(dem);
    }
    for (int i = 0; i < ps[0]->n; i++) {
        const int j = spheres_place(ps[1], ps[0]->id[i]);
        far = fmax(far, fabs(ps[0]->x[i] - ps[1]->x[j]));
    }
    particles_free(ps[0]);
    *left = ps[1];
    forget(&s);
    return far;
}

FACT(box_of_triangles_is_a_box)
{
    struct particles *ps;

    ck_assert_double_le(apart(1, &ps), 1e-9);
    particles_free(ps);
}

FACT(surfaces_give_the_same_bits_with_two_threads)
{
    struct particles *one, *two;

    apart(1, &one);
    apart(2, &two);
    for (int i = 0; i < one->n; i++) {
        ck_assert_int_eq(one->id[i], two->id[i]);
        ck_assert(one->x[i] == two->x[i] && one->wz[i] == two->wz[i]);
    }
    particles_free(one);
    particles_free(two);
    omp_set_num_threads(1);
}

/* --- springs -------------------------------------------------------------- */

/* A sphere slides and rolls over a floor; the run is interrupted in the middle
 * and continued from the state of the contacts, with a new list: the same but
 * for the rounding of R omega, which depends on when lists are made. */
FACT(springs_of_surfaces_are_part_of_the_state)
{
    struct surface s = floor_of_two(0.5 * M_PI);
    const struct dem_options o = with(&contact_hertz, 2e-5, &s, 1);
    struct particles *const ps = thrown(0.8, 0.0);
    struct particles *const twin = thrown(0.8, 0.0);
    struct dem *const dem = dem_create(ps, &o);
    struct dem *const first = dem_create(twin, &o);
    struct dem *const second = dem_create(twin, &o);
    struct dem_report r;
    int n;

    dem_run(dem, 5000, &r);
    dem_changed(dem);
    dem_run(dem, 5000, &r);
    dem_run(first, 5000, &r);
    struct dem_history *const list = dem_histories(first, &n);
    ck_assert_int_eq(n, 1);
    ck_assert_double_gt(vector_length(list[0].xi), 1e-9);
    dem_restore_histories(second, list, n);
    dem_run(second, 5000, &r);
    ck_assert_double_eq_tol(ps->x[0], twin->x[0], 1e-13);
    ck_assert_double_eq_tol(ps->wz[0], twin->wz[0], 1e-13);
    free(list);
    dem_free(dem);
    dem_free(first);
    dem_free(second);
    particles_free(ps);
    particles_free(twin);
    forget(&s);
}

/* --- through the wall ------------------------------------------------------
 */

/* So fast that it is near the sheet in no step; or pressed through. */
FACT_FOR_EACH(particle_through_a_sheet_is_lost_by_its_id, 2)
{
    struct surface s[2] = {plane(0, -1.5, 0, 0, 1, 0), floor_of_two(0.3)};
    const struct dem_options o = with(&contact_linear, _i ? 1e-5 : 1e-2, s, 2);
    struct particles *const ps = particles_create(2);
    struct dem_report r;

    spheres_add(ps, 0.5, 1.0, 0.0, 0.2);
    spheres_add(ps, 0.1, 0.5, 0.2, 0.2);
    spheres_throw(ps, 1, 0.0, _i ? -30.0 : -100.0, 0.0);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_ne(dem_run(dem, _i ? 10000 : 1, &r), 0);
    ck_assert_int_eq(r.lost, 1);
    ck_assert_int_eq(r.lost_id, 1);
    ck_assert_int_eq(r.lost_through, 1);
    dem_free(dem);
    particles_free(ps);
    forget(&s[1]);
}

FACT(particle_in_the_solid_of_a_plane_is_lost)
{
    struct surface s = plane(0, 0, 0, 0, 1, 0);
    struct dem_options o = with(&contact_linear, 1e-5, &s, 1);
    struct particles *const ps = particles_create(1);
    struct dem_report r;

    spheres_add(ps, 0.1, 0.5, 0.2, 0.2);
    spheres_throw(ps, 0, 0.0, -60.0, 0.0);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_ne(dem_run(dem, 10000, &r), 0);
    ck_assert_int_eq(r.lost_id, 0);
    ck_assert_int_eq(r.lost_through, 0);
    dem_free(dem);
    particles_free(ps);
}
