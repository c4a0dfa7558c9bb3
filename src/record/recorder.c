/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/recorder.h"

#include <assert.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/processes.h"
#include "dem/population/population.h"
#include "output/series.h"
#include "output/table.h"
#include "record/snapshot.h"

enum { MAX_COLUMNS = 128, PARTS = 32 };

struct recorder {
    struct recording of;
    const struct simulation *sim;
    const struct simulation *drawn; /* what pictures show: all processes */
    struct folder *folder;          /* borrowed */
    double began;                   /* [s] wall clock */
    double ended;                   /* [s] the same; 0 while the run goes on */
    int n_own; /* [-] columns of the table; those of effects follow */
    const struct history_column *column[MAX_COLUMNS];
    struct table *history;
    struct snapshot *snapshot;
    struct snapshot *whole; /* of what is drawn; the same on one machine */
    struct field_output *pictures;
    /* Those that this simulation uses, ended by NULL. */
    const struct recorder_part *part[PARTS + 1];
    void *state[PARTS];
    /* For the summary: the worst of the whole run. */
    double worst_mass, worst_momentum, worst_exchange, worst_overlap, worst_cfl;
    double eps_lowest;
    long capped_steps;
};

/* --- the parts ------------------------------------------------------------ */

const struct recorder_part *const recorder_parts[] = {
    &recorder_second_half,   &recorder_profiles,        &recorder_probes,
    &recorder_effect_shares, &recorder_contacts,        &recorder_forces,
    &recorder_walls,         &recorder_particle_fields, &recorder_clumps,
    &recorder_bodies,        &recorder_bodies_among,    &recorder_outlines,
    &recorder_bodies_left,   &recorder_statistics,      &recorder_surface_table,
    &recorder_surfaces,      &recorder_pictures,        NULL};

/* 1: all files are unstructured grids. */
static int all_grids(const struct recording *of)
{
    return strcmp(of->output->format, "vtu") == 0;
}

struct series *recorder_series(const struct recorder_view *v, const char *name)
{
    return series_in(v->folder, name, all_grids(v->of) ? "vtu" : "vtp");
}

/* Non-zero after a message: a file cannot be written. */
static int choose_parts(struct recorder *r)
{
    const struct recorder_view v = {.of = &r->of,
                                    .sim = r->sim,
                                    .drawn = r->drawn,
                                    .snapshot = r->snapshot,
                                    .whole = r->whole,
                                    .folder = r->folder};
    int failed = 0, n = 0;

    /* First: it sums over the processes what the other parts write. */
    if (processes_engine != NULL) {
        r->part[n] = processes_engine->summary;
        r->state[n++] = processes_engine->summary->create(&v, &failed);
    }
    for (int i = 0; recorder_parts[i] != NULL && !failed; i++) {
        assert(n < PARTS);
        const struct recorder_part *const part = recorder_parts[i];
        r->state[n] = part->create(&v, &failed);
        if (r->state[n] != NULL && failed)
            part->free(r->state[n]);
        else if (r->state[n] != NULL)
            r->part[n++] = part;
    }
    return failed;
}

void recorder_free(struct recorder *r)
{
    if (r == NULL) return;
    table_free(r->history);
    MODELS_EACH(r->part, free, r->state[i_model]);
    field_output_free(r->pictures);
    if (r->whole != r->snapshot) owner_free(r->whole);
    owner_free(r->snapshot);
    free(r);
}

/* --- extremes for the summary --------------------------------------------- */

/* Keeps the largest overlap, residuals and Courant number, the lowest eps. */
static void update_extremes(struct recorder *r)
{
    const struct simulation *const sim = r->sim;

    if (sim->particles != NULL)
        r->worst_overlap = fmax(r->worst_overlap, sim->dem_report.max_overlap);
    if (sim->fluid != NULL && sim->steps > 0) {
        const struct fluid_report *const f = &sim->fluid->report;
        r->worst_mass = fmax(r->worst_mass, f->mass_residual);
        r->worst_momentum = fmax(r->worst_momentum, f->momentum_residual);
        r->worst_cfl = fmax(r->worst_cfl, f->cfl);
    }
    if (sim->coupling != NULL) {
        const struct coupling_report *const c = &sim->coupling->report;
        r->worst_exchange = fmax(r->worst_exchange, c->exchange_residual);
        r->eps_lowest = fmin(r->eps_lowest, c->eps_lowest);
        r->capped_steps += averaging_report(sim->averaging)->capped > 0;
    }
}

/* --- rows and fields ------------------------------------------------------ */

/* Adds a row to history.csv, with the columns of the effects behind its own. */
static int recorder_add_row(struct recorder *r)
{
    const struct effect_state *const all = r->sim->effects;
    double row[MAX_COLUMNS];
    int n = r->n_own;

    for (int i = 0; i < r->n_own; i++)
        row[i] = r->column[i]->value(r->sim);
    for (int i = 0; i < r->sim->n_effects; i++)
        if (all[i].effect->columns != NULL)
            n += all[i].effect->columns->row(all[i].memory, r->sim, &row[n]);
    return table_add(r->history, row) != 0;
}

/* Writes the fields of the snapshot for ParaView, and those of the models. */
static int recorder_add_fields(struct recorder *r)
{
    int failed = field_output_add(r->pictures, r->snapshot);

    MODELS_UNTIL(failed, r->part, fields, r->state[i_model], r->snapshot->t);
    return failed;
}

/* Copies the present state, and gathers it where several processes compute
 * it. */
static void recorder_take_snapshots(struct recorder *r)
{
    struct processes *const others = r->sim->processes;

    snapshot_take(r->snapshot, r->sim);
    if (r->whole != r->snapshot) others->gather(others, r->snapshot, r->whole);
}

int recorder_sample(struct recorder *r)
{
    const long step = r->sim->steps;

    update_extremes(r);
    if (step % r->of.row_every == 0) {
        recorder_take_snapshots(r);
        processes_join(r->sim, PROCESSES_ROW);
        /* The means of the parts are sums over all processes, so they are
         * computed even if the row could not be written. */
        const int unwritten = recorder_add_row(r);
        int failed = 0;
        MODELS_UNTIL(failed, r->part, row, r->state[i_model]);
        processes_join(r->sim, PROCESSES_ROW_DONE);
        if (unwritten || failed) return 1;
    }
    if (step % r->of.picture_every != 0) return 0;
    recorder_take_snapshots(r);
    return recorder_add_fields(r);
}

int recorder_last_row(struct recorder *r)
{
    if (r->sim->steps % r->of.row_every == 0 || r->sim->processes != NULL)
        return 0;
    recorder_take_snapshots(r);
    int failed = recorder_add_row(r);
    MODELS_UNTIL(failed, r->part, last_row, r->state[i_model]);
    return failed;
}

int recorder_last_state(struct recorder *r)
{
    if (r->snapshot->t <= field_output_last(r->pictures)) return 0;
    return recorder_add_fields(r);
}

/* --- the summary ---------------------------------------------------------- */

static void write_seconds(struct summary *f, const struct recorder *r)
{
    const struct seconds *const s = &r->sim->seconds;

    summary_begin(f, "seconds");
    summary_number(f, "cfd", s->cfd);
    summary_number(f, "dem", s->dem);
    summary_number(f, "averaging", s->averaging);
    summary_number(f, "exchange", s->exchange);
    summary_number(f, "output", s->output);
    summary_number(f, "total",
                   (r->ended > 0.0 ? r->ended : clock_now()) - r->began);
    summary_number(f, "processor", s->processor);
    summary_end(f);
}

static double recorder_rate(double amount, double seconds)
{
    return seconds > 0.0 ? amount / seconds : 0.0;
}

static void write_speed(struct summary *f, const struct recorder *r)
{
    const struct simulation *const sim = r->sim;

    if (sim->particles != NULL)
        summary_number(f, "particle_steps_per_second",
                       recorder_rate((double)sim->steps * sim->dem_steps *
                                         processes_particles(sim),
                                     sim->seconds.dem));
    if (sim->fluid != NULL)
        summary_number(f, "cell_steps_per_second",
                       recorder_rate((double)sim->steps * processes_cells(sim),
                                     sim->seconds.cfd));
}

static void write_residuals(struct summary *f, const struct recorder *r)
{
    summary_begin(f, "worst");
    if (r->sim->fluid != NULL) {
        summary_number(f, "mass_residual", r->worst_mass);
        summary_number(f, "momentum_residual", r->worst_momentum);
        summary_number(f, "cfl", r->worst_cfl);
    }
    if (r->sim->coupling != NULL) {
        summary_number(f, "exchange_residual", r->worst_exchange);
        summary_number(f, "eps_f_lowest", r->eps_lowest);
        summary_count(f, "steps_with_capped_cells", r->capped_steps);
    }
    if (r->sim->particles != NULL)
        summary_number(f, "overlap", r->worst_overlap);
    summary_end(f);
}

static void write_counts(struct summary *f, const struct recorder *r)
{
    struct effect_count c[EFFECT_COUNTS];

    for (int i = 0; i < r->sim->n_effects; i++) {
        const struct effect_state *const e = &r->sim->effects[i];
        const int n =
            e->effect->counts != NULL ? e->effect->counts(e->memory, c) : 0;
        for (int k = 0; k < n; k++)
            summary_count(f, c[k].name, c[k].value);
    }
}

static void summarize_count(struct summary *f, const char *key, double n)
{
    long count = 0;

    if (number_long(n, &count) == 0) summary_count(f, key, count);
}

static void write_population(struct summary *f, const struct simulation *sim)
{
    summary_count(f, "particles_in", sim->population->totals.inserted);
    summary_count(f, "particles_out", sim->population->totals.removed);
    summary_count(f, "particles_waiting", sim->population->totals.waiting);
}

/* The exit code of a run that has not ended: null in the summary. */
enum { STILL_RUNNING = -1 };

static int write_summary(const struct recorder *r, const char *reason, int code)
{
    const struct simulation *const sim = r->sim;
    char *const path = file_join(folder_name(r->folder), "summary.json");
    struct summary *const f = summary_create(path);
    free(path);
    summary_text(f, "program", "winnow " VERSION_TEXT);
    summary_text(f, "case", r->of.file);
    summary_text(f, "exit_reason", reason);
    summary_number(f, "exit_code", code < 0 ? (double)NAN : code);
    if (r->of.seed != NULL) summary_count(f, "seed", *r->of.seed);
    summary_count(f, "threads", omp_get_max_threads());
    summarize_count(f, "cells", processes_cells(sim));
    summarize_count(f, "particles", processes_particles(sim));
    if (sim->population != NULL) write_population(f, sim);
    summary_number(f, "step", sim->dt);
    summary_count(f, "particle_steps_in_a_step", sim->dem_steps);
    if (sim->dem_steps > 0)
        summary_number(f, "particle_step", sim->dt / sim->dem_steps);
    summary_count(f, "steps", sim->steps);
    summary_number(f, "simulated_seconds", sim->t);
    write_seconds(f, r);
    summary_number(f, "peak_memory", alloc_peak());
    write_speed(f, r);
    write_residuals(f, r);
    write_counts(f, r);
    MODELS_EACH(r->part, summarize, r->state[i_model], f);
    return summary_commit(f);
}

/* --- the beginning -------------------------------------------------------- */

static void add_column(struct recorder *r, struct table_head *head,
                       const struct history_column *c)
{
    assert(r->n_own < MAX_COLUMNS);
    r->column[r->n_own++] = c;
    table_head_add(head, "%s", c->name);
}

static struct table *create_history(struct recorder *r)
{
    struct table_head head = {0};

    for (const struct history_column *c = history_columns; c->name; c++)
        if (history_applies(c, r->sim)) add_column(r, &head, c);
    for (int i = 0; r->part[i] != NULL; i++)
        for (const struct history_column *c = r->part[i]->columns;
             c != NULL && c->name != NULL; c++)
            add_column(r, &head, c);
    for (int i = 0; i < r->sim->n_effects; i++) {
        const struct effect_columns *const more =
            r->sim->effects[i].effect->columns;
        for (int k = 0; more != NULL && more->names[k] != NULL; k++)
            table_head_add(&head, "%s", more->names[k]);
    }
    assert(head.n <= MAX_COLUMNS);
    return folder_table(r->folder, "history.csv", &head);
}

/* A run that is killed leaves this summary. */
int recorder_begin(const struct recorder *r)
{
    return write_summary(r, "running", STILL_RUNNING);
}

/* A summary from the start; that of a run that goes on stays as it is until the
 * state is loaded. Non-zero after a message. */
static int recorder_begin_summary(struct recorder *r, int resume)
{
    if (resume)
        folder_resume(r->folder);
    else if (folder_begin(r->folder) != 0)
        return 1;
    return folder_add(r->folder, "summary.json") != 0 ||
           folder_add(r->folder, "report.html") != 0 || /* by command */
           (!resume && recorder_begin(r) != 0);
}

/* What writes from the start; non-zero after a message. */
static int create_files(struct recorder *r)
{
    if (choose_parts(r) != 0) return 1;
    r->history = create_history(r);
    if (r->history == NULL) return 1;
    r->pictures = field_output_create(r->sim, r->folder, all_grids(&r->of));
    return r->pictures == NULL;
}

struct recorder *recorder_create(const struct recording *of,
                                 const struct simulation *sim,
                                 struct folder *folder, int resume)
{
    struct recorder *const r = alloc_zeroed(1, sizeof *r);

    r->of = *of;
    r->sim = sim;
    r->folder = folder;
    r->began = clock_now();
    r->eps_lowest = 1.0;
    r->snapshot = r->whole = snapshot_create(sim);
    r->drawn = sim;
    if (sim->processes != NULL && sim->processes->whole != NULL) {
        r->drawn = sim->processes->whole;
        r->whole = snapshot_create(r->drawn);
    }
    if (recorder_begin_summary(r, resume) == 0) {
        if (create_files(r) == 0) return r;
        if (!resume)
            write_summary(r, RECORDER_NOT_WRITTEN, RECORDER_NOT_WRITTEN_CODE);
    }
    recorder_free(r);
    return NULL;
}

/* --- the end -------------------------------------------------------------- */

/* The summary is written last, so that all files exist when it says "done".
 * Where writing has failed before, only the summary is tried. */
int recorder_finish(struct recorder *r, const char *reason, int exit_code)
{
    r->ended = clock_now();
    int failed = 0;
    if (strcmp(reason, RECORDER_NOT_WRITTEN) != 0)
        MODELS_UNTIL(failed, r->part, finish, r->state[i_model]);
    if (failed) {
        write_summary(r, RECORDER_NOT_WRITTEN, RECORDER_NOT_WRITTEN_CODE);
        return 1;
    }
    return write_summary(r, reason, exit_code) != 0;
}

void recorder_print(const struct recorder *r)
{
    const struct simulation *const sim = r->sim;
    const char *const dir = folder_name(r->folder);

    MODELS_EACH(r->part, print, r->state[i_model]);
    if (sim->fluid != NULL)
        printf("open %s/fluid.pvd%s in ParaView\n", dir,
               sim->particles != NULL ? " and particles.pvd" : "");
    else
        printf("open %s/particles.pvd in ParaView\n", dir);
}

/* --- the visit of all output. Chapter "Nothing is lost". ------------------ */

static void recorder_state_sums(struct recorder *r, struct state *s)
{
    double elapsed = clock_now() - r->began;

    state_real(s, "elapsed", "s", &elapsed);
    r->began = clock_now() - elapsed;
    state_real(s, "worst_mass", "-", &r->worst_mass);
    state_real(s, "worst_momentum", "-", &r->worst_momentum);
    state_real(s, "worst_exchange", "-", &r->worst_exchange);
    state_real(s, "worst_overlap", "-", &r->worst_overlap);
    state_real(s, "worst_cfl", "-", &r->worst_cfl);
    state_real(s, "eps_lowest", "-", &r->eps_lowest);
    state_long(s, "capped_steps", "-", &r->capped_steps);
}

/* The folder is visited last: it removes later files only after all others have
 * been found. */
void recorder_state(struct recorder *r, struct state *s)
{
    state_begin(s, "recorder");
    recorder_state_sums(r, s);
    if (r->sim->processes == NULL)
        snapshot_state(r->snapshot, r->sim->mesh, s);
    else if (s->loading)
        recorder_take_snapshots(r);
    table_state(r->history, s);
    MODELS_EACH(r->part, state, r->state[i_model], s);
    field_output_state(r->pictures, s);
    folder_state(r->folder, s);
    state_end(s);
}
