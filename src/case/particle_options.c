/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/particle_options.h"

#include <string.h>

#include "dem/dem_method.h"
#include "case/case_materials.h"
#include "case/case_mesh.h"
#include "case/population/case_population.h"
#include "case/surfaces/surfaces_part.h"

struct dem_options particle_options_dem(const struct settings *s, double step)
{
    struct dem_options o = {
        .law = contact_law_named(settings_text(s, "particles.contact")),
        .material = case_materials_one(s, 0),
        .integrator =
            integrator_named(settings_text(s, "particles.integrator")),
        .method = dem_method_named(settings_text(s, "particles.list")),
        .step = step,
        .skin = settings_real_or(s, "particles.skin", 0.0)};

    settings_where(s, "mesh.periodic", o.where, sizeof o.where);
    case_mesh_ends(s, o.lo, o.hi);
    case_mesh_periodic(s, o.periodic);
    surfaces_part_dem_options(s, &o);
    return o;
}

struct bed_options particle_options_bed(const struct settings *s)
{
    struct bed_options b = {
        .count = settings_int(s, "particles.bed.count"),
        .diameter = settings_real_or(s, "particles.bed.diameter", 0.0),
        .density = settings_real(s, "particles.grains.density"),
        .seed = (unsigned long)settings_int(s, "particles.bed.seed"),
        .jitter = settings_real(s, "particles.bed.jitter"),
        .settle = settings_real(s, "particles.bed.settle")};
    settings_where(s, "particles.bed.count", b.where, sizeof b.where);

    case_population_bed_sizes(s, &b);
    memcpy(b.gravity, s->effects.gravity, sizeof b.gravity);
    return b;
}

void particle_options_release(struct bed_options *b)
{
    if (b->sizes != NULL) b->free_sizes(b->sizes);
    b->sizes = NULL;
}

double particle_options_wall_overlap(const struct settings *s)
{
    static const char key[] = "particles.overlaps";
    const int allowed =
        settings_has(s, key) && strcmp(settings_text(s, key), "allow") == 0;

    return allowed ? 0.5 : 0.01;
}
