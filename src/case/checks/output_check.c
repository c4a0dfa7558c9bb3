/* SPDX-License-Identifier: GPL-3.0-or-later */
/* output_check.c -- what a case says in the group output, checked. */
#include "case/checks/checks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/case_mesh.h"
#include "base/text.h"
#include "case/particles/case_surfaces.h"
#include "record/recorder_part.h"

/* --- profiles and probes -------------------------------------------------- */

static const char profiles[] = "output.profiles";
static const char probes[] = "output.probes";

/* There are fields where there is a fluid, and those of the solids where the
 * particles act on it. */
static int check_field(const struct settings *s, const char *list,
                       const char *field)
{
    const int of_solids =
        strcmp(field, "eps_s") == 0 || strncmp(field, "us_", 3) == 0;

    if (!s->has.fluid)
        return settings_wrong(
            s, list, "the case has no field %s: fields are those of a fluid",
            field);
    if (of_solids && !s->exchange.two_way)
        return settings_wrong(s, list,
                              "the case has no field %s: it needs exchange "
                              "with coupling = \"two-way\"",
                              field);
    return 0;
}

/* A line has one place, in one of the two directions that it does not follow,
 * and lies within the box. */
static int check_line_of(const struct settings *s, int i)
{
    static const char *const place[3] = {"x", "height", "z"}; /* the keys */
    const struct output_profile *const p = &s->output.profiles.item[i];
    const struct profile_line l = profiles_line(p);
    const int one = l.along == 0, two = l.along == 2 ? 1 : 2;
    double lo[3], hi[3];

    if (p->has_place[l.along])
        return settings_wrong(s, profiles,
                              "profile %d goes along %c and so has no %s; "
                              "expected %s or %s, in m",
                              i, "xyz"[l.along], place[l.along], place[one],
                              place[two]);
    if (p->has_place[one] == p->has_place[two])
        return settings_wrong(s, profiles,
                              "profile %d goes along %c: expected %s or %s, in "
                              "m, the place of its line%s",
                              i, "xyz"[l.along], place[one], place[two],
                              l.across < 0 ? "" : ", and not both");
    case_mesh_ends(s, lo, hi);
    if (l.at >= lo[l.across] && l.at <= hi[l.across]) return 0;
    const int over = l.at > hi[l.across];
    return settings_wrong(s, profiles, "%s %g m is %s the box, %g m",
                          place[l.across], l.at,
                          l.across != 1 ? "beyond"
                          : over        ? "above"
                                        : "below",
                          over ? hi[l.across] : lo[l.across]);
}

/* Of two profiles in one file only the last would be left. */
static int check_names(const struct settings *s)
{
    const int n = s->output.profiles.n;
    char(*const name)[PROFILES_NAME] = alloc_zeroed((size_t)n, sizeof *name);
    int code = 0;

    for (int i = 0; i < n && code == 0; i++) {
        profiles_name(&s->output, i, name[i]);
        for (int k = 0; k < i && code == 0; k++)
            if (strcmp(name[i], name[k]) == 0)
                code =
                    settings_wrong(s, profiles,
                                   "profiles %d and %d are of the same field "
                                   "on the same line from the same time: both "
                                   "would be %s.csv; leave one of them out",
                                   k, i, name[i]);
    }
    free(name);
    return code;
}

static int check_profiles(const struct settings *s)
{
    const int n = s->output.profiles.n;
    int code = 0;

    for (int i = 0; i < n && code == 0; i++)
        code = check_field(s, profiles, s->output.profiles.item[i].field);
    for (int i = 0; i < n && code == 0; i++)
        code = check_line_of(s, i);
    return code != 0 || n == 0 ? code : check_names(s);
}

static int check_probes(const struct settings *s)
{
    const struct output_probe *const p = s->output.probes.item;
    const int n = s->output.probes.n;
    int code = 0;

    for (int i = 0; i < n && code == 0; i++)
        code = check_field(s, probes, p[i].field);
    for (int i = 0; i < n && code == 0; i++) {
        const double *const x = p[i].position;
        if (!case_mesh_holds(s, x))
            code = settings_wrong(
                s, probes, "the point [%g, %g, %g] m is outside the %s", x[0],
                x[1], x[2], s->poly == NULL ? "box" : "mesh");
    }
    return code;
}

/* --- forces --------------------------------------------------------------- */

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
    char word[PROFILES_NAME];
    int used;

    if (text[strspn(text, " ")] == '\0')
        return settings_wrong(s, list, "surfaces is empty; name some");
    for (; !is_surface(s, text) && sscanf(text, " %63[^ ]%n", word, &used) == 1;
         text += used)
        if (!is_surface(s, word))
            return settings_wrong(
                s, list, "there is no surface %s in particles.surfaces", word);
    if (o->patches == NULL && o->velocity > 0.0)
        return settings_wrong(s, list,
                              "coefficients are of the fluid's force on "
                              "patches; leave out velocity");
    return 0;
}

static int is_open(const struct settings *s, const char *patch)
{
    const enum boundary_kind kind = settings_side(s, patch)->condition->kind;
    return kind == BOUNDARY_INLET || kind == BOUNDARY_OUTLET;
}

/* A list of names where each one is of the mesh. */
static int check_patches(const struct settings *s, const char *text)
{
    char word[PROFILES_NAME];
    int used;

    if (text[strspn(text, " ")] == '\0')
        return settings_wrong(
            s, list,
            "patches is empty; name some, or leave it out for all walls");
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
        else if (is_open(s, word))
            return settings_wrong(s, list,
                                  "the fluid flows through the patch %s; "
                                  "forces are those on walls",
                                  word);
    return 0;
}

/* Two rows of the same name would have the same columns. */
static int check_name(const struct settings *s, int i)
{
    const struct output_force *const all = s->output.forces.item;
    char name[PROFILES_NAME], other[PROFILES_NAME];

    recorder_forces_name(&all[i], name);
    for (int k = 0; k < i; k++) {
        recorder_forces_name(&all[k], other);
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

static int check_forces(const struct settings *s)
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
        if (check_name(s, i) != 0 || check_directions(s, o) != 0) return 2;
    }
    return 0;
}

/* --- arrays of the particles ---------------------------------------------- */

static int is_particle_field(const char *word)
{
    const struct snapshot_field *f = snapshot_fields;

    while (f->name != NULL && strcmp(f->name, word) != 0)
        f++;
    return f->name != NULL;
}

static int unknown_field(const struct settings *s, const char *key,
                         const char *word)
{
    struct nearest n;

    nearest_init(&n, word);
    for (const struct snapshot_field *f = snapshot_fields; f->name; f++)
        nearest_offer(&n, f->name);
    const char *const best = nearest_best(&n);
    return settings_wrong(
        s, key,
        "there is no %s; expected mass, material, fluid_force, contact_force, "
        "contact_number, grains or grain_diameter%s%s",
        word, best != NULL ? "; nearest: " : "", best != NULL ? best : "");
}

/* Known words, each once. */
static int check_particles(const struct settings *s)
{
    static const char key[] = "output.particles";
    const char *const all = s->output.particles;
    char word[SNAPSHOT_WORD], other[SNAPSHOT_WORD];
    int used, past;

    for (const char *text = all;
         text != NULL && sscanf(text, " %63[^ ]%n", word, &used) == 1;
         text += used) {
        if (!is_particle_field(word)) return unknown_field(s, key, word);
        for (const char *at = all;
             at < text && sscanf(at, " %63[^ ]%n", other, &past) == 1;
             at += past)
            if (strcmp(word, other) == 0)
                return settings_wrong(s, key, "%s is named twice", word);
        if (strcmp(word, "fluid_force") == 0 && !s->has.exchange)
            return settings_wrong(s, key,
                                  "fluid_force needs the group exchange: no "
                                  "fluid acts on the particles");
    }
    return 0;
}

static int check_time_average(const struct settings *s)
{
    if (!s->effects.time_average || s->exchange.two_way) return 0;
    return settings_wrong(s, KEY_OF(s, effects.time_average),
                          "one-way there are no averaged fields; it needs "
                          "exchange.coupling = \"two-way\"");
}

int output_check(const struct settings *s)
{
    int code = check_profiles(s);

    if (code == 0) code = check_probes(s);
    if (code == 0) code = check_forces(s);
    if (code == 0) code = check_particles(s);
    return code != 0 ? code : check_time_average(s);
}
