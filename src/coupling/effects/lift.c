/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lift.c -- lift in a shear and of a particle that spins, and the torque that
 * slows its spin: forces that need the curl of the flow. */
#include "coupling/effects/forces.h"

#include "base/alloc.h"
#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "fluid/deferred.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

/* --- vorticity ------------------------------------------------------------ */

/* Curl u of the fluid, at the particles.
 *
 * The lift forces and the torque of the fluid need it. The gradient in the
 * cells is that of the case (fluid.gradient), and the interpolation to the
 * particles the adjoint of the averaging, as for the other derivatives of the
 * flow. With averaging.gradient_bandwidth it is found at the particles
 * themselves, by the derivative of a kernel [EW18 B.6]. */
struct vorticity {
    char name[48];    /* of the attached array `at` (particles.h) */
    double *u_b;      /* [m/s] at the boundary, 3 a face */
    double *gradient; /* [1/s] of u, 9 a cell; by a kernel: 9 a particle */
    double *curl;     /* [1/s] 3 a cell */
    double *at;       /* [1/s] interpolated to the particles, 3 each */
};

static void *vorticity_create(struct simulation *sim, const double *parameters)
{
    const struct mesh *const m = sim->mesh;
    struct vorticity *const v = owner_create(sizeof *v);

    (void)parameters;
    snprintf(v->name, sizeof v->name, "%s_vorticity",
             sim->running_effect->effect->name);
    v->u_b = owner_doubles(v, 3 * (m->n_faces - m->n_internal));
    v->gradient = owner_doubles(v, 9 * (m->n_cells > sim->particles->capacity
                                            ? m->n_cells
                                            : sim->particles->capacity));
    v->curl = owner_doubles(v, 3 * m->n_cells);
    v->at = particles_new_array(sim->particles, v->name, "1/s", 3);
    return v;
}

/* curl u of n gradients; d u_k/d x_j is at 3 k + j of each. */
static void vorticity_curl(int n, const double *gradient, double *curl)
{
    for (int i = 0; i < n; i++) {
        const double *const g = &gradient[9 * i];
        curl[3 * i] = g[7] - g[5];
        curl[3 * i + 1] = g[2] - g[6];
        curl[3 * i + 2] = g[3] - g[1];
    }
}

static void vorticity_update(void *memory, struct simulation *sim)
{
    struct vorticity *const v = memory;
    const struct fluid *const fl = sim->fluid;

    if (averaging_gradient(sim->averaging, 3, fl->u, v->gradient)) {
        vorticity_curl(sim->particles->n, v->gradient, v->at);
        return;
    }
    fluid_boundary_velocity(fl, v->u_b);
    boundary_reach_gradient(fl, fl->u, v->u_b, v->gradient);
    vorticity_curl(fl->mesh->n_cells, v->gradient, v->curl);
    averaging_gather(sim->averaging, 3, v->curl, v->at);
}

/* The spin of particle i against half of the curl [rad/s]. The grains of a
 * parcel of l diameters turn l times as fast as it does, so that both have the
 * same speed at the surface, and the same energy. */
static void vorticity_relative_spin(const struct vorticity *v,
                                    const struct particles *ps, int i,
                                    double Omega[3])
{
    const double *const curl = &v->at[3 * i];
    const double l = particles_across(ps, i);

    Omega[0] = l * ps->wx[i] - 0.5 * curl[0];
    Omega[1] = l * ps->wy[i] - 0.5 * curl[1];
    Omega[2] = l * ps->wz[i] - 0.5 * curl[2];
}

/* The force F [N] on one grain, for all of particle i. */
static void add_of_grains(struct simulation *sim, int i, double F[3])
{
    for (int a = 0; a < 3; a++)
        F[a] *= particles_grains(sim->particles, i);
    effect_force_add(sim, i, F);
}

/* --- saffman -------------------------------------------------------------- */

static const double coefficient = 1.615; /* [-] 6.46/4, Saffman 1968 */

double saffman_reynolds(double d, double nu, double G)
{
    return d * d * G / nu; /* [LS 5.5] */
}

double saffman_force(double mu, double d, double u_r, double Re_G)
{
    return 1.61 * mu * d * u_r * sqrt(Re_G); /* [LS 5.6], as printed */
}

/* For a vanishing slip alpha is infinite and the force 0: the lift of the shear
 * alone is left out, as in [LS 5.6]. */
double saffman_factor(double Re, double alpha)
{
    if (!(alpha < HUGE_VAL)) return 1.0;
    if (Re > 40.0) return 0.0524 * sqrt(alpha * Re);
    const double tail = 0.3314 * sqrt(alpha);
    return (1.0 - tail) * exp(-0.1 * Re) + tail;
}

void saffman_lift(double rho, double mu, double d, const double w[3],
                  const double curl[3], double F[3])
{
    const double speed = vector_length(w), G = vector_length(curl);
    double k = 0.0;

    if (G > 0.0 && mu > 0.0)
        k = coefficient * d * d * sqrt(rho * mu / G) *
            saffman_factor(rho * speed * d / mu, 0.5 * d * G / speed);
    if (mu == 0.0) /* beyond Re = 40 it cancels */
        k = coefficient * 0.0524 * M_SQRT1_2 * rho * d * d * d;
    vector_cross(w, curl, F);
    for (int a = 0; a < 3; a++)
        F[a] *= k; /* [LS 5.6] */
}

/* The lift for the slip at the start of the sub-step. */
static void saffman_before_substep(void *memory, struct simulation *sim)
{
    const struct vorticity *const v = memory;
    const struct fluid_options *const o = &sim->fluid->options;
    const struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        double w[3], F[3];
        coupling_slip(sim, i, w);
        saffman_lift(o->rho, o->mu, particles_grain(ps, i), w, &v->at[3 * i],
                     F);
        add_of_grains(sim, i, F);
    }
}

/* Where no collisions stir them, nothing else moves particles across the
 * stream, so that a small lift is missed too: in the time of the run they drift
 * by its share of the slip. */
static struct effect_estimate saffman_estimate(const struct effect_scales *k)
{
    const double w[3] = {k->slip, 0.0, 0.0}, curl[3] = {0.0, 0.0, k->shear};
    double F[3];

    saffman_lift(k->rho_f, k->mu, k->d, w, curl, F);
    struct effect_estimate e = effects_estimate(fabs(F[1]) / k->force, "");
    const double drift = e.share * k->slip * k->time / k->d; /* [-] */
    if (k->carried && !k->stirred && drift > e.share) {
        e.of = "a drift by a diameter across the stream";
        e.loss = fmin(1.0, drift);
    }
    return e;
}

static const struct key saffman_keys[] = {
    {"effects.saffman", KEY_GROUP, "", "", KEY_OPTIONAL,
     "lift on a particle that slips in a shear flow, with Mei's factor",
     "LS 5.5, 5.6", "fluid particles averaging exchange"},
    KEY_END};

const struct effect saffman_effect = {
    .name = "saffman",
    .what = "lift on a particle that slips in a shear flow",
    .equations = "LS 5.5, 5.6",
    .function = "saffman_lift",
    .keys = {saffman_keys},
    .create = vorticity_create,
    .before_particles = vorticity_update,
    .before_substep = saffman_before_substep,
    .estimate = saffman_estimate,
    .cost = {46.0, 63.0, 0.0},
};

/* --- spin ----------------------------------------------------------------- */

/* Re_r = rho d^2 |Omega| / mu [-]. */
static double spin_reynolds(double rho, double mu, double d, double Omega)
{
    return rho * d * d * Omega / mu;
}

/* Re_r/Re = d |Omega|/|w| is the coefficient at small Re; without viscosity the
 * limit is left. */
double spin_lift_coefficient(double Re, double Re_r)
{
    if (!(Re < HUGE_VAL)) return 0.45;
    return 0.45 +
           (Re_r / Re - 0.45) * exp(-0.05684 * pow(Re_r, 0.4) * pow(Re, 0.3));
}

double spin_force(double rho, double C_LR, double d, double u_r)
{
    return 0.5 * rho * 0.25 * M_PI * d * d * C_LR * fabs(u_r) *
           u_r; /* [LS 5.7] */
}

void spin_lift(double rho, double mu, double d, const double w[3],
               const double Omega[3], double F[3])
{
    const double speed = vector_length(w), spin = vector_length(Omega);
    double size = 0.0;

    if (speed > 0.0 && spin > 0.0)
        size =
            spin_force(rho,
                       spin_lift_coefficient(rho * speed * d / mu,
                                             spin_reynolds(rho, mu, d, spin)),
                       d, speed) /
            (speed * spin);
    vector_cross(w, Omega, F);
    for (int a = 0; a < 3; a++)
        F[a] *= size;
}

double spin_torque_factor(double Re_r)
{
    return Re_r <= 32.0 ? 64.0 * M_PI : 12.9 * sqrt(Re_r) + 128.4;
}

/* T/(I Omega) with T = (1/2) rho (d/2)^5 (factor/Re_r) Omega^2 and I = m d^2/10
 * = pi rho_s d^5/60. */
double spin_decay_rate(double rho, double mu, double d, double rho_s,
                       double Omega)
{
    if (mu == 0.0) return 0.0;
    const double factor = spin_torque_factor(spin_reynolds(rho, mu, d, Omega));
    return 15.0 / 16.0 * factor * mu / (M_PI * rho_s * d * d);
}

/* --- magnus --------------------------------------------------------------- */

/* Magnus's lift on a particle that spins [LS 5.7] (spin.h). */

/* The lift for slip and spin at the start of the sub-step. */
static void magnus_before_substep(void *memory, struct simulation *sim)
{
    const struct vorticity *const v = memory;
    const struct fluid_options *const o = &sim->fluid->options;
    const struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        double w[3], Omega[3], F[3];
        coupling_slip(sim, i, w);
        vorticity_relative_spin(v, ps, i, Omega);
        spin_lift(o->rho, o->mu, particles_grain(ps, i), w, Omega, F);
        add_of_grains(sim, i, F);
    }
}

/* A force of random direction adds to another one, on average, half the square
 * of its share. In a jet all spin alike, and what is missed is missed there. */
static struct effect_estimate magnus_estimate(const struct effect_scales *k)
{
    const double Re = k->rho_f * k->slip * k->d / k->mu;
    const double Re_r = spin_reynolds(k->rho_f, k->mu, k->d, k->spin);
    const double F =
        spin_force(k->rho_f, spin_lift_coefficient(Re, Re_r), k->d, k->slip);
    struct effect_estimate e =
        effects_estimate(Re > 0.0 && Re_r > 0.0 ? k->rolls * F / k->force : 0.0,
                         k->stirred ? "collisions turn it any way" : "");

    if (k->stirred) e.loss = 0.5 * e.share * e.share;
    if (k->jet > 0.0) {
        e.loss = fmin(1.0, e.share + e.loss / k->jet);
        e.of = "the force on a grain in the jet";
    }
    return e;
}

static const struct key magnus_keys[] = {
    {"effects.magnus", KEY_GROUP, "", "", KEY_OPTIONAL,
     "lift on a particle that rotates", "LS 5.7",
     "fluid particles averaging exchange"},
    KEY_END};

const struct effect magnus_effect = {
    .name = "magnus",
    .what = "lift on a particle that rotates",
    .equations = "LS 5.7",
    .function = "spin_lift",
    .keys = {magnus_keys},
    .create = vorticity_create,
    .before_particles = vorticity_update,
    .before_substep = magnus_before_substep,
    .estimate = magnus_estimate,
    .cost = {89.0, 65.0, 0.0},
};

/* --- fluid torque --------------------------------------------------------- */

/* The torque of the fluid on a particle that spins (spin.h).
 *
 *   I domega/dt = T,   omega - curl u/2 = Omega ~ exp(-r t)
 *
 * r is taken from the start of a sub-step of the drag, and the exponential is
 * stable for any sub-step. The reaction does not act on the fluid: averaged
 * over the cell a couple is no force, and the angular momentum of the fluid
 * below the size of a cell is not in the equations. */

static void fluid_torque_before_substep(void *memory, struct simulation *sim)
{
    const struct vorticity *const v = memory;
    const struct fluid_options *const o = &sim->fluid->options;
    struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        double *const spin[3] = {&ps->wx[i], &ps->wy[i], &ps->wz[i]};
        const double rho_s = ps->m[i] / particles_volume(ps, i);
        double Omega[3];
        vorticity_relative_spin(v, ps, i, Omega);
        const double rate = spin_decay_rate(
            o->rho, o->mu, particles_grain(ps, i), rho_s, vector_length(Omega));
        for (int k = 0; k < 3; k++)
            *spin[k] += Omega[k] * expm1(-rate * sim->substep) /
                        particles_across(ps, i);
    }
}

/* Of what the torque slows the spin by, so much at most was missed in the speed
 * of grains that roll over each other, by `check --try` in four scenes [-]. */
static const double rolled = 0.2;

/* The part of a spin that is lost in a relaxation time matters by the lift that
 * comes from it; and grains that roll are slowed by what is lost from one to
 * the next, over a diameter. */
static struct effect_estimate
fluid_torque_estimate(const struct effect_scales *k)
{
    const double rate =
        spin_decay_rate(k->rho_f, k->mu, k->d, k->rho_s, k->spin);
    const double lost = k->spin > 0.0 ? -expm1(-rate * k->tau) : 0.0;
    struct effect_estimate e = magnus_estimate(k);

    e.share *= lost;
    const double slowed =
        k->turns ? -rolled * expm1(-rate * fmin(k->tau, k->d / k->slip)) : 0.0;
    e.loss *= lost;
    if (slowed > e.loss) {
        e.loss = slowed;
        e.of = "the speed of grains that roll";
    }
    snprintf(e.remark, sizeof e.remark,
             lost > 0.0 ? "slows a spin by %.2g %%, and so the lift"
                        : "no spin",
             100.0 * lost);
    return e;
}

static const struct key fluid_torque_keys[] = {
    {"effects.fluid_torque", KEY_GROUP, "", "", KEY_OPTIONAL,
     "torque of the fluid, which slows the rotation of a particle", "LS 5.7",
     "fluid particles averaging exchange"},
    KEY_END};

const struct effect fluid_torque_effect = {
    .name = "fluid_torque",
    .what = "torque of the fluid on a particle that rotates",
    .equations = "",
    .function = "spin_decay_rate",
    .keys = {fluid_torque_keys},
    .create = vorticity_create,
    .before_particles = vorticity_update,
    .before_substep = fluid_torque_before_substep,
    .estimate = fluid_torque_estimate,
    .cost = {36.0, 66.0, 0.0},
};
