/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/particles/case_cohesion.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "coupling/effects.h"
#include "case/particles/case_materials.h"
#include "case/checks/case_scales.h"
#include "case/checks/case_memory.h"
#include "case/fill.h"

/* charge: room for one of each material. */
static struct attraction_scene scene_of(const struct settings *s,
                                        double *charge)
{
    struct attraction_scene scene = {.charge = charge};

    for (int k = 0; k <= s->particles.materials.n; k++) {
        charge[k] = case_materials_setup(s, k)->of.charge;
        scene.charged |= charge[k] != 0.0;
    }
    if (s->has.fluid) scene.viscosity = s->fluid.mu;
    return scene;
}

static int is_attraction(const struct settings *s, const struct effect *e)
{
    return e->attraction != NULL && settings_has(s, e->keys[0]->path);
}

/* One block: the attractions, then the charges of the materials. */
struct attraction *case_cohesion_create(const struct settings *s, int *n)
{
    double numbers[EFFECT_NUMBERS];

    *n = 0;
    for (int k = 0; effects[k] != NULL; k++)
        *n += is_attraction(s, effects[k]);
    if (*n == 0) return NULL;
    struct attraction *const all = alloc_zeroed(
        1, (size_t)*n * sizeof *all +
               (size_t)(1 + s->particles.materials.n) * sizeof(double));
    const struct attraction_scene scene = scene_of(s, (double *)(all + *n));
    for (int k = 0, i = 0; effects[k] != NULL; k++) {
        if (!is_attraction(s, effects[k])) continue;
        fill_effect_numbers(s, effects[k], numbers);
        all[i++] = effects[k]->attraction(numbers, &scene);
    }
    return all;
}

int case_cohesion_check(const struct settings *s)
{
    double *const charge = alloc_doubles((1 + s->particles.materials.n));
    const struct attraction_scene scene = scene_of(s, charge);
    double numbers[EFFECT_NUMBERS];
    int code = 0;

    for (int k = 0; effects[k] != NULL && code == 0; k++) {
        const struct effect *const e = effects[k];
        if (e->wrong == NULL || !fill_effect_numbers(s, e, numbers)) continue;
        const char *const why = e->wrong(numbers, &scene);
        if (why != NULL) code = settings_wrong(s, e->keys[0]->path, "%s", why);
    }
    free(charge);
    return code;
}

int case_cohesion_complete(const struct settings *s, struct simulation *sim,
                           struct dem_options *o)
{
    o->attractions = sim->attractions =
        case_cohesion_create(s, &o->n_attractions);
    return 0;
}

const char *case_cohesion_of_box(const struct settings *s)
{
    return s->effects.van_der_waals ? KEY_OF(s, effects.van_der_waals)
           : s->effects.capillary   ? KEY_OF(s, effects.capillary)
                                    : NULL;
}

void case_cohesion_free(struct simulation *sim)
{
    free(sim->attractions);
}

/* The pairs of a list grow with the cube of its gap: a skin or a range as wide
 * as the box would list each particle with all others. As many as fit around
 * one in a bed at rest are counted, at most all. */
int case_cohesion_check_pairs(const struct settings *s)
{
    static const double packed = 0.64;
    const struct case_scales k = case_scales_of(s);
    char key[64] = "";
    const double skin = s->particles.skin;
    double range = 0.0;
    int n;
    struct attraction *const all = case_cohesion_create(s, &n);

    for (int i = 0; i < n; i++) {
        if (all[i].range > fmax(range, skin))
            snprintf(key, sizeof key, "effects.%s.range", all[i].law->name);
        range = fmax(range, all[i].range);
    }
    free(all);
    if (skin + range == 0.0 || s->particles.list->no_contacts) return 0;
    const double apart = (k.d_most + skin + range) / k.d;
    const double around = fmin(k.particles, 8.0 * packed * gsl_pow_3(apart));
    return case_memory_check_pairs(
        s, key[0] != '\0' ? key : KEY_OF(s, particles.skin),
        0.5 * k.particles * around);
}
