/* SPDX-License-Identifier: GPL-3.0-or-later */
/* serve.c -- what each rank does with its part, and the ranks that wait for
 * what they are asked. */
#include "distributed/ranks/engine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "case/build.h"
#include "case/case_file.h"
#include "record/history.h"
#include "record/recorder_part.h"
#include "coupling/coupling.h"

int engine_agree(int code)
{
    MPI_Allreduce(MPI_IN_PLACE, &code, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return code;
}

static void serve_sum(struct processes *self, int n, double *x)
{
    (void)self;
    MPI_Allreduce(MPI_IN_PLACE, x, n, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

static int serve_largest(struct processes *self, int x)
{
    (void)self;
    return engine_agree(x);
}

static void join_nothing(struct processes *self, enum processes_order order)
{
    (void)self, (void)order;
}

/* Frees the part of the case that this rank has. */
static void release_part(struct engine *e)
{
    if (e->part == NULL) return;
    struct simulation *const sim = e->part->sim;
    second_half_free(e->rows);
    owner_free(e->last);
    sim->processes = NULL;
    part_free(e->part);
    build_free(sim);
    e->rows = NULL;
    e->last = NULL;
    e->part = NULL;
}

/* The file has the spheres of a run that goes on; its name is "" in a new one.
 */
int engine_build_part(struct engine *e, const char *file)
{
    int code;

    e->part = part_create(e->settings, MPI_COMM_WORLD,
                          file[0] != '\0' ? file : NULL, &code);
    code = engine_agree(code);
    if (code != 0) {
        release_part(e);
        return code;
    }
    struct processes *const p = &e->hooks;
    p->cells = partition_cells(&e->part->p);
    p->particles = e->part->sim->particles->next_id;
    p->V = e->part->V;
    p->join = join_nothing;
    p->sum = serve_sum;
    p->largest = serve_largest;
    e->part->sim->processes = p;
    return 0;
}

void engine_slot_file(const char *dir, const char *what, int slot,
                      char path[ENGINE_PATH])
{
    snprintf(path, ENGINE_PATH, "%s/checkpoint.%s.%d", dir, what, slot);
}

/* Sums of the first rank become those of all; the others begin anew. */
static void collect_tally(struct engine *e, struct effect_tally *t)
{
    double sum[2] = {t->sum, t->weight}, most[2] = {t->largest, t->seconds};

    MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    *t = (struct effect_tally){.largest = most[0], .seconds = most[1]};
    if (e->part->p.rank > 0) return;
    t->sum = sum[0];
    t->weight = sum[1];
}

static void collect_tallies(struct engine *e)
{
    struct simulation *const sim = e->part->sim;

    collect_tally(e, &sim->force_scale);
    for (int i = 0; i < sim->n_effects; i++)
        collect_tally(e, &sim->effects[i].tally);
}

double *engine_count(struct engine *e, long *moved)
{
    const struct partition *const p = &e->part->p;
    const double own[3] = {
        e->part->sim->particles->n,
        (double)p->here.own[0] * p->here.own[1] * p->here.own[2], alloc_peak()};
    double *const all = p->rank == 0 ? alloc_doubles(3 * p->size) : NULL;

    collect_tallies(e);
    *moved = spheres_moved(e->part->spheres);
    MPI_Gather(own, 3, MPI_DOUBLE, all, 3, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    return all;
}

/* The cells, and if they are saved the spheres, to or from the files of a slot;
 * a checksum, or -1. */
long engine_visit_part(struct engine *e, const char *dir, int slot,
                       struct state *to, int loading)
{
    struct simulation *const sim = e->part->sim;
    char path[ENGINE_PATH];

    engine_slot_file(dir, "cells", slot, path);
    const long checksum = pieces_visit(e->part, path, to, loading);
    engine_slot_file(dir, "grains", slot, path);
    collect_tallies(e);
    if (!loading) {
        spheres_save(e->part->spheres, path);
        return checksum;
    }
    MPI_Bcast(&sim->t, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    MPI_Bcast(&sim->steps, 1, MPI_LONG, 0, MPI_COMM_WORLD);
    return engine_agree(averaging_bind(sim->averaging)) == 0 ? checksum : -1;
}

/* --- the other ranks ------------------------------------------------------ */

/* The case that the command line names, which the first rank has checked. */
static struct settings *read_case(int argc, char **argv)
{
    const char **const overrides =
        alloc_zeroed((size_t)argc, sizeof *overrides);
    const char *file = "";
    int n = 0, code;

    for (int i = 2; i < argc; i++) {
        const int takes = argv[i][0] == '-' && strchr("osj", argv[i][1]) &&
                          argv[i][1] != '\0';
        const char *const value = takes && argv[i][2] == '\0' && i + 1 < argc
                                      ? argv[i + 1]
                                      : argv[i] + 2;
        if (argv[i][0] != '-') file = argv[i];
        if (takes && argv[i][1] == 's') overrides[n++] = value;
        i += takes && argv[i][2] == '\0';
    }
    struct settings *const s = case_file_read(file, n, overrides, &code);
    if (s != NULL) s->quiet = 1;
    free(overrides);
    return s;
}

static void serve_build(struct engine *e, int argc, char **argv,
                        const char *file)
{
    struct settings *const s = read_case(argc, argv);

    e->settings = s;
    if (engine_agree(s == NULL ? 4 : 0) != 0) return;
    if (engine_build_part(e, file) != 0) return;
    e->last = snapshot_create(e->part->sim);
    e->rows = second_half_create(e->part->sim, s->output.end);
}

/* The same sums in the same order as the recorder makes them. */
static void serve_add_row(struct engine *e)
{
    const struct simulation *const sim = e->part->sim;

    part_count_own(e->part);
    for (const struct history_column *c = history_columns; c->name; c++)
        if (history_applies(c, sim)) c->value(sim);
    second_half_add(e->rows);
}

static void obey(struct engine *e, const struct message *m)
{
    struct part *const part = e->part;

    if (m->order == RELEASE) release_part(e);
    if (m->order == PROCESSES_START) coupling_start(part->sim);
    if (m->order == PROCESSES_STEP) coupling_step(part->sim);
    if (m->order == PROCESSES_SNAPSHOT) snapshot_take(e->last, part->sim);
    if (m->order == PROCESSES_ROW) serve_add_row(e);
    if (m->order == PROCESSES_ROW_DONE) part_count_own(part);
    if (m->order == WRITE) pieces_write(part, e->last, m->path);
    if (m->order == GATHER) pieces_gather(part, e->last, NULL, m->detail);
    if (m->order == COUNT) {
        long moved;
        free(engine_count(e, &moved));
    }
    if (m->order == SAVE || m->order == LOAD)
        engine_visit_part(e, m->path, m->detail, NULL, m->order == LOAD);
}

int engine_serve(int argc, char **argv)
{
    struct engine e = {.settings = NULL};
    struct message m = {.order = BUILD};

    while (m.order != STOP) {
        MPI_Bcast(&m, sizeof m, MPI_BYTE, 0, MPI_COMM_WORLD);
        if (m.order == BUILD)
            serve_build(&e, argc, argv, m.path);
        else
            obey(&e, &m);
    }
    return m.detail;
}
