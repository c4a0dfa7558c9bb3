/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/lubrication.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/effect_scales.h"
#include "coupling/effects.h"
#include "coupling/effects/pair_share.h"
#include "dem/attraction.h"

double lubrication_coefficient(double mu, double R_star, double z, double z_min,
                               double z_out)
{
    if (z >= z_out) return 0.0;
    return 6.0 * M_PI * mu * R_star * R_star *
           (1.0 / fmax(z, z_min) - 1.0 / z_out);
}

static double lubrication_damping(const struct attraction *a, double R_star,
                                  double gap)
{
    if (gap < 0.0) return 0.0;
    return lubrication_coefficient(a->strength, R_star, gap, a->closest,
                                   a->range);
}

static const struct attraction_law law = {.name = "lubrication",
                                          .damping = lubrication_damping};

static struct attraction
lubrication_attraction(const double *p, const struct attraction_scene *scene)
{
    return (struct attraction){.law = &law,
                               .strength = scene->viscosity,
                               .closest = p[0],
                               .range = p[1]};
}

/* The particles are created with it; this measures it. */
static void *lubrication_create(struct simulation *sim,
                                const double *parameters)
{
    (void)parameters;
    return pair_share_create(sim, &law);
}

/* A pair that closes with the slip loses ln(z_out/z_min), about 7, times 6 pi
 * mu R*^2/m* of its speed on the way through the gap: all of it at St = rho_s u
 * d/(9 mu) of about 10. */
static struct effect_estimate
lubrication_estimate(const struct effect_scales *k)
{
    const double St = k->rho_s * k->slip * k->d / (9.0 * k->mu);

    return (struct effect_estimate){
        St > 0.0 && k->carried && (k->eps_s > 1e-3 || k->pair != NULL)
            ? fmin(1.0, 10.0 / St)
            : 0.0,
        "of the speed of an impact is lost, 10/St", 0};
}

static const struct key keys[] = {
    {"effects.lubrication", KEY_GROUP, "", "", KEY_OPTIONAL,
     "lubrication force between close particles and at walls", "Cox67",
     "fluid particles"},
    {"effects.lubrication.roughness", KEY_REAL, "m", "> 0", NULL,
     "gap z_min below which the force grows no further", "", ""},
    {"effects.lubrication.range", KEY_REAL, "m", "> 0", NULL,
     "gap z_out below which it acts", "", ""},
    {0}};

static const char *lubrication_wrong(const double *p,
                                     const struct attraction_scene *scene)
{
    (void)scene;
    return p[0] < p[1] ? NULL : "the range must be longer than the roughness";
}

const struct effect lubrication_effect = {
    .name = "lubrication",
    .what = "lubrication force between close particles",
    .equations = "Cox67",
    .function = "lubrication_coefficient",
    .keys = {keys},
    .create = lubrication_create,
    .after_step = pair_share_after_step,
    .free = pair_share_free,
    .attraction = lubrication_attraction,
    .wrong = lubrication_wrong,
    .estimate = lubrication_estimate,
    .cost = {35.0, 1.0, 81.0},
};
