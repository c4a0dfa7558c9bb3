/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Insertion and removal of particles: no overlap, the required size
 * distribution, ids that are never used twice, the same bits after a
 * restart. */
#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/alloc.h"
#include "dem/population/insertion.h"
#include "dem/population/population.h"
#include "facts.h"
#include "kept.h"
#include "spheres.h"

static const double table[][2] = {{1e-3, 3.0}, {2e-3, 1.0}, {4e-3, 1.0}};

static struct sizes *three_sizes(void)
{
    const struct sizes_options o = {
        .law = sizes_law_named("discrete"), .n = 3, .point = table};
    return sizes_create(&o);
}

static struct insertion source(const struct sizes *sizes, long count,
                               double rate)
{
    const struct insertion in = {.options = {.lo = {-0.02, 0.0, -0.02},
                                             .hi = {0.02, 0.04, 0.02},
                                             .velocity = {0.0, -0.5, 0.0},
                                             .diameter = 2e-3,
                                             .sizes = sizes,
                                             .density = 1500.0,
                                             .count = count,
                                             .rate = rate,
                                             .seed = 7}};
    return in;
}

static struct box_domain around(int periodic)
{
    const double lo[3] = {-0.02, -0.02, -0.02}, hi[3] = {0.02, 0.04, 0.02};
    const int flags[3] = {periodic, 0, 0};
    return box_domain_of(lo, hi, flags);
}

/* The smallest gap of any two, across the seams of a periodic box [m]. */
static double closest(const struct particles *ps, const struct box_domain *box)
{
    double least = 1.0;

    for (int i = 0; i < ps->n; i++)
        for (int j = 0; j < i; j++) {
            const double d[3] = {ps->x[i] - ps->x[j], ps->y[i] - ps->y[j],
                                 ps->z[i] - ps->z[j]};
            double r2 = 0.0;
            for (int k = 0; k < 3; k++) {
                const double near =
                    d[k] - box->length[k] * rint(d[k] * box->inverse[k]);
                r2 += near * near;
            }
            least = fmin(least, sqrt(r2) - 0.5 * (ps->d[i] + ps->d[j]));
        }
    return least;
}

/* 400 spheres, a fifth of the region: no overlaps, and all are inside of it. */
FACT_FOR_EACH(inserted_particles_overlap_no_others, 2)
{
    const struct box_domain box = around(_i);
    struct sizes *const sizes = three_sizes();
    struct particles *const ps = particles_create(404);
    struct insertion in = source(sizes, 400, 0.0);

    for (int k = 0; k < 4; k++) /* existing particles, half of them on a seam */
        spheres_add(ps, _i ? 0.0199 : 0.0, 0.008 * k + 0.008, 0.0, 8e-3);
    ck_assert_int_eq(insertion_step(&in, ps, &box, 0.0), 400);
    ck_assert_double_ge(closest(ps, &box), -1e-15);
    for (int i = 4; i < ps->n; i++) {
        ck_assert_double_ge(ps->y[i] - 0.5 * ps->d[i], 0.0);
        ck_assert_double_le(ps->y[i] + 0.5 * ps->d[i], 0.04 + 1e-15);
        ck_assert_double_ge(ps->x[i] - 0.5 * ps->d[i], -0.02 - 1e-15);
        ck_assert_double_eq(ps->vy[i], -0.5);
        ck_assert_double_eq_tol(ps->m[i] / particles_volume(ps, i), 1500.0,
                                1e-9);
    }
    ck_assert_int_eq(insertion_step(&in, ps, &box, 1.0), 0);
    particles_free(ps);
    owner_free(sizes);
}

/* Also where it is so crowded that most places are taken, the diameters are
 * those of the distribution, in the order of their numbers: shares 0.6, 0.2,
 * 0.2, of 3000 with a deviation of 0.009. */
FACT(dense_insertion_does_not_change_the_size_distribution)
{
    const struct box_domain box = around(0);
    struct sizes *const sizes = three_sizes();
    struct particles *const ps = particles_create(3000);
    struct insertion in = source(sizes, 3000, 0.0);
    double share[3] = {0.0, 0.0, 0.0};

    insertion_step(&in, ps, &box, 0.0);
    insertion_step(&in, ps, &box, 0.1);
    ck_assert_int_lt(ps->n, 3000); /* not all can be placed */
    ck_assert_int_gt(ps->n, 800);
    for (int i = 0; i < ps->n; i++)
        ck_assert_double_eq(ps->d[i], insertion_diameter(&in.options, i));
    for (long k = 0; k < 3000; k++)
        for (int g = 0; g < 3; g++)
            share[g] +=
                (insertion_diameter(&in.options, k) == table[g][0]) / 3000.0;
    ck_assert_double_eq_tol(share[0], 0.6, 0.03);
    ck_assert_double_eq_tol(share[2], 0.2, 0.03);
    ck_assert_double_ge(closest(ps, &box), 0.0);
    particles_free(ps);
    owner_free(sizes);
}

/* Places are even: the mean of 2000 in each direction is the middle, to 5
 * standard deviations of L/sqrt(12 n). Spheres of next to no size. */
FACT(insertion_positions_are_uniform_over_the_region)
{
    const struct insertion in = source(NULL, 2000, 0.0);
    double mean[3] = {0.0, 0.0, 0.0}, x[3];

    for (long k = 0; k < 2000; k++) {
        insertion_place(&in.options, k, 0, 0.0, x);
        for (int a = 0; a < 3; a++)
            mean[a] += x[a] / 2000.0;
    }
    const double five = 5.0 * 0.04 / sqrt(12.0 * 2000.0);
    ck_assert_double_eq_tol(mean[0], 0.0, five);
    ck_assert_double_eq_tol(mean[1], 0.02, five);
    ck_assert_double_eq_tol(mean[2], 0.0, five);
}

FACT(a_source_inserts_at_its_rate)
{
    struct insertion in = source(NULL, 50, 1000.0);

    in.options.start = 0.1;
    ck_assert_int_eq((int)insertion_count_due(&in, 0.0999), 0);
    ck_assert_int_eq((int)insertion_count_due(&in, 0.1), 1);
    ck_assert_int_eq((int)insertion_count_due(&in, 0.1105), 11);
    ck_assert_int_eq((int)insertion_count_due(&in, 10.0), 50);
    in.options.rate = 0.5; /* one in two seconds */
    ck_assert_int_eq((int)insertion_count_due(&in, 2.0), 1);
    ck_assert_int_eq((int)insertion_count_due(&in, 2.2), 2);
    in.options.rate = 0.0;
    ck_assert_int_eq((int)insertion_count_due(&in, 0.1), 50);
}

/* [kg] of the spheres before number n. */
static double mass_of_first(const struct insertion_options *o, long n)
{
    double m = 0.0;

    for (long k = 0; k < n; k++)
        m += o->density * M_PI / 6.0 * pow(insertion_diameter(o, k), 3);
    return m;
}

/* 1, 2 and 4 mm, whose masses are 1, 8 and 64: what is due has at least the
 * mass that the rate says, and without its last sphere at most that. A source
 * that first looks late, as a resumed one does, finds the same number. */
FACT(a_mass_rate_is_met_within_one_sphere)
{
    struct sizes *const sizes = three_sizes();
    struct insertion in = source(sizes, 2000, 0.0);
    const struct insertion_options *const o = &in.options;

    in.options.start = 0.1;
    in.options.mass_rate = 0.02;
    const struct insertion untouched = in;
    ck_assert_int_eq((int)insertion_count_due(&in, 0.0999), 0);
    ck_assert_int_eq((int)insertion_count_due(&in, 0.1), 1);
    for (double t = 0.1; t < 0.8; t += 0.0037) {
        const long n = insertion_count_due(&in, t);
        struct insertion late = untouched;
        const double mass = 0.02 * (t - 0.1);
        ck_assert_double_ge(mass_of_first(o, n), mass);
        ck_assert_double_le(mass_of_first(o, n - 1), mass + 1e-15);
        ck_assert_int_eq((int)insertion_count_due(&late, t), (int)n);
    }
    ck_assert_int_gt((int)in.n_due, 400);
    ck_assert_int_eq((int)insertion_count_due(&in, 1e9), 2000);
    owner_free(sizes);
}

/* --- a run with sources and sinks ----------------------------------------- */

struct run {
    struct particles *ps;
    struct dem *dem;
    struct population *life;
    struct sizes *sizes;
    long step;
};

/* A stream from above; particles that reach the floor are removed. */
static struct run begin(void)
{
    const struct box_domain box = around(0);
    struct dem_options o = spheres_options(&contact_linear, 1e-5, 0.02);
    struct run r = {.ps = particles_create(300), .sizes = three_sizes()};

    o.hi[1] = 0.04;
    o.material.friction = 0.3;
    o.material.restitution = 0.5;
    r.life = population_create(&box, 1, 2);
    r.life->sources[0] = source(r.sizes, 5000, 4000.0);
    r.life->sinks[0].side = 2; /* the floor */
    r.life->sinks[1] = (struct population_sink){
        .lo = {-1, -1, 0.015}, .hi = {1, 0.02, 1}, .side = -1};
    r.dem = dem_create(r.ps, &o);
    return r;
}

static void go_on(struct run *r, int steps)
{
    struct dem_report report;

    for (int k = 0; k < steps; k++) {
        if (population_mark(r->life, r->ps, 1e-4) > 0)
            dem_remove(r->dem, r->life->is_removed);
        population_insert(r->life, r->ps, r->dem, 1e-4 * (double)r->step);
        for (int i = 0; i < r->ps->n; i++)
            r->ps->ey[i] = -9.81 * r->ps->m[i];
        ck_assert_int_eq(dem_run(r->dem, 10, &report), 0);
        r->step++;
    }
}

static void end(struct run *r)
{
    dem_free(r->dem);
    owner_free(r->life);
    particles_free(r->ps);
    owner_free(r->sizes);
}

/* 0.12 s: the first have been removed, and as many ids were used as particles
 * were inserted. */
FACT(ids_are_never_given_twice)
{
    struct run r = begin();
    char seen[5000] = {0};

    for (int k = 0; k < 60; k++) {
        go_on(&r, 20);
        const struct population_totals *const a = &r.life->totals;
        ck_assert_int_eq(r.ps->n, (int)(a->inserted - a->removed));
        ck_assert_int_eq(r.ps->next_id, (int)a->inserted);
        for (int i = 0; i < r.ps->n; i++) {
            const int id = r.ps->id[i];
            ck_assert_int_ne(seen[id], 2); /* removed particles stay removed */
            ck_assert_double_eq(
                r.ps->d[i],
                insertion_diameter(&r.life->sources[0].options, id));
        }
        for (int id = 0; id < (int)a->inserted; id++)
            if (seen[id] == 1 && spheres_place(r.ps, id) < 0) seen[id] = 2;
        for (int i = 0; i < r.ps->n; i++)
            seen[r.ps->id[i]] = 1;
    }
    ck_assert_int_gt((int)r.life->totals.removed, 50);
    ck_assert_int_gt((int)r.life->totals.inserted, 300);
    end(&r);
}

/* Every inserted particle is present or removed, in number, in mass and in the
 * report. */
FACT(inserted_mass_is_present_or_removed)
{
    struct run r = begin();
    double there = 0.0;

    go_on(&r, 1000);
    const struct population_totals *const a = &r.life->totals;
    for (int i = 0; i < r.ps->n; i++)
        there += r.ps->m[i];
    ck_assert_double_gt(a->mass_out, 0.0);
    ck_assert_double_eq_tol((there + a->mass_out) / a->mass_in, 1.0, 1e-12);
    ck_assert_double_lt(a->momentum_out[1], 0.0); /* they have been removed */
    for (int i = 0; i < r.ps->n; i++) {
        ck_assert_double_gt(r.ps->y[i] - 0.5 * r.ps->d[i], -0.02);
        ck_assert(r.ps->z[i] < 0.015 + 2e-3 || r.ps->y[i] > 0.02 - 2e-3);
    }
    end(&r);
}

/* Those that are due and find no room wait; the next time the same ones do,
 * and none of them is counted twice. */
FACT(particles_that_find_no_room_wait_and_are_counted_once)
{
    struct run r = begin();
    struct insertion_options *const o = &r.life->sources[0].options;

    o->count = 200;
    o->rate = 0.0;
    o->lo[0] = o->lo[1] = o->lo[2] = 0.0;
    o->hi[0] = o->hi[1] = o->hi[2] = 0.012;
    for (int k = 0; k < 3; k++) {
        population_insert(r.life, r.ps, r.dem, 0.0);
        ck_assert_int_gt((int)r.life->totals.waiting, 0);
        ck_assert_int_eq(
            (int)(r.life->totals.inserted + r.life->totals.waiting), 200);
    }
    end(&r);
}

/* The tangential displacements of the remaining particles are unchanged when
 * another is removed: the same force on the same contact, to rounding. */
FACT(remaining_particles_keep_their_tangential_displacements)
{
    struct particles *const ps = particles_create(4);
    struct dem_options o = spheres_options(&contact_linear, 1e-5, 0.1);
    struct dem_report r;
    double F[2];

    o.material.friction = 0.5;
    spheres_add(ps, -0.05, 0, 0, 0.01);
    spheres_throw(ps, spheres_add(ps, 0, 0, 0, 0.01), 0.2, 0.2, 0);
    spheres_add(ps, 0.0099, 0, 0, 0.01);
    spheres_add(ps, 0.08, 0, 0, 0.01);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 20, &r), 0);
    F[0] = ps->cfy[spheres_place(ps, 1)];
    int gone[4] = {0};
    gone[spheres_place(ps, 0)] = 1;
    dem_remove(dem, gone);
    ck_assert_int_eq(ps->n, 3);
    ck_assert_int_eq(spheres_place(ps, 0), -1);
    ck_assert_int_eq(dem_run(dem, 0, &r), 0);
    F[1] = ps->cfy[spheres_place(ps, 1)];
    ck_assert_double_ne(F[0], 0.0);
    ck_assert_double_eq_tol(F[1] / F[0], 1.0, 0.02); /* half a step's slip */
    ck_assert_int_eq(r.contacts, 1);
    dem_free(dem);
    particles_free(ps);
}

/* Stopped in the middle of it, saved and loaded, the run continues with the
 * same bits. */
FACT_FOR_EACH(a_resumed_run_with_insertion_has_the_same_bits, 2)
{
    struct run a = begin(), b = begin();
    struct kept *const kept = kept_create();

    if (_i) /* as many by mass, about */
        a.life->sources[0].options.mass_rate =
            b.life->sources[0].options.mass_rate = 0.05;
    go_on(&a, 400);
    ck_assert_int_gt(a.ps->n, 40);
    particles_state(a.ps, &kept->state);
    dem_state(a.dem, &kept->state);
    population_state(a.life, &kept->state);
    particles_state(b.ps, kept_load(kept));
    dem_state(b.dem, &kept->state);
    population_state(b.life, &kept->state);
    ck_assert_int_eq(kept->state.failed, 0);
    kept_free(kept);
    b.step = a.step;
    go_on(&a, 300);
    go_on(&b, 300);
    ck_assert_int_eq(a.ps->n, b.ps->n);
    const size_t size = (size_t)a.ps->n * sizeof(double);
    ck_assert_mem_eq(a.ps->x, b.ps->x, size);
    ck_assert_mem_eq(a.ps->wz, b.ps->wz, size);
    ck_assert_mem_eq(a.ps->id, b.ps->id, (size_t)a.ps->n * sizeof(int));
    ck_assert_int_eq((int)a.life->totals.removed, (int)b.life->totals.removed);
    end(&a);
    end(&b);
}

/* A new particle in the place of a removed one has none of its data. */
FACT(inserted_particles_have_no_data_of_removed_ones)
{
    struct particles *const ps = particles_create(2);
    double attached[2] = {0.0, 0.0};

    particles_attach(ps, "attached", "-", attached, 1);
    const int i = spheres_add(ps, 0, 0, 0, 0.01);
    spheres_throw(ps, i, 1, 2, 3);
    spheres_spin(ps, i, 4, 5, 6);
    ps->ex[i] = ps->cfz[i] = attached[i] = 7.0;
    particles_remove(ps, (const int[1]){1});
    ck_assert_int_eq(ps->n, 0);
    ck_assert_int_eq(spheres_add(ps, 0, 0, 0, 0.01), 0);
    ck_assert_double_eq(ps->vx[0], 0.0);
    ck_assert_double_eq(ps->wz[0], 0.0);
    ck_assert_double_eq(ps->ex[0], 0.0);
    ck_assert_double_eq(ps->cfz[0], 0.0);
    ck_assert_double_eq(attached[0], 0.0);
    ck_assert_int_eq(ps->id[0], 1);
    particles_free(ps);
}

/* --- files -----------------------------------------------------------------
 */

static struct insertion_sphere *read_text(const char *text, long *n)
{
    char path[64];

    snprintf(path, sizeof path, "/tmp/winnow-test-life-%ld", (long)getpid());
    FILE *const f = fopen(path, "w");
    fputs(text, f);
    fclose(f);
    struct input in = input_of(path);
    struct insertion_sphere *const list = grain_table_parse(&in, n);
    input_release(&in);
    unlink(path);
    return list;
}

FACT(a_file_brings_its_spheres_in_its_order)
{
    const struct box_domain box = around(0);
    struct particles *const ps = particles_create(3);
    struct insertion in = source(NULL, 0, 0.0);
    long n;

    struct insertion_sphere *const list =
        read_text("# x y z d\n0 0.01 0 2e-3\n\n 0.005 0.01 0 3e-3\n", &n);
    ck_assert_int_eq((int)n, 2);
    in.options.list = list;
    in.options.count = n;
    ck_assert_int_eq(insertion_step(&in, ps, &box, 0.0), 2);
    ck_assert_double_eq(ps->x[1], 0.005);
    ck_assert_double_eq(ps->d[1], 3e-3);
    free(list);
    ck_assert_ptr_null(read_text("0 0 0 1e-3\n0 0 0\n", &n));
    ck_assert_ptr_null(read_text("0 0 0 -1e-3\n", &n));
    ck_assert_ptr_null(read_text("0 0 0 1e-3 5\n", &n));
    ck_assert_ptr_null(read_text("0 0 0 4.9e-324\n", &n)); /* no volume */
    ck_assert_ptr_null(read_text("0 1e300 0 1e-3\n", &n));
    ck_assert_ptr_null(read_text("# nothing\n", &n));
    particles_free(ps);
}

/* As a program with its origin elsewhere writes it: 2 mm behind, and in x
 * a period and a half away. */
FACT(places_of_a_file_are_moved_and_brought_back_into_the_period)
{
    const struct box_domain box = around(1);
    const double L = box.length[0], by[3] = {-0.5 * L, 0.0, 0.002};
    struct insertion_sphere one = {.d = 1e-3};

    for (int k = 0; k < 3; k++)
        one.x[k] = 0.5 * (box.lo[k] + box.hi[k]) - by[k];
    one.x[0] += 2.0 * L;
    one.x[1] = box.hi[1] + L; /* not periodic: it stays outside */
    insertion_move(&one, 1, by, &box);
    ck_assert_double_eq_tol(one.x[0], 0.5 * (box.lo[0] + box.hi[0]), 1e-15);
    ck_assert_double_eq(one.x[1], box.hi[1] + L);
    ck_assert_double_eq_tol(one.x[2], 0.5 * (box.lo[2] + box.hi[2]), 1e-15);
}
