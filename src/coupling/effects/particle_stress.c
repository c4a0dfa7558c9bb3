/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_stress.c -- a stress on the mesh in the place of contacts.
 * Chapter "Fewer or other particles".
 *
 * The particles move through each other with all other forces. Then the stress
 * tau of where they are puts them back [Snider01],
 *
 *   eps(tau) - div((dt^2 / rho) grad tau) = eps* - max(0, eps^n - eps_cp),
 *
 * without flux through walls; eps* and eps^n are spread from the particles,
 * after and before they have moved. It is implicit in tau: under a weight waves
 * of tau run as fast as tau / sqrt(rho P eps^beta), and eps(tau) stays below
 * eps_cp whatever tau is. The force -(tau_n - tau_c) S_f of face f between
 * cells c and n goes to the particles between the centres of the two, as
 *
 *   a_f = -(tau_n - tau_c) S_f / (rho (eps_c V_c + eps_n V_n) / 2).
 *
 * That is where the shares of c and n change as a particle moves: its work is
 * what the stress has lost or gained, and a closed gas does not heat. The
 * particles there have not just the volume of the bracket; what they leave of
 * the force, or take too much, goes to all of c and n alike. So momentum is
 * kept to rounding, whatever eps is. Places follow a_f, linear between the
 * faces of a cell, so that each cell gains what the equation says. What was
 * above eps_cp before the step moves places only: else it would become energy.
 */
#include "coupling/effects/forces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/hats.h"
#include "base/alloc.h"
#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "coupling/simulation.h"
#include "dem/box_domain.h"
#include "dem/dem.h"
#include "linear/solvers.h"

/* --- the effect ----------------------------------------------------------- */

struct particle_stress {
    struct particle_stress_law law;
    double least; /* [Pa] P_s; of lun the least P */
    double rho;   /* [kg/m^3] of the particles */
    double stiff; /* [Pa/m^2] rho / dt^2 */
    struct preconditioned matrix;
    struct cg_work *cg;
    double heaviest;           /* [m] on the diagonal: of a thin cell */
    double *g;                 /* [m] S.S / S.d of each inner face */
    double *P;                 /* [Pa] of the law in each cell */
    double *tau, *shift;       /* [Pa] of velocities, and of places */
    double *before, *eps;      /* [-] eps^n and eps* */
    double *wanted, *fraction; /* [-] right-hand side, and eps(tau) */
    double *rhs, *sums, *change;
    double *face; /* [m/s^2] a_f of the six sides of a cell */
    double *half; /* [m^3] of particles in the six halves of a cell */
    double *a;    /* [m/s^2] 3 a cell: of what is left of the forces */
    double *q;    /* 6 a particle */
    struct hats *hats;
    int n_cells;
    long solves, iterations, crowded; /* [-] so far */
    int failed;                       /* [-] 1: a tau was not found */
};

static void *particle_stress_create(struct simulation *sim,
                                    const double *parameters)
{
    const struct mesh *const m = sim->mesh;
    const struct particles *const ps = sim->particles;
    struct particle_stress *const self = owner_create(sizeof *self);
    double **const narrow[] = {&self->P,       &self->tau,  &self->shift,
                               &self->before,  &self->eps,  &self->wanted,
                               &self->rhs,     &self->sums, &self->change,
                               &self->fraction};

    self->law = (struct particle_stress_law){
        .lun = parameters[0] != 0.0,
        .exponent = parameters[2],
        .packing = parameters[3],
        .e = dem_created_with(sim->dem)->material.restitution};
    self->n_cells = m->n_cells;
    self->least = parameters[1];
    for (int k = 0; k < (int)(sizeof narrow / sizeof *narrow); k++)
        *narrow[k] = owner_doubles(self, m->n_cells);
    self->a = owner_doubles(self, 3 * m->n_cells);
    self->face = owner_doubles(self, 6 * m->n_cells);
    self->half = owner_doubles(self, 6 * m->n_cells);
    self->g = owner_doubles(self, m->n_internal);
    self->q = owner_doubles(self, HATS_MOMENTS * ps->capacity);
    self->hats = owner_join(self, hats_create(m, ps->capacity));
    self->heaviest = 1e6 * cbrt(m->V[0]);
    for (int f = 0; f < m->n_internal; f++) {
        self->g[f] = vector_dot(mesh_S(m, f), mesh_S(m, f)) /
                     vector_dot(mesh_S(m, f), mesh_d(m, f));
        self->heaviest = fmax(self->heaviest, 1e6 * self->g[f]);
    }
    double *const link = mesh_links(m);
    self->matrix = preconditioned_create(m->n_cells, m->n_internal, m->owner,
                                         m->neighbour, self->g, link, m->V);
    free(link);
    owner_join(self, self->matrix.matrix);
    self->cg = owner_join(self, cg_work_create(m->n_cells));
    return self;
}

/* The solids fraction of the particles where they are now. */
static void particle_stress_spread(struct particle_stress *self,
                                   const struct simulation *sim, double *eps)
{
    for (int i = 0; i < sim->particles->n; i++)
        self->q[i] = particles_volume(sim->particles, i);
    hats_find(self->hats, sim->particles);
    hats_spread(self->hats, 1, self->q, eps);
}

static void particle_stress_before(void *memory, struct simulation *sim)
{
    struct particle_stress *const self = memory;

    particle_stress_spread(self, sim, self->before);
    if (sim->particles->n == 0) return;
    self->rho = sim->particles->m[0] / particles_volume(sim->particles, 0);
    self->stiff = self->rho / (sim->dt * sim->dt);
    if (self->law.lun)
        hats_moments(self->hats, sim->particles, self->q, self->face);
    for (int c = 0; c < self->n_cells; c++)
        self->P[c] =
            self->law.lun
                ? fmax(self->least,
                       self->rho * hats_temperature(&self->face[6 * c]))
                : self->least;
}

const struct hats *particle_stress_places(const struct simulation *sim,
                                          double *packing)
{
    const struct particle_stress *const self =
        effects_memory(sim, &particle_stress_effect);

    *packing = self->law.packing;
    return self->hats;
}

/* --- tau ------------------------------------------------------------------ */

/* Sets eps(tau), what is missing to `wanted` times V rho / dt^2 [Pa m], and the
 * diagonal V rho / (dt^2 tau') [m], which in a thin cell is not more than what
 * the others do not feel; returns the most [-] that is missing in a cell. */
static double particle_stress_missing(struct particle_stress *self,
                                      const struct mesh *m, const double *tau)
{
    const double stiff = self->stiff;
    double most = 0.0;

#pragma omp parallel for schedule(static)
    for (int c = 0; c < m->n_cells; c++) {
        const double eps =
            particle_stress_fraction(&self->law, self->P[c], tau[c]);
        self->fraction[c] = eps;
        self->sums[c] = fmin(
            self->heaviest,
            stiff * m->V[c] /
                particle_stress_slope(&self->law, self->P[c], fmax(eps, 1e-9)));
        self->rhs[c] = stiff * m->V[c] * (self->wanted[c] - eps);
    }
    for (int f = 0; f < m->n_internal; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        const double out = self->g[f] * (tau[o] - tau[n]);
        self->rhs[o] -= out;
        self->rhs[n] += out;
    }
    for (int c = 0; c < m->n_cells; c++) {
        const double of = fabs(self->rhs[c]) / m->V[c];
        if (of > most || isnan(of)) most = of;
    }
    return most / stiff;
}

/* Upward in tau, downward in eps: neither overshoots. */
static void particle_stress_update(struct particle_stress *self,
                                   const struct mesh *m, double *tau)
{
    for (int c = 0; c < m->n_cells; c++) {
        const double eps = self->fraction[c], change = self->change[c];
        const double by = change * self->sums[c] / (self->stiff * m->V[c]);
        if (change > 0.0 && self->sums[c] < self->heaviest)
            tau[c] += change;
        else
            tau[c] = particle_stress(&self->law, self->P[c],
                                     fmax(eps + by, 1e-3 * eps));
    }
}

/* Solves for tau [Pa] by Newton's method, from the last one. */
static void particle_stress_solve(struct particle_stress *self,
                                  const struct simulation *sim, double *tau)
{
    static const double enough = 1e-8; /* [-] of eps */
    enum { MOST = 60 };
    const struct mesh *const m = sim->mesh;
    const double absolute = 0.1 * enough * self->stiff * m->V[0];

    for (int c = 0; c < m->n_cells; c++) /* the first time */
        if (tau[c] <= 0.0)
            tau[c] = particle_stress(&self->law, self->P[c],
                                     fmin(fmax(self->wanted[c], enough),
                                          self->law.packing * (1.0 - enough)));
    int k = 0;
    for (; k < MOST; k++, self->iterations++) {
        if (particle_stress_missing(self, m, tau) < enough) break;
        memset(self->change, 0, (size_t)m->n_cells * sizeof *self->change);
        preconditioned_set(self->matrix, self->g, self->sums);
        cg_solve(self->matrix, self->rhs, self->change, 1e-4, absolute, 500,
                 self->cg);
        particle_stress_update(self, m, tau);
    }
    self->solves++;
    self->failed |= k == MOST;
}

/* --- velocities and places ------------------------------------------------ */

/* a_f at the sides of cell c, lower and upper along x, y, z; at a wall that of
 * the other side. And of what the particles between the centres leave, the
 * acceleration of the cells. */
static void particle_stress_sides(const struct particle_stress *self,
                                  const struct mesh *m, const double *tau,
                                  int c, double side[6], double left[3])
{
    int wall[6] = {0};

    memset(side, 0, 6 * sizeof *side);
    memset(left, 0, 3 * sizeof *left);
    for (int j = m->cell_start[c]; j < m->cell_start[c + 1]; j++) {
        const int f = m->cell_face[j], o = m->owner[f];
        const double *const S = mesh_S(m, f);
        const int k = S[0] != 0.0 ? 0 : S[1] != 0.0 ? 1 : 2;
        const int w = 2 * k + (m->out[j] * S[k] > 0.0);
        wall[w] = f >= m->n_internal;
        if (wall[w]) continue;
        const int n = m->neighbour[f], beside = o == c ? n : o;
        const double V = self->eps[o] * m->V[o] + self->eps[n] * m->V[n];
        if (V <= 0.0) continue;
        side[w] = -2.0 * (tau[n] - tau[o]) * S[k] / (self->rho * V);
        left[k] +=
            side[w] *
            (0.5 -
             (self->half[6 * c + w] + self->half[6 * beside + (w ^ 1)]) / V);
    }
    for (int w = 0; w < 6; w++)
        if (wall[w]) side[w] = side[w ^ 1];
}

/* Between two cells without particles no force would find one: there is no
 * stress in them, and each tau acts twice, with opposite signs. */
static void particle_stress_accelerate(struct particle_stress *self,
                                       const struct mesh *m, double *tau)
{
    for (int c = 0; c < m->n_cells; c++)
        if (self->eps[c] <= 0.0) tau[c] = 0.0;
#pragma omp parallel for schedule(static)
    for (int c = 0; c < m->n_cells; c++)
        particle_stress_sides(self, m, tau, c, &self->face[6 * c],
                              &self->a[3 * c]);
}

static void particle_stress_push(struct particle_stress *self,
                                 struct simulation *sim)
{
    struct particles *const ps = sim->particles;
    const double dt = sim->dt;

    hats_gather(self->hats, 3, self->a, self->q);
    hats_add_halves(self->hats, self->face, self->q);
    for (int i = 0; i < ps->n; i++) {
        const double *const a = &self->q[3 * i], m = ps->m[i];
        const double F[3] = {m * a[0], m * a[1], m * a[2]};
        ps->vx[i] += dt * a[0];
        ps->vy[i] += dt * a[1];
        ps->vz[i] += dt * a[2];
        effects_report(sim, F, 1.0);
    }
}

/* Between the sides of its cell, along k, where particle i is. */
static double particle_stress_between(const struct particle_stress *self, int i,
                                      int k)
{
    const struct hats *const h = self->hats;
    const int *const n = h->mesh->box.n, *const at = &h->cell[3 * i];
    const int c = at[0] + n[0] * (at[1] + n[1] * at[2]);
    const double s = h->place[3 * i + k];

    return (1.0 - s) * self->face[6 * c + 2 * k] +
           s * self->face[6 * c + 2 * k + 1];
}

/* A wall holds what is pushed against it. */
static double particle_stress_place(const struct box_domain *box, int k,
                                    double x, double by, double R)
{
    if (box->periodic[k]) return box_domain_inside(box, k, x + by);
    return by < 0.0 ? fmax(x + by, fmin(x, box->lo[k] + R))
                    : fmin(x + by, fmax(x, box->hi[k] - R));
}

static void particle_stress_shift(const struct particle_stress *self,
                                  struct simulation *sim)
{
    const struct dem_options *const o = dem_created_with(sim->dem);
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    struct particles *const ps = sim->particles;
    double *const x[3] = {ps->x, ps->y, ps->z};

#pragma omp parallel for schedule(static)
    for (int i = 0; i < ps->n; i++)
        for (int k = 0; k < 3; k++) {
            const double a = particle_stress_between(self, i, k);
            x[k][i] = particle_stress_place(
                &box, k, x[k][i], sim->dt * sim->dt * a, 0.5 * ps->d[i]);
            if (sim->coupling != NULL) /* that the fluid sees */
                sim->coupling->u_mean[3 * i + k] += sim->dt * a;
        }
    dem_changed(sim->dem);
}

static void particle_stress_after(void *memory, struct simulation *sim)
{
    struct particle_stress *const self = memory;
    const struct mesh *const m = sim->mesh;
    int crowded = 0;

    if (sim->particles->n == 0) return;
    particle_stress_spread(self, sim, self->eps);
    hats_spread_halves(self->hats, self->q, self->half);
    for (int c = 0; c < m->n_cells; c++) {
        const double over = fmax(0.0, self->before[c] - self->law.packing);
        self->wanted[c] = fmax(0.0, self->eps[c] - over);
        crowded |= over > 0.0;
    }
    particle_stress_solve(self, sim, self->tau);
    particle_stress_accelerate(self, m, self->tau);
    particle_stress_push(self, sim);
    if (crowded) {
        memcpy(self->shift, self->tau, (size_t)m->n_cells * sizeof(double));
        for (int c = 0; c < m->n_cells; c++)
            self->wanted[c] = fmax(0.0, self->eps[c]);
        particle_stress_solve(self, sim, self->shift);
        particle_stress_accelerate(self, m, self->shift);
        self->crowded++;
    }
    particle_stress_shift(self, sim);
}

static const char *particle_stress_failure(const void *memory)
{
    const struct particle_stress *const self = memory;

    return self->failed
               ? "effects.particle_stress was not found in 60 iterations of "
                 "Newton's method; try a smaller step, or a packing and a "
                 "pressure of effects.particle_stress that carry the bed:"
               : NULL;
}

/* --- what a case sees ----------------------------------------------------- */

static int particle_stress_fields(const void *memory, struct effect_field *f)
{
    const struct particle_stress *const self = memory;

    f[0] = (struct effect_field){"solids_stress", 1, self->tau};
    return 1;
}

static int particle_stress_counts(const void *memory, struct effect_count *c)
{
    const struct particle_stress *const self = memory;

    c[0] = (struct effect_count){"particle_stress_solves", self->solves};
    c[1] =
        (struct effect_count){"particle_stress_iterations", self->iterations};
    c[2] = (struct effect_count){"particle_stress_crowded", self->crowded};
    return 3;
}

/* The largest solids fraction and stress of a cell. */
static int particle_stress_row(void *memory, const struct simulation *sim,
                               double *values)
{
    struct particle_stress *const self = memory;

    particle_stress_spread(self, sim, self->wanted);
    values[0] = values[1] = 0.0;
    for (int c = 0; c < self->n_cells; c++) {
        values[0] = fmax(values[0], self->wanted[c]);
        values[1] = fmax(values[1], self->tau[c]);
    }
    return 2;
}

static const char *const particle_stress_names[] = {
    "solids_highest [-]", "solids_stress_highest [Pa]", NULL};

static const struct effect_columns particle_stress_columns = {
    particle_stress_names, particle_stress_row};

/* tau is where Newton's method begins. */
static void particle_stress_state(void *memory, struct state *s)
{
    struct particle_stress *const self = memory;

    state_long(s, "solves", "-", &self->solves);
    state_long(s, "iterations", "-", &self->iterations);
    state_long(s, "crowded", "-", &self->crowded);
    state_reals(s, "tau", "Pa", self->tau, self->n_cells, 1);
}

static const struct model stress_of_harris_crighton = {.name =
                                                           "harris-crighton",
                                                       .value = 0},
                          stress_of_lun = {.name = "lun", .value = 1};
static const struct model *const stress_laws[] = {&stress_of_harris_crighton,
                                                  &stress_of_lun, NULL};

static const struct key particle_stress_keys[] = {
    {"effects.particle_stress", KEY_GROUP, "", "", KEY_OPTIONAL,
     "a stress on the mesh in the place of contacts, with particles.list = "
     "\"none\"",
     "Snider01", "particles", KEY_GIVEN(effects_options, particle_stress),
     .divided = "the stress is one system of all cells"},
    {"effects.particle_stress.law", KEY_NAME, "", "harris-crighton | lun",
     "harris-crighton",
     "the stress of the solids fraction, and with lun of the fluctuations",
     "Snider01, Lun84", "", .choices = stress_laws},
    {"effects.particle_stress.pressure", KEY_REAL, "Pa", "> 0", NULL,
     "P_s; with lun the least density times mean square fluctuation",
     "Snider01", ""},
    {"effects.particle_stress.exponent", KEY_REAL, "-", ">= 1, <= 10", "2.0",
     "beta of harris-crighton", "Snider01", ""},
    {"effects.particle_stress.packing", KEY_REAL, "-", "> 0, < 1", "0.6",
     "solids fraction eps_cp of the densest packing", "Snider01", ""},
    KEY_END};

/* Its cost is that of pairs of runs with it and without, of Goldschmidt's and
 * Mueller's beds, the least of three each. A step has 1.4 to 1.8 iterations of
 * Newton's method in the one and 3.6 to 17 in the other, the more the narrower
 * the cells, and no case tells how many: check says up to 1.6 times what the
 * first takes, and half of what cells a third as wide take. */
const struct effect particle_stress_effect = {
    .name = "particle_stress",
    .what = "a stress of the solids in the place of contacts",
    .equations = "Snider01",
    .function = "particle_stress_solve",
    .keys = {particle_stress_keys},
    .create = particle_stress_create,
    .before_particles = particle_stress_before,
    .after_particles = particle_stress_after,
    .failure = particle_stress_failure,
    .fields = particle_stress_fields,
    .columns = &particle_stress_columns,
    .counts = particle_stress_counts,
    .state = particle_stress_state,
    .free = owner_free,
    .cost = {200.0, 2600.0, 0.0},
};
