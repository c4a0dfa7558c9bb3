/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/history.h"

#include <math.h>

#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/replacement.h"
#include "coupling/processes.h"
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
        part[1] += fabs(m->S[3 * f] + m->S[3 * f + 1] + m->S[3 * f + 2]);
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

/* Kinetic energy of the particles [J]. */
static double particle_energy(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->m[i] * (ps->vx[i] * ps->vx[i] + ps->vy[i] * ps->vy[i] +
                           ps->vz[i] * ps->vz[i]);
    return 0.5 * processes_total(sim, sum);
}

/* I = (2/5) m R^2 = m d^2 / 10. */
static double spin_energy(const struct simulation *sim)
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

/* --- physics -------------------------------------------------------------- */

/* Component k of a sum over all [N s]. */
static double component(const struct simulation *sim, int k,
                        void (*sum_of)(const struct simulation *, double[3]))
{
    double sum[3];

    sum_of(sim, sum);
    return sum[k];
}

HISTORY_VALUE(now, sim->t)
HISTORY_VALUE(inlet_velocity, fluid_inlet_velocity(sim->fluid))
HISTORY_VALUE(fluid_energy,
              processes_total(sim, fluid_kinetic_energy(sim->fluid)))
HISTORY_VECTOR(momentum, component(sim, k, coupling_total_momentum))
HISTORY_VECTOR(unpaid, component(sim, k, coupling_unpaid_impulse))

/* --- insertion and removal ------------------------------------------------ */

HISTORY_VALUE(particles, sim->particles->n)
HISTORY_VALUE(inserted, (double)sim->population->totals.inserted)
HISTORY_VALUE(removed, (double)sim->population->totals.removed)
HISTORY_VALUE(waiting, (double)sim->population->totals.waiting)
HISTORY_VALUE(mass_in, sim->population->totals.mass_in)
HISTORY_VALUE(mass_out, sim->population->totals.mass_out)
HISTORY_VECTOR(brought, component(sim, k, replacement_momentum))
HISTORY_VALUE(replaced, sim->fluid->replaced)

/* --- the energy of the particles ------------------------------------------ */

HISTORY_VALUE(normal_springs, dem_energy(sim->dem)->normal)
HISTORY_VALUE(tangential_springs, dem_energy(sim->dem)->tangential)
HISTORY_VALUE(damped_n, dem_energy(sim->dem)->damped_n)
HISTORY_VALUE(damped_t, dem_energy(sim->dem)->damped_t)
HISTORY_VALUE(slid, dem_energy(sim->dem)->slid)
HISTORY_VALUE(released, dem_energy(sim->dem)->released)
HISTORY_VALUE(rolled, dem_energy(sim->dem)->rolled)
HISTORY_VALUE(work, dem_energy(sim->dem)->work)
HISTORY_VALUE(attracted, dem_energy(sim->dem)->attracted)
HISTORY_VALUE(of_walls, dem_energy(sim->dem)->walls)
HISTORY_VALUE(energy_brought, dem_energy(sim->dem)->added)
HISTORY_VALUE(residual_of_energy, energy_residual(dem_energy(sim->dem)))

/* --- numerics ------------------------------------------------------------- */

HISTORY_VALUE(cfl, sim->fluid->report.cfl)
HISTORY_VALUE(mass_residual, sim->fluid->report.mass_residual)
HISTORY_VALUE(momentum_residual, sim->fluid->report.momentum_residual)
HISTORY_VALUE(splitting, sim->fluid->report.piso_residual)
HISTORY_VALUE(pressure_iterations, sim->fluid->report.pressure.iterations)
HISTORY_VALUE(momentum_iterations, sim->fluid->report.momentum.iterations)
HISTORY_VALUE(backflow_faces, sim->fluid->report.backflow_faces)
HISTORY_VALUE(flow_substeps, sim->fluid->report.flow_substeps)
HISTORY_VECTOR(mean_gradient, sim->fluid->mean_gradient[k])
HISTORY_VALUE(exchange_residual, sim->coupling->report.exchange_residual)
HISTORY_VALUE(eps_lowest, sim->coupling->report.eps_lowest)
HISTORY_VALUE(capped_cells, averaging_report(sim->averaging)->capped)
HISTORY_VALUE(substeps, sim->coupling->report.substeps)
HISTORY_VALUE(max_overlap, sim->dem_report.max_overlap)
HISTORY_VALUE(contacts, sim->dem_report.contacts)
HISTORY_VALUE(rebuilds, (double)sim->dem_report.rebuilds)
HISTORY_VALUE(relabelled, vector_length(sim->fluid->relabelled))

static double shortest_time(const struct simulation *sim)
{
    const double t = sim->coupling->report.shortest_time;
    return t < HUGE_VAL ? t : 0.0; /* no particle has one */
}

enum {
    F = HISTORY_FLUID,
    P = HISTORY_PARTICLES,
    C = HISTORY_COUPLING,
    D = HISTORY_MEAN_GRADIENT,
    N = HISTORY_PARTS,
    I = HISTORY_POPULATION,
    E = HISTORY_BUDGET
};

const struct history_column history_columns[] = {
    {"time [s]", now, 0},
    {"pressure_drop [Pa]", history_pressure_drop, F},
    {"bed_weight [Pa]", history_bed_weight, P},
    {"buoyant_weight [Pa]", history_buoyant_weight, C},
    {"inlet_velocity [m/s]", inlet_velocity, F},
    {"kinetic_energy_fluid [J]", fluid_energy, F},
    {"kinetic_energy_particles [J]", particle_energy, P},
    {"rotational_energy_particles [J]", spin_energy, P},
    {"particles [-]", particles, I},
    {"particles_in [-]", inserted, I},
    {"particles_out [-]", removed, I},
    {"particles_waiting [-]", waiting, I},
    {"mass_in [kg]", mass_in, I},
    {"mass_out [kg]", mass_out, I},
    {"momentum_brought_x [N s]", brought_x, I},
    {"momentum_brought_y [N s]", brought_y, I},
    {"momentum_brought_z [N s]", brought_z, I},
    {"fluid_replaced [kg]", replaced, I | C},
    {"energy_normal_springs [J]", normal_springs, E},
    {"energy_tangential_springs [J]", tangential_springs, E},
    {"lost_in_normal_dashpots [J]", damped_n, E},
    {"lost_in_tangential_dashpots [J]", damped_t, E},
    {"lost_by_sliding [J]", slid, E},
    {"lost_by_tangential_springs [J]", released, E},
    {"lost_by_rolling [J]", rolled, E},
    {"work_of_outside_forces [J]", work, E},
    {"work_of_cohesion [J]", attracted, E},
    {"work_of_walls [J]", of_walls, E},
    {"energy_brought [J]", energy_brought, E},
    {"energy_residual [J]", residual_of_energy, E},
    {"granular_temperature [m2/s2]", granular_temperature, P},
    {"mean_height [m]", mean_height, P},
    {"mean_fall_velocity [m/s]", mean_fall, P},
    {"momentum_x [N s]", momentum_x, 0},
    {"momentum_y [N s]", momentum_y, 0},
    {"momentum_z [N s]", momentum_z, 0},
    {"unpaid_impulse_x [N s]", unpaid_x, C},
    {"unpaid_impulse_y [N s]", unpaid_y, C},
    {"unpaid_impulse_z [N s]", unpaid_z, C},
    {"max_cfl [-]", cfl, F},
    {"max_overlap [-]", max_overlap, P},
    {"contacts [-]", contacts, P},
    {"list_rebuilds [-]", rebuilds, P},
    {"eps_f_lowest [-]", eps_lowest, C},
    {"capped_cells [-]", capped_cells, C},
    {"substeps [-]", substeps, C},
    {"shortest_relaxation_time [s]", shortest_time, C},
    {"mass_residual [-]", mass_residual, F},
    {"momentum_residual [-]", momentum_residual, F},
    {"piso_splitting [-]", splitting, F},
    {"exchange_residual [-]", exchange_residual, C},
    {"relabelled_momentum [N s]", relabelled, C},
    {"pressure_iterations [-]", pressure_iterations, F},
    {"momentum_iterations [-]", momentum_iterations, F},
    {"backflow_faces [-]", backflow_faces, F},
    {"mean_gradient_x [Pa/m]", mean_gradient_x, D},
    {"mean_gradient_y [Pa/m]", mean_gradient_y, D},
    {"mean_gradient_z [Pa/m]", mean_gradient_z, D},
    {"flow_substeps [-]", flow_substeps, N},
    {NULL, NULL, 0}};

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
           (!(c->needs & E) ||
            (sim->dem != NULL && dem_energy(sim->dem) != NULL));
}
