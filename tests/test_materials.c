/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several materials: the constants of a pair follow from both or from measured
 * values, and a single material costs and computes the same as before. */

#include "dem/materials.h"
#include "facts.h"
#include "spheres.h"

static const struct material glass = {.young = 48e9,
                                      .poisson = 0.2,
                                      .stiffness = 1e4,
                                      .restitution = 0.9,
                                      .friction = 0.3};
static const struct material steel = {.young = 208e9,
                                      .poisson = 0.3,
                                      .stiffness = 3e4,
                                      .restitution = 0.8,
                                      .friction = 0.5};

/* 1/E* = 0.96/48e9 + 0.91/208e9 and 1/G* = 1.8/20e9 + 1.7/80e9, by hand. A
 * mean of the two moduli would give 6.7e10. */
FACT(ls_4_9_a_contact_of_two_materials_has_the_moduli_of_both)
{
    const struct material_pair p = materials_mixed(&glass, &steel);
    const struct contact_constants k = contact_hertz.constants(&p);

    ck_assert_double_eq_tol(k.normal, 4.1025641e10, 1e3);
    ck_assert_double_eq_tol(k.tangential, 8.9887640e9, 1e3);
}

/* 2/(1/1e4 + 1/3e4) = 1.5e4, and the value of two equal springs is that of
 * each. */
FACT(ls_4_4_two_linear_springs_act_in_series)
{
    ck_assert_double_eq_tol(materials_mixed(&glass, &steel).stiffness, 1.5e4,
                            1e-8);
    ck_assert_double_eq(materials_mixed(&glass, &glass).stiffness, 1e4);
}

FACT(what_is_not_measured_is_the_smaller_one)
{
    const struct material_pair p = materials_mixed(&glass, &steel);

    ck_assert_double_eq(p.restitution, 0.8);
    ck_assert_double_eq(p.friction, 0.3);
    ck_assert_double_eq(p.rolling, 0.0);
}

/* Measured for 1 and 0, looked up for 0 and 1; only the given values are
 * used. */
FACT(measured_pair_values_are_symmetric)
{
    const struct materials_measured m = {1, 0, -1.0, -1.0, 0.0, 0.7, -1.0};
    const struct materials all = {2, &steel, 1, &m, 0};
    struct contact_constants k[4];

    materials_table(&contact_linear, &glass, &all, k);
    ck_assert_int_eq(memcmp(&k[1], &k[2], sizeof k[1]), 0);
    ck_assert_double_eq(k[1].friction, 0.7);
    ck_assert_double_eq(k[1].damping_n, 1.0); /* e = 0 is critical */
    ck_assert_double_eq_tol(k[1].normal, 1.5e4, 1e-8);
    ck_assert_double_eq(k[0].friction, 0.3);
    ck_assert_double_eq(k[3].friction, 0.5);
}

/* A glass sphere on a steel wall, elastic, at 1 m/s: the energy of the sphere
 * is (8/15) E* sqrt(R) delta^(5/2) at the deepest, in closed form. 0.2 % is
 * what a 1000th of the collision leaves; with the modulus of glass alone, 10 %
 * less force, and with that of steel, 65 % more. */
FACT(ls_4_7_a_glass_sphere_on_a_steel_wall_has_both_moduli)
{
    const double R = 0.005, v = 1.0, E = 4.1025641e10;
    const struct materials_measured m = {0, 1, -1.0, -1.0, 1.0, -1.0, -1.0};
    const struct materials all = {2, &steel, 1, &m, 1};
    struct dem_options o = spheres_options(&contact_hertz, 2e-8, 0.1);
    struct particles *const ps = particles_create(1);

    o.material = glass;
    o.materials = &all;
    spheres_add(ps, -0.1 + 1.0001 * R, 0.0, 0.0, 2.0 * R);
    spheres_throw(ps, 0, -v, 0.0, 0.0);
    const double delta =
        pow(15.0 * ps->m[0] * v * v / (16.0 * E * sqrt(R)), 0.4);
    const double force = 4.0 / 3.0 * E * sqrt(R) * pow(delta, 1.5);
    const struct collision c = spheres_collide(ps, &o);
    ck_assert_double_eq_tol(c.force / force, 1.0, 2e-3);
    ck_assert_double_eq_tol(c.overlap * 2.0 * R / delta, 1.0, 2e-3);
    particles_free(ps);
}

/* Speed that a sphere of the material keeps, from the wall or, if there is
 * one, from a sphere of the other material at rest. */
static double kept(const struct materials *all, int own, int other)
{
    struct dem_options o = spheres_options(&contact_linear, 1e-7, 0.1);
    struct particles *const ps = particles_create(2);

    o.material = glass;
    o.materials = all;
    particles_add_material(ps);
    spheres_add(ps, -0.0949, 0.0, 0.0, 0.01);
    spheres_throw(ps, 0, -1.0, 0.0, 0.0);
    ps->material[0] = own;
    if (other >= 0) {
        ps->x[0] = 0.0;
        spheres_add(ps, -0.01001, 0.0, 0.0, 0.01);
        ps->material[1] = other;
    }
    const struct collision c = spheres_collide(ps, &o);
    ck_assert_double_gt(c.time, 0.0);
    const int i = spheres_place(ps, 0), j = spheres_place(ps, 1);
    const double speed = ps->vx[i] - (other >= 0 ? ps->vx[j] : 0.0);
    particles_free(ps);
    return speed;
}

/* Each partner has its own e; 1 % is what steps of 1/1500 of a contact and
 * the last, attractive moments leave. */
FACT(each_pair_and_the_wall_have_their_own_restitution)
{
    const struct materials_measured m[] = {{0, 1, -1, -1, 0.6, -1, -1},
                                           {1, 2, -1, -1, 0.4, -1, -1},
                                           {0, 2, -1, -1, 0.2, -1, -1}};
    const struct material further[] = {steel, glass};
    const struct materials all = {3, further, 3, m, 2};

    ck_assert_double_eq_tol(kept(&all, 0, 0), 0.9, 0.01);
    ck_assert_double_eq_tol(kept(&all, 0, 1), 0.6, 0.01);
    ck_assert_double_eq_tol(kept(&all, 1, 0), 0.6, 0.01);
    ck_assert_double_eq_tol(kept(&all, 1, 1), 0.8, 0.01);
    ck_assert_double_eq_tol(kept(&all, 1, 2), 0.4, 0.01);
    ck_assert_double_eq_tol(kept(&all, 0, -1), 0.2, 0.01);
    ck_assert_double_eq_tol(kept(&all, 1, -1), 0.4, 0.01);
    ck_assert_double_eq_tol(kept(&all, 2, -1), 0.9, 0.01);
}

/* A cloud that collides, some of them with the walls. */
static struct particles *stirred(const struct materials *all, int law,
                                 int periodic)
{
    struct particles *const ps = spheres_cloud(6, 0.01, 0.5, 0.0155, 1.0, 7);
    struct dem_options o = spheres_options(contact_laws[law], 1e-5, 0.05);
    struct dem_report r;

    o.material = glass;
    o.material.young = 1e7;
    o.materials = all;
    o.periodic[0] = periodic;
    if (all != NULL) {
        particles_add_material(ps);
        for (int i = 0; i < ps->n; i++)
            ps->material[i] = i % 3;
    }
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 2000, &r), 0);
    ck_assert_int_gt(r.contacts + (int)r.rebuilds, 1);
    dem_free(dem);
    return ps;
}

/* Three materials that are one, to the bit: the loop with a table computes
 * what the loop without one does. */
FACT_FOR_EACH(equal_materials_are_one_material_bit_for_bit, 4)
{
    struct material same[] = {glass, glass};
    same[0].young = same[1].young = 1e7;
    const struct materials all = {3, same, 0, NULL, 1};
    struct particles *const a = stirred(NULL, _i / 2, _i % 2);
    struct particles *const b = stirred(&all, _i / 2, _i % 2);
    const size_t size = (size_t)a->n * sizeof(double);

    ck_assert_int_eq(memcmp(a->x, b->x, size), 0);
    ck_assert_int_eq(memcmp(a->vy, b->vy, size), 0);
    ck_assert_int_eq(memcmp(a->wz, b->wz, size), 0);
    for (int i = 0; i < b->n; i++) /* sorted anew, each with its own */
        ck_assert_int_eq(b->material[i], b->id[i] % 3);
    ck_assert_ptr_null(a->material);
    particles_free(a);
    particles_free(b);
}
