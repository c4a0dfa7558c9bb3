/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/history_sums.h"

#include <math.h>

#include "base/vector.h"
#include "coupling/processes.h"

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
        part[1] += fabs(m->S[3 * f] + m->S[3 * f + 1] + m->S[3 * f + 2]);
    part[0] = mean * part[1];
    processes_sum(sim, 2, part);
    return part[0] / part[1];
}

double history_pressure_drop(const struct simulation *sim)
{
    const struct patch *const in = patch_of(sim, BOUNDARY_INLET, "bottom");
    const struct patch *const out = patch_of(sim, BOUNDARY_OUTLET, "top");

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

double history_particle_energy(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->m[i] * (ps->vx[i] * ps->vx[i] + ps->vy[i] * ps->vy[i] +
                           ps->vz[i] * ps->vz[i]);
    return 0.5 * processes_total(sim, sum);
}

/* I = (2/5) m R^2 = m d^2 / 10. */
double history_spin_energy(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += 0.1 * ps->m[i] * ps->d[i] * ps->d[i] *
               (ps->wx[i] * ps->wx[i] + ps->wy[i] * ps->wy[i] +
                ps->wz[i] * ps->wz[i]);
    return 0.5 * processes_total(sim, sum);
}

/* The number of particles of all processes. */
static double history_sums_count(const struct simulation *sim)
{
    return processes_total(sim, sim->particles->n);
}

/* A third of their mean square about the mean. */
double history_granular_temperature(const struct simulation *sim)
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

/* Upwards: against gravity, of which a part along a period, where nothing is
 * high or low, does not count beside another part; without gravity y. */
static void find_up(const struct simulation *sim, double up[3])
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

double history_mean_height(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const double n = history_sums_count(sim);
    double sum = 0.0, up[3];

    find_up(sim, up);
    for (int i = 0; i < ps->n; i++)
        sum += (up[0] * ps->x[i] + up[1] * ps->y[i] + up[2] * ps->z[i]) / n;
    return processes_total(sim, sum);
}

/* The mean fall velocity, that of a single sphere. */
double history_mean_fall(const struct simulation *sim)
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
