/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fast loop over the contacts, with all its lanes, blocks and chunks,
 * against the reference loop over all pairs: in boxes of all kinds, every
 * number that a few steps give. */
#include <gsl/gsl_math.h>
#include <omp.h>

#include "dem/attraction.h"
#include "dem/energy.h"
#include "dem/fast/fast.h"
#include "dem/reference.h"
#include "facts.h"
#include "same_motion.h"

enum { STEPS = 3 };

/* --- the scenes ----------------------------------------------------------- */

/* Spheres at random, many of which overlap; the box has the side L, and there
 * is room for so many more. */
static struct particles *swarm(int n, int room, double L, uint64_t seed)
{
    struct particles *const ps = particles_create(n + room);
    const double d = fmin(0.5 / cbrt(n), 0.18) * L;

    for (int i = 0; i < n; i++) {
        const double own = d * (1.3 + 0.3 * spheres_random(&seed));
        const double x = spheres_random(&seed), y = spheres_random(&seed);
        spheres_add(ps, 0.48 * L * x, 0.48 * L * y,
                    0.48 * L * spheres_random(&seed), own);
        spheres_throw(ps, i, L * spheres_random(&seed),
                      L * spheres_random(&seed), L * spheres_random(&seed));
        spheres_spin(ps, i, 20.0 * spheres_random(&seed),
                     20.0 * spheres_random(&seed), 9.0 * spheres_random(&seed));
        ps->ey[i] = -9.81 * ps->m[i];
    }
    return ps;
}

/* What is on and what is off. */
struct scene {
    int n, periodic; /* bit k: direction k */
    double L;        /* [m] */
    int room;        /* [-] for spheres that are not there */
    int law, cohesion, rolling, budget;
};

/* Springs and attractions are so strong that in three steps a velocity changes
 * by some per cent, in a box of any size. */

static struct dem_options options_of(const struct scene *s,
                                     struct attraction pull[3], double *charge)
{
    struct dem_options o =
        spheres_options(contact_laws[s->law], 1e-4, 0.5 * s->L);
    const double weight = 1e4 * gsl_pow_3(0.2 * s->L), range = 0.01 * s->L;

    *charge = 1e-5 * sqrt(gsl_pow_5(s->L));
    o.material.stiffness = 1e5 * gsl_pow_3(s->L);
    o.material.young = 2e6 * gsl_pow_2(s->L);
    o.material.restitution = 0.7;
    o.material.friction = 0.3;
    o.material.rolling = s->rolling ? 0.1 : 0.0;
    for (int k = 0; k < 3; k++)
        o.periodic[k] = s->periodic >> k & 1;
    pull[0] = (struct attraction){.law = &electrostatic,
                                  .range = range,
                                  .strength = 1.0,
                                  .charge = charge};
    pull[1] = (struct attraction){.law = &van_der_waals,
                                  .range = range,
                                  .strength = weight * s->L * 1e-3,
                                  .closest = 0.005 * s->L};
    pull[2] = (struct attraction){
        .law = &capillary, .range = range, .strength = weight / s->L};
    o.attractions = pull;
    o.n_attractions = s->cohesion ? 3 : 0;
    return o;
}

/* --- comparing ------------------------------------------------------------ */

/* What a method gives. */
struct outcome {
    struct particles *ps;
    struct dem_report report;
    struct energy energy;
};

static struct outcome outcome_of(const struct scene *s,
                                 const struct dem_method *method)
{
    struct attraction pull[3];
    double charge;
    struct dem_options o = options_of(s, pull, &charge);
    struct outcome out = {.ps = swarm(s->n, s->room, s->L, (uint64_t)s->n + 5)};

    o.method = method;
    struct dem *const dem = dem_create(out.ps, &o);
    ck_assert_ptr_nonnull(dem);
    if (s->budget) dem_start_energy_budget(dem);
    ck_assert_int_eq(dem_run(dem, STEPS, &out.report), 0);
    if (s->budget) out.energy = *dem_energy(dem);
    dem_free(dem);
    return out;
}

/* Of the largest of its kind: the sums are of a few terms in another order,
 * 1e-15 each, in a handful of steps that amplify it little. A lane too many or
 * an image too far is of the size of the whole. */
static const double rounding = 1e-10;

static void compare_budget(const struct energy *got, const struct energy *want)
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
        ck_assert_double_eq_tol(
            g[k], w[k], 100.0 * rounding * fabs(w[k]) + 1e-14 * want->added);
}

/* The same scene by both methods, the fast one with 1 to `threads` threads;
 * gives the contacts. */
static int compare(const struct scene *s, int threads)
{
    const struct outcome want = outcome_of(s, &reference_all_pairs);

    for (int t = 1; t <= threads; t++) {
        omp_set_num_threads(t);
        const struct outcome got = outcome_of(s, &fast_verlet);
        same_report(&got.report, &want.report, rounding);
        same_motion(got.ps, want.ps, s->L, s->periodic, rounding);
        if (s->budget) compare_budget(&got.energy, &want.energy);
        particles_free(got.ps);
    }
    particles_free(want.ps);
    return want.report.contacts;
}

/* Boxes periodic in no direction, in x, y, z, in two of them and in all three;
 * smaller and larger than 2 m, and of 2 m; fewer contacts than the loop has
 * lanes and more, a sphere alone, and odd numbers of them; in one chunk, or
 * those few in the chunks of as many as there is room for. */
FACT_FOR_EACH(the_contact_loop_is_the_sum_over_all_pairs_in_any_box, 8)
{
    static const double sides[] = {0.01, 0.9, 2.0, 7.0};
    static const int counts[] = {1, 7, 33, 65};
    int contacts = 0;

    for (int size = 0; size < 4; size++)
        for (int k = 0; k < 16; k++) {
            const struct scene s = {.n = counts[(k + size) % 4],
                                    .periodic = _i,
                                    .L = sides[size],
                                    .room = size < 2 ? 0 : 8000,
                                    .law = k & 1,
                                    .cohesion = k >> 1 & 1,
                                    .rolling = k >> 2 & 1,
                                    .budget = k >> 3 & 1};
            contacts += compare(&s, 2);
        }
    ck_assert_int_gt(contacts, 1000);
}

/* So many that there are two chunks, of several blocks each: what a block
 * leaves out or does too late, or a chunk adds to another, would be missing.
 * Without a budget the loads go round in a ring of 1024 or 2048. */
FACT_FOR_EACH(the_contact_loop_is_the_sum_over_all_pairs_in_blocks_and_chunks,
              4)
{
    static const int periodic[] = {0, 7};
    const struct scene s = {.n = 2101,
                            .periodic = periodic[_i % 2],
                            .L = 0.9,
                            .law = _i % 2,
                            .rolling = 1,
                            .budget = _i < 2};

    ck_assert_int_gt(compare(&s, 2), 1000);
}

/* A ring that is shorter than what a block reaches is left alone: the loads are
 * summed where there is room for all of them, with the same bits. */
FACT(loads_for_which_a_ring_is_too_short_are_summed_without_it)
{
    static const int length[] = {0, 512};
    const struct scene s = {.n = 2101, .L = 0.9};
    struct particles *ps[2];

    for (int k = 0; k < 2; k++) {
        struct attraction pull[3];
        double charge;
        const struct dem_options o = options_of(&s, pull, &charge);
        struct dem_report r;

        ps[k] = swarm(s.n, 0, s.L, 3);
        struct dem *const dem = dem_create(ps[k], &o);
        ck_assert_int_eq(dem_run(dem, 1, &r), 0);
        if (length[k] > 0) fast_of(dem)->neighbours->ring_size = length[k];
        ck_assert_int_eq(dem_run(dem, STEPS, &r), 0);
        ck_assert_int_gt(r.contacts, 1000);
        dem_free(dem);
    }
    ck_assert_mem_eq(ps[0]->vx, ps[1]->vx, (size_t)s.n * sizeof(double));
    ck_assert_mem_eq(ps[0]->wz, ps[1]->wz, (size_t)s.n * sizeof(double));
    particles_free(ps[0]);
    particles_free(ps[1]);
}

/* Of contacts in order of their owners from `first` on, how many belong to
 * particles before `end`, rounded up to whole lanes if there are so many. */
static int whole_lanes(const struct chunk_contacts *c, int first, int n,
                       int end)
{
    int own = 0;

    while (own < n && c->owner[first + own] < end)
        own++;
    return (int)fmin(32.0 * ceil(own / 32.0), n);
}

/* A contact done after its block would come too late for its owner's motion;
 * one done before would be of no harm, but the lanes of the next block would be
 * empty. Walls begin lanes of their own. */
FACT(a_block_does_its_own_contacts_and_no_more_than_fill_its_lanes)
{
    const struct scene s = {.n = 1901, .L = 0.9};
    struct attraction pull[3];
    double charge;
    const struct dem_options o = options_of(&s, pull, &charge);
    struct particles *const ps = swarm(s.n, 0, s.L, 3);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    ck_assert_int_eq(dem_run(dem, 1, &r), 0);
    const struct chunk *const one = &fast_of(dem)->neighbours->chunks[0];
    const struct chunk_contacts *const c = &one->contacts;
    ck_assert_int_eq(fast_of(dem)->neighbours->n_chunks, 1);
    ck_assert_int_ge(one->n_blocks, 3);
    ck_assert_int_gt(c->n_walls, 32);
    for (int k = 0; k < one->n_blocks; k++) {
        const struct chunk_block *const b = &one->blocks[k];
        ck_assert_int_eq(b->pairs, whole_lanes(c, 0, c->n_pairs, b->end));
        ck_assert_int_eq(b->walls - c->n_pairs,
                         whole_lanes(c, c->n_pairs, c->n_walls, b->end));
    }
    dem_free(dem);
    particles_free(ps);
}
