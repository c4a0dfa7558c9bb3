/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_engine.c -- the keys of the distributed engine, and what `check` says of
 * it.  Chapter "Past one machine". */
#include "case/engine/case_engine.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case/checks/case_cost.h"
#include "case/case_mesh.h"
#include "case/checks/check_line.h"
#include "coupling/processes.h"
#include "case/engine/refusal.h"

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

int case_engine_check(const struct settings *s)
{
    return is_distributed(s) ? refusal_engine(s) : 0;
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
    const double one = case_cost_seconds(s);

    puts("Distributed engine");
    check_line("time on one core", one, "s", "about, by build/winnow");
    check_line("time of one rank", slower * one, "s",
               "about, by build/winnow-mpi");
    check_line("ranks for each thread replaced", slower, "-",
               "below that it only pays where one machine has too little "
               "memory");
    check_line("memory of all ranks",
               1e-6 * (per_particle * k->particles + per_cell * k->cells), "MB",
               "about; of N ranks a part each, and their layers");
    check_line("memory of a rank besides", 1e-6 * libraries, "MB", "about");
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
