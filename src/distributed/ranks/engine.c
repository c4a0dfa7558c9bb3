/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"
#include "base/file.h"
#include "case/case_mesh.h"
#include "coupling/processes.h"
#include "distributed/ranks/engine.h"
#include "output/checkpoint/state_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <zlib.h>

/* A picture of more is not drawn [-]. */
static const double most_drawn = 1e5;

static struct engine *of(struct processes *hooks)
{
    return (struct engine *)hooks;
}

/* Asks the others. */
static void engine_give(int order, int detail, const char *path)
{
    struct message m = {.order = order, .detail = detail};

    snprintf(m.path, ENGINE_PATH, "%s", path);
    MPI_Bcast(&m, sizeof m, MPI_BYTE, 0, MPI_COMM_WORLD);
}

static void engine_join(struct processes *self, enum processes_order order)
{
    engine_give((int)order, 0, "");
    if (order == PROCESSES_ROW || order == PROCESSES_ROW_DONE)
        part_count_own(of(self)->part);
}

static int write_pieces(struct processes *self, const char *path,
                        const struct snapshot *s)
{
    struct engine *const e = of(self);
    char piece[ENGINE_PATH];

    for (int r = 0; r < e->part->p.size; r++) {
        pieces_name(path, r, 1, piece);
        if (folder_list(e->folder, piece) != 0) return 1;
    }
    engine_give(WRITE, 0, path);
    return pieces_write(of(self)->part, s, path);
}

static void engine_gather(struct processes *self, const struct snapshot *part,
                          struct snapshot *whole)
{
    const int with = of(self)->whole.particles != NULL;

    engine_give(GATHER, with, "");
    pieces_gather(of(self)->part, part, whole, with);
}

/* A number that a checkpoint has; -1 if there is none. */
static double number_in(const char *dir, const char *file, const char *name)
{
    char *const path = file_join(dir, file);
    const char *why;
    struct state_file *const f = state_file_open(path, &why);
    const double x = f != NULL ? state_file_number(f, name) : -1.0;

    state_file_free(f);
    free(path);
    return x >= 0.0 ? x : -1.0;
}

static const char slot_name[] = "/processes/slot";

/* A slot that neither the checkpoint nor the one before it uses. */
static int free_slot(const char *dir)
{
    const double taken[2] = {number_in(dir, "checkpoint", slot_name),
                             number_in(dir, "checkpoint.before", slot_name)};
    int slot = 0;

    while (slot == taken[0] || slot == taken[1])
        slot++;
    return slot;
}

/* The checksum of a file [-]; -1 if it cannot be read. */
static long engine_checksum_of(const char *path)
{
    unsigned char bytes[65536];
    FILE *const f = fopen(path, "rb");
    unsigned long crc = crc32_z(0, NULL, 0);

    if (f == NULL) return -1;
    for (size_t n; (n = fread(bytes, 1, sizeof bytes, f)) > 0;)
        crc = crc32_z(crc, bytes, n);
    fclose(f);
    return (long)crc;
}

/* The cells and the spheres have files of their own. */
static void engine_visit(struct processes *self, struct state *s)
{
    struct engine *const e = of(self);
    int slot = s->loading ? 0 : free_slot(e->dir);
    long found, cells, grains;
    char path[ENGINE_PATH];

    state_begin(s, "processes");
    state_whole(s, "slot", "-", &slot);
    engine_give(s->loading ? LOAD : SAVE, slot, e->dir);
    state_end(s);
    cells = found = engine_visit_part(e, e->dir, slot, s, s->loading);
    engine_slot_file(e->dir, "grains", slot, path);
    grains = s->loading ? 0 : engine_checksum_of(path);
    state_begin(s, "processes");
    state_long(s, "cells", "-", &cells);
    state_long(s, "grains", "-", &grains);
    state_end(s);
    if (found >= 0 && found != cells)
        fprintf(stderr, "winnow: %s/checkpoint.cells.%d is damaged\n", e->dir,
                slot);
    s->failed |= found < 0 || found != cells;
}

static void engine_release(struct processes *self)
{
    struct engine *const e = of(self);

    engine_give(RELEASE, 0, "");
    part_free(e->part);
    if (e->whole.mesh != NULL) mesh_free(e->whole.mesh);
    free(e->whole.fluid);
    free(e->whole.particles);
    free(e);
}

/* The outline of what is drawn, if anything is. */
static void outline(struct engine *e)
{
    const struct settings *const s = e->settings;
    const int moving = s->output.animation;
    const int many = e->hooks.particles > most_drawn;
    const int drawn = moving || (s->output.picture && !many);
    struct simulation *const w = &e->whole;

    if (s->output.picture && !drawn && !s->quiet)
        fprintf(stderr, "no picture is drawn of more than %g particles\n",
                most_drawn);
    if (!drawn && s->output.profiles.n == 0 && s->output.probes.n == 0) return;
    w->mesh = case_mesh_outline(s);
    w->mesh->V = alloc_doubles(w->mesh->n_cells);
    for (int c = 0; c < w->mesh->n_cells; c++)
        w->mesh->V[c] = 1.0; /* all are alike */
    w->fluid = alloc_zeroed(1, sizeof *w->fluid);
    w->fluid->options.coupled = e->part->sim->fluid->options.coupled;
    if (drawn) w->particles = alloc_zeroed(1, sizeof *w->particles);
    if (drawn) w->particles->capacity = (int)e->hooks.particles;
    e->hooks.whole = w;
}

/* The spheres of a run that goes on; non-zero after a message. */
static int find_spheres(const char *dir, char path[ENGINE_PATH])
{
    const char *const file = number_in(dir, "checkpoint", slot_name) >= 0.0
                                 ? "checkpoint"
                                 : "checkpoint.before";
    const double slot = number_in(dir, file, slot_name);

    engine_slot_file(dir, "grains", (int)slot, path);
    if (slot < 0.0)
        fprintf(stderr, "winnow: %s/%s is not of several ranks\n", dir, file);
    else if ((double)engine_checksum_of(path) !=
             number_in(dir, file, "/processes/grains"))
        fprintf(stderr, "winnow: %s is missing or damaged\n", path);
    else
        return 0;
    return 1;
}

static struct simulation *engine_build(const struct settings *s,
                                       const char *dir, int resumes, int *code)
{
    struct engine *const e = alloc_zeroed(1, sizeof *e);
    char file[ENGINE_PATH] = "";

    e->settings = s;
    snprintf(e->dir, ENGINE_PATH, "%s", dir);
    *code = resumes && find_spheres(dir, file) != 0 ? 2 : 0;
    if (*code == 0) {
        engine_give(BUILD, 0, file);
        *code = engine_agree(0); /* the others have read the case */
        if (*code == 0) *code = engine_build_part(e, file);
    }
    if (*code != 0) {
        free(e);
        return NULL;
    }
    e->hooks.join = engine_join;
    e->hooks.write = write_pieces;
    e->hooks.gather = engine_gather;
    e->hooks.state = engine_visit;
    e->hooks.free = engine_release;
    outline(e);
    return e->part->sim;
}

static int engine_check(const struct settings *s)
{
    struct partition p;
    int code = processes_check_all(s);

    if (code == 0) code = part_divide(s, MPI_COMM_WORLD, &p);
    if (code == 0) partition_release(&p);
    return code;
}

/* --- engine summary: what differs from one machine stands in the summary. */

/* Lists the files of the three slots. */
static void *engine_summary_create(const struct recorder_view *v, int *failed)
{
    char name[64];
    ((struct engine *)v->sim->processes)->folder = v->folder;
    for (int i = 0; i < 6; i++) {
        snprintf(name, sizeof name, "checkpoint.%s.%d",
                 i % 2 ? "cells" : "grains", i / 2);
        char *const path = folder_file(v->folder, name);
        *failed |= path == NULL;
        free(path);
    }
    return *failed ? NULL : v->sim->processes;
}

static void engine_summary_summarize(const void *of, struct summary *f)
{
    struct engine *const e = *(struct engine *const *)&of;
    const struct partition *const p = &e->part->p;
    char name[32];
    long moved;

    engine_give(COUNT, 0, "");
    double *const all = engine_count(e, &moved);
    summary_begin(f, "engine");
    summary_text(f, "particles", "LAMMPS");
    summary_text(f, "linear_systems", "PETSc");
    summary_text(f, "same_results",
                 "to rounding for any number of ranks and after a resume, not "
                 "to the bit");
    summary_count(f, "ranks", p->size);
    summary_count(f, "ranks_x", p->P[0]);
    summary_count(f, "ranks_y", p->P[1]);
    summary_count(f, "ranks_z", p->P[2]);
    summary_count(f, "layers", p->layers);
    summary_count(f, "particles_on_another_rank", moved);
    for (int r = 0; r < p->size; r++) {
        snprintf(name, sizeof name, "rank_%d", r);
        summary_begin(f, name);
        summary_count(f, "particles", (long)all[3 * r]);
        summary_count(f, "cells", (long)all[3 * r + 1]);
        summary_number(f, "peak_memory", all[3 * r + 2]);
        summary_end(f);
    }
    summary_end(f);
    free(all);
}

static const struct recorder_part engine_summary = {
    .create = engine_summary_create, .summarize = engine_summary_summarize};

static const struct processes_engine of_ranks = {
    .check = engine_check, .build = engine_build, .summary = &engine_summary};
const struct processes_engine *const processes_engine = &of_ranks;

void engine_stop(int code)
{
    engine_give(STOP, code, "");
}
