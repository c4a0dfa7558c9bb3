/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/simulation.h"

const struct effect *effects_named(const char *name)
{
    for (const struct effect *const *e = effects; *e != NULL; e++)
        if (strcmp((*e)->name, name) == 0) return *e;
    return NULL;
}

void effects_add(struct simulation *sim, const struct effect *e, void *memory)
{
    const size_t n = (size_t)sim->n_effects;
    struct effect_state *const more = alloc_zeroed(n + 1, sizeof *more);

    if (n > 0) memcpy(more, sim->effects, n * sizeof *more);
    free(sim->effects);
    sim->effects = more;
    sim->effects[sim->n_effects++] = (struct effect_state){e, memory};
}

void *effects_memory(const struct simulation *sim, const struct effect *e)
{
    for (int i = 0; i < sim->n_effects; i++)
        if (sim->effects[i].effect == e) return sim->effects[i].memory;
    return NULL;
}
