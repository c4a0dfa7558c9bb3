/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surfaces_part.c -- surfaces and prescribed particles as a part of a case. */
#include "case/surfaces/surfaces_part.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "case/case_mesh.h"
#include "case/checks/case_scales.h"
#include "base/text.h"
#include "case/models.h"
#include "case/surfaces/case_surfaces.h"
#include "case/surfaces/case_walls.h"
#include "dem/surfaces/surface_start.h"
#include "dem/surfaces/surfaces_checksum.h"

static const char surfaces[] = "particles.surfaces";
static const char unseen[] =
    "no walls for the fluid, which bodies and the patches of a mesh from files "
    "are";

/* 1 if there are surfaces in a fluid, which it does not see. */
static int are_unseen(const struct settings *s)
{
    return s->has.fluid && s->particles.surfaces.n > 0;
}

int surfaces_part_check(struct settings *s)
{
    const int code = case_surfaces_check(s);
    return code != 0 ? code : case_walls_check(s);
}

void surfaces_part_dem_options(const struct settings *s, struct dem_options *o)
{
    case_walls_ends(s, o->lo, o->hi);
    o->n_surfaces = case_surfaces_count(s);
    o->n_prescribed = s->particles.prescribed.n;
}

/* --- what `winnow check` says of it --------------------------------------- */

/* In a step a wall should move by a small part of a diameter, as particles do.
 */
static void print_speed(double speed, const struct case_scales *k)
{
    text_line("highest speed", speed, "m/s", "of any point of them in the box");
    if (k->particles > 0 && speed > 0.0)
        text_line("its path in a particle step / d", speed * k->dem_dt / k->d,
                  "-", "of the smallest particle");
}

void surfaces_part_print(const struct settings *s, const struct case_scales *k)
{
    const int n = case_surfaces_count(s);
    double lo[3], hi[3], speed = 0.0;
    int triangles = 0;

    if (!s->has.particles) return; /* nothing meets them */
    struct surface *const made = case_surfaces_create(s);
    if (made == NULL) return;
    case_mesh_ends(s, lo, hi);
    for (int i = 0; i < n; i++) {
        const double reach = surface_reach(&made[i], lo, hi);
        if (made[i].triangles != NULL) triangles += made[i].triangles->n;
        speed = fmax(speed, motion_speed(&made[i].motion, reach));
    }
    puts("Walls besides the box");
    text_line("surfaces", n, "-", are_unseen(s) ? unseen : "");
    text_line("triangles", triangles, "-", "");
    print_speed(speed, k);
    case_surfaces_free(made, n);
}

/* --- in a simulation ------------------------------------------------------ */

static int surfaces_part_has_room(const void *state, const double x[3],
                                  double R)
{
    const struct simulation *const sim = state;
    return case_walls_has_room(sim->walls, x, R);
}

static int start_wrong(const void *state, const struct particles *ps)
{
    const struct simulation *const sim = state;
    return surface_start_wrong(ps, sim->surfaces, sim->n_surfaces, "");
}

static void surfaces_part_take_names(struct simulation *sim)
{
    sim->surface_names =
        alloc_zeroed((size_t)sim->n_surfaces, sizeof *sim->surface_names);
    for (int i = 0; i < sim->n_surfaces; i++)
        sim->surface_names[i] = sim->surfaces[i].name;
}

void surfaces_part_complete(const struct settings *s, struct simulation *sim,
                            struct dem_options *o)
{
    o->prescribed = sim->prescribed = case_surfaces_create_prescribed(s);
    o->surfaces = sim->surfaces = case_surfaces_create(s);
    sim->n_surfaces = o->n_surfaces;
    surfaces_part_take_names(sim);
    sim->walls = case_walls_create(
        s, case_walls_count(s) > 0 ? &sim->surfaces[o->n_surfaces - 1] : NULL);
    o->surfaces_checksum = surfaces_checksum(o);
    sim->region = (struct placement_region){
        .has_room = sim->walls != NULL ? surfaces_part_has_room : NULL,
        .start_wrong = start_wrong,
        .state = sim};
}

void surfaces_part_free(struct simulation *sim)
{
    case_surfaces_free(sim->surfaces, sim->n_surfaces);
    free(sim->surface_names);
    free(sim->prescribed);
    case_walls_free(sim->walls);
}

/* Placed spheres may overlap a surface only where the case allows it. */
int surfaces_part_place(const struct settings *s, struct particles *ps,
                        const struct dem_options *o)
{
    char where[SETTINGS_PATH];

    if (strcmp(s->particles.overlaps, "allow") == 0) return 0;
    settings_where(s, surfaces, where, sizeof where);
    return surface_start_wrong(ps, o->surfaces, o->n_surfaces, where) != 0 ? 2
                                                                           : 0;
}

/* Prescribed particles must exist. */
int surfaces_part_add(const struct settings *s, struct simulation *sim)
{
    static const char list[] = "particles.prescribed";
    if (are_unseen(s) && !settings_quiet(s))
        fprintf(stderr, "%s: %s\n", surfaces, unseen);
    const int n =
        s->particles.has_bed ? s->particles.bed.count : sim->particles->n;

    for (int k = 0; k < s->particles.prescribed.n; k++) {
        const int id = s->particles.prescribed.item[k].of.id;
        if (n == 0)
            return settings_wrong(s, list,
                                  "there is no particle %d: there is none at "
                                  "the start",
                                  id);
        if (id >= n)
            return settings_wrong(s, list,
                                  "there is no particle %d: they are 0 to %d",
                                  id, n - 1);
    }
    return 0;
}

MODELS_KIND(surfaces_part_kind, surface_shapes, "surface",
            "walls besides those of the box", "particles.surfaces.shape", NULL)
