/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distributed/ranks/part.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "case/build.h"
#include "case/build_boundaries.h"
#include "case/build_fluid.h"
#include "case/build_particles.h"
#include "case/particle_options.h"
#include "case/case_materials.h"
#include "case/case_overlap.h"
#include "case/case_steps.h"
#include "coupling/coupling.h"
#include "dem/dem_internal.h"
#include "fluid/pressure_system.h"

/* --- the partition -------------------------------------------------------- */

/* The direction of gravity; that of y without it. */
static int direction_down(const struct settings *s)
{
    double g[3];
    int down = 1;

    particle_options_gravity(s, g);
    for (int k = 0; k < 3; k++)
        if (fabs(g[k]) > fabs(g[down])) down = k;
    return down;
}

/* A corrector reads two cells far: the pressure gradient of a neighbour reads
 * that neighbour's neighbours. Schemes that need the velocity gradient read one
 * more. */
static int layers_of(const struct settings *s)
{
    if (settings_has(s, "layers")) return settings_int(s, "layers");
    return strcmp(settings_text(s, "fluid.convection"), "upwind") == 0 ? 2 : 3;
}

int part_divide(const struct settings *s, MPI_Comm comm, struct partition *p)
{
    struct box_spec box;
    int P[3] = {0, 0, 0}, rank, size;

    settings_vector(s, "mesh.size", box.size);
    settings_counts(s, "mesh.cells", box.cells);
    settings_flags(s, "mesh.periodic", box.periodic);
    if (settings_has(s, "ranks")) settings_counts(s, "ranks", P);
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &size);
    return partition_init(p, &box, P, direction_down(s), rank, size,
                          layers_of(s));
}

/* What a step of a cell and of a particle costs [s]: measured, chapter "Past
 * one machine". Only their ratio counts. */
static const double cell_cost = 8e-6, particle_cost = 0.23e-6;

/* The planes at equal shares of cells and particles. */
static void cut(struct part *part, const struct simulation *record)
{
    struct partition *const p = &part->p;
    double *weight[3];
    const double cells = (double)p->N[0] * p->N[1] * p->N[2];

    for (int k = 0; k < 3; k++) {
        weight[k] = alloc_doubles(p->N[k]);
        for (int i = 0; i < p->N[k]; i++)
            weight[k][i] = cell_cost * cells / p->N[k];
        for (int i = 0; record != NULL && i < record->particles->n; i++) {
            const double *const x[3] = {record->particles->x,
                                        record->particles->y,
                                        record->particles->z};
            const double at = floor(x[k][i] / p->size_m[k] * p->N[k]);
            const int c = at < 0.0             ? 0
                          : at > p->N[k] - 1.0 ? p->N[k] - 1
                                               : (int)at;
            weight[k][c] += particle_cost * record->dem_steps;
        }
        MPI_Bcast(weight[k], p->N[k], MPI_DOUBLE, 0, part->comm);
    }
    partition_cut(p, (const double *const *)weight);
    for (int k = 0; k < 3; k++)
        free(weight[k]);
}

/* --- the simulation of a part --------------------------------------------- */

static void add_fluid(struct part *part, const struct settings *s,
                      const int cut_off[6])
{
    struct simulation *const sim = part->sim;
    int local;

    sim->boundaries = build_boundaries(s, sim->mesh, &sim->inlet_series);
    for (int i = 0; i < sim->mesh->n_patches; i++)
        if (cut_off[i])
            sim->boundaries[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    struct fluid_options o = build_fluid_options(s, sim);
    o.shared = solve_shared(part->solve);
    sim->fluid = fluid_create(sim->mesh, &o);
    /* Of all ranks one has the cell whose pressure is fixed, if any is. */
    int *const pinned = &sim->fluid->pressure->pinned_cell;
    int outlet = *pinned < 0;
    MPI_Allreduce(MPI_IN_PLACE, &outlet, 1, MPI_INT, MPI_MAX, part->comm);
    *pinned = -1;
    if (partition_owner(&part->p, 0, &local) == part->p.rank && !outlet)
        *pinned = local;
}

/* Room for the spheres of a rank: for all of a small case; else for twice its
 * share, which a bed that is cut across gravity does not leave. */
static int capacity(int n, int ranks)
{
    const int enough = 100000;

    return n < enough                     ? n
           : n < 2 * (n / ranks) + enough ? n
                                          : 2 * (n / ranks) + enough;
}

static int add_particles(struct part *part, const struct settings *s,
                         const struct simulation *record)
{
    struct simulation *const sim = part->sim;
    int numbers[3] = {0, 0, 0};

    if (record != NULL) {
        numbers[0] = record->particles->capacity;
        numbers[1] = record->particles->next_id;
        numbers[2] = record->particles->material != NULL;
    }
    MPI_Bcast(numbers, 3, MPI_INT, 0, part->comm);
    sim->particles = particles_create(capacity(numbers[0], part->p.size));
    sim->particles->next_id = numbers[1];
    if (numbers[2]) particles_add_material(sim->particles);
    struct dem_options o = particle_options_dem(s, sim->dt / sim->dem_steps);
    o.materials = sim->materials = case_materials_create(s);
    o.method = &spheres_method;
    sim->dem = dem_create(sim->particles, &o);
    if (sim->dem == NULL) return 2;
    case_overlap_limit(s, sim);
    sim->held_force = alloc_doubles(3 * sim->particles->capacity);
    particles_attach(sim->particles, "held_force", "N", sim->held_force, 3);
    return 0;
}

/* Compares the impulse that the fluid of all ranks has lost with that charged
 * to their particles (transfer.c, check_payment); called when the fluid's
 * velocity has just been gathered for that. */
static void check_payment(void *to, int m, const double *q)
{
    struct part *const part = to;
    const struct simulation *const sim = part->sim;
    const struct coupling *const cp = sim->coupling;
    const unsigned char *const own = halo_own(part->halo);
    double sum[4] = {0.0, 0.0, 0.0, 0.0}, off = 0.0;

    if (m != 3 || q != cp->smooth || sim->fluid->t <= 0.0) return;
    for (int j = 0; j < 3 * sim->particles->n; j++) {
        const double estimate = sim->dt * cp->k[j / 3] * (q[j] - cp->u_mean[j]);
        sum[j % 3] -= estimate + cp->unpaid_impulse[j];
        sum[3] += fabs(estimate) + fabs(cp->unpaid_impulse[j]);
    }
    for (int c = 0; c < sim->mesh->n_cells; c++)
        for (int k = 0; k < 3 && own[c]; k++)
            sum[k] += sim->mesh->V[c] * sim->dt *
                      (cp->field[4 * c] * sim->fluid->u[3 * c + k] -
                       cp->field[4 * c + 1 + k]);
    halo_sum(part->halo, 4, sum);
    for (int k = 0; k < 3; k++)
        off = fmax(off, fabs(sum[k]));
    part->exchange_residual = sum[3] > 0.0 ? off / sum[3] : 0.0;
}

static int add_coupling(struct part *part, const struct settings *s)
{
    struct simulation *const sim = part->sim;
    struct averaging_options o = build_averaging_options(s);
    const int diffuses =
        strcmp(settings_text(s, "averaging.method"), "diffusion") == 0;

    part->smoothing =
        (struct smoothing){.h = part->halo,
                           .mesh = sim->mesh,
                           .bandwidth = diffuses ? o.bandwidth : 0.0,
                           .tolerance = o.tolerance,
                           .gathered = check_payment,
                           .to = part};
    o.parts = &part->smoothing;
    o.bandwidth = 0.0;
    sim->averaging =
        averaging_create(&smoothing_method, sim->mesh, sim->particles, &o);
    if (sim->averaging == NULL) return 2;
    build_coupling(s, sim);
    build_effects(s, sim);
    return 0;
}

/* The mean diameter, of which the skin of the list follows. */
static double mean_diameter(const struct part *part,
                            const struct simulation *record)
{
    double d = record != NULL ? dem_mean_diameter(record->particles) : 0.0;

    MPI_Bcast(&d, 1, MPI_DOUBLE, 0, part->comm);
    return d;
}

struct part *part_create(const struct settings *s, MPI_Comm comm,
                         const struct simulation *record, int *code)
{
    struct part *const part = alloc_zeroed(1, sizeof *part);
    struct simulation *const sim = alloc_zeroed(1, sizeof *sim);
    int cut_off[6];

    part->comm = comm;
    part->sim = sim;
    *code = part_divide(s, comm, &part->p);
    if (*code != 0) return part;
    cut(part, record);
    sim->mesh = partition_mesh(&part->p, cut_off);
    sim->dt = case_steps_length(s);
    sim->dem_steps = case_steps_within(s);
    part->halo = halo_create(&part->p, comm);
    part->places = partition_faces(sim->mesh, cut_off);
    part->solve = solve_create(sim->mesh, part->halo, &part->places, comm);
    add_fluid(part, s, cut_off);
    *code = add_particles(part, s, record);
    if (*code == 0) *code = add_coupling(part, s);
    if (*code != 0) return part;
    const struct words w = words_of(s, mean_diameter(part, record));
    part->spheres = spheres_create(sim->dem, &part->p, &w, comm);
    return part;
}

void part_free(struct part *part)
{
    if (part == NULL) return;
    build_free(part->sim);
    solve_free(part->solve);
    halo_free(part->halo);
    partition_release(&part->p);
    free(part->places.up);
    free(part->places.down);
    free(part);
}
