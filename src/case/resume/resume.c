/* SPDX-License-Identifier: GPL-3.0-or-later */
/* resume.c -- saves the state of a run, and resumes it.  Chapter "Nothing is
 * lost".
 *
 * DIR/checkpoint is written before the first step, every output.checkpoint
 * seconds of wall time, on SIGUSR1, and at every end; DIR/checkpoint.before is
 * the one before it. DIR/checkpoint.ahead is of a run that has not begun: it
 * has the bed that settles, and stays until there is a first checkpoint. In
 * between, a copy of the state in memory is renewed about
 * every second, for a run that breaks down has no good state any more. */
#include "case/checks/case_scales.h"
#include "case/resume/resume.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "case/case_steps.h"
#include "case/resume/ahead.h"
#include "case/resume/bed_cache.h"
#include "case/resume/case_copy.h"
#include "case/resume/case_text.h"
#include "case/resume/state_texts.h"
#include "output/checkpoint/state_file.h"

/* Wall time between two copies: at least this, and so many times what one
 * takes [s], [-]. */
static const double shortest_interval = 1.0, least_ratio = 50.0;

struct resume {
    const struct settings *settings;
    const struct run_options *options;
    struct folder *folder;
    struct simulation *sim;
    struct recorder *recorder;
    char *path, *before;      /* of the two files */
    struct ahead *ahead;      /* the third file */
    char *lines;              /* the case (case_text.h) */
    struct case_copy *copy;   /* of the case, for the folder */
    struct state_file *found; /* to resume from; NULL */
    struct state_image image; /* the last copy of the state */
    long sampled;             /* [-] steps whose results were written */
    double copied, written;   /* [s] wall clock of the last of each */
    double cost;              /* [s] that a copy takes */
};

/* --- saving --------------------------------------------------------------- */

static int visit_all(const struct resume *r, struct state_file *f)
{
    struct state *const s = state_file_state(f);

    if (simulation_state(r->sim, s) == 0) recorder_state(r->recorder, s);
    return s->failed;
}

/* A copy of the state as it is now. */
static int copy_state(struct resume *r)
{
    double clock = clock_now();
    struct state_file *const f = state_file_create();

    state_texts_put(f, r->settings, r->options, r->lines);
    visit_all(r, f);
    free(r->image.bytes);
    r->image = state_file_image(f);
    r->cost = 0.0;
    clock_add(&r->cost, &clock);
    r->copied = clock;
    return r->image.bytes == NULL;
}

/* Writes the copy; the file of before becomes the one before. */
static int write_copy(struct resume *r)
{
    r->written = clock_now();
    return state_file_write(&r->image, r->path, r->before);
}

static int resume_save(struct resume *r)
{
    return copy_state(r) != 0 || write_copy(r) != 0;
}

/* --- finding -------------------------------------------------------------- */

/* The newer of the two files that is whole; *damaged counts the others. */
static struct state_file *find_whole(const struct resume *r, int *damaged)
{
    const char *const path[2] = {r->path, r->before};

    *damaged = 0;
    for (int i = 0; i < 2; i++) {
        const char *why;
        struct state_file *const f = state_file_open(path[i], &why);
        if (f != NULL) return f;
        if (why == NULL) continue;
        ++*damaged;
        fprintf(stderr, "winnow: %s is not used: %s\n", path[i], why);
    }
    return NULL;
}

/* Whether what was found is of another case; then after a message, unless path
 * is NULL. */
static int is_other(const struct resume *r, const char *path)
{
    char *const was = state_file_text(r->found, "settings");
    const int other = case_text_differs(was, r->lines, path);

    free(was);
    if (!other && path != NULL) state_texts_print_version(r->found, path);
    return other;
}

/* Of the state that was found; non-zero after a message. */
static int is_after_end(const struct resume *r)
{
    const double t = state_file_number(r->found, "/t");
    const double end = r->settings->output.end;

    if (!(t > end + 0.5 * case_steps_length(r->settings))) return 0;
    fprintf(stderr,
            "winnow: output.end is %g s, and the run in %s is at t = %g s "
            "already: a run can only be continued to a later end\n",
            end, folder_name(r->folder), t);
    return 1;
}

/* Finds what the run goes on from: a state of this case or, if there is none, a
 * bed of this case that settles. Non-zero after a message. */
static int resume_find(struct resume *r)
{
    int damaged;

    r->found = find_whole(r, &damaged);
    if (r->found != NULL && !is_other(r, NULL))
        return is_other(r, r->path) || is_after_end(r);
    if (ahead_find(r->ahead)) {
        const int other = ahead_is_other(r->ahead, 1);
        state_file_free(r->found);
        r->found = NULL;
        return other;
    }
    if (r->found != NULL) return is_other(r, r->path);
    if (damaged == 0) /* else it has been said why */
        fprintf(stderr, "winnow: nothing to resume in %s: no checkpoint\n",
                folder_name(r->folder));
    return 1;
}

void resume_free(struct resume *r)
{
    if (r == NULL) return;
    state_file_free(r->found);
    ahead_free(r->ahead);
    case_copy_free(r->copy);
    free(r->image.bytes);
    free(r->path);
    free(r->before);
    free(r->lines);
    free(r);
}

void resume_keep_step(struct settings *s, const char *dir)
{
    struct resume r = {.path = file_join(dir, RESUME_FILE),
                       .before = file_join(dir, RESUME_FILE_BEFORE)};
    int damaged;

    r.found = case_scales_is_auto(s) ? find_whole(&r, &damaged) : NULL;
    char *const step =
        r.found != NULL ? state_file_text(r.found, "particles_step") : NULL;
    if (step != NULL && strtod(step, NULL) > 0.0)
        s->particles.step = strtod(step, NULL);
    free(step);
    state_file_free(r.found);
    free(r.path);
    free(r.before);
}

struct resume *resume_create(const struct settings *s, struct folder *folder,
                             const struct run_options *o, int *code)
{
    struct resume *const r = alloc_zeroed(1, sizeof *r);

    *code = 0;
    r->settings = s;
    r->options = o;
    r->folder = folder;
    r->path = file_join(folder_name(folder), RESUME_FILE);
    r->before = file_join(folder_name(folder), RESUME_FILE_BEFORE);
    r->lines = case_text_lines(s);
    if (o->fresh) bed_cache_forget(s);
    r->copy = case_copy_create(s, o);
    r->ahead = ahead_create(s, folder, o, r->lines);
    if (!o->resume || resume_find(r) == 0) return r;
    *code = 2;
    resume_free(r);
    return NULL;
}

int resume_is_of_run(const struct resume *r)
{
    return r->found != NULL;
}

int resume_settle(struct resume *r, struct bed_settling *b, enum bed_stage when)
{
    return ahead_settle(r->ahead, b, when);
}

int resume_before(struct resume *r)
{
    return r->found != NULL ? 0 : ahead_replaces(r->ahead, r->path);
}

/* --- the run -------------------------------------------------------------- */

/* Returns the exit code. */
static int resume_load(struct resume *r)
{
    r->written = clock_now();
    if (visit_all(r, r->found) != 0 || state_file_all_visited(r->found) != 0)
        return 2;
    state_file_free(r->found);
    r->found = NULL;
    if (!settings_quiet(r->settings))
        fprintf(stderr, "%s: resumed at t = %g s, after %ld steps\n",
                folder_name(r->folder), r->sim->t, r->sim->steps);
    return recorder_begin(r->recorder) != 0 ? RECORDER_NOT_WRITTEN_CODE : 0;
}

/* Lists a file before it is written. */
static int resume_list(const struct resume *r, const char *name)
{
    char *const path = folder_file(r->folder, name);

    free(path);
    return path == NULL;
}

int resume_begin(struct resume *r, struct simulation *sim,
                 struct recorder *recorder)
{
    const int goes_on = r->found != NULL;

    r->sim = sim;
    r->recorder = recorder;
    const int code = goes_on ? resume_load(r) : 0;
    if (code != 0) return code;
    r->sampled = sim->steps;
    const int failed =
        goes_on ? case_copy_restore(r->copy, folder_name(r->folder)) != 0 ||
                      copy_state(r) != 0
                : case_copy_write(r->copy, r->folder) != 0 ||
                      resume_list(r, RESUME_FILE) != 0 ||
                      resume_list(r, RESUME_FILE_BEFORE) != 0 ||
                      resume_save(r) != 0;
    if (!failed) ahead_is_over(r->ahead);
    return failed ? RECORDER_NOT_WRITTEN_CODE : 0;
}

int resume_after_step(struct resume *r)
{
    const double now = clock_now();
    const double every = r->settings->output.checkpoint;

    r->sampled = r->sim->steps;
    if (interrupt_save_requested()) {
        if (resume_save(r) != 0) return 1;
        fprintf(stderr, "%s: saved at t = %g s\n", r->path, r->sim->t);
        return 0;
    }
    if (now - r->written >= every) return resume_save(r);
    if (now - r->copied < fmax(shortest_interval, least_ratio * r->cost))
        return 0;
    return copy_state(r);
}

/* The state as it is now, unless the last step broke down or was cut short. */
int resume_end(struct resume *r, int broke_down)
{
    if (r->image.bytes == NULL) return 0;
    return !broke_down && r->sampled == r->sim->steps ? resume_save(r)
                                                      : write_copy(r);
}
