/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/particles/case_materials.h"
#include "case/particles/case_population.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "case/checks/checks.h"
#include "case/settings.h"
#include "base/text.h"
#include "case/schema.h"
#include "coupling/effects.h"

static const char list[] = "particles.materials", pairs[] = "particles.pairs",
                  of_grains[] = "particles.grains.";

const struct material_setup *case_materials_setup(const struct settings *s,
                                                  int number)
{
    return number <= 0 ? &s->particles.grains
                       : &s->particles.materials.item[number - 1];
}

int case_materials_number(const struct settings *s, const char *name)
{
    if (name == NULL || strcmp(name, "grains") == 0) return 0;
    for (int k = 0; k < s->particles.materials.n; k++)
        if (strcmp(name, s->particles.materials.item[k].name) == 0)
            return k + 1;
    return -1;
}

/* The numbers of the keys that the contact law alone reads (contact.h). */
static void read_own(const struct settings *s, int number, double *own)
{
    const struct key *k = s->particles.contact->own_keys;

    for (int n = 0; k != NULL && k->path != NULL && n < MODEL_NUMBERS; k++) {
        const char *const name = strrchr(k->path, '.') + 1;

        if (strncmp(k->path, of_grains, strlen(of_grains)) != 0) continue;
        if (!schema_is_required(k) || settings_has(s, k->path))
            own[n] = settings_real(s, k->path);
        if (number > 0 && settings_item_is_set(s, list, number - 1, name))
            own[n] = settings_item_real(s, list, number - 1, name);
        n++;
    }
}

struct material case_materials_one(const struct settings *s, int number)
{
    struct material m = case_materials_setup(s, number)->of;

    read_own(s, number, m.own);
    m.restitution = case_parcels_restitution(s, m.restitution);
    return m;
}

/* The value that a case gives, or -1, which says that it gives none. */
static double measured(int given, double value)
{
    return given ? value : -1.0;
}

/* The measured properties of the k-th pair of materials. */
static struct materials_measured case_materials_pair(const struct settings *s,
                                                     int k)
{
    const struct pair_setup *const p = &s->particles.pairs.item[k];

    return (struct materials_measured){
        .a = case_materials_number(s, p->between),
        .b = case_materials_number(s, p->and),
        .stiffness = measured(p->of.stiffness > 0.0, p->of.stiffness),
        .tangential = measured(p->of.tangential > 0.0, p->of.tangential),
        .restitution = measured(p->has_restitution,
                                case_parcels_restitution(s, p->of.restitution)),
        .friction = measured(p->has_friction, p->of.friction),
        .rolling = measured(p->has_rolling, p->of.rolling)};
}

/* Where parcels lose what their grains would, the walls are of materials of
 * their own, with e as it is: behind all others, in the same order. */
int case_materials_total(const struct settings *s)
{
    const int n = 1 + s->particles.materials.n;
    return case_parcels_keep_dissipation(s) ? 2 * n : n;
}

int case_materials_of_wall(const struct settings *s, const char *name)
{
    return case_materials_number(s, name) + case_materials_total(s) - 1 -
           s->particles.materials.n;
}

/* Of pairs of a particle with a wall: e of the case, and what it says that was
 * measured. How many; taken: room for n^2 + 2 m. */
static int pairs_with_walls(const struct settings *s,
                            struct materials_measured *taken)
{
    const int n = 1 + s->particles.materials.n, m = s->particles.pairs.n;

    for (int k = 0; k < n * n; k++)
        taken[k] = (struct materials_measured){
            k / n,
            n + k % n,
            -1.0,
            -1.0,
            fmin(case_materials_setup(s, k / n)->of.restitution,
                 case_materials_setup(s, k % n)->of.restitution),
            -1.0,
            -1.0};
    for (int k = 0; k < 2 * m; k++) {
        const struct pair_setup *const p = &s->particles.pairs.item[k / 2];
        struct materials_measured one = case_materials_pair(s, k / 2);
        const int a = one.a, b = one.b;
        one.a = k % 2 ? a : b;
        one.b = n + (k % 2 ? b : a);
        one.restitution = measured(p->has_restitution, p->of.restitution);
        taken[n * n + k] = one;
    }
    return n * n + 2 * m;
}

/* One block: the struct, the materials, the pairs. */
struct materials *case_materials_create(const struct settings *s)
{
    const int n = 1 + s->particles.materials.n, m = s->particles.pairs.n;
    const int total = case_materials_total(s);
    struct materials *all;
    struct material *further;
    struct materials_measured *taken;

    if (total == 1) return NULL;
    all = alloc_zeroed(1, sizeof *all + (size_t)total * sizeof *further +
                              (size_t)(3 * m + n * n) * sizeof *taken);
    further = (struct material *)(all + 1);
    taken = (struct materials_measured *)(further + total);
    for (int k = 1; k < total; k++)
        further[k - 1] = case_materials_one(s, k % n);
    for (int k = 0; k < m; k++)
        taken[k] = case_materials_pair(s, k);
    *all = (struct materials){total, further, m, taken,
                              case_materials_of_wall(s, s->particles.walls)};
    if (total > n) all->n_measured += pairs_with_walls(s, &taken[m]);
    return all;
}

/* --- checks --------------------------------------------------------------- */

int case_materials_check_name(const struct settings *s, const char *path,
                              const char *name)
{
    struct nearest n;
    char hint[NEAREST_HINT];

    if (case_materials_number(s, name) >= 0) return 0;
    nearest_init(&n, name);
    nearest_offer(&n, "grains");
    for (int k = 0; k < s->particles.materials.n; k++)
        nearest_offer(&n, s->particles.materials.item[k].name);
    return settings_wrong(
        s, path, "no material %s%s", name,
        nearest_hint(nearest_best(&n),
                     ": there are grains and the names in particles.materials",
                     hint));
}

int case_materials_resist_rolling(const struct settings *s)
{
    if (!s->has.particles) return 0;
    const struct material zero = case_materials_one(s, 0);
    struct materials *const all = case_materials_create(s);
    const int rolls = materials_have_rolling(&zero, all);
    free(all);
    return rolls;
}

/* Names are used once. */
static int materials_check_one(const struct settings *s, int k)
{
    const char *const name = s->particles.materials.item[k].name;

    if (case_materials_number(s, name) != k + 1)
        return settings_wrong(s, list, "the name %s is given twice", name);
    return 0;
}

static int check_pair(const struct settings *s, int k)
{
    const struct pair_setup *const p = &s->particles.pairs.item[k];

    if (case_materials_check_name(s, pairs, p->between) != 0 ||
        case_materials_check_name(s, pairs, p->and) != 0)
        return 2;
    for (int i = 0; i < k; i++) {
        const struct materials_measured a = case_materials_pair(s, i),
                                        b = case_materials_pair(s, k);
        if ((a.a == b.a && a.b == b.b) || (a.a == b.b && a.b == b.a))
            return settings_wrong(s, pairs, "%s and %s are given twice",
                                  p->between, p->and);
    }
    return 0;
}

/* A sphere has the density of its material. */
static int materials_check_place(const struct settings *s, int i)
{
    static const char place[] = "particles.place";
    const char *const name = s->particles.place.item[i].material;

    if (case_materials_check_name(s, place, name) != 0) return 2;
    const int number = case_materials_number(s, name);
    if (case_materials_setup(s, number)->density > 0.0) return 0;
    return settings_wrong(
        s, place, "sphere %d is of %s, whose density [kg/m^3] is not given", i,
        name);
}

int case_materials_check(const struct settings *s)
{
    int code = 0;

    for (int k = 0; k < s->particles.materials.n && code == 0; k++)
        code = materials_check_one(s, k);
    for (int k = 0; k < s->particles.pairs.n && code == 0; k++)
        code = check_pair(s, k);
    for (int i = 0; i < s->particles.place.n && code == 0; i++)
        code = materials_check_place(s, i);
    return code != 0 ? code
                     : case_materials_check_name(s, KEY_OF(s, particles.walls),
                                                 s->particles.walls);
}

/* --- attractions ---------------------------------------------------------- */

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
struct attraction *case_materials_attractions(const struct settings *s, int *n)
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
        all[i] = effects[k]->attraction(numbers, &scene);
        case_parcels_attraction(s, &all[i++]);
    }
    return all;
}

int case_materials_check_attractions(const struct settings *s)
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

const char *case_materials_attraction_of_box(const struct settings *s)
{
    return s->effects.van_der_waals ? KEY_OF(s, effects.van_der_waals)
           : s->effects.capillary   ? KEY_OF(s, effects.capillary)
                                    : NULL;
}

/* The pairs of a list grow with the cube of its gap: a skin or a range as wide
 * as the box would list each particle with all others. As many as fit around
 * one in a bed at rest are counted, at most all. */
int case_materials_check_pairs(const struct settings *s)
{
    static const double packed = 0.64;
    const struct case_scales k = case_scales_of(s);
    char key[64] = "";
    const double skin = s->particles.skin;
    double range = 0.0;
    int n;
    struct attraction *const all = case_materials_attractions(s, &n);

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
