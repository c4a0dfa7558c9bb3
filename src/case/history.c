/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/history.h"

#include <gsl/gsl_math.h>
#include <math.h>

#include "coupling/coupling.h"
#include "case/history_energy.h"

static double now(const struct simulation *sim)
{
    return sim->t;
}

/* --- physics ------------------------------------------------------------ */

/* Of kind: what enters by its own pressure is an inlet. */
static const struct patch *patch_of(const struct fluid *fl,
                                    enum boundary_kind kind, const char *name)
{
    const struct boundary *const b = fl->options.boundaries;

    for (int i = 0; i < fl->mesh->n_patches; i++)
        if ((b[i].enters ? BOUNDARY_INLET : b[i].kind) == kind)
            return &fl->mesh->patches[i];
    return mesh_patch(fl->mesh, name);
}

double history_pressure_drop(const struct simulation *sim)
{
    const struct fluid *const fl = sim->fluid;
    const struct patch *const in = patch_of(fl, BOUNDARY_INLET, "bottom");
    const struct patch *const out = patch_of(fl, BOUNDARY_OUTLET, "top");

    if (in == NULL || out == NULL) return 0.0;
    return fluid_patch_pressure(fl, in) - fluid_patch_pressure(fl, out);
}

/* Extent along gravity over the volume: one over the (mean) section. */
static double per_section(const struct simulation *sim, double *g)
{
    const struct mesh *const m = sim->mesh;
    double volume = 1.0, along = 0.0;

    *g = 0.0;
    for (int k = 0; k < 3; k++) {
        const double length = m->hi[k] - m->lo[k];
        volume *= length;
        along += fabs(sim->gravity[k]) * length;
        *g += sim->gravity[k] * sim->gravity[k];
    }
    if (m->face_centre != NULL) volume = 0.0;
    for (int c = 0; c < m->n_cells && m->face_centre != NULL; c++)
        volume += m->V[c];
    *g = sqrt(*g);
    return *g > 0.0 ? along / (*g * volume) : 0.0;
}

double history_bed_weight(const struct simulation *sim)
{
    double g, mass = 0.0;
    const double section = per_section(sim, &g);

    for (int i = 0; i < sim->particles->n; i++)
        mass += sim->particles->m[i];
    return mass * g * section;
}

static double buoyant_weight(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double g, volume = 0.0;
    const double section = per_section(sim, &g);

    for (int i = 0; i < ps->n; i++)
        volume += M_PI / 6.0 * ps->d[i] * ps->d[i] * ps->d[i];
    return history_bed_weight(sim) -
           sim->fluid->options.rho * volume * g * section;
}

static double inlet_velocity(const struct simulation *sim)
{
    return fluid_inlet_velocity(sim->fluid);
}

static double fluid_energy(const struct simulation *sim)
{
    return fluid_kinetic_energy(sim->fluid);
}

static double particle_energy(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->m[i] * (ps->vx[i] * ps->vx[i] + ps->vy[i] * ps->vy[i] +
                           ps->vz[i] * ps->vz[i]);
    return 0.5 * sum;
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
    return 0.5 * sum;
}

/* A third of their mean square about the mean. */
static double granular_temperature(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};
    double sum = 0.0;

    if (ps->n == 0) return 0.0;
    for (int k = 0; k < 3; k++) {
        double mean = 0.0;
        for (int i = 0; i < ps->n; i++)
            mean += v[k][i] / ps->n;
        for (int i = 0; i < ps->n; i++)
            sum += (v[k][i] - mean) * (v[k][i] - mean);
    }
    return sum / (3.0 * ps->n);
}

static double mean_height(const struct simulation *sim)
{
    double sum = 0.0;

    for (int i = 0; i < sim->particles->n; i++)
        sum += sim->particles->y[i] / sim->particles->n;
    return sum;
}

/* The mean fall velocity, that of a single sphere. */
static double mean_fall(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const double *const g = sim->gravity;
    const double size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->vx[i] * g[0] + ps->vy[i] * g[1] + ps->vz[i] * g[2];
    return size > 0.0 && ps->n > 0 ? sum / (size * ps->n) : 0.0;
}

static double total_momentum(const struct simulation *sim, int k)
{
    double total[3];
    coupling_total_momentum(sim, total);
    return total[k];
}

static double momentum_x(const struct simulation *sim)
{
    return total_momentum(sim, 0);
}

static double momentum_y(const struct simulation *sim)
{
    return total_momentum(sim, 1);
}

static double momentum_z(const struct simulation *sim)
{
    return total_momentum(sim, 2);
}

static double owed(const struct simulation *sim, int k)
{
    double sum[3];
    coupling_unpaid_impulse(sim, sum);
    return sum[k];
}

static double owed_x(const struct simulation *sim)
{
    return owed(sim, 0);
}

static double owed_y(const struct simulation *sim)
{
    return owed(sim, 1);
}

static double owed_z(const struct simulation *sim)
{
    return owed(sim, 2);
}

/* --- numerics ----------------------------------------------------------- */

static double cfl(const struct simulation *sim)
{
    return sim->fluid->report.cfl;
}

static double mass_residual(const struct simulation *sim)
{
    return sim->fluid->report.mass_residual;
}

static double momentum_residual(const struct simulation *sim)
{
    return sim->fluid->report.momentum_residual;
}

static double splitting(const struct simulation *sim)
{
    return sim->fluid->report.piso_residual;
}

static double pressure_iterations(const struct simulation *sim)
{
    return sim->fluid->report.pressure.iterations;
}

static double momentum_iterations(const struct simulation *sim)
{
    return sim->fluid->report.momentum.iterations;
}

static double backflow_faces(const struct simulation *sim)
{
    return sim->fluid->report.backflow_faces;
}

static double exchange_residual(const struct simulation *sim)
{
    return sim->coupling->report.exchange_residual;
}

static double relabelled(const struct simulation *sim)
{
    const double *const r = sim->fluid->relabelled;
    return sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
}

static double eps_lowest(const struct simulation *sim)
{
    return sim->coupling->report.eps_lowest;
}

static double capped_cells(const struct simulation *sim)
{
    return averaging_report(sim->averaging)->capped;
}

static double substeps(const struct simulation *sim)
{
    return sim->coupling->report.substeps;
}

static double shortest_time(const struct simulation *sim)
{
    const double t = sim->coupling->report.shortest_time;
    return t < HUGE_VAL ? t : 0.0; /* no particle has one */
}

static double max_overlap(const struct simulation *sim)
{
    return sim->dem_report.max_overlap;
}

static double contacts(const struct simulation *sim)
{
    return sim->dem_report.contacts;
}

static double rebuilds(const struct simulation *sim)
{
    return (double)sim->dem_report.rebuilds;
}

static double mean_gradient_x(const struct simulation *sim)
{
    return sim->fluid->mean_gradient[0];
}

static double mean_gradient_y(const struct simulation *sim)
{
    return sim->fluid->mean_gradient[1];
}

static double mean_gradient_z(const struct simulation *sim)
{
    return sim->fluid->mean_gradient[2];
}

static double fluid_parts(const struct simulation *sim)
{
    return sim->fluid->report.flow_substeps;
}

enum {
    F = HISTORY_FLUID,
    P = HISTORY_PARTICLES,
    C = HISTORY_COUPLING,
    D = HISTORY_MEAN_GRADIENT,
    N = HISTORY_PARTS,
    E = HISTORY_BUDGET,
    L = HISTORY_POPULATION
};

const struct history_column history_columns[] = {
    {"time [s]", now, 0},
    {"pressure_drop [Pa]", history_pressure_drop, F},
    {"bed_weight [Pa]", history_bed_weight, P},
    {"buoyant_weight [Pa]", buoyant_weight, C},
    {"inlet_velocity [m/s]", inlet_velocity, F},
    {"kinetic_energy_fluid [J]", fluid_energy, F},
    {"kinetic_energy_particles [J]", particle_energy, P},
    {"rotational_energy_particles [J]", spin_energy, P},
    {"particles [-]", history_particles, L},
    {"particles_in [-]", history_inserted, L},
    {"particles_out [-]", history_removed, L},
    {"particles_waiting [-]", history_waiting, L},
    {"mass_in [kg]", history_mass_in, L},
    {"mass_out [kg]", history_mass_out, L},
    {"momentum_brought_x [N s]", history_brought_x, L},
    {"momentum_brought_y [N s]", history_brought_y, L},
    {"momentum_brought_z [N s]", history_brought_z, L},
    {"fluid_replaced [kg]", history_replaced, C | L},
    {"energy_normal_springs [J]", history_energy_normal, E},
    {"energy_tangential_springs [J]", history_energy_tangential, E},
    {"lost_in_normal_dashpots [J]", history_energy_damped_n, E},
    {"lost_in_tangential_dashpots [J]", history_energy_damped_t, E},
    {"lost_by_sliding [J]", history_energy_slid, E},
    {"lost_by_tangential_springs [J]", history_energy_released, E},
    {"lost_by_rolling [J]", history_energy_rolled, E},
    {"work_of_outside_forces [J]", history_energy_work, E},
    {"work_of_cohesion [J]", history_energy_attracted, E},
    {"work_of_walls [J]", history_energy_walls, E},
    {"energy_brought [J]", history_energy_brought, E},
    {"energy_residual [J]", history_energy_residual, E},
    {"granular_temperature [m2/s2]", granular_temperature, P},
    {"mean_height [m]", mean_height, P},
    {"mean_fall_velocity [m/s]", mean_fall, P},
    {"momentum_x [N s]", momentum_x, 0},
    {"momentum_y [N s]", momentum_y, 0},
    {"momentum_z [N s]", momentum_z, 0},
    {"owed_x [N s]", owed_x, C},
    {"owed_y [N s]", owed_y, C},
    {"owed_z [N s]", owed_z, C},
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
    {"fluid_parts [-]", fluid_parts, N},
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
           (!(c->needs & L) || sim->population != NULL) &&
           (!(c->needs & E) ||
            (sim->dem != NULL && dem_energy(sim->dem) != NULL));
}
