/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/models.h"

#include "averaging/averaging.h"
#include "averaging/diffusion.h"
#include "averaging/interpolation.h"
#include "coupling/coupling.h"
#include "coupling/effects.h"
#include "dem/dem_method.h"
#include "dem/population/sizes.h"
#include "dem/surfaces/surface.h"
#include "fluid/fluid.h"
#include "fluid/inlet_profile.h"
#include "resolved/solid_bodies.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

const struct kind models_kinds[] = {
    {"contact", "contact laws", "particles.contact", NULL, contact_laws},
    {"integrator", "time integrators of the particles", "particles.integrator",
     NULL, integrators},
    {"list", "methods to find contact pairs", "particles.list", NULL,
     dem_methods},
    {"sizes", "distributions of diameters", "particles.sizes.distribution",
     NULL, sizes_laws},
    {"surface", "walls besides those of the box", "particles.surfaces.shape",
     NULL, surface_shapes},
    {"averaging", "averaging methods, from particles to fields",
     "averaging.method", NULL, averaging_methods},
    {"scheme", "schemes of the diffusion in pseudo-time", "averaging.scheme",
     NULL, diffusion_schemes},
    {"bandwidth_variation", "variations of the bandwidth",
     "averaging.bandwidth_variation", NULL, bandwidth_rules},
    {"interpolation", "interpolations, from fields to particles",
     "averaging.interpolation", "exchange", interpolations},
    {"drag", "drag laws", "exchange.drag", NULL, drag_laws},
    {"shape", "shapes of grains in the drag", "exchange.shape", NULL,
     drag_shapes},
    {"treatment", "treatments of the drag in the fluid", "exchange.treatment",
     NULL, coupling_treatments},
    {"slip_integration", "integrations of the drag over a sub-step",
     "exchange.slip_integration", NULL, coupling_slip_integrations},
    {"model", "forms of the averaged momentum equation", "exchange.model", NULL,
     coupling_forms},
    {"coupling", "directions of the coupling", "exchange.coupling", NULL,
     coupling_directions},
    {"time", "time schemes of the fluid", "fluid.time", NULL, time_schemes},
    {"convection", "convection schemes", "fluid.convection", NULL,
     convection_schemes},
    {"gradient", "gradient schemes of the velocity", "fluid.gradient", NULL,
     velocity_gradient_schemes},
    {"continuity", "forms of the mass balance", "fluid.continuity", NULL,
     fluid_continuity_forms},
    {"patch", "boundary conditions on a side of the box", "fluid.<patch>", NULL,
     boundary_conditions},
    {"profile", "velocity profiles of an inlet", "fluid.<patch>.profile",
     "fluid", inlet_profiles},
    {"effect", "further effects, each on where it is named", "effects", NULL,
     effects},
    {"body_method", "ways that bodies hold the fluid", "bodies.method", NULL,
     solid_bodies_methods},
    {NULL, NULL, NULL, NULL, NULL}};

/* The first members of each descriptor are those of a model. */
int models_at(const struct kind *kind, int i, struct model *m)
{
    const void *const *const list = kind->list;

    for (int k = 0; k <= i; k++)
        if (list[k] == NULL) return 0;
    memcpy(m, list[i], offsetof(struct model, value));
    return 1;
}

const struct kind *models_kind(const char *name)
{
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        if (strcmp(k->name, name) == 0) return k;
    return NULL;
}

int models_tables(const struct key **tables, int max)
{
    struct model m;
    int n = 0;

    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; models_at(k, i, &m); i++)
            for (int t = 0; t < KEY_TABLES && m.keys[t] != NULL; t++) {
                int known = 0;
                for (int j = 0; j < n && j < max; j++)
                    known |= tables[j] == m.keys[t];
                if (!known && n < max) tables[n] = m.keys[t];
                n += !known;
            }
    return n;
}

int models_reads(const struct model *m, const char *path)
{
    for (int t = 0; t < KEY_TABLES && m->keys[t] != NULL; t++)
        for (const struct key *k = m->keys[t]; k->path != NULL; k++)
            if (strcmp(k->path, path) == 0) return 1;
    return 0;
}

/* "fluid.<patch>" itself is no pattern: the other keys of the fluid match it.
 */
static int is_chosen_by(const struct kind *kind, const struct key *key)
{
    const int is_patch = key->type == KEY_PATCH;

    return is_patch == (kind->list == boundary_conditions) &&
           (is_patch || key_matches(kind->key, key->path));
}

void models_words(const struct key *key, char *text, size_t size)
{
    struct model m;
    size_t used = 0;

    text[0] = '\0';
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; is_chosen_by(k, key) && models_at(k, i, &m); i++) {
            if (key->type == KEY_PATCH && m.keys[0] != NULL) continue;
            const int wrote = snprintf(text + used, size - used, "%s%s",
                                       used > 0 ? " | " : "", m.name);
            used += (size_t)wrote;
            assert(used < size);
        }
}

int models_value(const struct model *const *choices, const char *name)
{
    while (strcmp((*choices)->name, name) != 0)
        choices++;
    return (*choices)->value;
}

/* 1 if the model, or one that a key of it chooses, has that key of a patch. */
static int patch_reads(const struct model *m, const char *name)
{
    char path[128];
    struct model other;

    snprintf(path, sizeof path, "fluid." KEY_ANY_PATCH ".%s", name);
    if (models_reads(m, path)) return 1;
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; models_reads(m, k->key) && models_at(k, i, &other); i++)
            if (models_reads(&other, path)) return 1;
    return 0;
}

int models_make_patch(int n, const char *const *name)
{
    const struct kind *const patch = models_kind("patch");
    struct model m;

    for (int i = 0; models_at(patch, i, &m); i++) {
        int first = 0, others = 0;
        if (m.keys[0] == NULL) continue;
        const char *const own = strrchr(m.keys[0][0].path, '.') + 1;
        for (int k = 0; k < n; k++)
            if (strcmp(name[k], own) == 0)
                first++;
            else
                others += patch_reads(&m, name[k]);
        if (first == 1 && first + others == n) return 1;
    }
    return 0;
}
