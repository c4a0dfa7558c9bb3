/* SPDX-License-Identifier: GPL-3.0-or-later */
/* collisions.c -- what collisions do besides pushing particles apart, where a
 * stress stands for them (particle_stress.c): they lose energy, and make the
 * fluctuations alike in all directions.
 * Chapter "Fewer or other particles".
 *
 * With the mean velocity u of a cell and x = dt r / (1 + dt r), r the rate,
 * damping changes the velocity v of a particle by
 *
 *   gather(x u) - v gather(x)                                    [ORourke10]
 *
 * Gathering is the adjoint of spreading: momentum is kept to rounding, and the
 * energy changes by -sum x (v - u)^2 and less. Isotropy draws the velocity of a
 * particle with the probability x anew from the normal distribution of its
 * cell; then all in the cell are shifted and scaled to its momentum and energy
 * [ORourke12]. */
#include "coupling/effects/forces.h"

#include <gsl/gsl_math.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "averaging/hats.h"
#include "base/alloc.h"
#include "base/number.h"
#include "base/statistics.h"
#include "base/vector.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "coupling/simulation.h"

double collision_damping_rate(double e, double eps_per_d, double g_0,
                              double Theta)
{
    return (1.0 - e * e) * 4.0 / sqrt(M_PI) * eps_per_d * g_0 * sqrt(Theta);
}

double collision_isotropy_rate(double eps_per_d, double g_0, double Theta)
{
    return 96.0 / (5.0 * sqrt(M_PI)) * eps_per_d * g_0 * sqrt(Theta);
}

struct collisions {
    double e; /* [-] restitution of the damping */
    unsigned long seed;
    double *moments; /* 6 a cell */
    double *field;   /* of the damping 4 a cell: x u, x */
    double *q;       /* 6 a particle */
    struct cell_sums {
        double m, p[3], e; /* [kg], [kg m/s], [kg m^2/s^2] */
    } * before, *after;    /* of the isotropy */
};

static void *collisions_create(struct simulation *sim, const double *parameters)
{
    struct collisions *const self = owner_create(sizeof *self);
    const int cells = sim->mesh->n_cells;

    self->e = parameters[0];
    self->seed = (unsigned long)number_clamped(parameters[0], 0, INT_MAX);
    self->moments = owner_doubles(self, HATS_MOMENTS * cells);
    self->field = owner_doubles(self, 4 * cells);
    self->q = owner_doubles(self, HATS_MOMENTS * sim->particles->capacity);
    self->before = owner_zeroed(self, (size_t)cells, sizeof *self->before);
    self->after = owner_zeroed(self, (size_t)cells, sizeof *self->after);
    return self;
}

/* g_0 = eps_cp / (eps_cp - eps_s) [ORourke10], at most 1000. */
static double collisions_g_0(double packing, double eps_s)
{
    return packing / fmax(packing - eps_s, 1e-3 * packing);
}

/* dv [m/s] of particle i in a step, as a force. */
static void collisions_report(struct simulation *sim, int i, const double dv[3])
{
    const double per_dt = sim->particles->m[i] / sim->dt;
    const double F[3] = {per_dt * dv[0], per_dt * dv[1], per_dt * dv[2]};

    sim->particles->vx[i] += dv[0];
    sim->particles->vy[i] += dv[1];
    sim->particles->vz[i] += dv[2];
    effects_report(sim, F, 1.0);
}

/* --- collision damping ---------------------------------------------------- */

static void collision_damping_step(void *memory, struct simulation *sim)
{
    struct collisions *const self = memory;
    const struct particles *const ps = sim->particles;
    double packing;
    const struct hats *const h = particle_stress_places(sim, &packing);

    hats_moments(h, ps, self->q, self->moments);
    for (int c = 0; c < sim->mesh->n_cells; c++) {
        const double *const of = &self->moments[HATS_MOMENTS * c];
        const double r = collision_damping_rate(self->e, of[5],
                                                collisions_g_0(packing, of[0]),
                                                hats_temperature(of));
        const double x = sim->dt * r / (1.0 + sim->dt * r);
        for (int k = 0; k < 3; k++)
            self->field[4 * c + k] = of[0] > 0.0 ? x * of[1 + k] / of[0] : 0.0;
        self->field[4 * c + 3] = x;
    }
    hats_gather(h, 4, self->field, self->q);
    for (int i = 0; i < ps->n; i++) {
        const double *const g = &self->q[4 * i];
        const double dv[3] = {g[0] - g[3] * ps->vx[i], g[1] - g[3] * ps->vy[i],
                              g[2] - g[3] * ps->vz[i]};
        collisions_report(sim, i, dv);
    }
}

static const struct key damping_keys[] = {
    {"effects.collision_damping", KEY_GROUP, "", "", KEY_OPTIONAL,
     "the energy that collisions lose, where a stress stands for them",
     "ORourke10, Haff83", "effects.particle_stress",
     .divided = "the stress is one system of all cells"},
    {"effects.collision_damping.restitution", KEY_REAL, "-", ">= 0, <= 1", NULL,
     "coefficient of restitution e of the grains", "ORourke10", ""},
    KEY_END};

const struct effect collision_damping_effect = {
    .name = "collision_damping",
    .what = "loss of energy by collisions that are not computed",
    .equations = "ORourke10, Haff83",
    .function = "collision_damping_step",
    .keys = {damping_keys},
    .create = collisions_create,
    .before_particles = collision_damping_step,
};

/* --- collision isotropy --------------------------------------------------- */

static int collisions_cell(const struct hats *h, int i)
{
    const int *const n = h->mesh->box.n, *const at = &h->cell[3 * i];
    return at[0] + n[0] * (at[1] + n[1] * at[2]);
}

/* Mass, momentum and energy of the particles in each cell. */
static void collisions_sum(const struct hats *h, const struct particles *ps,
                           struct cell_sums *sums)
{
    memset(sums, 0, (size_t)h->mesh->n_cells * sizeof *sums);
    for (int i = 0; i < ps->n; i++) {
        struct cell_sums *const of = &sums[collisions_cell(h, i)];
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        of->m += ps->m[i];
        of->e += ps->m[i] * vector_dot(v, v);
        vector_along(of->p, ps->m[i], v, of->p);
    }
}

/* Of the fluctuations [kg m^2/s^2]. */
static double collisions_energy(const struct cell_sums *of)
{
    return fmax(0.0, of->e - vector_dot(of->p, of->p) / of->m);
}

static void collisions_draw(const struct collisions *self,
                            const struct simulation *sim, const struct hats *h,
                            double packing)
{
    struct particles *const ps = sim->particles;
    double *const v[3] = {ps->vx, ps->vy, ps->vz};

    for (int i = 0; i < ps->n; i++) {
        const int c = collisions_cell(h, i);
        const double *const of = &self->moments[HATS_MOMENTS * c];
        const struct cell_sums *const now = &self->before[c];
        const double x = sim->dt * collision_isotropy_rate(
                                       of[5], collisions_g_0(packing, of[0]),
                                       hats_temperature(of));
        const double sigma = sqrt(collisions_energy(now) / (3.0 * now->m));
        if (random_uniform(self->seed, ps->id[i], sim->steps, 0) >=
            x / (1.0 + x))
            continue;
        for (int k = 0; k < 3; k++)
            v[k][i] =
                now->p[k] / now->m +
                sigma * random_normal(self->seed, ps->id[i], sim->steps, k + 1);
    }
}

static void collision_isotropy_step(void *memory, struct simulation *sim)
{
    struct collisions *const self = memory;
    struct particles *const ps = sim->particles;
    double *const v[3] = {ps->vx, ps->vy, ps->vz};
    double packing;
    const struct hats *const h = particle_stress_places(sim, &packing);

    hats_moments(h, ps, self->q, self->moments);
    collisions_sum(h, ps, self->before);
    collisions_draw(self, sim, h, packing);
    collisions_sum(h, ps, self->after);
    for (int i = 0; i < ps->n; i++) {
        const int c = collisions_cell(h, i);
        const struct cell_sums *const was = &self->before[c];
        const struct cell_sums *const is = &self->after[c];
        const double E = collisions_energy(is);
        const double s = E > 0.0 ? sqrt(collisions_energy(was) / E) : 1.0;
        for (int k = 0; k < 3; k++)
            v[k][i] = was->p[k] / was->m + s * (v[k][i] - is->p[k] / is->m);
    }
}

static const struct key isotropy_keys[] = {
    {"effects.collision_isotropy", KEY_GROUP, "", "", KEY_OPTIONAL,
     "collisions make the fluctuations alike in all directions, where a stress "
     "stands for them",
     "ORourke12", "effects.particle_stress",
     .divided = "the stress is one system of all cells"},
    {"effects.collision_isotropy.seed", KEY_INT, "-", ">= 0", "1",
     "seed of the random numbers; the same seed gives the same run", "", ""},
    KEY_END};

const struct effect collision_isotropy_effect = {
    .name = "collision_isotropy",
    .what = "collisions that are not computed make fluctuations isotropic",
    .equations = "ORourke12",
    .function = "collision_isotropy_step",
    .keys = {isotropy_keys},
    .create = collisions_create,
    .before_particles = collision_isotropy_step,
};
