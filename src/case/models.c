/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/models.h"

#include "averaging/averaging.h"
#include "averaging/diffusion.h"
#include "averaging/interpolation.h"
#include "coupling/coupling.h"
#include "coupling/effects.h"
#include "dem/dem_method.h"
#include "fluid/fluid.h"
#include "fluid/inlet_profile.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

const struct kind *const models_kinds[] = {&models_contact,
                                           &models_integrator,
                                           &models_list,
                                           &case_population_sizes,
                                           &case_surfaces_kind,
                                           &models_averaging,
                                           &models_scheme,
                                           &models_variation,
                                           &models_interpolation,
                                           &models_drag,
                                           &models_shape,
                                           &models_treatment,
                                           &models_slip_integration,
                                           &models_form,
                                           &models_direction,
                                           &models_time_scheme,
                                           &models_convection,
                                           &models_gradient,
                                           &models_continuity,
                                           &models_patch,
                                           &models_profile,
                                           &models_effect,
                                           &case_bodies_method,
                                           NULL};

MODELS_KIND(models_contact, contact_laws, "contact", "contact laws",
            "particles.contact", NULL)
MODELS_KIND(models_integrator, integrators, "integrator",
            "time integrators of the particles", "particles.integrator", NULL)
MODELS_KIND(models_list, dem_methods, "list", "methods to find contact pairs",
            "particles.list", NULL)
MODELS_KIND(models_averaging, averaging_methods, "averaging",
            "averaging methods, from particles to fields", "averaging.method",
            NULL)
MODELS_KIND(models_scheme, diffusion_schemes, "scheme",
            "schemes of the diffusion in pseudo-time", "averaging.scheme", NULL)
MODELS_KIND(models_variation, bandwidth_rules, "bandwidth_variation",
            "variations of the bandwidth", "averaging.bandwidth_variation",
            NULL)
MODELS_KIND(models_interpolation, interpolations, "interpolation",
            "interpolations, from fields to particles",
            "averaging.interpolation", "exchange")
MODELS_KIND(models_drag, drag_laws, "drag", "drag laws", "exchange.drag", NULL)
MODELS_KIND(models_shape, drag_shapes, "shape", "shapes of grains in the drag",
            "exchange.shape", NULL)
MODELS_KIND(models_treatment, coupling_treatments, "treatment",
            "treatments of the drag in the fluid", "exchange.treatment", NULL)
MODELS_KIND(models_slip_integration, coupling_slip_integrations,
            "slip_integration", "integrations of the drag over a sub-step",
            "exchange.slip_integration", NULL)
MODELS_KIND(models_form, coupling_forms, "model",
            "forms of the averaged momentum equation", "exchange.model", NULL)
MODELS_KIND(models_direction, coupling_directions, "coupling",
            "directions of the coupling", "exchange.coupling", NULL)
MODELS_KIND(models_time_scheme, time_schemes, "time",
            "time schemes of the fluid", "fluid.time", NULL)
MODELS_KIND(models_convection, convection_schemes, "convection",
            "convection schemes", "fluid.convection", NULL)
MODELS_KIND(models_gradient, velocity_gradient_schemes, "gradient",
            "gradient schemes of the velocity", "fluid.gradient", NULL)
MODELS_KIND(models_continuity, fluid_continuity_forms, "continuity",
            "forms of the mass balance", "fluid.continuity", NULL)
MODELS_KIND(models_patch, boundary_conditions, "patch",
            "boundary conditions on a side of the box", "fluid.<patch>", NULL)
MODELS_KIND(models_profile, inlet_profiles, "profile",
            "velocity profiles of an inlet", "fluid.<patch>.profile", "fluid")
MODELS_KIND(models_effect, effects, "effect",
            "further effects, each on where it is named", "effects", NULL)

const struct kind *models_kind(const char *name)
{
    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        if (strcmp((*k)->name, name) == 0) return *k;
    return NULL;
}

int models_tables(const struct key **tables, int max)
{
    struct model m;
    int n = 0;

    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        for (int i = 0; (*k)->model(i, &m); i++)
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

    return is_patch == (kind == &models_patch) &&
           (is_patch || key_matches(kind->key, key->path));
}

void models_words(const struct key *key, char *text, size_t size)
{
    struct model m;
    size_t used = 0;

    text[0] = '\0';
    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        for (int i = 0; is_chosen_by(*k, key) && (*k)->model(i, &m); i++) {
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
    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        for (int i = 0; models_reads(m, (*k)->key) && (*k)->model(i, &other);
             i++)
            if (models_reads(&other, path)) return 1;
    return 0;
}

int models_make_patch(int n, const char *const *name)
{
    struct model m;

    for (int i = 0; models_patch.model(i, &m); i++) {
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
