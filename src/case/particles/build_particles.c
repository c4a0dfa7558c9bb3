/* SPDX-License-Identifier: GPL-3.0-or-later */
/* build_particles.c -- the particles of a case, at rest or placed. */
#include "case/build.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "case/particles/case_clumps.h"
#include "case/particles/case_materials.h"
#include "case/case_mesh.h"
#include "case/case_file.h"
#include "case/particles/case_population.h"
#include "case/resolved/case_bodies.h"
#include "case/resume/resume.h"
#include "case/particles/case_surfaces.h"
#include "dem/box_domain.h"
#include "dem/dem_method.h"

static int bed_lost(const struct bed_report *r)
{
    fprintf(stderr,
            "winnow: %d particles left the box while the bed settled, the "
            "first with id %d; is the box too small for its bed, or the "
            "material too soft to carry it?\n",
            r->dem.lost, r->dem.lost_id);
    return 3;
}

/* None yet, with room for the bed and for those that come later. */
static struct particles *bed_particles(const struct settings *s)
{
    return case_clumps_particles(s, case_clumps_balls(s, s->particles.bed_clump,
                                                      s->particles.bed.count) +
                                        case_population_count(s));
}

static int allocate_bed(const struct settings *s, struct simulation *sim,
                        const struct dem_options *o)
{
    sim->particles = bed_particles(s);
    sim->dem = dem_create(sim->particles, o);
    return sim->dem == NULL ? 2 : 0;
}

static void build_particles_print_settled(const struct settings *s,
                                          const struct bed_report *r,
                                          int in_box, const char *cached)
{
    const char *const warning =
        r->settled ? "" : ": NOT AT REST, raise particles.bed.settle";

    if (s->quiet || (r->steps == 0 && cached == NULL)) return;
    if (r->steps == 0)
        fprintf(stderr,
                "the bed was settled before: %s (--fresh settles it anew)\n",
                cached);
    else if (in_box)
        fprintf(stderr,
                "settled in %.3g s: height %.4g m, solid fraction %.3f, "
                "kinetic energy %.1g m g d%s\n",
                r->time, r->height, r->packing, r->kinetic, warning);
    else
        fprintf(stderr, "settled in %.3g s: kinetic energy %.1g m g d%s\n",
                r->time, r->kinetic, warning);
}

/* The bed from the file, or made anew and kept there; NULL: it is not kept.
 * Returns what bed_create does. */
static int make_bed(const struct settings *s, struct simulation *sim,
                    const struct dem_options *o, const struct bed_saver *saver,
                    const struct input *file, struct bed_report *r)
{
    struct bed_options b = build_particles_bed(s);

    b.region = sim->region;
    b.saver = saver;
    sim->particles = bed_particles(s);
    sim->dem = dem_create(sim->particles, o);
    const int found = sim->dem == NULL ? BED_REFUSED
                                       : bed_cache_create(file, sim->particles,
                                                          sim->dem, &b, o, r);
    build_particles_free_bed(&b);
    return found;
}

/* Where the file in which another run has kept the bed is damaged, it is
 * removed and the bed is settled again. */
static int remake_bed(const struct settings *s, struct simulation *sim,
                      const struct dem_options *o,
                      const struct bed_saver *saver, const char *path,
                      struct bed_report *r)
{
    fprintf(stderr, "winnow: %s is removed, and the bed is settled anew\n",
            path);
    unlink(path);
    dem_free(sim->dem);
    particles_free(sim->particles);
    sim->dem = NULL;
    sim->particles = NULL;
    const struct input none = {.path = (char *)path};
    return make_bed(s, sim, o, saver, &none, r);
}

/* The bed is kept in a file that the case names, which must be written, or in
 * one that another run may use again. */
static int create_bed(const struct settings *s, struct simulation *sim,
                      const struct dem_options *o,
                      const struct bed_saver *saver)
{
    const char *const named = s->particles.bed_file;
    char path[SETTINGS_PATH];
    struct bed_report r;

    const int cached = named == NULL && bed_cache_file(s, path, sizeof path);
    struct input ours = cached ? input_of(path) : (struct input){0};
    const int was_there = ours.text != NULL;
    int found = make_bed(s, sim, o, saver,
                         named != NULL ? settings_input(s, named)
                         : cached      ? &ours
                                       : NULL,
                         &r);
    input_release(&ours);
    if (found == BED_REFUSED && was_there)
        found = remake_bed(s, sim, o, saver, path, &r);
    if (found == BED_UNSAVED && cached) found = BED_CREATED;
    if (found == BED_LOST && r.dem.lost > 0) return bed_lost(&r);
    if (found == BED_STOPPED) return r.stopped;
    if (found != BED_CREATED) return found == BED_UNSAVED ? 4 : 2;
    if (cached && !r.settled) unlink(path);
    build_particles_print_settled(s, &r, sim->region.has_room == NULL,
                                  cached ? path : NULL);
    return 0;
}

/* The spheres at the positions of the case; there is no dem yet. */
static int build_particles_put_spheres(const struct settings *s,
                                       struct simulation *sim,
                                       const struct dem_options *o)
{
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    const int n = s->particles.place.n;

    double balls = case_population_count(s);

    for (int k = 0; k < n; k++)
        balls += case_clumps_balls(s, s->particles.place.item[k].clump, 1.0);
    sim->particles = case_clumps_particles(s, balls);
    if (sim->materials != NULL) particles_add_material(sim->particles);
    for (int k = 0; k < n; k++) {
        const struct place_setup *const p = &s->particles.place.item[k];
        const int material = case_materials_number(s, p->material);
        double x[3];
        memcpy(x, p->position, sizeof x);
        for (int a = 0; a < 3; a++)
            if (x[a] < o->lo[a] || x[a] > o->hi[a])
                x[a] = box_domain_inside(&box, a, x[a]);
        const double density = case_materials_setup(s, material)->density;
        int i;
        if (p->clump == NULL)
            i = particles_add(sim->particles, x, p->diameter, density);
        else if (case_clumps_place(s, sim->particles, o, p, x, density, &i) !=
                 0)
            return 2;
        for (int q = i; q < sim->particles->n && material > 0; q++)
            sim->particles->material[q] = material;
        if (p->clump != NULL) continue;
        sim->particles->vx[i] = p->velocity[0];
        sim->particles->vy[i] = p->velocity[1];
        sim->particles->vz[i] = p->velocity[2];
        sim->particles->wx[i] = p->spin[0];
        sim->particles->wy[i] = p->spin[1];
        sim->particles->wz[i] = p->spin[2];
    }
    const int code = case_surfaces_place(s, sim->particles, o);
    return code != 0 ? code : case_population_place(s, sim->particles, o);
}

static int place_spheres(const struct settings *s, struct simulation *sim,
                         const struct dem_options *o)
{
    if (build_particles_put_spheres(s, sim, o) != 0) return 2;
    sim->dem = dem_create(sim->particles, o);
    return sim->dem == NULL ? 2 : 0;
}

/* The lattice that the bed is dropped from. */
static int place_bed(const struct settings *s, struct simulation *sim,
                     const struct dem_options *o)
{
    struct bed_options b = build_particles_bed(s);

    b.region = sim->region;
    sim->particles = bed_particles(s);
    const int wrong = bed_fill(sim->particles, &b, o) != 0;
    build_particles_free_bed(&b);
    if (wrong) return 2;
    sim->dem = dem_create(sim->particles, o);
    return sim->dem == NULL ? 2 : 0;
}

/* The options of dem, with materials, surfaces, attractions and bodies. */
static int build_particles_complete(const struct settings *s,
                                    struct simulation *sim,
                                    struct dem_options *o)
{
    *o = build_particles_dem(s, sim->dt / sim->dem_steps);
    o->materials = sim->materials = case_materials_create(s);
    case_surfaces_complete(s, sim, o);
    o->attractions = sim->attractions =
        case_materials_attractions(s, &o->n_attractions);
    return case_bodies_complete(s, sim, o);
}

int build_particles_check(const struct settings *s)
{
    struct simulation *const sim = alloc_zeroed(1, sizeof *sim);
    struct dem_options o;

    sim->dt = case_steps_length(s);
    sim->dem_steps = case_steps_within(s);
    int code = build_particles_complete(s, sim, &o);
    if (code == 0)
        code = s->particles.has_bed ? place_bed(s, sim, &o)
                                    : place_spheres(s, sim, &o);
    if (code == 0) case_surfaces_tell_unseen(s);
    build_free(sim);
    return code;
}

void build_particles_limit(const struct settings *s, struct simulation *sim)
{
    const double max = s->particles.max_overlap;

    dem_limit_overlap(sim->dem, fmin(s->particles.expected_overlap, max), max);
}

int build_particles(const struct settings *s, struct simulation *sim,
                    int with_bed, const struct bed_saver *saver)
{
    struct dem_options o;
    int code = build_particles_complete(s, sim, &o);

    if (code != 0) return code;
    if (s->particles.has_bed)
        code =
            with_bed ? create_bed(s, sim, &o, saver) : allocate_bed(s, sim, &o);
    else
        code = place_spheres(s, sim, &o);
    if (code != 0) return code;
    dem_clock(sim->dem, 0);
    build_particles_limit(s, sim);
    case_surfaces_tell_unseen(s);
    case_population_add(s, sim);
    sim->particles->across = case_parcels_table(s);
    case_parcels_tell(s);
    sim->held_force = particles_new_array(sim->particles, "held_force", "N", 3);
    return 0;
}

/* --- options of dem and its bed ------------------------------------------- */

struct dem_options build_particles_dem(const struct settings *s, double step)
{
    struct dem_options o = {.law = s->particles.contact,
                            .material = case_materials_one(s, 0),
                            .integrator = s->particles.integrator,
                            .method = s->particles.list,
                            .step = step,
                            .shortest_step = s->particles.shortest_step,
                            .step_error = s->particles.step_error,
                            .skin = s->particles.skin};

    settings_where(s, KEY_OF(s, mesh.box.periodic), o.where, sizeof o.where);
    case_mesh_ends(s, o.lo, o.hi);
    case_mesh_periodic(s, o.periodic);
    case_surfaces_dem_options(s, &o);
    return o;
}

struct bed_options build_particles_bed(const struct settings *s)
{
    struct bed_options b = s->particles.bed;

    b.density = s->particles.grains.density;
    b.clump = case_clumps_shape(s, s->particles.bed_clump);
    settings_where(s, KEY_OF(s, particles.bed.count), b.where, sizeof b.where);

    case_population_bed_sizes(s, &b);
    memcpy(b.gravity, s->effects.gravity, sizeof b.gravity);
    return b;
}

void build_particles_free_bed(struct bed_options *b)
{
    owner_free(b->sizes);
    b->sizes = NULL;
}

double build_particles_wall_overlap(const struct settings *s)
{
    return strcmp(s->particles.overlaps, "allow") == 0 ? 0.5 : 0.01;
}
