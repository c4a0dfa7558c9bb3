/* SPDX-License-Identifier: GPL-3.0-or-later */
/* export.c -- particles and walls as a deck that LAMMPS runs.
 * Chapter "Past one machine".
 *
 *     winnow export CASE --to lammps -o DIR
 *
 * DIR/in.lammps and DIR/data.lammps; fluid and drag are left out. */
#include "case/case_file.h"
#include "case/command.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "case/build.h"
#include "coupling/simulation.h"
#include "coupling/processes.h"
#include "dem/dem_method.h"
#include "distributed/words.h"

static void export_put_line(void *to, const char *line)
{
    fprintf(to, "%s\n", line);
}

static void export_put_data(FILE *f, const struct words *w,
                            const struct particles *ps)
{
    fprintf(f, "# written by winnow export\n\n%d atoms\n%d atom types\n", ps->n,
            w->materials);
    for (int k = 0; k < 3; k++)
        fprintf(f, "%.17g %.17g %clo %chi\n", w->lo[k], w->hi[k], 'x' + k,
                'x' + k);
    fprintf(f, "\nAtoms # sphere: id type diameter density x y z\n\n");
    for (int i = 0; i < ps->n; i++)
        fprintf(f, "%d %d %.17g %.17g %.17g %.17g %.17g\n", ps->id[i] + 1,
                ps->material != NULL ? ps->material[i] + 1 : 1, ps->d[i],
                ps->m[i] / particles_volume(ps, i), ps->x[i], ps->y[i],
                ps->z[i]);
    fprintf(f, "\nVelocities # v, omega\n\n");
    for (int i = 0; i < ps->n; i++)
        fprintf(f, "%d %.17g %.17g %.17g %.17g %.17g %.17g\n", ps->id[i] + 1,
                ps->vx[i], ps->vy[i], ps->vz[i], ps->wx[i], ps->wy[i],
                ps->wz[i]);
}

/* All steps are one run: LAMMPS of 2021 applies the polynomial of the dashpots
 * of walls again at the start of every further one. */
static void put_deck(FILE *f, const struct settings *s, const struct words *w,
                     const double g[3])
{
    const double size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const double steps = (double)case_steps_until_end(s) * case_steps_within(s);

    fputs("# ", f);
    text_put(f, s->title, TEXT_LAMMPS);
    fputs("\n# particles and walls of ", f);
    text_put(f, s->file, TEXT_LAMMPS);
    fputs(", written by winnow export; without the fluid\n"
          "# one run only: LAMMPS up to 2022 changes the dashpots of "
          "walls in a second one\n",
          f);
    words_begin(w, export_put_line, f);
    fprintf(f, "read_data data.lammps\n");
    words_contacts(w, export_put_line, f);
    if (size > 0.0)
        fprintf(f, "fix gravity all gravity %.17g vector %.17g %.17g %.17g\n",
                size, g[0] / size, g[1] / size, g[2] / size);
    fprintf(f,
            "fix move all nve/sphere\n"
            "thermo_style custom step time atoms ke\nthermo 1000\n"
            "dump all all custom %.0f dump.lammps id type diameter x y z vx "
            "vy vz\n"
            "dump_modify all sort id format float %%.17g\nrun %.0f\n",
            fmax(1.0, steps), steps);
}

/* Writes one of the two files; non-zero after a message. */
static int write_file(const char *dir, const char *name,
                      const struct settings *s, const struct words *w,
                      const struct simulation *sim, int data)
{
    char *const path = file_join(dir, name);
    struct file *const f = file_create(path);

    if (f != NULL && data) export_put_data(file_stream(f), w, sim->particles);
    if (f != NULL && !data) put_deck(file_stream(f), s, w, sim->gravity);
    const int failed = f == NULL || file_commit(f) != 0;
    if (!failed) printf("%s\n", path);
    free(path);
    return failed;
}

static int export_case(const struct settings *s, const char *dir)
{
    int code;
    struct simulation *const sim = build_simulation(s, &code);

    if (sim == NULL) return code;
    const struct words w = words_of(s, dem_mean_diameter(sim->particles));
    if (file_make_dirs(dir) != 0 ||
        write_file(dir, "data.lammps", s, &w, sim, 1) != 0 ||
        write_file(dir, "in.lammps", s, &w, sim, 0) != 0)
        code = 4;
    build_free(sim);
    return code;
}

static int export_act(const struct command_line *l)
{
    int code;

    if (!l->to || strcmp(l->words[1], "lammps") != 0) {
        fprintf(stderr, "winnow: export knows one program: --to lammps\n");
        return 2;
    }
    struct settings *const s =
        case_file_read(l->words[0], l->n_overrides, l->overrides, &code);
    if (s != NULL) code = processes_check_export(s);
    if (s != NULL && code == 0)
        code = export_case(s, l->dir != NULL ? l->dir : "out/export");
    settings_free(s);
    return code;
}

const struct command export_command = {
    "export",
    "CASE --to lammps [-o DIR] [-s path.to.key=value]...",
    "particles and walls as a deck that LAMMPS runs, DIR/in.lammps and "
    "DIR/data.lammps",
    "ost",
    2,
    2,
    export_act};
