/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/inlet_profile.h"
#include "case/engine/refusal.h"

#include <stdio.h>
#include <string.h>

#include "case/case_file.h"
#include "case/case_materials.h"
#include "case/checks/materials_check.h"
#include "case/schema.h"
#include "case/engine/words.h"

/* Keys that are known, and by a full stop at the end all that begin so. */
static const char known[] =
    " title cites engine ranks layers mesh mesh.size mesh.cells mesh.grading "
    "mesh.periodic fluid fluid. particles particles.contact particles.step "
    "particles.skin particles.unsafe_step particles.expected_overlap "
    "particles.max_overlap particles.integrator particles.list "
    "particles.grains particles.grains. particles.materials "
    "particles.materials. particles.pairs particles.pairs. particles.walls "
    "particles.walls. particles.bed particles.place particles.place. "
    "particles.overlaps particles.sizes particles.sizes. averaging "
    "averaging. exchange exchange. effects effects.gravity "
    "effects.pressure_gradient output output.end output.every "
    "output.history output.checkpoint output.picture output.animation "
    "output.profiles output.profiles. output.probes output.probes. "
    "particles.bed.count particles.bed.diameter particles.bed.seed "
    "particles.bed.jitter particles.bed.settle particles.bed.sizes ";

/* Keys that are not, by how they begin, and why; the last one is the rest. */
static const struct {
    const char *key, *why;
} reasons[] = {
    {"particles.surfaces", "LAMMPS of this version has no triangulated and no "
                           "moving walls"},
    {"particles.prescribed", "its particles all move freely"},
    {"particles.bed.file", "all ranks settle the bed together"},
    {"particles.insert", "new particles are not handed out to the ranks yet"},
    {"particles.sinks", "particles that leave are not counted over the ranks "
                        "yet"},
    {"mesh.polymesh", "only boxes are divided so far"},
    {"mesh.shear", "only boxes are divided so far"},
    {"bodies", "bodies are not divided yet"},
    {"effects.virtual_mass", "it acts within the integrator, which is LAMMPS'"},
    {"effects.energy_budget", "it is kept in the contact loop, which is "
                              "LAMMPS'"},
    {"effects.capillary", "cohesion is not told to LAMMPS"},
    {"effects.van_der_waals", "cohesion is not told to LAMMPS"},
    {"effects.electrostatic", "cohesion is not told to LAMMPS"},
    {"", "it has not been divided among ranks yet"}};

static int refusal_begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* 1 if the list has the path, or how it begins, up to a full stop. */
static int is_known(const char *path)
{
    char word[160];

    for (size_t n = strlen(path); n > 0; n--) {
        const int whole = path[n] == '\0' || path[n - 1] == '.';
        snprintf(word, sizeof word, " %.*s ", (int)n, path);
        if (whole && strstr(known, word) != NULL) return 1;
    }
    return 0;
}

static int refusal_refuse(const struct settings *s, const char *path,
                          const char *why)
{
    return settings_wrong(s, path,
                          "not on the distributed engine (%s); run on one "
                          "machine, or leave it out",
                          why);
}

/* The first key that the case has and the engine has not; `about` is how those
 * begin that are asked for. */
static int refusal_check_keys(const struct settings *s, const char *about)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    SCHEMA_EACH (row, tables) {
        const char *const path = row->path;
        int i = 0;
        if (row->type == KEY_PATCH || strchr(path, '<') != NULL ||
            is_known(path) || !settings_has(s, path))
            continue;
        while (!refusal_begins(path, reasons[i].key))
            i++;
        if (refusal_begins(path, about) ||
            strstr(reasons[i].why, "cohesion") != NULL)
            return refusal_refuse(s, path, reasons[i].why);
    }
    return 0;
}

static int is_one_of(const char *name, const char *one, const char *other)
{
    return strcmp(name, one) == 0 || strcmp(name, other) == 0;
}

/* Choices of which the engine does not know all; the groups are there. */
static int check_choices(const struct settings *s)
{
    static const char not_yet[] = "not divided yet";
    const struct averaging_options *const a = &s->averaging;
    const struct {
        int known;
        const char *key, *why;
    } choices[] = {
        {is_one_of(s->particles.integrator->name, "velocity-verlet", ""),
         "particles.integrator",
         "LAMMPS moves the particles by velocity Verlet"},
        {is_one_of(a->method->name, "pcm", "diffusion"), "averaging.method",
         "other averages reach farther than the layers of a rank"},
        {is_one_of(a->scheme, "exponential", "series"), "averaging.scheme",
         "a step of the others waits for all ranks in every iteration"},
        {is_one_of(a->vary, "uniform", ""), "averaging.bandwidth_variation",
         "the bandwidth must be the same on all ranks"},
        {s->exchange.slip_integration == SLIP_INTEGRATION_FROZEN,
         "exchange.slip_integration",
         "the other one acts within the integrator, which is LAMMPS': use "
         "sub-steps"},
        {s->exchange.two_way, "exchange.coupling", not_yet},
        {is_one_of(s->fluid.time->name, "euler", ""), "fluid.time", not_yet},
        {!s->fluid.has_mean_flow, "fluid.mean_flow", not_yet},
        {a->cap == 0.0, "averaging.cap", not_yet},
        {!settings_has(s, "averaging.regions"), "averaging.regions", not_yet},
        {!s->particles.list->no_contacts, "particles.list",
         "LAMMPS looks for contacts"},
        {s->fluid.outer_correctors == 0, "fluid.outer_correctors", not_yet}};

    for (size_t i = 0; i < sizeof choices / sizeof *choices; i++)
        if (!choices[i].known)
            return refusal_refuse(s, choices[i].key, choices[i].why);
    return 0;
}

static int check_sides(const struct settings *s)
{
    char path[128];

    for (int i = 0; i < s->sides.n; i++) {
        const struct boundary_options *const o = &s->sides.item[i];
        const int varies =
            o->has_profile && o->profile != &inlet_profile_uniform;
        snprintf(path, sizeof path, "%s.%s", o->key,
                 varies ? "profile" : "rotation");
        if (varies || o->condition == &rotating_wall_condition)
            return refusal_refuse(
                s, path, "a rank does not see the whole side of the box");
    }
    return 0;
}

static int check_grading(const struct settings *s)
{
    for (int k = 0; k < 3; k++)
        if (s->mesh.box.grading[k] != 1.0)
            return refusal_refuse(s, "mesh.grading",
                                  "cells of different width are "
                                  "not divided yet");
    return 0;
}

/* Contacts that LAMMPS has no number for. */
int refusal_export(const struct settings *s)
{
    static const char grains[] = "particles.grains.restitution";
    const int n = s->particles.materials.n + 1;

    if (!s->has.particles)
        return settings_wrong(s, "particles", "there are none to move");
    if (n > WORDS_MATERIALS)
        return settings_wrong(s, "particles.materials", "%d at most",
                              WORDS_MATERIALS);
    if (!words_has_law(s))
        return refusal_refuse(s, "particles.contact",
                              "LAMMPS has Hertz's spring and a linear one");
    if (materials_check_rolling(s))
        return refusal_refuse(s, "particles.grains.rolling_friction",
                              "LAMMPS' law of it is another one");
    const struct words w = words_of(s, 1.0);
    for (int i = 0; i < n * n; i++)
        if (words_restitution(w.hertz, w.pair[i].damping_n) < 0.0)
            return refusal_refuse(
                s, grains,
                "LAMMPS' dashpot is not as strong as a restitution "
                "so small needs");
    return refusal_check_keys(s, "particles");
}

int refusal_engine(const struct settings *s)
{
    const char *const missing = !s->has.fluid       ? "fluid"
                                : !s->has.particles ? "particles"
                                : !s->has.exchange  ? "exchange"
                                                    : NULL;

    if (missing != NULL)
        return settings_wrong(s, missing,
                              "the distributed engine computes fluid and "
                              "particles together; run on one machine%s",
                              s->has.fluid ? ""
                                           : ", or winnow export CASE --to "
                                             "lammps");
    int code = refusal_check_keys(s, "");
    if (code == 0) code = check_choices(s);
    if (code == 0) code = check_sides(s);
    if (code == 0) code = check_grading(s);
    return code != 0 ? code : refusal_export(s);
}
