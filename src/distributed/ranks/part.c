/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distributed/ranks/part.h"

#include <math.h>
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/build.h"
#include "case/particles/case_materials.h"
#include "case/case_file.h"
#include "coupling/coupling.h"
#include "dem/dem_method.h"
#include "dem/contact.h"
#include "fluid/systems.h"

/* --- the partition -------------------------------------------------------- */

/* The direction of gravity; that of y without it. */
static int direction_down(const struct settings *s)
{
    const double *const g = s->effects.gravity;
    int down = 1;

    for (int k = 0; k < 3; k++)
        if (fabs(g[k]) > fabs(g[down])) down = k;
    return down;
}

/* A corrector reads two cells far: the pressure gradient of a neighbour reads
 * that neighbour's neighbours. Schemes that need the velocity gradient read one
 * more. */
static int layers_of(const struct settings *s)
{
    if (s->layers > 0) return s->layers;
    return strcmp(s->fluid.convection->name, "upwind") == 0 ? 2 : 3;
}

int part_divide(const struct settings *s, MPI_Comm comm, struct partition *p)
{
    int rank, size;

    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &size);
    return partition_init(p, &s->mesh.box, s->ranks, direction_down(s), rank,
                          size, layers_of(s));
}

/* What a step of a cell and of a particle costs [s]: measured, chapter "Past
 * one machine". Only their ratio counts. */
static const double cell_cost = 8e-6, particle_cost = 0.23e-6;

/* The planes at equal shares of the work of cells and of the particles where
 * they are now. */
static void part_cut(struct part *part)
{
    struct partition *const p = &part->p;
    const double each = particle_cost * part->sim->dem_steps;
    double *weight[3];

    for (int k = 0; k < 3; k++) {
        weight[k] = alloc_doubles(p->N[k]);
        for (int i = 0; i < p->N[k]; i++)
            weight[k][i] = cell_cost * partition_cells(p) / p->N[k];
    }
    spheres_weigh(part->spheres, each, weight);
    partition_cut(p, (const double *const *)weight);
    for (int k = 0; k < 3; k++)
        free(weight[k]);
}

/* --- the spheres ---------------------------------------------------------- */

/* Those that this rank offers to LAMMPS. */
struct offer {
    double lo[3], hi[3]; /* [m] a little more than its part of the box */
    double density;      /* [kg/m^3] */
    int n, room;
    struct sphere *list;
};

static void part_offer(struct offer *o, const struct sphere *s)
{
    for (int k = 0; k < 3; k++)
        if (!(s->x[k] >= o->lo[k] && s->x[k] <= o->hi[k])) return;
    o->list = alloc_room(o->list, o->n, &o->room, sizeof *o->list);
    o->list[o->n++] = *s;
}

static void offer_of_bed(void *to, int i, const double x[3], double d)
{
    struct offer *const o = to;
    const double m = o->density * M_PI / 6.0 * d * d * d;

    part_offer(
        o, &(struct sphere){
               .id = i, .type = 1, .x = {x[0], x[1], x[2]}, .d = d, .m = m});
}

static void offer_placed(const struct settings *s, struct offer *o)
{
    for (int i = 0; i < s->particles.place.n; i++) {
        const struct place_setup *const p = &s->particles.place.item[i];
        const int material = case_materials_number(s, p->material);
        const double d = p->diameter;
        struct sphere one = {.id = i, .type = material + 1, .d = d};
        one.m =
            case_materials_setup(s, material)->density * M_PI / 6.0 * d * d * d;
        memcpy(one.x, p->position, sizeof one.x);
        memcpy(one.v, p->velocity, sizeof one.v);
        memcpy(one.w, p->spin, sizeof one.w);
        part_offer(o, &one);
    }
}

/* Each rank goes through the whole lattice, or list, and takes its own. */
static int part_add_all(struct part *part, const struct settings *s,
                        const struct bed_options *bed,
                        const struct dem_options *dem)
{
    struct partition *const p = &part->p;
    struct offer o = {.n = 0};
    const int r[3] = {p->rank % p->P[0], p->rank / p->P[0] % p->P[1],
                      p->rank / p->P[0] / p->P[1]};
    int wrong = 0;

    for (int k = 0; k < 3; k++) {
        const double L = p->size_m[k], width = L / p->P[k];
        o.lo[k] = r[k] * width - 1e-6 * L;
        o.hi[k] = (r[k] + 1) * width + 1e-6 * L;
    }
    if (bed != NULL) {
        o.density = bed->density;
        wrong = bed_each(bed, dem, offer_of_bed, &o);
    } else {
        offer_placed(s, &o);
    }
    spheres_add(part->spheres, o.n, o.list);
    free(o.list);
    return wrong;
}

/* The spheres of the case, where they are before the first step. */
static int part_place(struct part *part, const struct settings *s)
{
    const int has_bed = s->particles.has_bed;
    const struct dem_options dem = build_particles_dem(s, part->sim->dt);
    struct bed_options bed = {.settle = 0.0};
    struct bed_report r;
    double d;

    if (has_bed) bed = build_particles_bed(s);
    int code = part_add_all(part, s, has_bed ? &bed : NULL, &dem) ? 2 : 0;
    const long n = spheres_all(part->spheres, &d);
    if (code == 0 && n > 0 && bed.settle > 0.0 &&
        vector_length(bed.gravity) > 0.0) {
        const double step =
            limits_step(dem.law, &dem.material, bed.diameter, bed.density, 1.0);
        const struct words w = words_of(s, d);
        spheres_settle(part->spheres, &w, step, &bed, &r);
        if (part->p.rank == 0 && !s->quiet)
            fprintf(stderr, "settled in %.3g s: kinetic energy %.1g m g d%s\n",
                    r.time, r.kinetic,
                    r.settled ? ""
                              : ": NOT AT REST, raise particles.bed.settle");
    }
    build_particles_free_bed(&bed);
    return code;
}

/* --- the simulation of a part --------------------------------------------- */

static void part_add_fluid(struct part *part, const struct settings *s,
                           const int cut_off[6])
{
    struct simulation *const sim = part->sim;
    int local;

    sim->boundaries = build_boundaries(s, sim->mesh);
    for (int i = 0; i < sim->mesh->n_patches; i++)
        if (cut_off[i]) {
            boundary_release(&sim->boundaries[i]);
            sim->boundaries[i] = (struct boundary){.kind = BOUNDARY_SLIP};
        }
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

/* Room for those that may come later: half as many. */
static int capacity(int share, long all)
{
    const double most = 1.5 * share + 2000.0;

    return (double)all < most ? (int)all : (int)most;
}

static int part_add_particles(struct part *part, const struct settings *s,
                              long all)
{
    struct simulation *const sim = part->sim;
    struct dem_options o = build_particles_dem(s, sim->dt / sim->dem_steps);

    o.materials = sim->materials = case_materials_create(s);
    o.method = &spheres_method;
    sim->particles =
        particles_create(capacity(spheres_share(part->spheres), all));
    sim->particles->next_id = (int)all;
    if (sim->materials != NULL) particles_add_material(sim->particles);
    sim->dem = dem_create(sim->particles, &o);
    if (sim->dem == NULL) return 2;
    build_particles_limit(s, sim);
    sim->held_force = particles_new_array(sim->particles, "held_force", "N", 3);
    return 0;
}

static int add_coupling(struct part *part, const struct settings *s)
{
    struct simulation *const sim = part->sim;
    struct averaging_options o = build_averaging_options(s);
    const int diffuses = o.method == &diffusion_method;

    part->smoothing =
        (struct smoothing){.h = part->halo,
                           .mesh = sim->mesh,
                           .bandwidth = diffuses ? o.bandwidth : 0.0,
                           .tolerance = o.tolerance};
    o.parts = &part->smoothing;
    o.bandwidth = 0.0;
    sim->averaging =
        averaging_create(&smoothing_method, sim->mesh, sim->particles, &o);
    if (sim->averaging == NULL) return 2;
    build_coupling(s, sim);
    build_effects(s, sim);
    return 0;
}

/* --- sums over the cells -------------------------------------------------- */

/* Exchanges two lists of numbers. */
static void swap(double *a, double *b, int n)
{
    for (int i = 0; i < n; i++) {
        const double x = a[i];
        a[i] = b[i];
        b[i] = x;
    }
}

/* Copies get no volume and no residual, and their sides of the box no area; the
 * box is the whole one. The second call takes this back. */
void part_count_own(struct part *part)
{
    struct mesh *const m = part->sim->mesh;
    const int sides = 3 * (m->n_faces - m->n_internal);

    swap(m->V, part->own_V, m->n_cells);
    swap(m->S, part->own_S, sides); /* those of the boundary come first */
    for (int c = 0; c < m->n_cells; c++)
        if (part->V[c] == 0.0)
            swap(part->sim->fluid->momentum->residual + 3 * c,
                 part->no_residual + 3 * c, 3);
    swap(m->lo, part->ends, 3);
    swap(m->hi, part->ends + 3, 3);
}

static void find_own(struct part *part)
{
    const struct mesh *const m = part->sim->mesh;
    const unsigned char *const own = halo_own(part->halo);

    part->V = owner_doubles(part, m->n_cells);
    part->own_V = owner_doubles(part, m->n_cells);
    part->no_residual = owner_doubles(part, 3 * m->n_cells);
    part->own_S = owner_doubles(part, 3 * (m->n_faces - m->n_internal));
    for (int c = 0; c < m->n_cells; c++)
        part->V[c] = part->own_V[c] = own[c] ? m->V[c] : 0.0;
    for (int f = m->n_internal; f < m->n_faces; f++)
        if (own[m->owner[f]])
            memcpy(part->own_S + 3 * (f - m->n_internal), mesh_S(m, f),
                   3 * sizeof *m->S);
    memcpy(part->ends + 3, part->p.size_m, sizeof part->p.size_m);
}

/* --- all ------------------------------------------------------------------ */

/* Cells, fluid and coupling, where the spheres are. */
static int part_add_fields(struct part *part, const struct settings *s,
                           long all)
{
    struct simulation *const sim = part->sim;
    int cut_off[6];

    sim->mesh = partition_mesh(&part->p, cut_off);
    part->halo = halo_create(&part->p, part->comm);
    part->places = partition_faces(sim->mesh, cut_off);
    part->solve =
        solve_create(sim->mesh, part->halo, &part->places, part->comm);
    part_add_fluid(part, s, cut_off);
    find_own(part);
    const int code = part_add_particles(part, s, all);
    return code != 0 ? code : add_coupling(part, s);
}

struct part *part_create(const struct settings *s, MPI_Comm comm,
                         const char *file, int *code)
{
    struct part *const part = owner_create(sizeof *part);
    struct simulation *const sim = alloc_zeroed(1, sizeof *sim);
    double d = 1.0;

    part->comm = comm;
    part->sim = sim;
    sim->dt = case_steps_length(s);
    sim->dem_steps = case_steps_within(s);
    *code = part_divide(s, comm, &part->p);
    if (*code != 0) return part;
    struct words w = words_of(s, d);
    part->spheres = spheres_create(&part->p, &w, file, comm);
    if (file == NULL) *code = part_place(part, s);
    if (*code != 0) return part;
    const long all = spheres_all(part->spheres, &d);
    w = words_of(s, d);
    part_cut(part);
    *code = part_add_fields(part, s, all);
    if (*code == 0) spheres_begin(part->spheres, sim->dem, &w);
    return part;
}

void part_free(struct part *part)
{
    if (part == NULL) return;
    if (part->sim->dem == NULL) spheres_free(part->spheres);
    solve_free(part->solve);
    halo_free(part->halo);
    partition_release(&part->p);
    free(part->places.up);
    free(part->places.down);
    owner_free(part);
}
