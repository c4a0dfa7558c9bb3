/* SPDX-License-Identifier: GPL-3.0-or-later */
/* forces_check.c -- what a case says in output.forces, checked. */
#include "case/forces/forces.h"

#include <stdio.h>
#include <string.h>

#include "base/vector.h"
#include "case/surfaces/case_walls.h"

const char forces_list[] = "output.forces";

/* 1 if a surface of the grains has this name. */
static int is_surface(const struct settings *s, const char *name)
{
    static const char surfaces[] = "particles.surfaces";
    if (!settings_has(s, "particles")) return 0;
    int is = case_walls_count(s) > 0 && strcmp(name, case_walls_name) == 0;

    for (int k = 0; k < settings_length(s, surfaces); k++)
        is |= strcmp(settings_item_text(s, surfaces, k, "name"), name) == 0;
    return is;
}

/* A list of names where each one is of a surface. */
static int check_surfaces(const struct settings *s, int i)
{
    const char *text = settings_item_text(s, forces_list, i, "surfaces");
    char word[FORCES_NAME];
    int used;

    if (text[strspn(text, " ")] == '\0')
        return settings_wrong(s, forces_list, "surfaces is empty; name some");
    for (; !is_surface(s, text) && sscanf(text, " %63[^ ]%n", word, &used) == 1;
         text += used)
        if (!is_surface(s, word))
            return settings_wrong(s, forces_list,
                                  "there is no surface %s in "
                                  "particles.surfaces",
                                  word);
    if (!settings_item_has(s, forces_list, i, "patches") &&
        settings_item_has(s, forces_list, i, "velocity"))
        return settings_wrong(s, forces_list,
                              "coefficients are of the fluid's force on "
                              "patches; leave out velocity");
    return 0;
}

/* A list of names where each one is of the mesh. */
static int check_patches(const struct settings *s, int i)
{
    const char *text = settings_item_text(s, forces_list, i, "patches");
    char word[FORCES_NAME];
    int used;

    if (text[strspn(text, " ")] == '\0')
        return settings_wrong(s, forces_list,
                              "patches is empty; name some, or leave "
                              "it out for all walls");
    for (; sscanf(text, " %63[^ ]%n", word, &used) == 1; text += used)
        if (settings_side(s, word) == NULL && is_surface(s, word))
            return settings_wrong(
                s, forces_list,
                "%s is a surface, on which the fluid does not act: surfaces = "
                "\"%s\" gives the force of the grains on it",
                word, word);
        else if (settings_side(s, word) == NULL)
            return settings_wrong(
                s, forces_list,
                "there is no patch %s, or it has no boundary condition", word);
        else if (forces_is_open(s, word))
            return settings_wrong(s, forces_list,
                                  "the fluid flows through the patch %s; "
                                  "forces are those on walls",
                                  word);
    return 0;
}

void forces_name(const struct settings *s, int i, char name[FORCES_NAME])
{
    static const char *const keys[] = {"name", "patches", "surfaces"};

    snprintf(name, FORCES_NAME, "walls");
    for (int k = 2; k >= 0; k--)
        if (settings_item_has(s, forces_list, i, keys[k]))
            snprintf(name, FORCES_NAME, "%s",
                     settings_item_text(s, forces_list, i, keys[k]));
}

/* Two rows of the same name would have the same columns. */
static int forces_check_name(const struct settings *s, int i)
{
    char name[FORCES_NAME], other[FORCES_NAME];

    forces_name(s, i, name);
    for (int k = 0; k < i; k++) {
        forces_name(s, k, other);
        if (strcmp(name, other) == 0)
            return settings_wrong(s, forces_list,
                                  "two have columns that begin with \"%s\"; "
                                  "give each a name of its own",
                                  name);
    }
    return 0;
}

static int check_directions(const struct settings *s, int i)
{
    static const char *const keys[] = {"drag", "lift", "axis"};

    for (int k = 0; k < 3; k++) {
        double e[3];
        settings_item_vector(s, forces_list, i, keys[k], e);
        if (vector_length(e) == 0.0)
            return settings_wrong(s, forces_list,
                                  "%s: expected a direction, found [0, 0, 0]",
                                  keys[k]);
    }
    return 0;
}

int forces_check(const struct settings *s)
{
    for (int i = 0; i < settings_length(s, forces_list); i++) {
        const int U = settings_item_has(s, forces_list, i, "velocity");
        const int A = settings_item_has(s, forces_list, i, "area");
        const int surfaces = settings_item_has(s, forces_list, i, "surfaces");
        const int patches = settings_item_has(s, forces_list, i, "patches");
        if (surfaces && check_surfaces(s, i) != 0) return 2;
        if ((patches || !surfaces) && !s->has.fluid)
            return settings_wrong(
                s, forces_list,
                "the forces on patches need fluid, which the case does not "
                "have; those of the grains on surfaces are written with "
                "surfaces = \"...\"");
        if (patches && check_patches(s, i) != 0) return 2;
        if (U != A || (settings_item_has(s, forces_list, i, "length") && !U))
            return settings_wrong(s, forces_list,
                                  "coefficients need velocity and area, and "
                                  "that of the torque for length besides");
        if (forces_check_name(s, i) != 0 || check_directions(s, i) != 0)
            return 2;
    }
    return 0;
}
