/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_materials.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "case/schema.h"

static const char first[] = "grains", list[] = "particles.materials",
                  pairs[] = "particles.pairs",
                  wall[] = "particles.walls.material",
                  of_grains[] = "particles.grains.";

/* A number of a material, 0 if not given; number 0 is a group of its own. */
static double case_materials_value(const struct settings *s, int number,
                                   const char *key)
{
    char path[64];

    if (number > 0) return settings_item_real_or(s, list, number - 1, key, 0.0);
    snprintf(path, sizeof path, "particles.%s.%s", first, key);
    return settings_real_or(s, path, 0.0);
}

int case_materials_number(const struct settings *s, const char *name)
{
    if (strcmp(name, first) == 0) return 0;
    const int k = settings_item_named(s, list, name);
    return k < 0 ? -1 : k + 1;
}

/* The numbers of the keys that the contact law alone reads (contact.h). */
static void read_own(const struct settings *s, int number, double *own)
{
    const struct key *k =
        contact_law_named(settings_text(s, "particles.contact"))->own_keys;

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
    struct material m = {
        .young = case_materials_value(s, number, "young"),
        .poisson = case_materials_value(s, number, "poisson"),
        .stiffness = case_materials_value(s, number, "stiffness"),
        .tangential = case_materials_value(s, number, "tangential_ratio"),
        .restitution = case_materials_value(s, number, "restitution"),
        .friction = case_materials_value(s, number, "friction"),
        .rolling = case_materials_value(s, number, "rolling_friction"),
        .charge = case_materials_value(s, number, "charge")};

    read_own(s, number, m.own);
    return m;
}

double case_materials_density(const struct settings *s, int number)
{
    return case_materials_value(s, number, "density");
}

static int number_in_pair(const struct settings *s, int k, const char *key)
{
    return case_materials_number(s, settings_item_text(s, pairs, k, key));
}

struct materials_measured case_materials_pair(const struct settings *s, int k)
{
    return (struct materials_measured){
        .a = number_in_pair(s, k, "between"),
        .b = number_in_pair(s, k, "and"),
        .stiffness = settings_item_real_or(s, pairs, k, "stiffness", -1.0),
        .tangential =
            settings_item_real_or(s, pairs, k, "tangential_ratio", -1.0),
        .restitution = settings_item_real_or(s, pairs, k, "restitution", -1.0),
        .friction = settings_item_real_or(s, pairs, k, "friction", -1.0),
        .rolling =
            settings_item_real_or(s, pairs, k, "rolling_friction", -1.0)};
}

/* One block: the struct, the materials, the pairs. */
struct materials *case_materials_create(const struct settings *s)
{
    const int n = settings_length(s, list), m = settings_length(s, pairs);
    struct materials *all;
    struct material *further;
    struct materials_measured *taken;

    if (n == 0) return NULL;
    all = alloc_zeroed(1, sizeof *all + (size_t)n * sizeof *further +
                              (size_t)m * sizeof *taken);
    further = (struct material *)(all + 1);
    taken = (struct materials_measured *)(further + n);
    for (int k = 0; k < n; k++)
        further[k] = case_materials_one(s, k + 1);
    for (int k = 0; k < m; k++)
        taken[k] = case_materials_pair(s, k);
    *all = (struct materials){n + 1, further, m, taken, 0};
    if (settings_has(s, wall))
        all->wall = case_materials_number(s, settings_text(s, wall));
    return all;
}
