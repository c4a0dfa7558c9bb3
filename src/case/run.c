/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/run.h"

#include <stdio.h>

#include "base/clock.h"
#include "base/thread_tuner.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "coupling/coupling.h"
#include "coupling/processes.h"
#include "output/folder.h"
#include "case/build.h"
#include "case/checks/checks.h"
#include "case/case_file.h"
#include "record/recorder.h"
#include "coupling/simulation.h"
#include "case/particles/case_population.h"
#include "case/resume/resume.h"

enum {
    WRONG = 2,
    BROKE_DOWN = 3,
    NOT_WRITTEN = RECORDER_NOT_WRITTEN_CODE,
    INTERRUPTED = INTERRUPT_CODE
};

/* Samples the simulation and adds the wall time that this takes. */
static int run_sample(struct recorder *r, struct simulation *sim)
{
    double clock = clock_now();
    const int failed = recorder_sample(r);

    clock_add(&sim->seconds.output, &clock);
    return failed;
}

static int run_step(struct simulation *sim, struct thread_tuner *threads)
{
    const double began = clock_processor();

    thread_tuner_before_step(threads);
    const int failed = coupling_step(sim);
    thread_tuner_after_step(threads);
    sim->seconds.processor += clock_processor() - began;
    return failed;
}

/* The parts of a run; all but the recorder are borrowed. */
struct run {
    const struct settings *settings;
    const struct run_options *options;
    struct folder *folder;
    struct simulation *sim;
    struct recorder *recorder;
    struct resume *resume;
    int resumes;              /* [-] 1: it had begun, and goes on */
    int cut;                  /* [-] 1: a signal ended the last step early */
    int told;                 /* [-] 1: of an overlap deeper than expected */
    char why[BREAKDOWN_TEXT]; /* the computation broke down */
};

static int broke_down(struct run *run)
{
    breakdown_describe(run->sim, run->why);
    return BROKE_DOWN;
}

/* The state before the first step: as the case has it, or as it was saved. */
static int run_start(struct run *run)
{
    if (!run->resumes && coupling_start(run->sim) != 0) return broke_down(run);
    if (!run->resumes && run_sample(run->recorder, run->sim) != 0)
        return NOT_WRITTEN;
    return resume_begin(run->resume, run->sim, run->recorder);
}

/* One step. One that was cut short is not sampled. */
static int advance_one(struct run *run, struct thread_tuner *threads,
                       struct progress *progress)
{
    struct simulation *const sim = run->sim;
    const int failed = run_step(sim, threads);

    run->cut = failed && interrupt_arrived();
    if (run->cut || case_population_is_cut_short(sim)) return INTERRUPTED;
    if (failed) return broke_down(run);
    progress_show(progress, sim->t);
    breakdown_warn(&run->told, sim);
    if (run_sample(run->recorder, sim) != 0) return NOT_WRITTEN;
    if (resume_after_step(run->resume) != 0) return NOT_WRITTEN;
    return interrupt_arrived() ? INTERRUPTED : 0;
}

/* The loop. Returns the exit code. */
static int run_advance(struct run *run)
{
    struct simulation *const sim = run->sim;
    const long steps = case_steps_until_end(run->settings);
    struct thread_tuner *const threads = thread_tuner_create();
    struct progress progress;
    int code = 0;

    run->told = breakdown_overlaps(sim); /* before this run went on */
    progress_init(&progress, sim->t, run->settings->output.end,
                  run->settings->quiet);
    while (code == 0 && sim->steps < steps)
        code = advance_one(run, threads, &progress);
    thread_tuner_free(threads);
    if (code == INTERRUPTED) interrupt_discard();
    progress_end(&progress);
    case_population_report_waiting(sim);
    return code;
}

static const char *run_reason_of(int code, const char *why)
{
    return code == 0             ? "done"
           : code == INTERRUPTED ? "interrupted"
           : code == NOT_WRITTEN ? RECORDER_NOT_WRITTEN
                                 : why;
}

static void print_last_line(const struct run *run, int code)
{
    const char *const dir = run->options->dir;

    if (code == BROKE_DOWN)
        fprintf(stderr, "winnow: %s\nthe last good state is in %s\n", run->why,
                dir);
    else if (code == INTERRUPTED)
        fprintf(stderr,
                "winnow: interrupted at t = %g s; what is done is in %s\n",
                run->sim->t, dir);
    else if (code == 0)
        recorder_print(run->recorder);
}

/* The state is saved before the last picture and the other files of the end. */
static int run_finish(struct run *run, int code)
{
    struct recorder *const r = run->recorder;

    if (code != NOT_WRITTEN &&
        resume_end(run->resume, code == BROKE_DOWN || run->cut) != 0)
        code = NOT_WRITTEN;
    if (code == 0 && recorder_last_row(r) != 0) code = NOT_WRITTEN;
    if (code != 0 && code != NOT_WRITTEN && recorder_last_state(r) != 0)
        code = NOT_WRITTEN;
    if (recorder_finish(r, run_reason_of(code, run->why), code) != 0)
        code = NOT_WRITTEN;
    print_last_line(run, code);
    return code;
}

/* What the recorder is told of the case. */
static struct recording run_recording(const struct settings *s)
{
    return (struct recording){
        .file = s->file,
        .title = s->title,
        .output = &s->output,
        .seed = s->particles.has_bed ? &s->particles.bed.seed : NULL,
        .filter = s->bodies.filter,
        .quiet = s->quiet,
        .row_every = case_steps_between_rows(s),
        .picture_every = case_steps_between(s, s->output.every),
        .steps = case_steps_until_end(s)};
}

/* The run after the simulation is built. A run that cannot be resumed does not
 * change the folder. */
static int run_simulation(struct run *run)
{
    if (resume_before(run->resume) != 0) return NOT_WRITTEN;
    const struct recording of = run_recording(run->settings);
    run->recorder = recorder_create(&of, run->sim, run->folder, run->resumes);
    if (run->recorder == NULL) {
        if (!run->resumes)
            folder_abandon(run->folder); /* if it was not begun */
        return NOT_WRITTEN;
    }
    int code = run_start(run);
    if (code == 0) code = run_advance(run);
    if (code != WRONG) code = run_finish(run, code);
    recorder_free(run->recorder);
    return code;
}

/* What is removed if the program ends while the simulation is built. */
struct building {
    const struct run *run;
    struct folder *folder;
    const char *bed; /* the file that a bed is kept in; or NULL */
    struct interrupt_watch watch;
};

static void clean_up(void *data)
{
    const struct building *const b = data;

    folder_abandon(b->folder);
    if (b->bed != NULL) file_remove_part(b->bed);
}

/* A signal that arrives while a bed settles waits until the bed is saved. */
static int settle(void *data, struct bed_settling *bed, enum bed_stage stage)
{
    struct building *const b = data;

    if (stage == BED_STAGE_START) interrupt_watch_end(&b->watch);
    const int code = resume_settle(b->run->resume, bed, stage);
    if (stage == BED_STAGE_END) interrupt_watch_begin(&b->watch, clean_up, b);
    return code;
}

/* Builds the simulation; a signal during this time ends the program. */
static struct simulation *run_build(const struct run *run, int *code)
{
    const struct settings *const s = run->settings;

    struct building b = {
        .run = run, .folder = run->folder, .bed = s->particles.bed_file};
    const struct bed_saver saver = {&b, settle};

    interrupt_watch_begin(&b.watch, clean_up, &b);
    struct simulation *const sim =
        processes_engine != NULL
            ? processes_engine->build(s, run->options->dir, run->resumes, code)
            : build_for_run(s, !run->resumes, &saver, code);
    interrupt_watch_end(&b.watch);
    return sim;
}

int run_case(const struct settings *s, const struct run_options *o)
{
    int code = 0;

    if (processes_check_run(s) != 0 || case_scales_check(s) != 0) return WRONG;
    struct run run = {.settings = s, .options = o};
    run.folder = folder_open(o->dir); /* before settling */
    if (run.folder == NULL) return NOT_WRITTEN;
    run.resume = resume_create(s, run.folder, o, &code);
    if (run.resume != NULL) {
        run.resumes = resume_is_of_run(run.resume);
        if (!run.resumes && folder_is_used(run.folder) && !s->quiet)
            fprintf(stderr,
                    "%s: the files of an earlier run are replaced; -o names "
                    "another folder\n",
                    o->dir);
        run.sim = run_build(&run, &code);
    }
    const int built = run.sim != NULL;
    if (built) code = run_simulation(&run);
    resume_free(run.resume);
    if (!built) folder_abandon(run.folder);
    build_free(run.sim);
    folder_free(run.folder);
    return code;
}
