/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cohesion.c -- the attractions of dem/cohesion as effects.
 * Chapter "Materials, rolling and cohesion". */
#include "coupling/effects.h"

#include <math.h>
#include <stddef.h>

#include "dem/attraction.h"
#include "dem/cohesion/capillary.h"
#include "dem/cohesion/electrostatic.h"
#include "dem/cohesion/van_der_waals.h"

/* They act within the steps of the particles, and while a bed settles:
 * therefore the particles are created with them (.attraction), and create makes
 * nothing. */
static void *create(struct simulation *sim, const double *parameters)
{
    (void)sim, (void)parameters;
    return NULL;
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
     "particles"},
    {"effects.electrostatic.permittivity", KEY_REAL, "-", ">= 1", "1.0",
     "relative permittivity of what is between, eps_r", "LS 4.13", ""},
    {"effects.electrostatic.range", KEY_REAL, "m", "> 0", NULL,
     "longest gap between two surfaces at which it acts", "", ""},
    {0}};

const struct effect cohesion_electrostatic = {
    .name = "electrostatic",
    .what = "force between electric charges",
    .equations = "LS 4.13",
    .function = "electrostatic_force",
    .keys = electrostatic_keys,
    .create = create,
    .attraction = electrostatic_of,
    .wrong = electrostatic_wrong,
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
     "attraction of surfaces that are close, walls too", "LS 4.14",
     "particles"},
    {"effects.van_der_waals.hamaker", KEY_REAL, "J", "> 0", NULL,
     "Hamaker's constant A", "LS 4.14", ""},
    {"effects.van_der_waals.min_gap", KEY_REAL, "m", "> 0", "4e-10",
     "gap below which the force stays what it is there", "", ""},
    {"effects.van_der_waals.range", KEY_REAL, "m", "> 0", NULL,
     "longest gap between two surfaces at which it acts", "", ""},
    {0}};

const struct effect cohesion_van_der_waals = {
    .name = "van_der_waals",
    .what = "van der Waals attraction",
    .equations = "LS 4.14",
    .function = "van_der_waals_force",
    .keys = van_der_waals_keys,
    .create = create,
    .attraction = van_der_waals_of,
    .wrong = van_der_waals_wrong,
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
     "bridges of liquid, to walls too", "LS 4.15", "particles"},
    {"effects.capillary.tension", KEY_REAL, "N/m", "> 0", NULL,
     "surface tension of the liquid, gamma", "LS 4.15", ""},
    {"effects.capillary.angle", KEY_REAL, "rad", ">= 0, < 1.5707963", "0.0",
     "angle of contact, theta", "LS 4.15", ""},
    {"effects.capillary.range", KEY_REAL, "m", ">= 0", "0.0",
     "gap at which a bridge breaks; 0: it is there while they touch", "", ""},
    {"effects.capillary.harmonic", KEY_BOOL, "", "", "false",
     "R* of unequal spheres: the harmonic mean instead of the mean", "LS 4.15",
     ""},
    {0}};

const struct effect cohesion_capillary = {
    .name = "capillary",
    .what = "pull of bridges of liquid",
    .equations = "LS 4.15",
    .function = "capillary_force",
    .keys = capillary_keys,
    .create = create,
    .attraction = capillary_of,
};
