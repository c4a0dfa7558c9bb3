/* SPDX-License-Identifier: GPL-3.0-or-later */
/* stochastic_drag.c -- see stochastic_drag.h for the process.
 *
 * The random force is the one that [EW18 26] makes of C',
 *
 *   F' = (pi/8) rho_f d^2 eps^2 |w| w C',   w = u_f - v,
 *
 * along the slip. It changes nothing but the coefficient k of the drag k w, by
 * k' = (pi/8) rho_f d^2 eps^2 |w| C', so that what the fluid is charged with,
 * sub-steps and implicit treatment stay as they are, and momentum with them.
 * For k' below -k the drag would change its direction: |k'| is limited to k,
 * above as below so that the mean does not change, and the limited values are
 * counted.
 *
 * The state of a particle is y = C' / sigma, whose variance is 1 on any path
 * through regions of other sigma. It changes once a step of the fluid, before
 * the fluid is charged for the next one. The normal numbers are those of seed,
 * particle and step (base/statistics.h); 0 is a particle that has none yet.
 */
#include "coupling/effects/forces.h"

#include <gsl/gsl_math.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/statistics.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/drag.h"
#include "coupling/effects.h"
#include "coupling/transfer.h"

double stochastic_drag_memory(double dt, double T)
{
    return exp(-dt / T);
}

double stochastic_drag_time(double a, double dt)
{
    return -dt / log(a); /* [EW18 37] */
}

double stochastic_drag_step(double a, double b, double C, double w)
{
    return a * C + b * sqrt(1.0 - a * a) * w; /* [EW18 33] */
}

double stochastic_drag_mean(double a, double n, double C)
{
    return pow(a, n) * C; /* [EW18 35] */
}

double stochastic_drag_variance(double a, double b, double n)
{
    return b * b * (1.0 - pow(a, 2.0 * n)); /* [EW18 36] */
}

double stochastic_drag_sigma(const struct stochastic_drag_sigma *s, double Re)
{
    if (Re <= s->Re_low) return s->low;
    if (Re >= s->Re_high) return s->high;
    const double x = (Re - s->Re_low) / (s->Re_high - s->Re_low);
    const double y = log(Re / s->Re_low) / log(s->Re_high / s->Re_low);
    return s->linear || s->low == 0.0 ? s->low + x * (s->high - s->low)
                                      : s->low * pow(s->high / s->low, y);
}

struct stochastic_drag {
    struct stochastic_drag_sigma sigma;
    double T; /* [s] */
    unsigned long seed;
    double *y;       /* [-] C' / sigma(C_d), one a particle; 0: none yet */
    long uses, cuts; /* [-] of k' so far */
};

/* Of the numbers of a case, in the order of its keys. */
static struct stochastic_drag_sigma sigma_of(const double *p)
{
    return (struct stochastic_drag_sigma){p[0], p[1], p[2], p[3], p[4] != 0.0};
}

static void *stochastic_drag_create(struct simulation *sim,
                                    const double *parameters)
{
    struct stochastic_drag *const self = owner_create(sizeof *self);

    self->sigma = sigma_of(parameters);
    self->T = parameters[5];
    self->seed = (unsigned long)number_clamped(parameters[6], 0, INT_MAX);
    self->y = particles_new_array(sim->particles, "stochastic_y", "-", 1);
    return self;
}

/* The normal number of particle i in a step, counted from 1 [EW18 34]. */
static double normal_of(const struct stochastic_drag *self,
                        const struct particles *ps, int i, long step)
{
    return random_normal(self->seed, ps->id[i], step, 0);
}

static double stochastic_drag_slip_of(const struct simulation *sim, int i)
{
    double w[3];

    coupling_slip(sim, i, w);
    return gsl_hypot3(w[0], w[1], w[2]);
}

/* k' [kg/s] of particle i before it is cut. A parcel is a sample of the grains'
 * velocities: it has the C' of one of them. */
static double random_coefficient(const struct stochastic_drag *self,
                                 const struct simulation *sim, int i)
{
    const struct fluid_options *const o = &sim->fluid->options;
    const double d = particles_grain(sim->particles, i);
    const double w = stochastic_drag_slip_of(sim, i);
    const double eps = sim->coupling->eps[i];
    const double Re = coefficient_reynolds(eps, o->rho, o->mu, d, w);
    const double C = stochastic_drag_sigma(&self->sigma, Re) * self->y[i];

    return particles_grains(sim->particles, i) * M_PI / 8.0 * o->rho * d * d *
           eps * eps * w * C; /* [EW18 26] */
}

static void stochastic_drag_drag(void *memory, struct simulation *sim,
                                 double *k)
{
    struct stochastic_drag *const self = memory;
    const int n = sim->particles->n;
    long cuts = 0;

#pragma omp parallel for schedule(static) reduction(+ : cuts) if (n >= TRANSFER_MANY)
    for (int i = 0; i < n; i++) {
        if (self->y[i] == 0.0)
            self->y[i] = normal_of(self, sim->particles, i, sim->steps);
        const double all = k[i];
        const double part = random_coefficient(self, sim, i);
        cuts += fabs(part) > all;
        k[i] = all + fmax(-all, fmin(all, part)); /* [EW18 32] */
    }
    self->cuts += cuts;
    self->uses += n;
}

/* The sizes of the forces, after the cut. */
static void stochastic_drag_report(const struct stochastic_drag *self,
                                   struct simulation *sim)
{
    for (int i = 0; i < sim->particles->n; i++) {
        const double part = fabs(random_coefficient(self, sim, i));
        const double f[3] = {
            fmin(part * stochastic_drag_slip_of(sim, i), transfer_drag(sim, i)),
            0.0, 0.0};
        effects_report(sim, f, 1.0);
    }
}

/* One step of the process, for the step that comes. */
static void stochastic_drag_after_particles(void *memory,
                                            struct simulation *sim)
{
    struct stochastic_drag *const self = memory;

    stochastic_drag_report(self, sim);
    const double a = stochastic_drag_memory(sim->dt, self->T);
    const int n = sim->particles->n;

#pragma omp parallel for schedule(static) if (n >= TRANSFER_MANY)
    for (int i = 0; i < n; i++)
        self->y[i] = stochastic_drag_step(
            a, 1.0, self->y[i],
            normal_of(self, sim->particles, i, sim->steps + 1));
}

static void stochastic_drag_state(void *memory, struct state *s)
{
    struct stochastic_drag *const self = memory;

    state_long(s, "uses", "-", &self->uses);
    state_long(s, "cuts", "-", &self->cuts);
}

/* Sigma goes from one Reynolds number up to another. */
static const char *stochastic_drag_wrong(const double *parameters,
                                         const struct attraction_scene *scene)
{
    (void)scene;
    return parameters[3] < parameters[2] ? "Re_high is below Re_low" : NULL;
}

/* sqrt(2 / pi) of sigma over C_d, on average, of which the velocity follows the
 * part that lasts: the fluctuation does so for T, about d / u, and a grain
 * answers within tau. Where the case gives no sigma, it is that of EW18's
 * liquid bed, whose Re_p went from 3 to 10.5; beyond the data, of either, the
 * drag is its bound, with that of a stream that takes the grains along. */
static struct effect_estimate
stochastic_drag_estimate(const struct effect_scales *k)
{
    static const struct stochastic_drag_sigma bed = {93.5, 13.43, 3.0, 10.5, 0};
    const double *const n = k->numbers, eps = 1.0 - k->passed;
    const struct stochastic_drag_sigma s = n != NULL ? sigma_of(n) : bed;
    const double Re = coefficient_reynolds(eps, k->rho_f, k->mu, k->d, k->slip);
    const double T = k->slip > 0.0 ? k->d / (eps * k->slip) : 0.0;
    const double most =
        k->drag + M_PI / 6.0 * gsl_pow_3(k->d) * k->rho_s * k->changes;
    const double F = M_PI / 8.0 * k->rho_f * gsl_pow_2(k->d * eps * k->slip) *
                     stochastic_drag_sigma(&s, Re);
    const int no_data = /* to a tenth, as Re is an estimate */
        s.low != s.high && (Re < 0.9 * s.Re_low || Re > 1.1 * s.Re_high);
    struct effect_estimate e = effects_estimate(
        no_data ? fmin(1.0, most / k->force)
                : sqrt(2.0 / M_PI) * fmin(F, k->drag) / k->force,
        "");

    if (n == NULL && (!k->partners || k->eps_s < 0.01 || !k->carried))
        return effects_estimate(0.0, k->carried ? "no neighbours that disturb"
                                                : "grains at rest");
    if (n == NULL && k->rho_f < 0.05 * k->rho_s)
        return effects_estimate(0.0, "EW18 and our beds show no gain in gas");
    e.loss = T > 0.0 ? e.share * sqrt(T / (T + k->tau)) : 0.0;
    e.unknown = e.bound = no_data;
    if (no_data)
        snprintf(e.remark, sizeof e.remark, "no data for Re_p %.3g (%g to %g)",
                 Re, s.Re_low, s.Re_high);
    return e;
}

/* As of EW18's liquid bed. */
static void stochastic_drag_trial(const struct effect_scales *k,
                                  char text[EFFECT_TRIAL])
{
    snprintf(text, EFFECT_TRIAL,
             "{sigma_low=93.5;sigma_high=13.43;Re_low=3.0;Re_high=10.5;time=%g;"
             "}",
             k->slip > 0.0 ? k->d / ((1.0 - k->passed) * k->slip) : 1.0);
}

static int stochastic_drag_counts(const void *memory, struct effect_count *c)
{
    const struct stochastic_drag *const self = memory;

    c[0] = (struct effect_count){"stochastic_drag_uses", self->uses};
    c[1] = (struct effect_count){"stochastic_drag_cuts", self->cuts};
    return 2;
}

static const struct key keys[] = {
    {"effects.stochastic_drag", KEY_GROUP, "", "", KEY_OPTIONAL,
     "a random part of the drag, for the fluctuations that averaging removes",
     "EW18 32-37", "fluid particles averaging exchange"},
    {"effects.stochastic_drag.sigma_low", KEY_REAL, "-", ">= 0", NULL,
     "standard deviation of the drag coefficient at Re_low and below",
     "EW18 Fig. 9", ""},
    {"effects.stochastic_drag.sigma_high", KEY_REAL, "-", ">= 0", NULL,
     "the same at Re_high and above", "EW18 Fig. 9", ""},
    {"effects.stochastic_drag.Re_low", KEY_REAL, "-", "> 0", "1.0",
     "Reynolds number with the superficial slip", "EW18 27", ""},
    {"effects.stochastic_drag.Re_high", KEY_REAL, "-", "> 0", "1.0",
     "the same; between the two sigma is a power of it", "EW18 27", ""},
    {"effects.stochastic_drag.linear", KEY_BOOL, "", "", "false",
     "between the two sigma is linear", "EW18 Fig. 9", ""},
    {"effects.stochastic_drag.time", KEY_REAL, "s", "> 0", NULL,
     "integral time T of the fluctuation", "EW18 37", ""},
    {"effects.stochastic_drag.seed", KEY_INT, "-", ">= 0", "1",
     "seed of the random numbers; the same seed gives the same run", "EW18 34",
     ""},
    KEY_END};

const struct effect stochastic_drag_effect = {
    .name = "stochastic_drag",
    .what = "a random part of the drag, along the slip",
    .equations = "EW18 32-37",
    .function = "stochastic_drag_drag",
    .keys = {keys},
    .create = stochastic_drag_create,
    .after_particles = stochastic_drag_after_particles,
    .drag = stochastic_drag_drag,
    .counts = stochastic_drag_counts,
    .state = stochastic_drag_state,
    .wrong = stochastic_drag_wrong,
    .estimate = stochastic_drag_estimate,
    .trial = stochastic_drag_trial,
    .cost = {69.0, 0.0, 0.0},
};
