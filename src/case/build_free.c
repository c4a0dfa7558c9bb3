/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build_free.h"

#include <stdlib.h>

#include "coupling/coupling.h"
#include "coupling/processes.h"
#include "case/build_boundaries.h"
#include "case/cohesion/case_cohesion.h"
#include "case/surfaces/surfaces_part.h"

void build_free(struct simulation *sim)
{
    if (sim == NULL) return;
    if (sim->processes != NULL) sim->processes->free(sim->processes);
    for (int i = 0; i < sim->n_effects; i++)
        if (sim->effects[i].effect->free != NULL)
            sim->effects[i].effect->free(sim->effects[i].memory);
    free(sim->effects);
    coupling_free(sim->coupling);
    averaging_free(sim->averaging);
    dem_free(sim->dem);
    surfaces_part_free(sim);
    case_cohesion_free(sim);
    if (sim->population != NULL) sim->insert_remove->free(sim->population);
    free(sim->materials);
    particles_free(sim->particles);
    fluid_free(sim->fluid);
    build_boundaries_free(sim->boundaries,
                          sim->mesh != NULL ? sim->mesh->n_patches : 0);
    free(sim->held_force);
    mesh_free(sim->mesh);
    free(sim);
}
