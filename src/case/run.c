/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/run.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/thread_tuner.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "coupling/coupling.h"
#include "output/folder.h"
#include "case/breakdown.h"
#include "case/build.h"
#include "case/case_part.h"
#include "case/case_overlap.h"
#include "case/case_steps.h"
#include "case/command.h"
#include "case/case_scales.h"
#include "case/progress.h"
#include "case/recorder.h"

enum {
    WRONG = 2,
    BROKE_DOWN = 3,
    NOT_WRITTEN = RECORDER_NOT_WRITTEN_CODE,
    INTERRUPTED = INTERRUPT_CODE
};

/* Looks and keeps the time that writing takes. */
static int sample(struct recorder *r, struct simulation *sim)
{
    double clock = clock_now();
    const int failed = recorder_sample(r);

    clock_add(&sim->seconds.output, &clock);
    return failed;
}

/* One step, by as many threads as pay. */
static int step(struct simulation *sim, struct thread_tuner *crew)
{
    thread_tuner_begin(crew);
    const int failed = coupling_step(sim);
    thread_tuner_end(crew);
    return failed;
}

/* The loop. Returns the exit code; a breakdown is described in why. A step that
 * was interrupted may have been cut short: it is not looked at. */
static int advance(const struct settings *s, struct simulation *sim,
                   struct recorder *r, struct progress *bar,
                   struct thread_tuner *crew, char *why)
{
    const long steps = case_steps_until_end(s);
    int told = 0;

    if (coupling_start(sim) != 0) {
        breakdown_describe(sim, why);
        return BROKE_DOWN;
    }
    if (sample(r, sim) != 0) return NOT_WRITTEN;
    while (sim->steps < steps) {
        const int failed = step(sim, crew);

        if (interrupt_arrived()) return INTERRUPTED;
        if (failed) {
            breakdown_describe(sim, why);
            return BROKE_DOWN;
        }
        case_overlap_tell(sim, &told);
        if (sample(r, sim) != 0) return NOT_WRITTEN;
        progress_show(bar, sim->t);
    }
    return 0;
}

static const char *reason_of(int code, const char *why)
{
    return code == 0             ? "done"
           : code == INTERRUPTED ? "interrupted"
           : code == NOT_WRITTEN ? RECORDER_NOT_WRITTEN
                                 : why;
}

/* Everything after the simulation is built. */
static int run_simulation(const struct settings *s, struct simulation *sim,
                          struct folder *folder, const struct run_options *o)
{
    struct recorder *const r = recorder_create(s, sim, folder);
    struct progress bar;
    struct thread_tuner crew;
    char why[BREAKDOWN_TEXT] = "";

    if (r == NULL) {
        folder_leave(folder); /* if it was not begun */
        return NOT_WRITTEN;
    }
    progress_init(&bar, 0.0, settings_real(s, "output.end"), o->quiet);
    thread_tuner_use_all(&crew);
    int code = advance(s, sim, r, &bar, &crew, why);
    thread_tuner_restore(&crew);
    progress_end(&bar);
    if (code == INTERRUPTED) interrupt_take();
    case_part_after_run(sim);
    if (code != 0 && code != NOT_WRITTEN && recorder_last_state(r) != 0)
        code = NOT_WRITTEN;
    if (recorder_finish(r, reason_of(code, why), code) != 0) code = NOT_WRITTEN;
    if (code == BROKE_DOWN)
        fprintf(stderr, "winnow: %s\nthe last good state is in %s\n", why,
                o->dir);
    else if (code == INTERRUPTED)
        fprintf(stderr,
                "winnow: interrupted at t = %g s; what is done is in "
                "%s\n",
                sim->t, o->dir);
    else if (code == 0)
        recorder_print(r);
    recorder_free(r);
    return code;
}

/* What is to be cleared away if the run does not begin. */
struct beginning {
    struct folder *folder;
    const char *bed; /* the file that a bed is kept in; or NULL */
};

static void leave(void *of)
{
    const struct beginning *const b = of;

    folder_leave(b->folder);
    if (b->bed != NULL) file_remove_part(b->bed);
}

/* The simulation; a signal meanwhile ends the program. */
static struct simulation *build(const struct settings *s, struct folder *folder,
                                int *code)
{
    static const char bed[] = "particles.bed.file";
    struct beginning b = {folder,
                          settings_has(s, bed) ? settings_text(s, bed) : NULL};
    struct interrupt_watch watch;

    interrupt_watch_begin(&watch, leave, &b);
    struct simulation *const sim = build_simulation(s, code);
    interrupt_watch_end(&watch);
    if (sim == NULL) folder_leave(folder);
    return sim;
}

int run_case(const struct settings *s, const struct run_options *o)
{
    int code;

    if (case_scales_check(s) != 0) return WRONG;
    struct folder *const folder = folder_take(o->dir); /* before settling */
    if (folder == NULL) return NOT_WRITTEN;
    if (o->quiet) folder_be_quiet(folder);
    struct simulation *const sim = build(s, folder, &code);
    if (sim != NULL) code = run_simulation(s, sim, folder, o);
    build_free(sim);
    folder_free(folder);
    return code;
}

/* out/NAME for a case some/where/NAME.cfg, as a new string. A name that begins
 * with a dot stays whole, because it would become that of another folder. */
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
    char *const dir = default_dir(l->words[0]);
    const struct run_options o = {l->dir != NULL ? l->dir : dir, l->quiet};

    interrupt_hold();
    interrupt_watch_begin(&watch, NULL, NULL);
    struct settings *const s = command_settings(l, &code);
    interrupt_watch_end(&watch);
    if (l->threads > 0) omp_set_num_threads(l->threads);
    if (s != NULL && l->quiet) settings_be_quiet(s);
    if (s != NULL) code = run_case(s, &o);
    settings_free(s);
    free(dir);
    return code;
}

const struct command command_run = {
    "run",
    "CASE [-o DIR] [-s path.to.key=value]... [-j THREADS] [--quiet]",
    "run a case; DIR is out/ and the name of the case if not given",
    "osj-",
    1,
    1,
    act};
