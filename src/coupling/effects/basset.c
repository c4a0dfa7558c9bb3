/* SPDX-License-Identifier: GPL-3.0-or-later */
/* basset.c -- Basset's history force as an effect (basset.h).
 *
 * In a step dt the slip w is linear, and the mean of the force over the step,
 * C = (3/2) d^2 sqrt(pi rho mu), is
 *
 *   C [ (4/3) sqrt(dt) w'                          of this step
 *     + (4/3) (2 sqrt(2) - 2) sqrt(dt) w'_before   of the one before
 *     + sum c_k g(s_k dt) E_k ]                    of all earlier ones
 *
 * with g(x) = (1 - exp(-x))/x. Of w' = (du - dv)/dt in this step, du is known
 * and makes a held force, and dv makes an added mass C (4/3) sqrt(dt) (another
 * one beside that of LS 5.3) in every particle step. An inserted particle
 * counts as one that was at rest in the fluid before: its first slip is a step
 * of w, the last term of [LS 5.4].
 */
#include "coupling/effects/forces.h"

#include "base/alloc.h"
#include "base/number.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "dem/integrator.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_dawson.h>
#include <math.h>
#include <stdio.h>

enum { ROW = 6, TERMS_A_ROW = 2 }; /* numbers a particle in one array of E */

/* One row a particle; all follow the particles when these are sorted. All but
 * `held` and `start` are the history of the slip. */
struct basset {
    struct basset_kernel kernel;
    double decay[BASSET_TERMS];                /* [-] exp(-s_k dt) */
    double gain[BASSET_TERMS];                 /* [-] g(s_k dt) */
    double *E[BASSET_TERMS / TERMS_A_ROW];     /* [m/s] ROW each */
    char name[BASSET_TERMS / TERMS_A_ROW][24]; /* of each of these, for a
                                                  checkpoint */
    double *change; /* [m/s] of w in the step before, 3 */
    double *u;      /* [m/s] of the fluid in the step before, 3 */
    double *age;    /* [-] steps done, 1 at most; 0: no history yet */
    double *held;   /* [N] the part that is known before the step, 3 */
    double *start;  /* [m/s] velocity at the start of the step, 3 */
};

static void *basset_create(struct simulation *sim, const double *parameters)
{
    struct basset *const self = owner_create(sizeof *self);
    struct particles *const ps = sim->particles;

    self->kernel = basset_kernel_create(sim->dt, parameters[0]);
    for (int k = 0; k < self->kernel.n; k++) {
        self->decay[k] = exp(-self->kernel.s[k] * sim->dt);
        self->gain[k] = implicit_drag_gain(self->kernel.s[k] * sim->dt);
        if (k % TERMS_A_ROW != 0) continue;
        const int row = k / TERMS_A_ROW;
        snprintf(self->name[row], sizeof self->name[row], "basset_E_%d", row);
        self->E[row] = particles_new_array(ps, self->name[row], "m/s", ROW);
    }
    self->change = particles_new_array(ps, "basset_change", "m/s", 3);
    self->u = particles_new_array(ps, "basset_u", "m/s", 3);
    self->age = particles_new_array(ps, "basset_age", "-", 1);
    self->held = particles_new_array(ps, "basset_held", "N", 3);
    self->start = particles_new_array(ps, "basset_start", "m/s", 3);
    particles_add_implicit_drag(ps);
    effect_force_inertia(sim);
    return self;
}

static double *basset_term(const struct basset *self, int k, int i)
{
    return &self->E[k / TERMS_A_ROW][ROW * i + 3 * (k % TERMS_A_ROW)];
}

/* Part of the change of the slip in the step before [-]. */
static const double before = 2.0 * M_SQRT2 - 2.0;

/* The added mass [kg] of a sphere of diameter d [m] in a step dt [s]. */
static double basset_mass_of(double dt, double rho, double mu, double d)
{
    return 4.0 / 3.0 * sqrt(dt) * basset_coefficient(rho, mu, d);
}

static double mass(const struct simulation *sim, int i)
{
    const struct fluid_options *const o = &sim->fluid->options;
    const struct particles *const ps = sim->particles;
    return particles_grains(ps, i) *
           basset_mass_of(sim->dt, o->rho, o->mu, particles_grain(ps, i));
}

/* The held force over the added mass [m/s^2]: component a of particle i, whose
 * fluid has changed by du [m/s]. Of a first slip w_0 the mean over the step is
 * 2 w_0/sqrt(dt). */
static double known_part(const struct basset *self,
                         const struct simulation *sim, int i, int a, double du,
                         double w_0)
{
    const double dt = sim->dt;
    double older = 0.0;

    for (int k = 0; k < self->kernel.n; k++)
        older += self->kernel.c[k] * self->gain[k] * basset_term(self, k, i)[a];
    return du / dt + before * self->change[3 * i + a] / dt +
           0.75 * (older / sqrt(dt) + 2.0 * w_0 / dt);
}

/* [LS 5.4]: what is known of it as a force, the rest as a mass. */
static void basset_before_particles(void *memory, struct simulation *sim)
{
    struct basset *const self = memory;
    struct particles *const ps = sim->particles;
    const double *const u = sim->coupling->u_f;

    for (int i = 0; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        const double m = mass(sim, i);
        const int is_new = self->age[i] == 0.0;
        ps->added_mass[i] += m;
        for (int a = 0; a < 3; a++) {
            const int j = 3 * i + a;
            const double du = is_new ? 0.0 : u[j] - self->u[j];
            self->held[j] =
                m * known_part(self, sim, i, a, du, is_new ? u[j] - v[a] : 0.0);
            sim->held_force[j] += self->held[j];
            self->start[j] = v[a];
        }
    }
}

/* Advances the history of one component by a step. dw [m/s] is the change of
 * the slip in the step that ends, w_0 a first slip at its start. */
static void update_history(struct basset *self, int i, int a, double dw,
                           double w_0)
{
    for (int k = 0; k < self->kernel.n; k++) {
        double *const E = basset_term(self, k, i);
        E[a] = self->decay[k] *
               (E[a] + self->gain[k] * self->change[3 * i + a] + w_0);
    }
    self->change[3 * i + a] = dw;
}

/* The impulse of the step, no part of which has acted on the fluid yet. */
static void basset_after_particles(void *memory, struct simulation *sim)
{
    struct basset *const self = memory;
    const struct particles *const ps = sim->particles;
    const double *const u = sim->coupling->u_f;

    for (int i = 0; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        const double m = mass(sim, i);
        const int is_new = self->age[i] == 0.0;
        double impulse[3], force[3];
        for (int a = 0; a < 3; a++) {
            const int j = 3 * i + a;
            const double dv = v[a] - self->start[j];
            const double du = is_new ? 0.0 : u[j] - self->u[j];
            impulse[a] = self->held[j] * sim->dt - m * dv;
            force[a] = impulse[a] / sim->dt;
            update_history(self, i, a, du - dv,
                           is_new ? u[j] - self->start[j] : 0.0);
            self->u[j] = u[j];
        }
        self->age[i] = 1.0;
        effect_force_charge(sim, i, m);
        coupling_add_impulse(sim, i, impulse);
        effects_report(sim, force, 1.0);
    }
}

/* A slip that is there at the start and dies out as w_0 exp(-t/T) has, at t = x
 * T, the force C w_0/sqrt(T) (1/sqrt(x) - 2 D(sqrt(x))), with the integral 2
 * D(sqrt(x)) of Dawson's D, which is largest, 0.541, where the force changes
 * its sign. This is the mean of its size up to t over that of exp(-t/T). A
 * large one, of share s, makes the decay slower by 1 + s, and itself smaller.
 */
static double basset_of_decay(double share, double x)
{
    const double most = 0.541, zero = 0.854;
    const double sum = 2.0 * gsl_sf_dawson(sqrt(x));
    double s = 0.0;

    share *= (x < zero ? sum : 4.0 * most - sum) / -expm1(-x);
    for (int i = 0; i < 30; i++)
        s = share / sqrt(1.0 + s);
    return s;
}

/* A slip that rises and falls in turn, each in a time T at the rate a, mostly
 * has the history of the first sine of that square wave, of the amplitude 4/pi
 * a and the frequency omega = pi/T: C (4/pi) a sqrt(pi/omega), whose mean size
 * is 2/pi of that, over C a sqrt(T) [-]. */
static const double of_turns = 8.0 / (M_PI * M_PI);

/* C (2 sqrt(t)) dw/dt for as long as the slip develops, but no longer than it
 * takes to. Beyond Re = 1 the kernel fades sooner. */
static struct effect_estimate basset_estimate(const struct effect_scales *k)
{
    const double C = basset_coefficient(k->rho_f, k->mu, k->d);
    const double Re = k->rho_f * k->slip * k->d / k->mu;
    double share = 0.0; /* of an endless time */

    if (k->acceleration > 0.0)
        share = C * sqrt(k->time) * k->acceleration / k->force;
    share = k->decays && share > 0.0 ? basset_of_decay(share, k->end / k->time)
                                     : (k->turns ? of_turns : 2.0) * share;
    if (k->decays && k->time < k->dt)
        return effects_unknown(
            share, "the slip dies out in %.2g s, within one step of the fluid",
            k->time);
    return Re <= 1.0
               ? effects_estimate(share, "")
               : effects_unknown(share,
                                 "no data for Re %.3g (below 1), where it "
                                 "fades sooner",
                                 Re);
}

static void basset_added_mass(const struct effect_scales *k,
                              struct added_mass *sum)
{
    const double m_f = k->rho_f * M_PI / 6.0 * gsl_pow_3(k->d);
    const double C = basset_mass_of(k->dt, k->rho_f, k->mu, k->d) / m_f;

    sum->C += C;
    sum->C_history += before * C;
}

static const struct key keys[] = {
    {"effects.basset", KEY_GROUP, "", "", KEY_OPTIONAL,
     "force of the boundary layer that lags behind the slip", "LS 5.4",
     "fluid particles averaging exchange"},
    {"effects.basset.tolerance", KEY_REAL, "-", ">= 2e-5, <= 0.1", "2e-3",
     "relative error of the kernel from one step to a million", "LS 5.4", ""},
    KEY_END};

const struct effect basset_effect = {
    .name = "basset",
    .what = "history force: the boundary layer lags behind the slip",
    .equations = "LS 5.4",
    .function = "basset_before_particles",
    .keys = {keys},
    .create = basset_create,
    .before_particles = basset_before_particles,
    .after_particles = basset_after_particles,
    .estimate = basset_estimate,
    .added_mass = basset_added_mass,
    .cost = {212.0, 0.0, 11.0},
};

/* --- basset kernel -------------------------------------------------------- */

/* How long the past counts, over the step: what is older has faded in the
 * slowest term. */
static const double longest = 1e6;

/* The spacing makes the error of the rule, 2 exp(-pi^2/q), half of the
 * tolerance; the ends are where what is cut off is that small. The two add up
 * at the far end, with a tenth for the term that the end halves. */
struct basset_kernel basset_kernel_create(double dt, double tolerance)
{
    const double half = tolerance / 2.2;
    const double q = M_PI * M_PI / log(2.0 / half);
    const double low = log(gsl_pow_2(half) * M_PI / (4.0 * longest * dt));
    const double high = log(log(2.0 / half) / dt);
    const double terms = 1.0 + ceil((high - low) / q);
    struct basset_kernel k = {.n = number_clamped(terms, 1, BASSET_TERMS)};

    for (int i = 0; i < k.n; i++) {
        const double y = low + i * q;
        k.s[i] = exp(y);
        k.c[i] = q * exp(0.5 * y) / M_SQRTPI;
    }
    return k;
}

double basset_kernel_value(const struct basset_kernel *k, double t)
{
    double sum = 0.0;

    for (int i = 0; i < k->n; i++)
        sum += k->c[i] * exp(-k->s[i] * t);
    return sum;
}

double basset_coefficient(double rho, double mu, double d)
{
    return 1.5 * d * d * sqrt(M_PI * rho * mu);
}

double basset_force(double rho, double mu, double d, double t, double rate)
{
    return basset_coefficient(rho, mu, d) * 2.0 * sqrt(t) * rate; /* [LS 5.4] */
}
