/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/checks.h"

#include <math.h>
#include <stdio.h>

#include "averaging/averaging.h"
#include "case/build.h"
#include "case/case_mesh.h"
#include "case/case_file.h"
#include "case/particles/case_clumps.h"
#include "case/particles/case_materials.h"
#include "coupling/processes.h"
#include "case/particles/case_population.h"
#include "case/resolved/case_bodies.h"
#include "case/schema.h"
#include "case/particles/case_surfaces.h"
#include "coupling/effects.h"
#include "dem/dem_method.h"
#include "dem/integrator.h"
#include "mesh/measures.h"

/* Of direction k the name of its two sides, and that of both at once. */
static const char *validate_side_of(int k, int i)
{
    return schema_patches[i < 2 ? 2 * k + i : 6 + k];
}

static const char *const axes[3] = {"x", "y", "z"};

static int has_side(const struct settings *s, const char *patch)
{
    char path[64];

    snprintf(path, sizeof path, "fluid.%s", patch);
    return settings_has(s, path);
}

/* A periodic direction has no sides; any other has each of its two once. */
static int check_direction(const struct settings *s, int k)
{
    const int both = has_side(s, validate_side_of(k, 2));
    const int *const periodic = s->mesh.box.periodic;

    for (int i = 0; i < 2; i++) {
        const int given = has_side(s, validate_side_of(k, i)) + both;

        if (periodic[k] && given > 0)
            return settings_wrong(s, KEY_OF(s, mesh.box.periodic),
                                  "%s is periodic, so the fluid has no %s "
                                  "there; leave one of them out",
                                  axes[k],
                                  both ? validate_side_of(k, 2)
                                       : validate_side_of(k, i));
        if (!periodic[k] && given == 0)
            return settings_wrong(s, "fluid",
                                  "the side %s has no boundary condition: give "
                                  "fluid.%s or fluid.%s, or make %s periodic",
                                  validate_side_of(k, i),
                                  validate_side_of(k, i),
                                  validate_side_of(k, 2), axes[k]);
        if (given == 2)
            return settings_wrong(s, "fluid", "%s is given twice, by %s and %s",
                                  validate_side_of(k, i),
                                  validate_side_of(k, i),
                                  validate_side_of(k, 2));
    }
    return 0;
}

/* 1 if a side or patch has a condition of that kind. */
static int has_condition(const struct settings *s, enum boundary_kind kind)
{
    for (int i = 0; i < s->sides.n; i++)
        if (s->sides.item[i].condition->kind == kind) return 1;
    return 0;
}

/* What drives a flow from the end of a direction to its beginning. */
static int check_drive(const struct settings *s)
{
    const struct fluid_options *const o = &s->fluid;
    const double *const drives[] = {o->mean_gradient, o->mean_flow};
    int periodic[3];

    case_mesh_periodic(s, periodic);
    for (int i = 0; i < 6; i++)
        if (drives[i / 3][i % 3] != 0.0 && !periodic[i % 3])
            return settings_wrong(s, settings_key(s, drives[i / 3]),
                                  "%s is not periodic, so no mean flow can be "
                                  "driven along it; expected 0 there",
                                  axes[i % 3]);
    if (o->has_mean_gradient && o->has_mean_flow)
        return settings_wrong(
            s, KEY_OF(s, fluid.mean_flow),
            "the mean gradient follows from it; leave fluid.mean_gradient out");
    return 0;
}

/* The drag on the fluid acts with the velocity at the end of a whole step, so a
 * step with coupling is not divided. */
static int validate_check_parts(const struct settings *s)
{
    if (s->fluid.cfl > 0.0 && s->has.exchange)
        return settings_wrong(s, KEY_OF(s, fluid.cfl),
                              "with exchange all of fluid.step is one step; "
                              "give a shorter fluid.step instead");
    return 0;
}

static int check_fluid(const struct settings *s)
{
    const int files = s->mesh.polymesh != NULL;
    int code = case_mesh_check_fluid(s);

    for (int k = 0; k < 3 && code == 0 && !files; k++)
        code = check_direction(s, k);
    if (code == 0 && has_condition(s, BOUNDARY_INLET) &&
        !has_condition(s, BOUNDARY_OUTLET))
        return settings_wrong(
            s, "fluid",
            "there is an inlet and no outlet: what flows in cannot leave");
    if (code == 0) code = build_boundaries_check(s);
    if (code == 0) code = check_drive(s);
    return code != 0 ? code : validate_check_parts(s);
}

/* One diameter for all, or the name of a distribution. */
static int check_bed_sizes(const struct settings *s)
{
    const int one = s->particles.bed.diameter > 0.0;

    if (one == (s->particles.bed_sizes != NULL))
        return settings_wrong(s, KEY_OF(s, particles.has_bed),
                              "give either diameter or sizes%s",
                              one ? ", not both" : "");
    return 0;
}

/* Spheres poured into a box fill at most about 0.64 of its volume; beyond 0.6
 * they cannot settle. */
static int check_bed_fits(const struct settings *s)
{
    struct bed_options b = build_particles_bed(s);
    const struct bed_range range = bed_range(&b);
    const char *const diameter = KEY_OF(s, particles.bed.diameter);
    const char *const key = b.sizes != NULL ? KEY_OF(s, particles.bed_sizes)
                            : settings_has(s, diameter)
                                ? diameter
                                : KEY_OF(s, particles.bed_clump);
    const char *const spheres =
        b.clump == NULL ? "spheres" : "clumps in spheres";
    double lo[3], size[3];

    build_particles_free_bed(&b);
    case_mesh_ends(s, lo, size);
    for (int k = 0; k < 3; k++)
        size[k] -= lo[k];
    for (int k = 0; k < 3; k++)
        if (range.max > size[k] && b.count > 0)
            return settings_wrong(s, key,
                                  "%s of %g m are larger than the box, %g m",
                                  spheres, range.max, size[k]);
    const double share = range.volume / case_mesh_volume(s);
    if (share > 0.6)
        return settings_wrong(s, KEY_OF(s, particles.bed.count),
                              "%d %s of %g m would fill %.0f %% of the box; at "
                              "most 60 %% can settle",
                              b.count, spheres, b.diameter, 100.0 * share);
    return 0;
}

static int validate_check_place(const struct settings *s)
{
    double lo[3], hi[3];
    int periodic[3];

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    for (int i = 0; i < s->particles.place.n; i++) {
        const double d = s->particles.place.item[i].diameter;
        const double *const x = s->particles.place.item[i].position;
        for (int k = 0; k < 3; k++) {
            /* the period of a box that is oblique leads back into it */
            if (periodic[k] && s->poly != NULL) continue;
            if (s->particles.place.item[i].clump != NULL) continue;
            const double margin =
                periodic[k] ? 0.0 : (0.5 - build_particles_wall_overlap(s)) * d;
            if (x[k] < lo[k] + margin || x[k] > hi[k] - margin)
                return settings_wrong(
                    s, KEY_OF(s, particles.place),
                    "sphere %d at [%g, %g, %g] m with diameter %g m is not "
                    "inside the box; particles.overlaps = \"allow\" takes it "
                    "as it is if its centre is",
                    i, x[0], x[1], x[2], d);
        }
        if (!case_mesh_holds(s, x))
            return settings_wrong(
                s, KEY_OF(s, particles.place),
                "sphere %d at [%g, %g, %g] m is not inside the mesh", i, x[0],
                x[1], x[2]);
    }
    return 0;
}

/* The drag is solved exactly within kick and drift; Heun has neither. */
static int check_integrator(const struct settings *s)
{
    if (s->particles.integrator->adapts &&
        s->particles.shortest_step > s->particles.step &&
        s->particles.step > 0.0)
        return settings_wrong(s, KEY_OF(s, particles.shortest_step),
                              "%g s is longer than particles.step, %g s",
                              s->particles.shortest_step, s->particles.step);
    if (!s->has.exchange || !s->particles.integrator->predicts) return 0;
    return settings_wrong(s, KEY_OF(s, particles.integrator),
                          "%s is for cases without exchange; with it there are "
                          "velocity-verlet and symplectic-euler",
                          s->particles.integrator->name);
}

/* A method that finds the pairs may not know all that a case asks for. */
static int validate_check_list(const struct settings *s)
{
    const struct dem_options o = build_particles_dem(s, 1.0);
    const char *const unknown = dem_unsupported(&o);
    if (unknown == NULL) return 0;
    return settings_wrong(
        s, KEY_OF(s, particles.list), "%s does not support %s%s; %s does",
        o.method->name, unknown,
        o.n_surfaces > s->particles.surfaces.n
            ? ", which the walls of a mesh are that is no plain box"
            : "",
        dem_methods[0]->name);
}

/* What the stress in the place of contacts cannot be beside. */
static const char *validate_beside_stress(const struct settings *s)
{
    if (!s->particles.list->no_contacts)
        return "it takes the place of contacts: set particles.list to \"none\"";
    if (s->poly != NULL)
        return "it is computed on plain boxes; this mesh is none";
    if (settings_has(s, "effects.energy_budget"))
        return "effects.energy_budget does not know its work: leave one out";
    for (int k = 0; k < s->particles.materials.n; k++)
        if (s->particles.materials.item[k].density !=
            s->particles.grains.density)
            return "all materials must have the same density";
    for (int k = 0; effects[k] != NULL; k++)
        if (effects[k]->added_mass != NULL &&
            settings_has(s, effects[k]->keys[0]->path))
            return "the mass that it accelerates is that of the particles "
                   "alone: leave out the effects with an added mass";
    return NULL;
}

static int validate_check_stress(const struct settings *s)
{
    const char *const why =
        s->effects.particle_stress ? validate_beside_stress(s) : NULL;

    return why == NULL ? 0
                       : settings_wrong(s, KEY_OF(s, effects.particle_stress),
                                        "%s", why);
}

static int validate_check_particles(struct settings *s)
{
    const int bed = s->particles.has_bed, place = s->particles.has_place;
    int code = check_integrator(s);

    if (code == 0) code = case_clumps_check(s);
    if (code == 0) code = case_materials_check(s);
    if (code == 0) code = case_surfaces_check(s);
    if (code == 0) code = case_materials_check_attractions(s);
    if (code == 0) code = case_population_check(s);
    if (code == 0) code = validate_check_list(s);
    if (code == 0) code = validate_check_stress(s);
    if (code != 0) return code;
    if (bed == place && (bed || !s->particles.has_insert))
        return settings_wrong(s, "particles", "give either bed or place%s",
                              bed ? ", not both" : ", or insert");
    code = bed ? check_bed_sizes(s) : validate_check_place(s);
    if (code == 0 && bed) code = check_bed_fits(s);
    return code != 0 ? code : case_materials_check_pairs(s);
}

/* An average over more than that many lengths of the mesh is the same
 * everywhere, and images of images would be added up for ever [-]. */
static const double most_lengths = 10.0, most_widths = 100.0;

/* The cells of a second grid, at most [-]. */
static const double most_cells = 1e8;

static const int most_regions = 32; /* [-] */

/* The longest and the shortest side of the box around the mesh [m]. */
static void sides(const struct settings *s, double *longest, double *shortest)
{
    double lo[3], hi[3];

    case_mesh_ends(s, lo, hi);
    *longest = 0.0;
    *shortest = HUGE_VAL;
    for (int k = 0; k < 3; k++) {
        *longest = fmax(*longest, hi[k] - lo[k]);
        *shortest = fmin(*shortest, hi[k] - lo[k]);
    }
}

static int check_width(const struct settings *s, const char *key, double b)
{
    double longest, shortest;

    sides(s, &longest, &shortest);
    if (b > most_lengths * longest)
        return settings_wrong(
            s, key,
            "%g m is more than %g times the mesh, which is %g m long: the "
            "average would be the same everywhere",
            b, most_lengths, longest);
    if (b > most_widths * shortest)
        return settings_wrong(
            s, key,
            "%g m is more than %g times the shortest side of the mesh, %g m", b,
            most_widths, shortest);
    return 0;
}

static int check_widths(const struct settings *s)
{
    const struct averaging_options *const o = &s->averaging;
    int code = check_width(s, KEY_OF(s, averaging.bandwidth), o->bandwidth);

    if (code == 0)
        code = check_width(s, KEY_OF(s, averaging.delta_05), o->delta_05);
    for (int i = 0; i < o->regions.n && code == 0; i++)
        code = check_width(s, KEY_OF(s, averaging.regions),
                           o->regions.item[i].bandwidth);
    return code;
}

/* A second grid is as fine as its bandwidth. */
static int check_second_grid(const struct settings *s)
{
    const double b = s->averaging.bandwidth;
    double lo[3], hi[3], cells = 1.0;

    if (!s->averaging.method->has_own_grid) return 0;
    case_mesh_ends(s, lo, hi);
    for (int k = 0; k < 3; k++)
        cells *= fmax(1.0, floor((hi[k] - lo[k]) / b));
    if (cells <= most_cells) return 0;
    return settings_wrong(
        s, KEY_OF(s, averaging.bandwidth),
        "a second grid of cells of %g m would have %.3g of them; at most %g", b,
        cells, most_cells);
}

/* A slope needs cells on both sides of the particle. */
static int check_gradient_bandwidth(const struct settings *s)
{
    const double b = s->averaging.gradient_bandwidth;

    if (b == 0.0) return 0;
    struct mesh *const m = case_mesh_outline(s);
    const double widest = mesh_widest_link(m);
    mesh_free(m);
    if (b >= widest * (1.0 - 1e-9))
        return check_width(s, KEY_OF(s, averaging.gradient_bandwidth), b);
    return settings_wrong(
        s, KEY_OF(s, averaging.gradient_bandwidth),
        "%g m is less than the widest cell, %g m: too few cells for a slope", b,
        widest);
}

static int case_averaging_check_given(const struct settings *s)
{
    const struct averaging_options *const o = &s->averaging;
    const int b = o->bandwidth > 0.0, delta = o->delta_05 > 0.0;

    if (delta && model_choice_refuse_unread(s, "averaging",
                                            KEY_OF(s, averaging.delta_05)) != 0)
        return 2;
    if (o->regions.n > most_regions)
        return settings_wrong(s, KEY_OF(s, averaging.regions), "%d at most",
                              most_regions);
    if (b && delta)
        return settings_wrong(s, KEY_OF(s, averaging.delta_05),
                              "give either bandwidth or delta_05, not both");
    if (o->method->needs_bandwidth && !b && !delta)
        return settings_wrong(s, KEY_OF(s, averaging.method),
                              "%s needs averaging.bandwidth", o->method->name);
    return 0;
}

static int case_averaging_check(const struct settings *s)
{
    int code = case_averaging_check_given(s);

    if (code == 0) code = check_widths(s);
    if (code == 0) code = check_gradient_bandwidth(s);
    return code != 0 ? code : check_second_grid(s);
}

int validate_case(struct settings *s)
{
    int code = 0;

    if (!s->has.fluid && !s->has.particles)
        return settings_wrong(
            s, "mesh",
            "there is neither fluid nor particles: nothing to compute");
    const int is_auto = case_scales_is_auto(s);
    if (!is_auto) code = case_steps_check(s);
    if (code == 0 && s->has.fluid) code = check_fluid(s);
    if (code == 0) code = model_choice_check(s);
    if (code == 0 && s->has.particles) code = validate_check_particles(s);
    if (code == 0 && is_auto) code = case_scales_auto_step(s);
    if (code == 0 && is_auto) code = case_steps_check(s);
    if (code == 0 && s->has.averaging) code = case_averaging_check(s);
    if (code == 0) code = processes_check(s);
    if (code == 0) code = case_bodies_check(s);
    return code != 0 ? code : output_check(s);
}
