/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_engine.c -- the keys of the distributed engine, and what `check` says of
 * it.  Chapter "Past one machine". */
#include "case/engine/case_engine.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/case_file.h"
#include "case/particles/case_materials.h"
#include "case/case_mesh.h"
#include "case/checks/case_scales.h"
#include "base/text.h"
#include "case/checks/materials_check.h"
#include "case/engine/words.h"
#include "case/schema.h"
#include "coupling/processes.h"
#include "fluid/inlet_profile.h"

const struct key case_engine_keys[] = {
    {"engine", KEY_NAME, "", "one | distributed", "one",
     "one: this machine; distributed: several processes, by build/winnow-mpi",
     "", "", .at = KEY_AT(settings, engine)},
    {"ranks", KEY_COUNTS, "-", ">= 1", "",
     "processes in x, y, z; left out: as many as there are, side by side "
     "across gravity",
     "", "", .at = KEY_AT(settings, ranks), .mark = KEY_MAY_CHANGE},
    {"layers", KEY_INT, "-", ">= 1, <= 16", "",
     "layers of neighbours' cells around those of a rank; left out: as many as "
     "the schemes read",
     "", "", .at = KEY_AT(settings, layers), .mark = KEY_MAY_CHANGE},
    KEY_END};

static int is_distributed(const struct settings *s)
{
    return strcmp(s->engine, "distributed") == 0;
}

/* Measured on one core with a settled bed of 9240 spheres: LAMMPS' steps of the
 * particles take 4.3 times as long as ours, and PETSc's of the fluid 4.3 times.
 * [byte] of a bed of 400,000 spheres on 1, 2 and 4 ranks: what a sphere takes,
 * LAMMPS' part and the writing of a checkpoint among it, and a process without
 * any. */
static const double slower = 4.3;
static const double per_particle = 2300.0, per_cell = 2200.0, libraries = 65e6;

void case_engine_print(const struct settings *s, const struct case_scales *k)
{
    if (!is_distributed(s)) return;
    const double one = case_scales_seconds(s);

    puts("Distributed engine");
    text_line("time on one core", one, "s", "about, by build/winnow");
    text_line("time of one rank", slower * one, "s",
              "about, by build/winnow-mpi");
    text_line("ranks for each thread replaced", slower, "-",
              "below that it only pays where one machine has too little "
              "memory");
    text_line("memory of all ranks",
              1e-6 * (per_particle * k->particles + per_cell * k->cells), "MB",
              "about; of N ranks a part each, and their layers");
    text_line("memory of a rank besides", 1e-6 * libraries, "MB", "about");
}

int case_engine_check_run(const struct settings *s)
{
    if (processes_engine != NULL) return processes_engine->check(s);
    if (!is_distributed(s)) return 0;
    return settings_wrong(s, "engine",
                          "this program computes on one machine; run the case "
                          "with mpirun -n N build/winnow-mpi (make "
                          "distributed)");
}

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

static int begins(const char *text, const char *with)
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

static int refuse_key(const struct settings *s, const char *path,
                      const char *why)
{
    return settings_wrong(s, path,
                          "not on the distributed engine (%s); run on one "
                          "machine, or leave it out",
                          why);
}

/* The first key that the case has and the engine has not; `about` is how those
 * begin that are asked for. */
static int check_keys(const struct settings *s, const char *about)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    SCHEMA_EACH (row, tables) {
        const char *const path = row->path;
        int i = 0;
        if (row->type == KEY_PATCH || strchr(path, '<') != NULL ||
            is_known(path) || !settings_has(s, path))
            continue;
        while (!begins(path, reasons[i].key))
            i++;
        if (begins(path, about) || strstr(reasons[i].why, "cohesion") != NULL)
            return refuse_key(s, path, reasons[i].why);
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
            return refuse_key(s, choices[i].key, choices[i].why);
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
            return refuse_key(s, path,
                              "a rank does not see the whole side of the box");
    }
    return 0;
}

static int check_grading(const struct settings *s)
{
    for (int k = 0; k < 3; k++)
        if (s->mesh.box.grading[k] != 1.0)
            return refuse_key(s, "mesh.grading",
                              "cells of different width are "
                              "not divided yet");
    return 0;
}

/* Contacts that LAMMPS has no number for. */
int case_engine_check_export(const struct settings *s)
{
    static const char grains[] = "particles.grains.restitution";
    const int n = s->particles.materials.n + 1;

    if (!s->has.particles)
        return settings_wrong(s, "particles", "there are none to move");
    if (n > WORDS_MATERIALS)
        return settings_wrong(s, "particles.materials", "%d at most",
                              WORDS_MATERIALS);
    if (!words_has_law(s))
        return refuse_key(s, "particles.contact",
                          "LAMMPS has Hertz's spring and a linear one");
    if (materials_check_rolling(s))
        return refuse_key(s, "particles.grains.rolling_friction",
                          "LAMMPS' law of it is another one");
    const struct words w = words_of(s, 1.0);
    for (int i = 0; i < n * n; i++)
        if (words_restitution(w.hertz, w.pair[i].damping_n) < 0.0)
            return refuse_key(
                s, grains,
                "LAMMPS' dashpot is not as strong as a restitution "
                "so small needs");
    return check_keys(s, "particles");
}

int case_engine_check_all(const struct settings *s)
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
    int code = check_keys(s, "");
    if (code == 0) code = check_choices(s);
    if (code == 0) code = check_sides(s);
    if (code == 0) code = check_grading(s);
    return code != 0 ? code : case_engine_check_export(s);
}

int case_engine_check(const struct settings *s)
{
    return is_distributed(s) ? case_engine_check_all(s) : 0;
}
