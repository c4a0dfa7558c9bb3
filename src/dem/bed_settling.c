/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/bed.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/thread_tuner.h"
#include "base/vector.h"
#include "dem/clumps.h"
#include "dem/contact.h"

static const double settling_e = 0.1; /* [-] e while the bed comes to rest */
static const double settling_speed = 1.0; /* [m/s] that the step is made for */
static const double settling_drag = 3.0;  /* [-] relaxation over sqrt(d/g) */
enum { CHECK_EVERY = 50 };

/* The two parts of the settling, and its end. */
enum { DISSIPATIVE, REAL, ENDED };

struct bed_settling {
    struct particles *ps;
    const struct bed_options *bed;
    const struct material *material; /* the real one */
    struct dem *run;
    double *own_mass;     /* [kg] sorted with the particles; or NULL */
    double step;          /* [s] */
    int part;             /* [-] of the settling */
    double weight;        /* [N] with the masses that settle */
    struct bed_report *r; /* time, steps and kinetic energy so far */
};

double bed_settling_time(const struct bed_settling *b)
{
    return b->r->time;
}

/* While a bed of several sizes settles, small spheres have the inertia of the
 * mean one, because otherwise the step would have to resolve their short
 * impacts; the state of rest depends on the weights alone. Returns their own
 * masses, sorted with the particles from now on; NULL with one size. */
static double *raise_small_masses(struct particles *ps,
                                  const struct bed_options *bed)
{
    const double mean = bed->density * M_PI / 6.0 * gsl_pow_3(bed->diameter);

    if (bed->sizes == NULL || ps->clumps != NULL) return NULL;
    double *const own = alloc_doubles(ps->capacity);
    memcpy(own, ps->m, (size_t)ps->n * sizeof *own);
    particles_attach(ps, "own_mass", "kg", own, 1);
    for (int i = 0; i < ps->n; i++)
        ps->m[i] = fmax(own[i], mean);
    return own;
}

static void restore_masses(struct particles *ps, double *own)
{
    if (own == NULL) return;
    memcpy(ps->m, own, (size_t)ps->n * sizeof *own);
    particles_detach(ps, own);
    free(own);
}

static void set_weight(struct particles *ps, const double *m, const double g[3])
{
    for (int i = 0; i < ps->n; i++) {
        ps->ex[i] = m[i] * g[0];
        ps->ey[i] = m[i] * g[1];
        ps->ez[i] = m[i] * g[2];
    }
}

static void bed_settling_slow_down(struct particles *ps, double factor)
{
    double *const all[] = {ps->vx, ps->vy, ps->vz, ps->wx, ps->wy, ps->wz};

    for (int k = 0; k < 6; k++)
        for (int i = 0; i < ps->n; i++)
            all[k][i] *= factor;
    if (ps->clumps != NULL) clumps_slow_down(ps, factor);
}

static void begin_part(struct bed_settling *b, int part)
{
    double mass = 0.0;

    b->part = part;
    for (int i = 0; i < b->ps->n; i++)
        mass += b->ps->m[i];
    b->weight = mass * vector_length(b->bed->gravity);
    if (part != REAL) return;
    dem_change_material(b->run, b->material);
    if (b->own_mass != NULL) set_weight(b->ps, b->own_mass, b->bed->gravity);
}

void bed_settling_state(struct bed_settling *b, struct state *s)
{
    int part = b->part;

    state_begin(s, "settling");
    state_whole(s, "part", "-", &part);
    if (s->loading && part >= REAL) begin_part(b, REAL);
    b->part = part;
    state_real(s, "weight", "N", &b->weight);
    state_whole(s, "settled", "-", &b->r->settled);
    state_real(s, "kinetic", "-", &b->r->kinetic);
    state_real(s, "time", "s", &b->r->time);
    state_long(s, "steps", "-", &b->r->steps);
    particles_state(b->ps, s);
    dem_state(b->run, s);
    state_end(s);
}

/* Non-zero: settling ends here. */
static int call_saver(struct bed_settling *b, enum bed_stage stage)
{
    const struct bed_saver *const k = b->bed->saver;

    if (k != NULL) b->r->stopped = k->visit(k->memory, b, stage);
    return b->r->stopped;
}

/* Runs until the bed is at rest, at the earliest at `least` [s]; multiplies all
 * velocities by `factor` at each check. */
static int run_to_rest(struct bed_settling *b, double least, double factor)
{
    struct bed_report *const r = b->r;
    struct thread_tuner *const threads = thread_tuner_create();
    int lost = 0;

    do {
        if (call_saver(b, BED_STAGE_STEPS) != 0) break;
        thread_tuner_before_step(threads);
        lost = dem_run(b->run, CHECK_EVERY, &r->dem);
        thread_tuner_after_step(threads);
        r->steps += r->dem.steps;
        r->time += (double)r->dem.steps * b->step;
        r->kinetic = (r->dem.translation + r->dem.rotation) /
                     (b->weight * b->bed->diameter);
        r->settled = r->kinetic < BED_SETTLED_ENERGY && r->time >= least;
        if (factor < 1.0) bed_settling_slow_down(b->ps, factor);
    } while (!lost && !r->settled && r->time < b->bed->settle);
    thread_tuner_free(threads);
    return lost;
}

/* Both parts of the settling, or what is left of them. The first lasts at least
 * as long as a sphere takes to fall by its diameter, because all spheres are at
 * rest at the start. */
static int settle_in_parts(struct bed_settling *b)
{
    const double fall = sqrt(b->bed->diameter / vector_length(b->bed->gravity));
    const double interval = CHECK_EVERY * b->step;
    int lost = 0;

    if (call_saver(b, BED_STAGE_START) != 0) return 0;
    if (b->part == DISSIPATIVE) {
        lost =
            run_to_rest(b, 1.5 * fall, exp(-interval / (settling_drag * fall)));
        if (lost || b->r->stopped) return lost;
        begin_part(b, b->r->settled ? REAL : ENDED);
    }
    if (b->part == REAL) lost = run_to_rest(b, 0.0, 1.0);
    if (lost || b->r->stopped) return lost;
    b->part = ENDED;
    call_saver(b, BED_STAGE_END);
    return 0;
}

/* In both parts; as bed_settle. */
static int settle_lattice(struct particles *ps, const struct bed_options *bed,
                          const struct dem_options *o, struct bed_report *r,
                          struct bed_histories *histories)
{
    struct dem_options settling = *o;
    struct bed_settling b = {
        .ps = ps, .bed = bed, .material = &o->material, .r = r};
    const double filled = clumps_least_filled(bed->clump);
    double d = bed->diameter;

    settling.material.restitution = fmin(settling_e, o->material.restitution);
    if (bed->clump != NULL) d = bed_range(bed).ball;
    settling.step = b.step = limits_step(o->law, &o->material, d,
                                         filled * bed->density, settling_speed);
    b.run = dem_create(ps, &settling);
    if (b.run == NULL) return -1;
    b.own_mass = raise_small_masses(ps, bed);
    set_weight(ps, ps->m, bed->gravity);
    begin_part(&b, DISSIPATIVE);
    const int lost = settle_in_parts(&b);
    histories->list = dem_histories(b.run, &histories->n);
    dem_free(b.run);
    restore_masses(ps, b.own_mass);
    set_weight(ps, ps->m, (const double[3]){0.0, 0.0, 0.0});
    return lost;
}

int bed_settle(struct particles *ps, const struct bed_options *bed,
               const struct dem_options *dem, struct bed_report *r,
               struct bed_histories *histories)
{
    int lost = 0;

    *histories = (struct bed_histories){0, NULL};
    *r = (struct bed_report){.settled = 1};
    if (ps->n > 0 && bed->settle > 0.0 && vector_length(bed->gravity) > 0.0)
        lost = settle_lattice(ps, bed, dem, r, histories);
    bed_measure(ps, bed, dem, r);
    return lost;
}
