/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cohesion.c -- the attractions of dem/cohesion as effects.
 * Chapter "Materials, rolling and cohesion". */
#include "coupling/effects.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/effect_scales.h"
#include "coupling/effects/pair_share.h"
#include "dem/attraction.h"
#include "dem/cohesion/capillary.h"
#include "dem/cohesion/electrostatic.h"
#include "dem/cohesion/van_der_waals.h"

/* They act within the steps of the particles, and while a bed settles:
 * therefore the particles are created with them (.attraction), and what create
 * makes only measures them. */
static void *create_electrostatic(struct simulation *sim,
                                  const double *parameters)
{
    (void)parameters;
    return pair_share_create(sim, &electrostatic);
}

static void *create_van_der_waals(struct simulation *sim,
                                  const double *parameters)
{
    (void)parameters;
    return pair_share_create(sim, &van_der_waals);
}

static void *create_capillary(struct simulation *sim, const double *parameters)
{
    (void)parameters;
    return pair_share_create(sim, &capillary);
}

/* The force of two that touch, F [N] if the effect is not named: then it has no
 * strength, and F is that of ordinary materials. */
static struct effect_estimate cohesion_touching(const struct effect_scales *k,
                                                double F, const char *remark)
{
    const double R = 0.5 * k->d;

    if (k->pair == NULL)
        return (struct effect_estimate){fabs(F) / k->force, remark, 1};
    return (struct effect_estimate){
        fabs(k->pair->law->pair(k->pair, 0, 0, R, R, 0.0)) / k->force,
        "of two particles that touch", 0};
}

static struct effect_estimate
estimate_electrostatic(const struct effect_scales *k)
{
    const double q = 1e-5 * M_PI * k->d * k->d;
    return cohesion_touching(k, electrostatic_force(q, q, 1.0, k->d),
                             "if they touch and are charged to 1e-5 C/m^2");
}

static struct effect_estimate
estimate_van_der_waals(const struct effect_scales *k)
{
    return cohesion_touching(
        k, van_der_waals_force(1e-19, 1e-7, 4e-10),
        "if they touch by asperities of 0.1 um, A = 1e-19 J");
}

static struct effect_estimate estimate_capillary(const struct effect_scales *k)
{
    return cohesion_touching(k, capillary_force(0.072, 0.5 * k->d),
                             "if they touch and are wet");
}

static struct attraction electrostatic_of(const double *p,
                                          const struct attraction_scene *scene)
{
    return (struct attraction){.law = &electrostatic,
                               .strength = p[0],
                               .range = p[1],
                               .charge = scene->charge};
}

static const char *electrostatic_wrong(const double *p,
                                       const struct attraction_scene *scene)
{
    (void)p;
    return scene->charged ? NULL
                          : "no material has a charge: give "
                            "particles.grains.charge [C]";
}

static const struct key electrostatic_keys[] = {
    {"effects.electrostatic", KEY_GROUP, "", "", KEY_OPTIONAL,
     "force between charged particles; walls have no charge", "LS 4.13",
     "particles", .divided = "cohesion is not told to LAMMPS"},
    {"effects.electrostatic.permittivity", KEY_REAL, "-", ">= 1", "1.0",
     "relative permittivity of the medium, eps_r", "LS 4.13", ""},
    {"effects.electrostatic.range", KEY_REAL, "m", "> 0", NULL,
     "longest gap between two surfaces at which it acts", "", ""},
    {0}};

const struct effect cohesion_electrostatic = {
    .name = "electrostatic",
    .what = "force between electric charges",
    .equations = "LS 4.13",
    .function = "electrostatic_force",
    .keys = {electrostatic_keys},
    .create = create_electrostatic,
    .after_step = pair_share_after_step,
    .free = pair_share_free,
    .attraction = electrostatic_of,
    .wrong = electrostatic_wrong,
    .estimate = estimate_electrostatic,
    .cost = {52.0, 0.0, 98.0},
};

static struct attraction van_der_waals_of(const double *p,
                                          const struct attraction_scene *scene)
{
    (void)scene;
    return (struct attraction){.law = &van_der_waals,
                               .strength = p[0],
                               .closest = p[1],
                               .range = p[2]};
}

static const char *van_der_waals_wrong(const double *p,
                                       const struct attraction_scene *scene)
{
    (void)scene;
    return p[1] < p[2] ? NULL
                       : "the range must be longer than the closest gap, "
                         "min_gap";
}

static const struct key van_der_waals_keys[] = {
    {"effects.van_der_waals", KEY_GROUP, "", "", KEY_OPTIONAL,
     "attraction between close particles and to walls", "LS 4.14", "particles",
     .given = KEY_AT(effects_options, van_der_waals),
     .divided = "cohesion is not told to LAMMPS"},
    {"effects.van_der_waals.hamaker", KEY_REAL, "J", "> 0", NULL,
     "Hamaker's constant A", "LS 4.14", ""},
    {"effects.van_der_waals.min_gap", KEY_REAL, "m", "> 0", "4e-10",
     "gap below which the force is constant", "", ""},
    {"effects.van_der_waals.range", KEY_REAL, "m", "> 0", NULL,
     "longest gap between two surfaces at which it acts", "", ""},
    {0}};

const struct effect cohesion_van_der_waals = {
    .name = "van_der_waals",
    .what = "van der Waals attraction",
    .equations = "LS 4.14",
    .function = "van_der_waals_force",
    .keys = {van_der_waals_keys},
    .create = create_van_der_waals,
    .after_step = pair_share_after_step,
    .free = pair_share_free,
    .attraction = van_der_waals_of,
    .wrong = van_der_waals_wrong,
    .estimate = estimate_van_der_waals,
    .cost = {30.0, 0.0, 54.0},
};

static struct attraction capillary_of(const double *p,
                                      const struct attraction_scene *scene)
{
    (void)scene;
    return (struct attraction){.law = &capillary,
                               .strength = p[0] * cos(p[1]),
                               .range = p[2],
                               .harmonic = p[3] != 0.0};
}

static const struct key capillary_keys[] = {
    {"effects.capillary", KEY_GROUP, "", "", KEY_OPTIONAL,
     "liquid bridges between particles and to walls", "LS 4.15", "particles",
     .given = KEY_AT(effects_options, capillary),
     .divided = "cohesion is not told to LAMMPS"},
    {"effects.capillary.tension", KEY_REAL, "N/m", "> 0", NULL,
     "surface tension of the liquid, gamma", "LS 4.15", ""},
    {"effects.capillary.angle", KEY_REAL, "rad", ">= 0, < 1.5707963", "0.0",
     "angle of contact, theta", "LS 4.15", ""},
    {"effects.capillary.range", KEY_REAL, "m", ">= 0", "0.0",
     "gap at which a bridge breaks; 0: bridges exist at contact only", "", ""},
    {"effects.capillary.harmonic", KEY_BOOL, "", "", "false",
     "R* of unequal spheres: the harmonic mean instead of the mean", "LS 4.15",
     ""},
    {0}};

const struct effect cohesion_capillary = {
    .name = "capillary",
    .what = "attraction by liquid bridges",
    .equations = "LS 4.15",
    .function = "capillary_force",
    .keys = {capillary_keys},
    .create = create_capillary,
    .after_step = pair_share_after_step,
    .free = pair_share_free,
    .attraction = capillary_of,
    .estimate = estimate_capillary,
    .cost = {30.0, 0.0, 42.0},
};
