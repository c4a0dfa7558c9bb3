/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A heap of spheres that is moved across the seams of a periodic box is the
 * heap that it was in a closed one: every number of the contact loop. */
#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "dem/attraction.h"
#include "dem/energy.h"
#include "dem/reference.h"
#include "facts.h"
#include "same_motion.h"

enum { SPHERES = 90, STEPS = 12, METHODS = 3, SCENES = 8 };

static const double L = 0.04; /* [m] side of the box */

static const struct dem_method *const methods[METHODS] = {
    &fast_verlet, &reference_link_cells, &reference_all_pairs};

/* The charge of a sphere of each material [C]. */
static const double charge[2] = {4e-9, -2e-9};

/* What acts besides the contact: bit 0 the law, bit 1 cohesion, bit 2 rolling
 * and a second material. */
static struct dem_options options_of(int scene, int periodic,
                                     const struct materials *two,
                                     struct attraction pull[3])
{
    struct dem_options o =
        spheres_options(contact_laws[scene & 1], 2e-5, 0.5 * L);

    pull[0] = (struct attraction){.law = &electrostatic,
                                  .range = 1e-3,
                                  .strength = 1.0,
                                  .charge = charge};
    pull[1] = (struct attraction){.law = &van_der_waals,
                                  .range = 1e-3,
                                  .strength = 1e-7,
                                  .closest = 1e-5};
    pull[2] =
        (struct attraction){.law = &capillary, .range = 1e-3, .strength = 0.05};
    o.material.stiffness = 500.0;
    o.material.young = 1e6;
    o.material.restitution = 0.7;
    o.material.friction = 0.3;
    o.material.rolling = scene & 4 ? 0.1 : 0.0;
    o.materials = scene & 4 ? two : NULL;
    for (int k = 0; k < 3; k++)
        o.periodic[k] = periodic >> k & 1;
    o.attractions = pull;
    o.n_attractions = scene & 2 ? 3 : 0;
    return o;
}

/* Spheres of 2.4 to 3.6 mm at random in the middle third of the box, most of
 * which touch; nothing reaches the walls. */
static struct particles *heap(const double shift[3], int scene)
{
    struct particles *const ps = particles_create(SPHERES);
    uint64_t seed = 11;

    if (scene & 4) particles_add_material(ps);
    for (int i = 0; i < SPHERES; i++) {
        double x[3];
        for (int k = 0; k < 3; k++) {
            x[k] = 0.16 * L * spheres_random(&seed) + shift[k];
            x[k] -= shift[k] == 0.0 ? 0.0 : L * floor(x[k] / L + 0.5);
        }
        spheres_add(ps, x[0], x[1], x[2],
                    3e-3 * (1.0 + 0.2 * spheres_random(&seed)));
        spheres_throw(ps, i, 0.2 * spheres_random(&seed),
                      0.2 * spheres_random(&seed), 0.2 * spheres_random(&seed));
        spheres_spin(ps, i, 40.0 * spheres_random(&seed),
                     40.0 * spheres_random(&seed),
                     40.0 * spheres_random(&seed));
        ps->ey[i] = -9.81 * ps->m[i];
        if (ps->material != NULL) ps->material[i] = i % 2;
    }
    return ps;
}

/* What a run gives. */
struct outcome {
    struct particles *ps;
    struct dem_report report;
    struct energy energy;
    struct dem_overlap deepest;
    struct dem_history *spring;
    int n_springs;
};

static struct outcome outcome_of(int scene, int periodic, const double shift[3],
                                 const struct dem_method *method)
{
    const struct material other = {.young = 3e6,
                                   .poisson = 0.3,
                                   .stiffness = 800.0,
                                   .restitution = 0.9,
                                   .friction = 0.5,
                                   .rolling = 0.05};
    const struct materials two = {.n = 2, .further = &other};
    struct attraction pull[3];
    struct dem_options o = options_of(scene, periodic, &two, pull);
    struct outcome out = {.ps = heap(shift, scene)};

    o.method = method;
    struct dem *const dem = dem_create(out.ps, &o);
    ck_assert_ptr_nonnull(dem);
    dem_limit_overlap(dem, 0.0, 10.0);
    dem_start_energy_budget(dem);
    ck_assert_int_eq(dem_run(dem, STEPS, &out.report), 0);
    out.energy = *dem_energy(dem);
    out.deepest = dem_deepest(dem);
    out.spring = dem_histories(dem, &out.n_springs);
    dem_free(dem);
    for (int i = 0; i < SPHERES; i++) { /* back to where it was */
        out.ps->x[i] -= shift[0];
        out.ps->y[i] -= shift[1];
        out.ps->z[i] -= shift[2];
    }
    return out;
}

static void release(struct outcome *o)
{
    particles_free(o->ps);
    free(o->spring);
}

/* Places are rounded to 1e-18 m when they are moved, overlaps of 1e-4 m to
 * 1e-14 of them; contacts hardly amplify that in a dozen steps. A neighbour
 * that is missed, or one period off, changes all in the first digits. */
static const double rounding = 1e-9;

static void compare_energy(const struct energy *got, const struct energy *want)
{
    const double g[] = {got->kinetic,   got->normal,   got->tangential,
                        got->damped_n,  got->damped_t, got->slid,
                        got->released,  got->rolled,   got->work,
                        got->attracted, got->added};
    const double w[] = {want->kinetic,   want->normal,   want->tangential,
                        want->damped_n,  want->damped_t, want->slid,
                        want->released,  want->rolled,   want->work,
                        want->attracted, want->added};

    for (size_t k = 0; k < sizeof g / sizeof *g; k++)
        ck_assert_double_eq_tol(g[k], w[k], rounding * want->kinetic);
}

/* The tangential and rolling springs, by the ids of the two. */
static void compare_springs(const struct outcome *got,
                            const struct outcome *want)
{
    double most[2] = {1e-300, 1e-300};

    ck_assert_int_eq(got->n_springs, want->n_springs);
    for (int i = 0; i < want->n_springs; i++)
        for (int k = 0; k < 3; k++) {
            most[0] = fmax(most[0], fabs(want->spring[i].xi[k]));
            most[1] = fmax(most[1], fabs(want->spring[i].roll_angle[k]));
        }
    for (int i = 0; i < want->n_springs; i++) {
        const struct dem_history *const w = &want->spring[i], *g = NULL;
        double sign = 1.0;
        for (int j = 0; j < got->n_springs && g == NULL; j++) {
            const struct dem_history *const s = &got->spring[j];
            if (s->id == w->id && s->other == w->other) g = s;
            if (s->id == w->other && s->other == w->id) g = s, sign = -1.0;
        }
        ck_assert_ptr_nonnull(g);
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(sign * g->xi[k], w->xi[k],
                                    100.0 * rounding * most[0]);
            ck_assert_double_eq_tol(sign * g->roll_angle[k], w->roll_angle[k],
                                    100.0 * rounding * most[1]);
        }
    }
}

static void compare_deepest(const struct dem_overlap *got,
                            const struct dem_overlap *want)
{
    ck_assert_int_eq(got->id + got->other, want->id + want->other);
    ck_assert_double_eq_tol(got->depth, want->depth, rounding);
}

/* Moved by half a period, and by a part of it that leaves the heap on both
 * sides of the seam unequally, in every direction that is periodic. */
static void compare(int scene, int periodic, const struct outcome *want)
{
    static const double parts[2] = {0.5, -0.37};

    for (int k = 0; k < 2 * METHODS; k++) {
        double shift[3];
        for (int a = 0; a < 3; a++)
            shift[a] = periodic >> a & 1 ? parts[k % 2] * L : 0.0;
        struct outcome got = outcome_of(scene, periodic, shift, methods[k / 2]);
        same_report(&got.report, &want->report, rounding);
        same_motion(got.ps, want->ps, L, periodic, rounding);
        compare_energy(&got.energy, &want->energy);
        compare_springs(&got, want);
        compare_deepest(&got.deepest, &want->deepest);
        release(&got);
    }
}

FACT_FOR_EACH(a_heap_moved_across_the_seams_has_the_same_numbers, SCENES)
{
    const double here[3] = {0.0, 0.0, 0.0};
    struct outcome want = outcome_of(_i, 0, here, &reference_all_pairs);

    ck_assert_int_gt(want.report.contacts, SPHERES);
    ck_assert_double_gt(want.energy.slid, 1e-3 * want.energy.kinetic);
    for (int periodic = 1; periodic < 8; periodic++)
        compare(_i, periodic, &want);
    release(&want);
}
