/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What particles wear off walls, and the stresses of the faces. */
#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "dem/surfaces/surfaces.h"
#include "facts.h"
#include "spheres.h"

static const double hardness = 1e9, g = 9.81; /* [Pa], [m/s^2] */
static const double stiffness = 1e8; /* [N/m]: no overlap changes a lever arm */

/* U^2 f(alpha) of a speed of 1 m/s at this angle [rad] to a floor. */
static double angle_function(double alpha)
{
    const struct wear_of w = {.hardness = 0.25, .cutting = 1.0};
    const double v[3] = {cos(alpha), -sin(alpha), 0.0};

    return wear_finnie(&w, 1.0, v, (const double[3]){0.0, 1.0, 0.0});
}

FACT(finnie_cuts_most_at_16_845_degrees)
{
    const double best = 0.5 * atan(2.0 / 3.0), degree = M_PI / 180.0;

    ck_assert_double_eq_tol(best / degree, 16.845, 5e-4);
    ck_assert_double_eq_tol(angle_function(best), 0.5 * (sqrt(13.0) - 3.0),
                            1e-15);
    for (int a = 1; a < 900; a++)
        ck_assert_double_lt(angle_function(0.1 * a * degree),
                            0.5 * (sqrt(13.0) - 3.0));
    /* both branches at tan alpha = 1/3, then the second one alone */
    ck_assert_double_eq_tol(angle_function(atan(1.0 / 3.0) - 1e-9), 0.3, 1e-8);
    ck_assert_double_eq_tol(angle_function(atan(1.0 / 3.0) + 1e-9), 0.3, 1e-8);
    ck_assert_double_eq_tol(angle_function(10.0 * degree), 0.251559, 1e-6);
    ck_assert_double_eq_tol(angle_function(25.0 * degree), 0.273798, 1e-6);
    ck_assert_double_eq_tol(angle_function(30.0 * degree), 0.25, 1e-15);
    ck_assert_double_eq_tol(angle_function(60.0 * degree), 1.0 / 12.0, 1e-15);
    ck_assert_double_eq_tol(angle_function(0.0), 0.0, 1e-15);
    ck_assert_double_eq_tol(angle_function(90.0 * degree), 0.0, 1e-15);
    ck_assert(angle_function(-30.0 * degree) == 0.0); /* on the way out */
}

/* A floor, y = 0, of two triangles. */
static struct surface floor_that_wears(double cutting, double archard)
{
    double corner[2][3][3] = {
        {{-1.5, 0.0, -1.5}, {-1.5, 0.0, 1.5}, {1.5, 0.0, 1.5}},
        {{-1.5, 0.0, -1.5}, {1.5, 0.0, 1.5}, {1.5, 0.0, -1.5}}};
    const struct surface s = {.name = "floor",
                              .shape = &surface_stl,
                              .triangles = triangles_create(2, corner),
                              .wear = {hardness, cutting, archard}};
    return s;
}

static void forget(struct surface *s)
{
    owner_free((struct triangles *)(uintptr_t)s->triangles);
}

static struct dem_options with(const struct surface *s, double step, double e,
                               double mu)
{
    struct dem_options o = spheres_options(&contact_linear, step, 2.0);

    o.material.stiffness = stiffness;
    o.material.tangential = 1.0;
    o.material.restitution = e;
    o.material.friction = mu;
    o.surfaces = s;
    o.n_surfaces = 1;
    return o;
}

static struct wear_face all_faces(const struct dem *dem,
                                  const struct surface *s)
{
    const struct wear_face *const face = dem_surface_wear(dem, 0);
    struct wear_face sum = {0};

    for (int f = 0; f < wear_faces(s); f++) {
        sum.worn += face[f].worn;
        sum.normal += face[f].normal;
        sum.shear += face[f].shear;
    }
    return sum;
}

/* Contact time of the sphere of 0.2 m with the floor [s]. */
static double contact_time(double mass)
{
    return M_PI * sqrt(mass / stiffness);
}

/* One sphere of 0.2 m from just above the floor, until it has left. */
static struct wear_face impact(const struct surface *s, double vx, double vy,
                               double parts, double e, double mu, double *mass)
{
    struct particles *const ps = particles_create(1);
    struct dem_report r;

    spheres_add(ps, -0.3, 0.100001, 0.2, 0.2);
    spheres_throw(ps, 0, vx, vy, 0.0);
    *mass = ps->m[0];
    const double step = contact_time(*mass) / parts;
    const struct dem_options o = with(s, step, e, mu);
    struct dem *const dem = dem_create(ps, &o);
    dem_clock(dem, 0);
    ck_assert_int_eq(dem_run(dem, (int)(2.0 * parts), &r), 0);
    ck_assert_int_eq(r.contacts, 0);
    const struct wear_face sum = all_faces(dem, s);
    dem_free(dem);
    particles_free(ps);
    return sum;
}

/* Neither the step nor the restitution nor a plate that moves with both. */
FACT(an_impact_wears_what_its_velocity_says)
{
    struct surface s = floor_that_wears(0.8, 0.0);
    double m;

    for (int k = 0; k < 4; k++) {
        const double e = k % 2 ? 0.5 : 1.0, parts = k < 2 ? 20.0 : 113.0;
        const double V = 0.8 * 0.25 * 0.25 / (4.0 * hardness);
        double worn =
            impact(&s, 0.5 * cos(M_PI / 6), -0.25, parts, e, 0.3, &m).worn;
        ck_assert_double_eq_tol(worn / (m * V), 1.0, 1e-12);
        s.motion.velocity[0] = 0.7;
        worn = impact(&s, 0.7 + 0.5 * cos(M_PI / 6), -0.25, parts, e, 0.3, &m)
                   .worn;
        ck_assert_double_eq_tol(worn / (m * V), 1.0, 1e-12);
        s.motion.velocity[0] = 0.0;
    }
    forget(&s);
}

/* V p/k_A = J (v_s - (7/4) mu J/m) of an elastic impact in which it slides all
 * the time, J = 2 m v_n. The steps in which the contact begins and ends are
 * counted whole or not at all, (dt/t_c)^2 in all; and the overlap, a thousandth
 * of the radius, shortens the arm of the friction. The forces of the faces are
 * J and mu J. */
FACT(an_impact_that_slides_wears_what_archard_says)
{
    struct surface s = floor_that_wears(0.0, 0.02);
    const double mu = 0.3, vn = 0.3, vs = 1.0;
    double m;

    for (int k = 0; k < 2; k++) {
        const double parts = k ? 500.0 : 50.0, tol = k ? 3e-4 : 1e-3;
        const struct wear_face sum = impact(&s, vs, -vn, parts, 1.0, mu, &m);
        const double J = 2.0 * m * vn;
        const double V = 0.02 / hardness * J * (vs - 1.75 * mu * J / m);
        ck_assert_double_eq_tol(sum.worn / V, 1.0, tol);
        ck_assert_double_eq_tol(sum.normal / J, 1.0, 1e-3);
        ck_assert_double_eq_tol(sum.shear / (mu * J), 1.0, 1e-3);
    }
    forget(&s);
}

/* It lies on the floor at its weight and slides at 1 m/s: without friction for
 * ever, with friction until it rolls, after v^2/(7 mu g). Then it wears no
 * more. */
FACT_FOR_EACH(a_sphere_wears_by_its_weight_times_its_way_of_sliding, 2)
{
    struct surface s = floor_that_wears(0.0, 0.02);
    const double mu = _i ? 0.2 : 0.0, step = 2e-5;
    const struct dem_options o = with(&s, step, 0.5, mu);
    struct particles *const ps = particles_create(1);
    struct dem_report r;

    spheres_add(ps, -0.5, 0.1, 0.2, 0.2);
    const double W = g * ps->m[0];
    ps->y[0] -= W / stiffness;
    ps->ey[0] = -W;
    spheres_throw(ps, 0, 1.0, 0.0, 0.0);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 25000, &r), 0);
    const double way = _i ? 1.0 / (7.0 * mu * g) : 0.5;
    const double V = 0.02 / hardness * W * way;
    const double worn = all_faces(dem, &s).worn;
    ck_assert_double_eq_tol(worn / V, 1.0, _i ? 1e-5 : 1e-9);
    ck_assert_int_eq(dem_run(dem, 25000, &r), 0);
    if (_i) ck_assert_double_eq_tol(all_faces(dem, &s).worn / worn, 1.0, 1e-12);
    dem_free(dem);
    particles_free(ps);
    forget(&s);
}

/* A box of 12 triangles, from -0.6 to 0.6, that shakes, with a cloud in it. */
static struct surface shaken_box(void)
{
    static const int face[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                   {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    double corner[12][3][3];

    for (int t = 0; t < 12; t++)
        for (int c = 0; c < 3; c++) {
            const int v = face[t / 2][t % 2 ? (c + 2) % 4 : c];
            for (int k = 0; k < 3; k++)
                corner[t][c][k] = (v >> k & 1) ? 0.6 : -0.6;
        }
    return (struct surface){
        .name = "box",
        .shape = &surface_stl,
        .triangles = triangles_create(12, corner),
        .wear = {hardness, 1.0, 0.02},
        .motion = {.amplitude = {0.01, 0.0, 0.0}, .frequency = 20.0}};
}

static void shake(const struct surface *s, int threads, double mu,
                  struct wear_face *face, struct dem_surface *received)
{
    const struct dem_options o = with(s, 2e-5, 0.8, mu);
    struct particles *const ps = spheres_cloud(13, 0.06, 0.4, 0.085, 3.0, 5);
    struct dem_report r;

    omp_set_num_threads(threads);
    struct dem *const dem = dem_create(ps, &o);
    dem_clock(dem, 0);
    ck_assert_int_eq(dem_run(dem, 2000, &r), 0);
    memcpy(face, dem_surface_wear(dem, 0), 12 * sizeof *face);
    *received = dem_surface(dem, 0);
    dem_free(dem);
    particles_free(ps);
    omp_set_num_threads(1);
}

/* Without friction the forces of the faces along their normals are all that the
 * box receives. */
FACT(forces_of_the_faces_are_the_reaction_of_the_particles)
{
    struct surface s = shaken_box();
    struct wear_face face[12];
    struct dem_surface got;
    double sum[3] = {0.0, 0.0, 0.0}, size = 0.0;

    shake(&s, 1, 0.0, face, &got);
    for (int f = 0; f < 12; f++) { /* two a side, against -x, x, -y, y, -z, z */
        sum[f / 4] += (f / 2 % 2 ? 1.0 : -1.0) * face[f].normal;
        size += face[f].normal;
        ck_assert_double_gt(face[f].worn, 0.0);
        ck_assert_double_le(face[f].shear, 1e-12 * face[f].normal);
    }
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(sum[k], got.impulse[k], 1e-12 * size);
    forget(&s);
}

FACT(wear_has_the_same_bits_with_two_threads)
{
    struct surface s = shaken_box();
    struct wear_face one[12], two[12];
    struct dem_surface got;

    shake(&s, 1, 0.3, one, &got);
    shake(&s, 2, 0.3, two, &got);
    ck_assert_int_eq(memcmp(one, two, sizeof one), 0);
    forget(&s);
}
