/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/materials_check.h"

#include <stdlib.h>

#include "case/particles/case_materials.h"
#include "case/nearest.h"

static const char list[] = "particles.materials", pairs[] = "particles.pairs";

int materials_check_name(const struct settings *s, const char *path,
                         const char *name)
{
    struct nearest n;

    if (case_materials_number(s, name) >= 0) return 0;
    nearest_init(&n, name);
    nearest_offer(&n, "grains");
    for (int k = 0; k < s->particles.materials.n; k++)
        nearest_offer(&n, s->particles.materials.item[k].name);
    if (nearest_best(&n) == NULL)
        return settings_wrong(s, path,
                              "no material %s: there are %s and the names in "
                              "%s",
                              name, "grains", list);
    return settings_wrong(s, path, "no material %s; did you mean %s?", name,
                          nearest_best(&n));
}

int materials_check_rolling(const struct settings *s)
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

    if (materials_check_name(s, pairs, p->between) != 0 ||
        materials_check_name(s, pairs, p->and) != 0)
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

    if (materials_check_name(s, place, name) != 0) return 2;
    const int number = case_materials_number(s, name);
    if (case_materials_setup(s, number)->density > 0.0) return 0;
    return settings_wrong(s, place,
                          "sphere %d is of %s, whose density [kg/m^3] is not "
                          "given",
                          i, name);
}

int materials_check(const struct settings *s)
{
    int code = 0;

    for (int k = 0; k < s->particles.materials.n && code == 0; k++)
        code = materials_check_one(s, k);
    for (int k = 0; k < s->particles.pairs.n && code == 0; k++)
        code = check_pair(s, k);
    for (int i = 0; i < s->particles.place.n && code == 0; i++)
        code = materials_check_place(s, i);
    return code != 0 ? code
                     : materials_check_name(s, KEY_OF(s, particles.walls),
                                            s->particles.walls);
}
