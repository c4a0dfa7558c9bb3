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
    struct dem_options o = {.law = s->particles.contact,
                            .material = case_materials_one(s, 0),
                            .integrator = s->particles.integrator,
                            .method = s->particles.list,
                            .step = step,
                            .skin = s->particles.skin};

    settings_where(s, "mesh.periodic", o.where, sizeof o.where);
    case_mesh_ends(s, o.lo, o.hi);
    case_mesh_periodic(s, o.periodic);
    surfaces_part_dem_options(s, &o);
    return o;
}

struct bed_options particle_options_bed(const struct settings *s)
{
    struct bed_options b = s->particles.bed;

    b.density = s->particles.grains.density;
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
    return strcmp(s->particles.overlaps, "allow") == 0 ? 0.5 : 0.01;
}
