/* SPDX-License-Identifier: GPL-3.0-or-later */
/* forces_check.c -- what a case says in output.forces, checked. */
#include "case/forces/forces.h"

#include <stdio.h>
#include <string.h>

#include "base/vector.h"
#include "case/particles/case_surfaces.h"

static const char list[] = "output.forces";

/* 1 if a surface of the grains has this name. */
static int is_surface(const struct settings *s, const char *name)
{
    if (!s->has.particles) return 0;
    int is = case_walls_count(s) > 0 && strcmp(name, case_walls_name) == 0;

    for (int k = 0; k < s->particles.surfaces.n; k++)
        is |= strcmp(s->particles.surfaces.item[k].of.name, name) == 0;
    return is;
}

/* A list of names where each one is of a surface. */
static int check_surfaces(const struct settings *s,
                          const struct output_force *o)
{
    const char *text = o->surfaces;
    char word[FORCES_NAME];
    int used;

    if (text[strspn(text, " ")] == '\0')
        return settings_wrong(s, list, "surfaces is empty; name some");
    for (; !is_surface(s, text) && sscanf(text, " %63[^ ]%n", word, &used) == 1;
         text += used)
        if (!is_surface(s, word))
            return settings_wrong(s, list,
                                  "there is no surface %s in "
                                  "particles.surfaces",
                                  word);
    if (o->patches == NULL && o->velocity > 0.0)
        return settings_wrong(s, list,
                              "coefficients are of the fluid's force on "
                              "patches; leave out velocity");
    return 0;
}

/* A list of names where each one is of the mesh. */
static int check_patches(const struct settings *s, const char *text)
{
    char word[FORCES_NAME];
    int used;

    if (text[strspn(text, " ")] == '\0')
        return settings_wrong(s, list,
                              "patches is empty; name some, or leave "
                              "it out for all walls");
    for (; sscanf(text, " %63[^ ]%n", word, &used) == 1; text += used)
        if (settings_side(s, word) == NULL && is_surface(s, word))
            return settings_wrong(
                s, list,
                "%s is a surface, on which the fluid does not act: surfaces = "
                "\"%s\" gives the force of the grains on it",
                word, word);
        else if (settings_side(s, word) == NULL)
            return settings_wrong(
                s, list,
                "there is no patch %s, or it has no boundary condition", word);
        else if (forces_is_open(s, word))
            return settings_wrong(s, list,
                                  "the fluid flows through the patch %s; "
                                  "forces are those on walls",
                                  word);
    return 0;
}

void forces_name(const struct output_force *o, char name[FORCES_NAME])
{
    snprintf(name, FORCES_NAME, "%s",
             o->name != NULL       ? o->name
             : o->patches != NULL  ? o->patches
             : o->surfaces != NULL ? o->surfaces
                                   : "walls");
}

/* Two rows of the same name would have the same columns. */
static int forces_check_name(const struct settings *s, int i)
{
    const struct output_force *const all = s->output.forces.item;
    char name[FORCES_NAME], other[FORCES_NAME];

    forces_name(&all[i], name);
    for (int k = 0; k < i; k++) {
        forces_name(&all[k], other);
        if (strcmp(name, other) == 0)
            return settings_wrong(s, list,
                                  "two have columns that begin with \"%s\"; "
                                  "give each a name of its own",
                                  name);
    }
    return 0;
}

static int check_directions(const struct settings *s,
                            const struct output_force *o)
{
    const char *const none = vector_length(o->drag) == 0.0   ? "drag"
                             : vector_length(o->lift) == 0.0 ? "lift"
                             : vector_length(o->axis) == 0.0 ? "axis"
                                                             : NULL;

    if (none == NULL) return 0;
    return settings_wrong(s, list, "%s: expected a direction, found [0, 0, 0]",
                          none);
}

int forces_check(const struct settings *s)
{
    for (int i = 0; i < s->output.forces.n; i++) {
        const struct output_force *const o = &s->output.forces.item[i];
        const int U = o->velocity > 0.0, A = o->area > 0.0;
        const int surfaces = o->surfaces != NULL, patches = o->patches != NULL;
        if (surfaces && check_surfaces(s, o) != 0) return 2;
        if ((patches || !surfaces) && !s->has.fluid)
            return settings_wrong(
                s, list,
                "the forces on patches need fluid, which the case does not "
                "have; those of the grains on surfaces are written with "
                "surfaces = \"...\"");
        if (patches && check_patches(s, o->patches) != 0) return 2;
        if (U != A || (o->length > 0.0 && !U))
            return settings_wrong(s, list,
                                  "coefficients need velocity and area, and "
                                  "that of the torque for length besides");
        if (forces_check_name(s, i) != 0 || check_directions(s, o) != 0)
            return 2;
    }
    return 0;
}
