/* SPDX-License-Identifier: GPL-3.0-or-later */
/* processes_check.c -- the keys of the distributed engine, and what `check`
 * says of it.  Chapter "Past one machine". */
#include "coupling/processes.h"

#include <stdio.h>
#include <string.h>

#include "case/case_file.h"
#include "case/particles/case_materials.h"
#include "case/checks/checks.h"
#include "base/text.h"
#include "distributed/words.h"
#include "case/schema.h"

const struct key processes_check_keys[] = {
    {"engine", KEY_NAME, "", "one | distributed", "one",
     "one: this machine; distributed: several processes, by build/winnow-mpi",
     "", "", KEY_AT(settings, engine), .divided = KEY_DIVIDED},
    {"ranks", KEY_COUNTS, "-", ">= 1", "",
     "processes in x, y, z; left out: as many as there are, side by side "
     "across gravity",
     "", "", KEY_AT(settings, ranks), .mark = KEY_MAY_CHANGE,
     .divided = KEY_DIVIDED},
    {"layers", KEY_INT, "-", ">= 1, <= 16", "",
     "layers of neighbours' cells around those of a rank; left out: as many as "
     "the schemes read",
     "", "", KEY_AT(settings, layers), .mark = KEY_MAY_CHANGE,
     .divided = KEY_DIVIDED},
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

void processes_check_print(const struct settings *s,
                           const struct case_scales *k)
{
    if (!is_distributed(s)) return;

    puts("Distributed engine");
    text_line("time of one rank over that of one core", slower, "-",
              "as in a bed; with fewer ranks a thread it pays for memory only");
    text_line("memory of all ranks",
              1e-6 * (per_particle * k->particles + per_cell * k->cells), "MB",
              "about; of N ranks a part each, and their layers");
    text_line("memory of a rank besides", 1e-6 * libraries, "MB", "about");
}

int processes_check_run(const struct settings *s)
{
    if (processes_engine != NULL) return processes_engine->check(s);
    if (!is_distributed(s)) return 0;
    return settings_wrong(
        s, "engine",
        "this program computes on one machine; run the case with mpirun -n N "
        "build/winnow-mpi (make distributed)");
}

/* What the row of a path, or else of the group that it is in, says of several
 * machines: KEY_DIVIDED, why they refuse it, or NULL, as of a new key. */
static const char *divided_of(const struct key *const *tables, const char *path)
{
    char group[SCHEMA_TEXT];
    const struct key *const own = schema_find(tables, path);
    const char *said = own != NULL ? own->divided : NULL;

    snprintf(group, sizeof group, "%s", path);
    for (char *dot; said == NULL && (dot = strrchr(group, '.')) != NULL;) {
        *dot = '\0';
        const struct key *const row = schema_find(tables, group);
        if (row != NULL && row->divided != NULL &&
            strcmp(row->divided, KEY_DIVIDED) != 0)
            said = row->divided;
    }
    return said;
}

static int refuse_key(const struct settings *s, const char *path,
                      const char *why)
{
    return settings_wrong(s, path,
                          is_distributed(s)
                              ? "not on the distributed engine (%s); run on "
                                "one machine, or leave it out"
                              : "not in a deck of LAMMPS (%s); leave it out",
                          why);
}

/* The first key that the case has and the engine has not; `about` is how those
 * begin that are asked for, but for cohesion, which is always. */
static int check_keys(const struct settings *s, const char *about)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    SCHEMA_EACH (row, tables) {
        const char *const path = row->path;
        if (row->type == KEY_PATCH || strchr(path, '<') != NULL ||
            !settings_has(s, path))
            continue;
        const char *const said = divided_of(tables, path);
        if (said != NULL && (strcmp(said, KEY_DIVIDED) == 0 ||
                             strcmp(said, KEY_DIVIDED_ALL) == 0))
            continue;
        if (strncmp(path, about, strlen(about)) == 0 ||
            (said != NULL && strstr(said, "cohesion") != NULL))
            return refuse_key(s, path,
                              said != NULL
                                  ? said
                                  : "it has not been divided among ranks yet");
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
         KEY_OF(s, particles.integrator),
         "LAMMPS moves the particles by velocity Verlet"},
        {is_one_of(a->method->name, "pcm", "diffusion"),
         KEY_OF(s, averaging.method),
         "other averages reach farther than the layers of a rank"},
        {is_one_of(a->scheme, "exponential", "series"),
         KEY_OF(s, averaging.scheme),
         "a step of the others waits for all ranks in every iteration"},
        {is_one_of(a->vary, "uniform", ""), KEY_OF(s, averaging.vary),
         "the bandwidth must be the same on all ranks"},
        {s->exchange.slip_integration == SLIP_INTEGRATION_FROZEN,
         KEY_OF(s, exchange.slip_integration),
         "the other one acts within the integrator, which is LAMMPS': use "
         "sub-steps"},
        {s->exchange.two_way, KEY_OF(s, exchange.two_way), not_yet},
        {is_one_of(s->fluid.time->name, "euler", ""), KEY_OF(s, fluid.time),
         not_yet},
        {!s->fluid.has_mean_flow, KEY_OF(s, fluid.mean_flow), not_yet},
        {a->cap == 0.0, KEY_OF(s, averaging.cap), not_yet},
        {a->regions.n == 0, KEY_OF(s, averaging.regions), not_yet},
        {!s->particles.list->no_contacts, KEY_OF(s, particles.list),
         "LAMMPS looks for contacts"},
        {s->fluid.outer_correctors == 0, KEY_OF(s, fluid.outer_correctors),
         not_yet}};

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
        const char *const whole =
            o->condition->whole != NULL ? o->condition->whole(o) : NULL;
        if (whole == NULL) continue;
        snprintf(path, sizeof path, "%s.%s", o->key, whole);
        return refuse_key(s, path,
                          "a rank does not see the whole side of the box");
    }
    return 0;
}

static int check_grading(const struct settings *s)
{
    for (int k = 0; k < 3; k++)
        if (s->mesh.box.grading[k] != 1.0)
            return refuse_key(s, KEY_OF(s, mesh.box.grading),
                              "cells of different width are not divided yet");
    return 0;
}

/* Contacts that LAMMPS has no number for. */
int processes_check_export(const struct settings *s)
{
    const int n = s->particles.materials.n + 1;

    if (!s->has.particles)
        return settings_wrong(s, "particles", "there are none to move");
    if (n > WORDS_MATERIALS)
        return settings_wrong(s, KEY_OF(s, particles.materials), "%d at most",
                              WORDS_MATERIALS);
    if (!words_has_law(s))
        return refuse_key(s, KEY_OF(s, particles.contact),
                          "LAMMPS has Hertz's spring and a linear one");
    if (case_materials_resist_rolling(s))
        return refuse_key(s, KEY_OF(s, particles.grains.of.rolling),
                          "LAMMPS' law of it is another one");
    const struct words w = words_of(s, 1.0);
    for (int i = 0; i < n * n; i++)
        if (words_restitution(w.hertz, w.pair[i].damping_n) < 0.0)
            return refuse_key(s, KEY_OF(s, particles.grains.of.restitution),
                              "LAMMPS' dashpot is not as strong as a "
                              "restitution so small needs");
    return check_keys(s, "particles");
}

int processes_check_all(const struct settings *s)
{
    const char *const missing = !s->has.fluid       ? "fluid"
                                : !s->has.particles ? "particles"
                                : !s->has.exchange  ? "exchange"
                                                    : NULL;

    if (missing != NULL)
        return settings_wrong(
            s, missing,
            "the distributed engine computes fluid and particles together; run "
            "on one machine%s",
            s->has.fluid ? "" : ", or winnow export CASE --to lammps");
    int code = check_keys(s, "");
    if (code == 0) code = check_choices(s);
    if (code == 0) code = check_sides(s);
    if (code == 0) code = check_grading(s);
    return code != 0 ? code : processes_check_export(s);
}

int processes_check(const struct settings *s)
{
    return is_distributed(s) ? processes_check_all(s) : 0;
}
