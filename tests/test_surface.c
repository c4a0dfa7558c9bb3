/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One point and one surface: where it is nearest, on which side, how far. */
#include "base/alloc.h"
#include "dem/surfaces/surface.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "dem/surfaces/triangles.h"
#include "facts.h"
#include "capture.h"
#include "spheres.h"

static const struct motion at_rest = {.until = 0.0};

static struct surface cylinder(int inside, double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    const struct surface s = {.name = "tube",
                              .shape = &surface_cylinder,
                              .point = {0.1, -0.2, 0.3},
                              .normal = {x / length, y / length, z / length},
                              .radius = 0.5,
                              .inside = inside};
    return s;
}

static void assert_vector(const double a[3], double x, double y, double z)
{
    ck_assert_double_eq_tol(a[0], x, 1e-14);
    ck_assert_double_eq_tol(a[1], y, 1e-14);
    ck_assert_double_eq_tol(a[2], z, 1e-14);
}

/* The axis of the cylinder is along z; the point is 0.3 from it along x, 0.2
 * within the radius. */
FACT_FOR_EACH(a_cylinder_is_solid_around_or_inside_its_radius, 2)
{
    const struct surface s = cylinder(_i, 0.0, 0.0, 1.0);
    const double y[3] = {0.4, -0.2, 7.0};
    const struct surface_hit h = surface_nearest(&s, 0, y);
    ck_assert_double_eq_tol(h.r, _i ? 0.2 : -0.2, 1e-14);
    assert_vector(h.n, _i ? -1.0 : 1.0, 0.0, 0.0);
    assert_vector(h.q, 0.6, -0.2, 7.0);
}

/* There all directions are alike, and some unit vector across the axis is
 * taken, whatever the axis. */
FACT_FOR_EACH(a_point_on_the_axis_of_a_cylinder_has_a_normal_across_it, 12)
{
    static const double axes[][3] = {{1, 0, 0},   {0, 1, 0},    {0, 0, 1},
                                     {2, 0.1, 0}, {0.1, -1, 1}, {1, 1, 1}};
    const struct surface s =
        cylinder(_i % 2, axes[_i / 2][0], axes[_i / 2][1], axes[_i / 2][2]);
    const struct surface_hit h = surface_nearest(&s, 0, s.point);
    ck_assert_double_eq_tol(vector_length(h.n), 1.0, 1e-14);
    ck_assert_double_eq_tol(vector_dot(h.n, s.normal), 0.0, 1e-14);
    ck_assert_double_eq_tol(h.r, _i % 2 ? 0.5 : -0.5, 1e-14);
}

/* On both sides along its normal and, in the triangle itself, along it, too. */
FACT_FOR_EACH(a_triangle_has_two_sides_and_a_point_in_it_is_given_one, 3)
{
    double corner[1][3][3] = {{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}};
    const struct surface s = {.name = "sheet",
                              .shape = &surface_stl,
                              .triangles = triangles_create(1, corner)};
    static const double height[] = {0.25, -0.25, 0.0};
    const double y[3] = {0.5, 0.5, height[_i]};
    const struct surface_hit h = surface_nearest(&s, 0, y);
    ck_assert_double_eq(h.r, fabs(height[_i]));
    assert_vector(h.q, 0.5, 0.5, 0.0);
    ck_assert_double_eq_tol(h.n[2], _i == 1 ? -1.0 : 1.0, 1e-14);
    ck_assert_double_eq_tol(vector_length(h.n), 1.0, 1e-14);
    owner_free((struct triangles *)(uintptr_t)s.triangles);
}

FACT(a_triangle_without_an_area_has_no_normal)
{
    const double line[3][3] = {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}};
    const double wide[3][3] = {{1, 0, 0}, {1, 2, 0}, {1, 0, 3}};
    double n[3];
    triangle_normal(line, n);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq(n[k], 0.0);
    triangle_normal(wide, n);
    assert_vector(n, 1.0, 0.0, 0.0);
}

/* A quarter turn about z through (1, 0, 0), and then 0.5 along z: the plane
 * y = 0 has become x = 1, its normal (0, 1, 0) has become (-1, 0, 0). */
FACT(a_sphere_touches_a_turned_plane_where_it_is_now)
{
    const struct surface s = {.shape = &surface_plane,
                              .normal = {0.0, 1.0, 0.0},
                              .motion = {.velocity = {0.0, 0.0, 0.5},
                                         .centre = {1.0, 0.0, 0.0},
                                         .spin = {0.0, 0.0, 0.5 * M_PI}}};
    const struct pose p = motion_pose(&s.motion, 1.0);
    const double x[3] = {0.7, 5.0, 6.0}, deep[3] = {1.3, 5.0, 6.0};
    const struct surface_hit h = surface_nearest_moved(&s, 0, &p, x);
    ck_assert_double_eq_tol(h.r, 0.3, 1e-14);
    assert_vector(h.n, -1.0, 0.0, 0.0);
    assert_vector(h.q, 1.0, 5.0, 6.0);
    ck_assert_int_eq(surface_contains(&s, &p, x, 0.1), 0);
    ck_assert_int_eq(surface_contains(&s, &p, deep, 0.31), 0);
    ck_assert_int_eq(surface_contains(&s, &p, deep, 0.29), 1);
}

/* Of a plane and a cylinder all that is in the box may be near; of triangles
 * only they. */
FACT(a_surface_reaches_to_the_farthest_corner_from_its_centre)
{
    double corner[1][3][3] = {{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}};
    const double lo[3] = {-5.0, -1.0, -1.0}, hi[3] = {4.0, 1.0, 2.0};
    struct surface s = {.shape = &surface_plane,
                        .motion = {.centre = {1.0, 0.0, 0.0}}};
    ck_assert_double_eq_tol(surface_reach(&s, lo, hi), sqrt(36.0 + 1.0 + 4.0),
                            1e-14);
    s.shape = &surface_stl;
    s.triangles = triangles_create(1, corner);
    ck_assert_double_eq_tol(surface_reach(&s, lo, hi), sqrt(4.0 + 4.0), 1e-14);
    owner_free((struct triangles *)(uintptr_t)s.triangles);
}

FACT(what_makes_no_surface_is_refused)
{
    struct surface s = cylinder(1, 0.0, 0.0, 1.0);
    struct capture c = capture_begin(2);
    static char text[CAPTURE_TEXT];
    ck_assert_int_eq(surface_wrong(&s), 0);
    s.radius = 0.0;
    ck_assert_int_ne(surface_wrong(&s), 0);
    s.radius = 0.5;
    s.normal[2] = 0.0;
    ck_assert_int_ne(surface_wrong(&s), 0);
    s.shape = &surface_stl;
    ck_assert_int_ne(surface_wrong(&s), 0);
    capture_end(&c, text);
    ck_assert_ptr_nonnull(strstr(text, "\"tube\": its radius is not > 0"));
    ck_assert_ptr_nonnull(strstr(text, "its normal or axis has no direction"));
    ck_assert_ptr_nonnull(strstr(text, "it has no triangles"));
}

/* A sphere of radius 0.1 m may begin 0.01 m deep in a plane or a sheet, not
 * 0.011 m; and its position is reported. */
FACT_FOR_EACH(a_tenth_of_the_radius_is_how_deep_a_sphere_may_begin, 2)
{
    double corner[1][3][3] = {{{-9, 0, -9}, {9, 0, -9}, {0, 0, 9}}};
    struct surface s = {.name = "floor",
                        .shape = _i ? &surface_stl : &surface_plane,
                        .normal = {0.0, 1.0, 0.0},
                        .triangles = triangles_create(1, corner),
                        .motion = at_rest};
    static const double height[] = {0.15, 0.0901, 0.0899, 0.03, -0.03};
    for (int k = 0; k < 5; k++) {
        struct particles *const ps = particles_create(2);
        static char text[CAPTURE_TEXT];
        spheres_add(ps, 0.5, 1.0, 0.0, 0.2);
        spheres_add(ps, 0.5, height[k], 0.0, 0.2);
        struct capture c = capture_begin(2);
        const int wrong = surface_start_wrong(ps, &s, 1, "");
        capture_end(&c, text);
        /* a sheet has the sphere on its other side */
        ck_assert_int_eq(wrong, k >= 2);
        if (k == 3)
            ck_assert_ptr_nonnull(
                strstr(text, "particle 1 at [0.5, 0.03, 0] m begins 0.03 m "
                             "from the surface \"floor\""));
        if (k == 4 && !_i)
            ck_assert_ptr_nonnull(strstr(text, "begins 0.03 m deep in"));
        particles_free(ps);
    }
    ck_assert_double_eq_tol(
        surface_distance(&s, 0.0, (double[]){0.5, 0.07, 0.0}, 0.1), 0.07,
        1e-14);
    owner_free((struct triangles *)(uintptr_t)s.triangles);
}

/* Where sphere 1 is that slid down a plane, sticking at first: with a neighbour
 * far away that is taken out half-way, or alone. */
static void slide(int neighbour, double found[4])
{
    const double n = sqrt(5.0);
    const struct surface s = {.name = "slope",
                              .shape = &surface_plane,
                              .normal = {1.0 / n, 2.0 / n, 0.0}};
    struct particles *const ps = particles_create(2);
    struct dem_options o = spheres_options(&contact_linear, 1e-5, 1.0);
    struct dem_report r;
    int gone[2] = {0, 0};

    o.material.friction = 0.3;
    o.material.restitution = 0.3;
    o.surfaces = &s;
    o.n_surfaces = 1;
    if (neighbour) spheres_add(ps, 0.0, 0.0222, -0.5, 0.04);
    const int i = spheres_add(ps, 0.0, 0.0222, 0.5, 0.04);
    for (int j = 0; j <= i; j++) {
        ps->ey[j] = -9.81 * ps->m[j];
        ps->vx[j] = j == i ? 0.1 : -0.3;
    }
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 2000, &r), 0);
    ck_assert_int_eq(r.contacts, 1 + neighbour);
    gone[spheres_place(ps, 0)] = neighbour;
    dem_remove(dem, gone);
    ck_assert_int_eq(ps->n, 1);
    ck_assert_int_eq(dem_run(dem, 500, &r), 0);
    ck_assert_int_eq(r.contacts, 1);
    found[0] = ps->x[0];
    found[1] = ps->y[0];
    found[2] = ps->vx[0];
    found[3] = ps->wz[0];
    dem_free(dem);
    particles_free(ps);
}

/* To the last bit: it has none of the data of the removed sphere. */
FACT(a_contact_on_a_surface_keeps_its_own_tangential_displacement)
{
    double with[4], alone[4];
    slide(1, with);
    slide(0, alone);
    for (int k = 0; k < 4; k++)
        ck_assert_double_eq(with[k], alone[k]);
}
