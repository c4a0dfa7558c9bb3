/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/saffman.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/effects/effect_force.h"
#include "coupling/effect_scales.h"
#include "coupling/effects.h"
#include "coupling/effects/vorticity.h"

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

static void *saffman_create(struct simulation *sim, const double *parameters)
{
    (void)parameters;
    return vorticity_create(sim, "saffman_vorticity");
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
        saffman_lift(o->rho, o->mu, ps->d[i], w, &v->at[3 * i], F);
        effect_force_add(sim, i, F);
    }
}

static struct effect_estimate saffman_estimate(const struct effect_scales *k)
{
    const double w[3] = {k->slip, 0.0, 0.0}, curl[3] = {0.0, 0.0, k->shear};
    double F[3];

    saffman_lift(k->rho_f, k->mu, k->d, w, curl, F);
    return (struct effect_estimate){fabs(F[1]) / k->force, "", 0};
}

static const struct key keys[] = {
    {"effects.saffman", KEY_GROUP, "", "", KEY_OPTIONAL,
     "lift on a particle that slips in a shear flow, with Mei's factor",
     "LS 5.5, 5.6", "fluid particles averaging exchange"},
    {0}};

const struct effect saffman_effect = {
    .name = "saffman",
    .what = "lift on a particle that slips in a shear flow",
    .equations = "LS 5.5, 5.6",
    .function = "saffman_lift",
    .keys = {keys},
    .create = saffman_create,
    .before_particles = vorticity_update,
    .before_substep = saffman_before_substep,
    .free = vorticity_free,
    .estimate = saffman_estimate,
    .cost = {46.0, 63.0, 0.0},
};
