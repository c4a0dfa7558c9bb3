/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/history.h"

#include <math.h>

#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/replacement.h"
#include "coupling/processes.h"
#include "dem/clumps.h"
#include "dem/energy.h"
#include "dem/population/population.h"

/* --- sums over particles and faces ---------------------------------------- */

void history_up(const struct simulation *sim, double up[3])
{
    for (int k = 0; k < 3; k++)
        up[k] = sim->mesh->box.periodic[k] ? 0.0 : -sim->gravity[k];
    if (vector_length(up) == 0.0)
        for (int k = 0; k < 3; k++)
            up[k] = -sim->gravity[k];
    const double size = vector_length(up);
    if (size == 0.0) up[1] = 1.0;
    for (int k = 0; k < 3 && size > 0.0; k++)
        up[k] /= size;
}

/* The first patch of this kind, or else the one of this name; a patch at which
 * the fluid enters at a given pressure is an inlet. */
static const struct patch *patch_of(const struct simulation *sim,
                                    enum boundary_kind kind, const char *name)
{
    const struct mesh *const m = sim->fluid->mesh;
    const struct boundary *const b = sim->fluid->options.boundaries;
    int i = 0;

    while (i < m->n_patches &&
           (b[i].enters ? BOUNDARY_INLET : b[i].kind) != kind)
        i++;
    i = -processes_largest(sim, -i); /* the first in any process */
    return i < m->n_patches ? &m->patches[i] : mesh_patch(m, name);
}

static double mean_pressure(const struct simulation *sim, const struct patch *p)
{
    const struct mesh *const m = sim->fluid->mesh;
    double mean = fluid_patch_pressure(sim->fluid, p), part[2] = {0.0, 0.0};

    if (sim->processes == NULL) return mean;
    for (int f = p->first; f < p->first + p->n; f++)
        part[1] += fabs(mesh_S(m, f)[0] + mesh_S(m, f)[1] + mesh_S(m, f)[2]);
    part[0] = mean * part[1];
    processes_sum(sim, 2, part);
    return part[0] / part[1];
}

double history_pressure_drop(const struct simulation *sim)
{
    double up[3];
    history_up(sim, up);
    const int axis = vector_axis(up), turned = up[axis] < 0.0;
    const char *const *const ends = &mesh_sides[2 * axis];
    const struct patch *const in = patch_of(sim, BOUNDARY_INLET, ends[turned]);
    const struct patch *const out =
        patch_of(sim, BOUNDARY_OUTLET, ends[!turned]);

    if (in == NULL || out == NULL) return 0.0;
    return mean_pressure(sim, in) - mean_pressure(sim, out);
}

/* Extent along gravity over the volume: one over the (mean) section. */
static double per_section(const struct simulation *sim, double *g)
{
    const struct mesh *const m = sim->mesh;
    double volume = 1.0, along = 0.0;

    *g = vector_length(sim->gravity);
    for (int k = 0; k < 3; k++) {
        const double length = m->hi[k] - m->lo[k];
        volume *= length;
        along += fabs(sim->gravity[k]) * length;
    }
    if (m->face_centre != NULL) volume = 0.0;
    for (int c = 0; c < m->n_cells && m->face_centre != NULL; c++)
        volume += m->V[c];
    return *g > 0.0 ? along / (*g * volume) : 0.0;
}

double history_bed_weight(const struct simulation *sim)
{
    double g, mass = 0.0;
    const double section = per_section(sim, &g);

    for (int i = 0; i < sim->particles->n; i++)
        mass += sim->particles->m[i];
    return processes_total(sim, mass) * g * section;
}

double history_buoyant_weight(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double g, volume = 0.0;
    const double section = per_section(sim, &g);

    for (int i = 0; i < ps->n; i++)
        volume += particles_volume(ps, i);
    return history_bed_weight(sim) -
           sim->fluid->options.rho * processes_total(sim, volume) * g * section;
}

/* Kinetic energy of the particles, or of their spin, with I = (2/5) m R^2 =
 * m d^2 / 10 [J]. */
static double energy(const struct simulation *sim, int of_spin)
{
    const struct particles *const ps = sim->particles;
    const double *const u = of_spin ? ps->wx : ps->vx,
                        *const v = of_spin ? ps->wy : ps->vy,
                        *const w = of_spin ? ps->wz : ps->vz;
    double moving, turning;

    clumps_energy(ps->clumps, &moving, &turning);
    double sum = 2.0 * (of_spin ? turning : moving);
    for (int i = 0; i < ps->n; i++) {
        const double m =
            of_spin ? 0.1 * ps->m[i] * ps->d[i] * ps->d[i] : ps->m[i];
        if (!clumps_own(ps, i))
            sum += m * (u[i] * u[i] + v[i] * v[i] + w[i] * w[i]);
    }
    return 0.5 * processes_total(sim, sum);
}

/* The number of particles of all processes. */
static double history_sums_count(const struct simulation *sim)
{
    return processes_total(sim, sim->particles->n);
}

/* The grains that they stand for; the balls of a clump are one. */
static double history_sums_grains(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        if (!clumps_own(ps, i) ||
            ps->clumps->item[ps->clumps->of[ps->id[i]]].first == ps->id[i])
            sum += particles_grains(ps, i);
    return sum;
}

/* A third of the mean square of their velocity about its mean [m^2/s^2]. */
static double granular_temperature(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};
    const double n = history_sums_count(sim);
    double sum = 0.0;

    if (n == 0.0) return 0.0;
    for (int k = 0; k < 3; k++) {
        double mean = 0.0;
        for (int i = 0; i < ps->n; i++)
            mean += v[k][i] / n;
        mean = processes_total(sim, mean);
        for (int i = 0; i < ps->n; i++)
            sum += (v[k][i] - mean) * (v[k][i] - mean);
    }
    return processes_total(sim, sum) / (3.0 * n);
}

/* The mean coordinate upwards [m]. */
static double mean_height(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const double n = history_sums_count(sim);
    double sum = 0.0, up[3];

    history_up(sim, up);
    for (int i = 0; i < ps->n; i++)
        sum += (up[0] * ps->x[i] + up[1] * ps->y[i] + up[2] * ps->z[i]) / n;
    return processes_total(sim, sum);
}

/* Mean of their velocity along gravity [m/s]; 0 without gravity. */
static double mean_fall(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const double *const g = sim->gravity;
    const double size = vector_length(g), n = history_sums_count(sim);
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->vx[i] * g[0] + ps->vy[i] * g[1] + ps->vz[i] * g[2];
    sum = processes_total(sim, sum);
    return size > 0.0 && n > 0.0 ? sum / (size * n) : 0.0;
}

/* Component k of a sum over all [N s]. */
static double component(const struct simulation *sim, int k,
                        void (*sum_of)(const struct simulation *, double[3]))
{
    double sum[3];

    sum_of(sim, sum);
    return sum[k];
}

static double shortest_time(const struct simulation *sim)
{
    const double t = sim->coupling->report.shortest_time;
    return t < HUGE_VAL ? t : 0.0; /* no particle has one */
}

/* --- the columns ---------------------------------------------------------- */

enum {
    F = HISTORY_FLUID,
    P = HISTORY_PARTICLES,
    C = HISTORY_COUPLING,
    D = HISTORY_MEAN_GRADIENT,
    N = HISTORY_PARTS,
    I = HISTORY_POPULATION,
    E = HISTORY_BUDGET,
    G = HISTORY_PARCELS,
    K = HISTORY_GRAINS
};

/* history.def has a line a column, in the order of the row: it makes a function
 * of each, called by its line, and then the table of them. */
#define COLUMN_AT(line) column_##line
#define COLUMN_OF(line) COLUMN_AT(line)
#define COLUMN(needs, title, what, value)                                      \
    HISTORY_VALUE(COLUMN_OF(__LINE__), value)
#include "record/history.def"
#undef COLUMN
#define COLUMN(needs, title, what, value)                                      \
    {title, COLUMN_OF(__LINE__), needs, what},
const struct history_column history_columns[] = {
#include "record/history.def"
    {NULL, NULL, 0, NULL}};

/* 1 if the pressure has a mean gradient, given or adapted. */
static int is_driven(const struct fluid *fl)
{
    for (int k = 0; k < 3 && fl != NULL; k++)
        if (fl->options.mean_gradient[k] != 0.0 || fl->options.keeps_flow[k])
            return 1;
    return 0;
}

int history_applies(const struct history_column *c,
                    const struct simulation *sim)
{
    return (!(c->needs & F) || sim->fluid != NULL) &&
           (!(c->needs & D) || is_driven(sim->fluid)) &&
           (!(c->needs & N) ||
            (sim->fluid != NULL && sim->fluid->options.cfl > 0.0)) &&
           (!(c->needs & P) || sim->particles != NULL) &&
           (!(c->needs & C) || sim->coupling != NULL) &&
           (!(c->needs & I) || sim->population != NULL) &&
           (!(c->needs & G) ||
            (sim->particles != NULL && sim->particles->across != NULL)) &&
           (!(c->needs & K) ||
            (sim->particles != NULL && (sim->particles->across != NULL ||
                                        sim->particles->clumps != NULL))) &&
           (!(c->needs & E) ||
            (sim->dem != NULL && dem_energy(sim->dem) != NULL));
}
