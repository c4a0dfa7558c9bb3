/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lubrication.c -- forces between particles that are close, as effects: the
 * liquid between them, and the attractions of dem/cohesion. */
#include "coupling/effects/forces.h"

#include "base/alloc.h"
#include "base/vector.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "dem/attraction.h"
#include "dem/dem_method.h"
#include "dem/box_domain.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* --- pair share ----------------------------------------------------------- */

/* Measures a force between close particles.
 *
 * The loops of the particles add up the forces of all laws. For the report of
 * an effect, the force of its law alone is computed again after every eighth
 * step: for each particle the strongest one of all partners and walls. */
enum { MEASURED = 8 }; /* [-] one step in so many, for the cost */

struct pair_share {
    const struct attraction *attraction; /* borrowed */
    struct link_cells *cells;
    double *strongest; /* [N] force on each particle */
};

/* The memory of the effect that is created, whose law has its name; NULL if the
 * particles do not have that. They are created with it (.attraction): this
 * measures it. */
static void *pair_share_create(struct simulation *sim, const double *parameters)
{
    const char *const name = sim->running_effect->effect->name;
    const struct dem_options *const o = &sim->dem->options;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    const struct attraction *found = NULL;

    for (int k = 0; k < o->n_attractions; k++)
        if (strcmp(o->attractions[k].law->name, name) == 0)
            found = &o->attractions[k];
    (void)parameters;
    if (found == NULL) return NULL;
    struct pair_share *const self = owner_create(sizeof *self);
    self->attraction = found;
    self->cells = link_cells_create(sim->particles->capacity, &box);
    self->strongest = owner_doubles(self, sim->particles->capacity);
    return self;
}

static void pair_share_free(void *memory)
{
    struct pair_share *const self = memory;

    if (self == NULL) return;
    owner_free(self->cells);
    owner_free(self);
}

static void position(const struct particles *ps, int i, double x[3])
{
    x[0] = ps->x[i];
    x[1] = ps->y[i];
    x[2] = ps->z[i];
}

static void pair_share_sort(struct pair_share *self, const struct particles *ps)
{
    double x[3];

    link_cells_clear(self->cells,
                     particles_widest(ps) + self->attraction->range);
    for (int i = 0; i < ps->n; i++) {
        position(ps, i, x);
        link_cells_add(self->cells, i, x);
    }
}

/* The force [N] between i and j; x [m] from j to i. */
static double pair_share_force(const struct pair_share *self,
                               const struct simulation *sim, int i, int j,
                               const double x[3])
{
    const struct particles *const ps = sim->particles;
    const double R = 0.5 * ps->d[i], S = 0.5 * ps->d[j], r = vector_length(x);
    const double v[3] = {ps->vx[i] - ps->vx[j], ps->vy[i] - ps->vy[j],
                         ps->vz[i] - ps->vz[j]};
    const int *const of = ps->material;

    return fabs(attraction_of_pair(
        self->attraction, of != NULL ? of[i] : 0, of != NULL ? of[j] : 0, R, S,
        r - R - S, -vector_dot(v, x) / r, 1.0 / ps->m[i] + 1.0 / ps->m[j],
        sim->dem->options.step));
}

/* Raises the strongest force of i by those of the walls of the box. */
static void pair_share_add_walls(struct pair_share *self,
                                 const struct simulation *sim, int i)
{
    const struct particles *const ps = sim->particles;
    const double R = 0.5 * ps->d[i], v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    double x[3];

    position(ps, i, x);
    for (int w = 0; w < 6; w++) {
        const double gap = box_domain_gap(&self->cells->box, w, x) - R;
        const double closing = w % 2 ? v[w / 2] : -v[w / 2];
        const double F =
            attraction_of_wall(self->attraction, R, gap, closing,
                               1.0 / ps->m[i], sim->dem->options.step);
        if (self->cells->box.periodic[w / 2]) continue;
        self->strongest[i] = fmax(self->strongest[i], fabs(F));
    }
}

/* Raises the strongest forces of i and of its partners with a larger index. */
static void pair_share_add_partners(struct pair_share *self,
                                    const struct simulation *sim, int i)
{
    const struct particles *const ps = sim->particles;
    int cell[LINK_CELLS_AROUND];
    double x[3], y[3];

    position(ps, i, x);
    const int n = link_cells_around(self->cells, x, cell);
    for (int c = 0; c < n; c++)
        for (int j = self->cells->head[cell[c]]; j >= 0;
             j = self->cells->next[j]) {
            if (j <= i) continue;
            position(ps, j, y);
            for (int k = 0; k < 3; k++)
                y[k] = box_domain_nearest(&self->cells->box, k, x[k] - y[k]);
            const double F = pair_share_force(self, sim, i, j, y);
            self->strongest[i] = fmax(self->strongest[i], F);
            self->strongest[j] = fmax(self->strongest[j], F);
        }
}

/* The hook after a step. */
static void pair_share_after_step(void *memory, struct simulation *sim)
{
    struct pair_share *const self = memory;
    const int n = sim->particles->n;

    if (self == NULL || sim->steps % MEASURED != 1) return;
    memset(self->strongest, 0, (size_t)n * sizeof *self->strongest);
    pair_share_sort(self, sim->particles);
    for (int i = 0; i < n; i++) {
        pair_share_add_walls(self, sim, i);
        pair_share_add_partners(self, sim, i);
    }
    for (int i = 0; i < n; i++) {
        const double f[3] = {self->strongest[i], 0.0, 0.0};
        effects_report(sim, f, 1.0);
    }
}

/* --- lubrication ---------------------------------------------------------- */

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

static const struct attraction_law law = {
    .name = "lubrication", .damping = lubrication_damping, .parcel_power = 1};

static struct attraction
lubrication_attraction(const double *p, const struct attraction_scene *scene)
{
    return (struct attraction){.law = &law,
                               .strength = scene->viscosity,
                               .closest = p[0],
                               .range = p[1]};
}

/* Of what an impact loses so much at most was seen in the mean speed of the
 * grains, by `check --try` in eight suspensions and beds [-]. */
static const double seen = 0.1;

/* A pair that closes with the slip loses ln(z_out/z_min), about 7, times 6 pi
 * mu R*^2/m* of its speed on the way through the gap: all of it at St = rho_s u
 * d/(9 mu) of about 10. Grains that meet less often than the fluid takes them
 * along again, in tau, hardly notice. */
static struct effect_estimate
lubrication_estimate(const struct effect_scales *k)
{
    const double St = k->rho_s * k->slip * k->d / (9.0 * k->mu);
    const int meets = k->numbers != NULL || (k->partners && k->eps_s > 1e-3);
    struct effect_estimate e =
        effects_estimate(0.0, "grains at rest, or far from each other");

    if (!meets || !k->carried || !(St > 0.0)) return e;
    e.share = NAN; /* it is no force that lasts */
    e.loss = fmin(1.0, 10.0 / St);
    e.of = k->numbers != NULL ? "the speed of an impact"
                              : "the speed of the grains";
    snprintf(e.remark, sizeof e.remark,
             "an impact at a Stokes number of %.3g loses %.3g %% of its speed",
             St, 100.0 * e.loss);
    if (k->numbers == NULL) e.loss *= seen * fmin(1.0, k->tau * k->meetings);
    return e;
}

/* The roughness of glass, a thousandth of the diameter; and no further than
 * Cox's law holds. */
static void lubrication_trial(const struct effect_scales *k,
                              char text[EFFECT_TRIAL])
{
    snprintf(text, EFFECT_TRIAL, "{roughness=%g;range=%g;}", 1e-3 * k->d,
             0.1 * k->d);
}

static const struct key lubrication_keys[] = {
    {"effects.lubrication", KEY_GROUP, "", "", KEY_OPTIONAL,
     "lubrication force between close particles and at walls", "Cox67",
     "fluid particles"},
    {"effects.lubrication.roughness", KEY_REAL, "m", "> 0", NULL,
     "gap z_min below which the force grows no further", "", ""},
    {"effects.lubrication.range", KEY_REAL, "m", "> 0", NULL,
     "gap z_out below which it acts", "", ""},
    KEY_END};

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
    .keys = {lubrication_keys},
    .create = pair_share_create,
    .after_step = pair_share_after_step,
    .free = pair_share_free,
    .attraction = lubrication_attraction,
    .wrong = lubrication_wrong,
    .estimate = lubrication_estimate,
    .trial = lubrication_trial,
    .cost = {35.0, 1.0, 81.0},
};

/* --- cohesion ------------------------------------------------------------- */

/* The attractions of dem/cohesion as effects.
 * Chapter "Materials, rolling and cohesion". */

/* They act within the steps of the particles, and while a bed settles. */

/* 1 in a liquid, which has a twentieth of the density of the grains at least:
 * no bridge forms in it, charges leak away, and the attraction of surfaces is a
 * tenth. */
static int is_liquid(const struct effect_scales *k)
{
    return k->rho_f > 0.05 * k->rho_s;
}

/* The force of two that touch, F [N] if the effect is not named: then it has no
 * strength, and F is that of ordinary materials. */
static struct effect_estimate cohesion_touching(const struct effect_scales *k,
                                                double F, const char *remark)
{
    const double l = k->across, R = 0.5 * l * k->d;

    if (k->pair != NULL)
        return effects_estimate(
            fabs(k->pair->law->pair(k->pair, 0, 0, R, R, 0.0)) / (l * l) /
                k->force,
            "of two that touch");
    if (!k->partners || k->eps_s < 1e-3)
        return effects_estimate(0.0, "grains hardly meet");
    return effects_estimate(fabs(F) / k->force, remark);
}

static struct effect_estimate
estimate_electrostatic(const struct effect_scales *k)
{
    const double q = 1e-5 * M_PI * k->d * k->d;
    struct effect_estimate e =
        cohesion_touching(k, electrostatic_force(q, q, 1.0, k->d),
                          "are they charged? this is for 1e-5 C/m^2");

    if (k->pair == NULL && is_liquid(k))
        return effects_estimate(0.0, "charges leak away in a liquid");
    e.unknown = k->pair == NULL && e.share > 0.0;
    return e;
}

static struct effect_estimate
estimate_van_der_waals(const struct effect_scales *k)
{
    return cohesion_touching(
        k, van_der_waals_force(is_liquid(k) ? 1e-20 : 1e-19, 1e-7, 4e-10),
        is_liquid(k) ? "for tips of 0.1 um, Hamaker constant 1e-20 J"
                     : "for tips of 0.1 um, Hamaker constant 1e-19 J");
}

static struct effect_estimate estimate_capillary(const struct effect_scales *k)
{
    struct effect_estimate e =
        cohesion_touching(k, capillary_force(0.072, 0.5 * k->d),
                          "are they wet? this is for bridges of water");

    if (k->pair == NULL && is_liquid(k))
        return effects_estimate(0.0, "no bridge forms in a liquid");
    e.unknown = k->pair == NULL && e.share > 0.0;
    return e;
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
    KEY_END};

const struct effect cohesion_electrostatic = {
    .name = "electrostatic",
    .what = "force between electric charges",
    .equations = "LS 4.13",
    .function = "electrostatic_force",
    .keys = {electrostatic_keys},
    .create = pair_share_create,
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
     KEY_GIVEN(effects_options, van_der_waals),
     .divided = "cohesion is not told to LAMMPS"},
    {"effects.van_der_waals.hamaker", KEY_REAL, "J", "> 0", NULL,
     "Hamaker's constant A", "LS 4.14", ""},
    {"effects.van_der_waals.min_gap", KEY_REAL, "m", "> 0", "4e-10",
     "gap below which the force is constant", "", ""},
    {"effects.van_der_waals.range", KEY_REAL, "m", "> 0", NULL,
     "longest gap between two surfaces at which it acts", "", ""},
    KEY_END};

const struct effect cohesion_van_der_waals = {
    .name = "van_der_waals",
    .what = "van der Waals attraction",
    .equations = "LS 4.14",
    .function = "van_der_waals_force",
    .keys = {van_der_waals_keys},
    .create = pair_share_create,
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
     KEY_GIVEN(effects_options, capillary),
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
    KEY_END};

const struct effect cohesion_capillary = {
    .name = "capillary",
    .what = "attraction by liquid bridges",
    .equations = "LS 4.15",
    .function = "capillary_force",
    .keys = {capillary_keys},
    .create = pair_share_create,
    .after_step = pair_share_after_step,
    .free = pair_share_free,
    .attraction = capillary_of,
    .estimate = estimate_capillary,
    .cost = {30.0, 0.0, 42.0},
};
