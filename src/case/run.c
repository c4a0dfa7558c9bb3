/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/run.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/model.h"
#include "base/thread_choice.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "coupling/coupling.h"
#include "coupling/processes.h"
#include "output/folder.h"
#include "case/build.h"
#include "case/case_check.h"
#include "case/case_steps.h"
#include "case/command.h"
#include "case/recorder.h"
#include "case/run_part.h"
#include "case/saver.h"

enum {
    WRONG = 2,
    BROKE_DOWN = 3,
    NOT_WRITTEN = RECORDER_NOT_WRITTEN_CODE,
    INTERRUPTED = INTERRUPT_CODE
};

/* Samples the simulation and adds the wall time that this takes. */
static int sample(struct recorder *r, struct simulation *sim)
{
    double clock = clock_now();
    const int failed = recorder_sample(r);

    clock_add(&sim->seconds.output, &clock);
    return failed;
}

static int step(struct simulation *sim, void *threads)
{
    const double began = clock_processor();

    MODELS_EACH(thread_choices, before_step, threads);
    const int failed = coupling_step(sim);
    MODELS_EACH(thread_choices, after_step, threads);
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
    const struct saver *saver; /* NULL: the run cannot be saved */
    void *memory;              /* of the saver */
    void *part[RUN_PARTS];     /* what the parts have created */
    int resumes;               /* [-] 1: it had begun, and goes on */
    int cut;                   /* [-] 1: a signal ended the last step early */
    char why[RUN_PART_TEXT];   /* the computation broke down */
};

static int broke_down(struct run *run)
{
    const struct simulation *const sim = run->sim;
    int known = 0;

    MODELS_UNTIL(known, run_parts, broke_down, sim, run->why);
    if (!known)
        snprintf(run->why, RUN_PART_TEXT,
                 "the computation broke down at t = %g s (step %ld)", sim->t,
                 sim->steps + 1);
    return BROKE_DOWN;
}

/* The state before the first step: as the case has it, or as it was saved. */
static int start(struct run *run)
{
    if (!run->resumes && coupling_start(run->sim) != 0) return broke_down(run);
    if (!run->resumes && sample(run->recorder, run->sim) != 0)
        return NOT_WRITTEN;
    if (run->saver == NULL) return 0;
    return run->saver->begin(run->memory, run->sim, run->recorder) != 0
               ? NOT_WRITTEN
               : 0;
}

/* The loop. Returns the exit code. A step that was cut short is not sampled. */
static int advance(struct run *run, void *threads)
{
    struct simulation *const sim = run->sim;
    const long steps = case_steps_until_end(run->settings);

    while (sim->steps < steps) {
        const int failed = step(sim, threads);
        int cut_short = 0;

        MODELS_UNTIL(cut_short, run_parts, is_cut_short, sim);
        if (cut_short) return INTERRUPTED;
        run->cut = failed && interrupt_arrived();
        if (run->cut) return INTERRUPTED;
        if (failed) return broke_down(run);
        MODELS_EACH(run_parts, after_step, run->part[i_model], sim);
        if (sample(run->recorder, sim) != 0) return NOT_WRITTEN;
        if (run->saver != NULL && run->saver->after_step(run->memory) != 0)
            return NOT_WRITTEN;
        if (interrupt_arrived()) return INTERRUPTED;
    }
    return 0;
}

static int run_steps(struct run *run)
{
    void *const threads = thread_choice_create();

    for (int i = 0; run_parts[i] != NULL; i++)
        if (run_parts[i]->create != NULL)
            run->part[i] = run_parts[i]->create(run->settings, run->sim);
    int code = advance(run, threads);
    MODELS_EACH(thread_choices, free, threads);
    if (code == INTERRUPTED) interrupt_discard();
    MODELS_EACH(run_parts, after_run, run->part[i_model], run->sim);
    return code;
}

static const char *reason_of(int code, const char *why)
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
                "winnow: interrupted at t = %g s; what is done is in "
                "%s\n",
                run->sim->t, dir);
    else if (code == 0)
        recorder_print(run->recorder);
}

/* The state is saved before the last picture and the other files of the end. */
static int finish(struct run *run, int code)
{
    struct recorder *const r = run->recorder;

    if (code != NOT_WRITTEN && run->saver != NULL &&
        run->saver->end(run->memory, code == BROKE_DOWN || run->cut) != 0)
        code = NOT_WRITTEN;
    if (code == 0 && recorder_last_row(r) != 0) code = NOT_WRITTEN;
    if (code != 0 && code != NOT_WRITTEN && recorder_last_state(r) != 0)
        code = NOT_WRITTEN;
    if (recorder_finish(r, reason_of(code, run->why), code) != 0)
        code = NOT_WRITTEN;
    print_last_line(run, code);
    return code;
}

/* The run after the simulation is built. A run that cannot be resumed does not
 * change the folder. */
static int run_simulation(struct run *run)
{
    if (run->saver != NULL && run->saver->before(run->memory) != 0)
        return NOT_WRITTEN;
    run->recorder =
        recorder_create(run->settings, run->sim, run->folder, run->resumes);
    if (run->recorder == NULL) {
        if (!run->resumes)
            folder_abandon(run->folder); /* if it was not begun */
        return NOT_WRITTEN;
    }
    int code = start(run);
    if (code == 0) code = run_steps(run);
    if (code == 0 || !run->resumes || run->sim->steps > 0)
        code = finish(run, code);
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
    const int code = b->run->saver->settle(b->run->memory, bed, stage);
    if (stage == BED_STAGE_END) interrupt_watch_begin(&b->watch, clean_up, b);
    return code;
}

/* Builds the simulation; a signal during this time ends the program. */
static struct simulation *build(const struct run *run, int *code)
{
    const struct settings *const s = run->settings;

    static const char bed[] = "particles.bed.file";
    struct building b = {.run = run,
                         .folder = run->folder,
                         .bed = settings_has(s, bed) ? settings_text(s, bed)
                                                     : NULL};
    const struct bed_saver saver = {&b, settle};

    interrupt_watch_begin(&b.watch, clean_up, &b);
    struct simulation *const sim =
        processes_engines[0] != NULL
            ? processes_engines[0]->build(s, run->options->dir, run->resumes,
                                          code)
            : build_for_run(s, !run->resumes,
                            run->saver != NULL ? &saver : NULL, code);
    interrupt_watch_end(&b.watch);
    return sim;
}

/* Non-zero, the exit code, after a message. */
static int create_saver(struct run *run)
{
    int code = 0;

    run->saver = savers[0];
    if (run->saver == NULL && run->options->resume)
        fprintf(stderr, "winnow: this program was built without src/case/resume"
                        " and cannot resume a run\n");
    if (run->saver == NULL) return run->options->resume ? WRONG : 0;
    run->memory =
        run->saver->create(run->settings, run->folder, run->options, &code);
    run->resumes = code == 0 && run->saver->is_of_run(run->memory);
    return code;
}

int run_case(const struct settings *s, const struct run_options *o)
{
    int code = 0;

    MODELS_UNTIL(code, case_checks, run, s);
    if (code != 0) return WRONG;
    struct run run = {.settings = s, .options = o};
    run.folder = folder_open(o->dir); /* before settling */
    if (run.folder == NULL) return NOT_WRITTEN;
    code = create_saver(&run);
    if (code == 0 && !run.resumes && folder_is_used(run.folder) &&
        !settings_quiet(s))
        fprintf(stderr,
                "%s: the files of an earlier run are replaced; -o names "
                "another folder\n",
                o->dir);
    if (code == 0) run.sim = build(&run, &code);
    const int built = run.sim != NULL;
    if (built) code = run_simulation(&run);
    if (run.memory != NULL) run.saver->free(run.memory);
    if (!built) folder_abandon(run.folder);
    build_free(run.sim);
    folder_free(run.folder);
    return code;
}

/* out/NAME for a case some/where/NAME.cfg, as a new string. Of a name that
 * begins with a dot nothing is cut off, because ".cfg" would become "". */
static char *default_dir(const char *file)
{
    const char *const slash = strrchr(file, '/');
    const char *const name = slash != NULL ? slash + 1 : file;
    char *const dir = file_join("out", name);
    char *const dot = strrchr(dir, '.');

    if (dot != NULL && name[0] != '.') *dot = '\0';
    return dir;
}

static int act(const struct command_line *l)
{
    int code;
    struct interrupt_watch watch;

    /* With --quiet there are only files, and errors on stderr. */
    if (l->quiet && freopen("/dev/null", "w", stdout) == NULL)
        return NOT_WRITTEN;
    char *const dir = default_dir(l->words[0]);
    const struct run_options o = {.dir = l->dir != NULL ? l->dir : dir,
                                  .resume = l->resume,
                                  .fresh = l->fresh,
                                  .n_overrides = l->n_overrides,
                                  .overrides = l->overrides};

    interrupt_hold();
    interrupt_watch_begin(&watch, NULL, NULL);
    struct settings *const s = command_settings(l, &code);
    interrupt_watch_end(&watch);
    if (l->threads > 0) omp_set_num_threads(l->threads);
    if (s != NULL && l->quiet) settings_set_quiet(s);
    if (s != NULL) code = run_case(s, &o);
    settings_free(s);
    free(dir);
    return code;
}

const struct command command_run = {
    "run",
    "CASE [-o DIR] [-s path.to.key=value]... [-j THREADS] [--resume] [--fresh] "
    "[--quiet]",
    "run a case; DIR is out/ and the name of the case if not given; --resume "
    "continues where the run in DIR ended, --fresh settles its bed anew, "
    "--quiet prints errors only",
    "osj-rf",
    1,
    1,
    act};
