/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fast loop against the reference loop over hundreds of steps: what the
 * chapters on lists and on speed do must not change what comes out. */
#include <stdlib.h>

#include "dem/attraction.h"
#include "dem/energy.h"
#include "dem/fast/fast.h"
#include "dem/reference.h"
#include "dem/surfaces/prescribed_particles.h"
#include "dem/surfaces/surface.h"
#include "facts.h"
#include "same_motion.h"

static const struct dem_method *const references[2] = {&reference_all_pairs,
                                                       &reference_link_cells};

enum { N = 151 };
static const double L = 14e-3; /* [m] side of the box */

/* Two sizes, thrown together in a small box with friction and gravity: some
 * hundred contacts at a time. There is capacity for ten more. */
static struct particles *thrown(void)
{
    struct particles *const ps = particles_create(N + 10);
    uint64_t seed = 3;

    for (int i = 0; i < N; i++) {
        const double x[3] = {2.3e-3 * (i % 6 + 0.55), 2.3e-3 * (i / 36 + 0.55),
                             2.3e-3 * (i / 6 % 6 + 0.55)};
        particles_add(ps, x, i % 2 ? 2e-3 : 2.28e-3, 2000.0);
        ps->ey[i] = -200.0 * ps->m[i];
        spheres_throw(ps, i, 0.3 * spheres_random(&seed),
                      -0.5 + 0.3 * spheres_random(&seed),
                      0.3 * spheres_random(&seed));
        spheres_spin(ps, i, 50.0 * spheres_random(&seed), 0.0, 0.0);
    }
    return ps;
}

static struct dem_options bed_of(int law, const struct dem_method *method)
{
    struct dem_options o = spheres_options(contact_laws[law], 4e-6, 0.5 * L);

    o.method = method;
    o.material.friction = 0.3;
    o.material.restitution = 0.5;
    for (int k = 0; k < 3; k++) {
        o.lo[k] = 0.0;
        o.hi[k] = L;
    }
    return o;
}

/* Rounding grows by a factor at every impact; after 1200 steps it is some 1e-9
 * of the largest velocity. A contact that is missed, done twice, or with the
 * wrong tangential displacement is 1e-3. */
static const double grown_rounding = 1e-7;

FACT_FOR_EACH(the_fast_loop_agrees_with_the_reference_loop, 4)
{
    struct particles *ps[2];
    struct dem_report r[2];

    for (int k = 0; k < 2; k++) {
        struct dem_options o =
            bed_of(_i % 2, k == 0 ? &fast_verlet : references[_i / 2]);
        o.integrator = integrators[_i / 2];
        ps[k] = thrown();
        struct dem *const dem = dem_create(ps[k], &o);
        ck_assert_int_eq(dem_run(dem, 900, &r[k]), 0);
        ck_assert_int_eq(dem_run(dem, 300, &r[k]), 0);
        dem_free(dem);
    }
    ck_assert_int_gt(r[0].contacts, 60);
    same_report(&r[0], &r[1], grown_rounding);
    same_motion(ps[0], ps[1], L, 0, grown_rounding);
    particles_free(ps[0]);
    particles_free(ps[1]);
}

/* --- every option at once ------------------------------------------------- */

static const struct material glass = {.young = 3e7,
                                      .poisson = 0.3,
                                      .stiffness = 2e4,
                                      .restitution = 0.8,
                                      .friction = 0.2,
                                      .rolling = 0.05};
static const struct materials_measured measured = {0,   1,   -1.0, -1.0,
                                                   0.6, 0.4, 0.02};
static const struct materials two = {2, &glass, 1, &measured, 1};

/* Periodic in the directions whose bits are set. */
static struct dem_options all_options(int law, int periodic,
                                      const struct dem_method *method,
                                      const struct attraction *wet)
{
    struct dem_options o = bed_of(law, method);

    o.material.rolling = 0.1;
    o.materials = &two;
    o.attractions = wet;
    o.n_attractions = 1;
    for (int k = 0; k < 3; k++)
        o.periodic[k] = periodic >> k & 1;
    return o;
}

static struct particles *thrown_of_two_materials(void)
{
    struct particles *const ps = thrown();

    particles_add_material(ps);
    particles_add_implicit_drag(ps);
    for (int i = 0; i < N; i++) {
        ps->material[i] = i % 3 == 0;
        ps->drag_coefficient[i] = 20.0 * ps->m[i];
        ps->added_mass[i] = 0.1 * i / N * ps->m[i];
    }
    return ps;
}

static void add_one(struct particles *ps)
{
    const double x[3] = {0.3 * L, 0.93 * L, 0.4 * L};
    const int i = particles_add(ps, x, 1.5e-3, 2500.0);

    ps->material[i] = 1;
    ps->vy[i] = -1.0;
}

static void remove_some(struct dem *dem, const struct particles *ps)
{
    int gone[N + 10];

    for (int i = 0; i < ps->n; i++)
        gone[i] = ps->id[i] % 10 == 4;
    dem_remove(dem, gone);
}

/* 480 steps, between which a particle is added and some are removed; with
 * springs = 1 the last part begins with a new dem and the histories of the one
 * before. */
static struct particles *life(const struct dem_options *o, int springs,
                              struct dem_report *r, struct energy *e)
{
    struct particles *const ps = thrown_of_two_materials();
    struct dem *dem = dem_create(ps, o);

    dem_start_energy_budget(dem);
    ck_assert_int_eq(dem_run(dem, 360, r), 0);
    add_one(ps);
    dem_changed(dem);
    ck_assert_int_eq(dem_run(dem, 60, r), 0);
    remove_some(dem, ps);
    if (springs) {
        int n;
        struct dem_history *const list = dem_histories(dem, &n);
        dem_free(dem);
        dem = dem_create(ps, o);
        dem_start_energy_budget(dem);
        dem_restore_histories(dem, list, n);
        free(list);
    }
    ck_assert_int_eq(dem_run(dem, 60, r), 0);
    *e = *dem_energy(dem);
    dem_free(dem);
    return ps;
}

static void same_term(double got, double want, double scale)
{
    ck_assert_double_eq_tol(got, want, grown_rounding * scale);
}

static void same_energy(const struct energy *a, const struct energy *b)
{
    const double E = b->added;

    same_term(a->kinetic, b->kinetic, E);
    same_term(a->normal, b->normal, E);
    same_term(a->tangential, b->tangential, E);
    same_term(a->damped_n, b->damped_n, E);
    same_term(a->damped_t, b->damped_t, E);
    same_term(a->slid, b->slid, E);
    same_term(a->released, b->released, E);
    same_term(a->rolled, b->rolled, E);
    same_term(a->work, b->work, E);
    same_term(a->attracted, b->attracted, E);
    same_term(a->added, b->added, E);
}

/* 151 spheres in boxes of any directions, two laws, two materials with a wall
 * of the second, rolling friction, bridges of liquid, drag, added mass, an
 * energy budget, insertion and removal. The integrator is velocity Verlet: with
 * symplectic Euler a run begins with the velocities of the last sweep, and the
 * lists that are made anew ask a sliding contact again whether its force is
 * above the limit, where it is equal to it. */
FACT_FOR_EACH(the_fast_loop_agrees_with_every_option_at_once, 16)
{
    const int law = _i & 1, periodic = _i >> 1, springs = periodic % 3 == 0;
    const struct attraction wet = {
        .law = &capillary, .range = 2e-4, .strength = 0.05};
    struct particles *ps[3];
    struct dem_report r[3];
    struct energy e[3];

    for (int k = 0; k < 3; k++) {
        const struct dem_options o = all_options(
            law, periodic, k == 0 ? &fast_verlet : references[k - 1], &wet);
        ps[k] = life(&o, springs, &r[k], &e[k]);
    }
    ck_assert_int_gt(r[0].contacts, 5);
    for (int k = 1; k < 3; k++) {
        same_report(&r[0], &r[k], grown_rounding);
        same_motion(ps[0], ps[k], L, periodic, grown_rounding);
        same_energy(&e[0], &e[k]);
        for (int i = 0; i < 3 * ps[0]->n; i++) {
            const int j = 3 * spheres_place(ps[k], ps[0]->id[i / 3]) + i % 3;
            ck_assert_double_eq_tol(ps[0]->drag_impulse[i],
                                    ps[k]->drag_impulse[j], 1e-13);
        }
    }
    for (int k = 0; k < 3; k++)
        particles_free(ps[k]);
}

/* A run that the fast loop began is continued by the reference loop as if it
 * had not changed: histories are the same list for both, with either of the two
 * as the owner of a pair. */
FACT_FOR_EACH(either_loop_continues_what_the_other_began, 2)
{
    struct particles *ps[4];

    for (int k = 0; k < 4; k++) {
        struct dem_options o =
            bed_of(_i, k & 1 ? &reference_link_cells : &fast_verlet);
        struct dem_report r;
        int n;
        ps[k] = thrown();
        struct dem *const first = dem_create(ps[k], &o);
        ck_assert_int_eq(dem_run(first, 500, &r), 0);
        struct dem_history *const list = dem_histories(first, &n);
        dem_free(first);
        o.method = k & 2 ? &reference_all_pairs : &fast_verlet;
        struct dem *const second = dem_create(ps[k], &o);
        dem_restore_histories(second, list, n);
        free(list);
        ck_assert_int_eq(dem_run(second, 200, &r), 0);
        dem_free(second);
    }
    for (int k = 1; k < 4; k++)
        same_motion(ps[k], ps[0], L, 0, grown_rounding);
    for (int k = 0; k < 4; k++)
        particles_free(ps[k]);
}

/* --- what is reported ----------------------------------------------------- */

/* Two spheres deep in each other, and one that leaves the box. */
FACT_FOR_EACH(both_loops_report_lost_particles_and_deep_overlaps, 3)
{
    const struct dem_method *const method[3] = {
        &fast_verlet, &reference_all_pairs, &reference_link_cells};
    struct dem_options o = spheres_options(contact_laws[1], 1e-5, 0.5);
    struct particles *const ps = particles_create(3);
    struct dem_report r;

    o.method = method[_i];
    o.material.stiffness = 1.0;
    spheres_add(ps, 0.0, 0.0, 0.0, 0.1);
    spheres_add(ps, 0.08, 0.0, 0.0, 0.1);
    spheres_add(ps, 0.0, 0.4, 0.0, 0.1);
    struct dem *const dem = dem_create(ps, &o);
    dem_limit_overlap(dem, 0.1, 0.5);
    ck_assert_int_eq(dem_run(dem, 1, &r), 0);
    const struct dem_overlap deep = dem_deepest(dem);
    ck_assert_double_eq_tol(deep.depth, 0.2, 1e-6);
    ck_assert_int_eq(deep.id + deep.other, 1);
    ck_assert_int_eq(dem_deepest(dem).expected == 0.1, 1);
    ps->vy[spheres_place(ps, 2)] = 1e5;
    ck_assert_int_ne(dem_run(dem, 1, &r), 0);
    ck_assert_int_eq(r.lost, 1);
    ck_assert_int_eq(r.lost_id, 2);
    ck_assert_double_eq_tol(r.lost_at[1], 1.4, 1e-6);
    dem_free(dem);
    particles_free(ps);
}

FACT_FOR_EACH(the_reference_loop_refuses_what_it_does_not_know, 2)
{
    const struct surface floor = {
        .name = "floor", .shape = &surface_plane, .normal = {0.0, 1.0, 0.0}};
    const struct prescribed_particle one = {.id = 0};
    struct particles *const ps = particles_create(1);
    struct dem_options o = bed_of(0, references[_i]);

    spheres_add(ps, 0.5 * L, 0.5 * L, 0.5 * L, 1e-3);
    dem_free(dem_create(ps, &o));
    o.integrator = integrator_named("heun");
    ck_assert_ptr_null(dem_create(ps, &o));
    o.integrator = NULL;
    o.surfaces = &floor;
    o.n_surfaces = 1;
    ck_assert_ptr_null(dem_create(ps, &o));
    o.n_surfaces = 0;
    o.prescribed = &one;
    o.n_prescribed = 1;
    ck_assert_ptr_null(dem_create(ps, &o));
    particles_free(ps);
}
