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
#include "case/resume/resume.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/text.h"
#include "case/case_file.h"
#include "case/checks/checks.h"
#include "output/checkpoint/state_file.h"

enum { WRONG = 2, NOT_WRITTEN = RECORDER_NOT_WRITTEN_CODE };

/* Wall time between two copies: at least this, and so many times what one
 * takes [s], [-]. */
static const double shortest_interval = 1.0, least_ratio = 50.0;

/* A bed that settles sooner is not worth a file [s]. */
static const double least_time = 1.0;

struct resume {
    const struct settings *settings;
    const struct run_options *options;
    struct folder *folder;
    struct simulation *sim;
    struct recorder *recorder;
    char *path, *before;      /* of the two files */
    char *ahead;              /* and of the third, whose state is: */
    struct state_file *early; /* to go on from; NULL */
    int is_there;             /* [-] 1: the file is of this run */
    int stays;                /* [-] 1: and stays when the program ends */
    double due;               /* [s] wall clock of its next writing */
    char *lines;              /* the case (resume.h) */
    struct case_copy *copy;   /* of the case, for the folder */
    struct state_file *found; /* to resume from; NULL */
    struct state_image image; /* the last copy of the state */
    long sampled;             /* [-] steps whose results were written */
    double copied, written;   /* [s] wall clock of the last of each */
    double cost;              /* [s] that a copy takes */
};

/* --- saving --------------------------------------------------------------- */

static const char program[] = "winnow " VERSION_TEXT;

/* The program, the case file and its text, the overrides, and the lines of the
 * case. */
static void put_texts(const struct resume *r, struct state_file *f)
{
    const struct settings *const s = r->settings;
    const struct run_options *const o = r->options;
    const char *const text = input_kept(settings_files(s), s->file)->text;

    state_file_put_text(f, "program", program);
    state_file_put_text(f, "case_file", s->file);
    state_file_put_text(f, "case", text != NULL ? text : "");
    state_file_put_text(f, "settings", r->lines);
    char step[32];
    snprintf(step, sizeof step, "%.17g", s->particles.step);
    state_file_put_text(f, "particles_step", step);
    for (int i = 0; i < o->n_overrides; i++) {
        char name[32];
        snprintf(name, sizeof name, "override_%d", i + 1);
        state_file_put_text(f, name, o->overrides[i]);
    }
}

/* A warning if another version of the program has written the file `path`. */
static void print_version(struct state_file *f, const char *path)
{
    char *const by = state_file_text(f, "program");

    text_blank(by);
    if (strcmp(by, program) != 0)
        fprintf(stderr,
                "winnow: %s was written by %s; this is %s, whose numbers may "
                "differ\n",
                path, by, program);
    free(by);
}

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

    free(r->image.bytes); /* before its memory is needed for the new one */
    struct state_file *const f = state_file_create();
    put_texts(r, f);
    visit_all(r, f);
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

/* NULL, after a message if the file is damaged, which is counted. */
static struct state_file *open_state_of(const char *path, int *damaged)
{
    const char *why;
    struct state_file *const f = state_file_open(path, &why);

    if (f != NULL || why == NULL) return f;
    ++*damaged;
    fprintf(stderr, "winnow: %s is not used: %s\n", path, why);
    return NULL;
}

/* The newer of the two files that is whole. */
static struct state_file *find_whole(const struct resume *r, int *damaged)
{
    struct state_file *const f = open_state_of(r->path, damaged);

    return f != NULL ? f : open_state_of(r->before, damaged);
}

/* Whether a state is of another case; then after a message, unless path is
 * NULL. */
static int is_other(const struct resume *r, struct state_file *f,
                    const char *path)
{
    char *const was = state_file_text(f, "settings");
    const int other = case_text_differs(was, r->lines, path);

    free(was);
    if (!other && path != NULL) print_version(f, path);
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
    int damaged = 0, early_damaged = 0;

    r->found = find_whole(r, &damaged);
    if (r->found != NULL && !is_other(r, r->found, NULL))
        return is_other(r, r->found, r->path) || is_after_end(r);
    r->early = open_state_of(r->ahead, &early_damaged);
    if (r->early != NULL) {
        state_file_free(r->found);
        r->found = NULL;
        return is_other(r, r->early, r->ahead);
    }
    if (r->found != NULL) return is_other(r, r->found, r->path);
    if (damaged == 0) /* else it has been said why */
        fprintf(stderr, "winnow: nothing to resume in %s: no checkpoint\n",
                folder_name(r->folder));
    return 1;
}

/* Where the run was refused before it began nothing is left of the bed. */
void resume_free(struct resume *r)
{
    if (r == NULL) return;
    if (r->is_there && !r->stays) unlink(r->ahead);
    state_file_free(r->found);
    state_file_free(r->early);
    case_text_free_copy(r->copy);
    free(r->image.bytes);
    free(r->path);
    free(r->before);
    free(r->ahead);
    free(r->lines);
    free(r);
}

void resume_keep_step(struct settings *s, const char *dir)
{
    struct resume r = {.path = file_join(dir, RESUME_FILE),
                       .before = file_join(dir, RESUME_FILE_BEFORE)};
    int damaged = 0;

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
    r->ahead = file_join(folder_name(folder), RESUME_FILE_AHEAD);
    r->lines = case_text_lines(s);
    if (o->fresh) bed_cache_forget(s);
    r->copy = case_text_copy(s, o);
    if (!o->resume || resume_find(r) == 0) return r;
    *code = 2;
    resume_free(r);
    return NULL;
}

int resume_is_of_run(const struct resume *r)
{
    return r->found != NULL;
}

/* --- before the run ------------------------------------------------------- */

/* The third file: with the bed, or only the case if b is NULL. Non-zero after a
 * message. */
static int save_early(struct resume *r, struct bed_settling *b)
{
    struct state_file *const f = state_file_create();
    char *const path = folder_early_file(r->folder);

    put_texts(r, f);
    state_file_put_text(f, RESUME_SETTLING, b != NULL ? "yes" : "no");
    if (b != NULL) bed_settling_state(b, state_file_state(f));
    struct state_image image = state_file_image(f);
    const int failed = path == NULL || image.bytes == NULL ||
                       state_file_write(&image, path, NULL) != 0;
    free(image.bytes);
    free(path);
    r->is_there |= !failed;
    r->stays |= failed;
    r->due = clock_now() + r->settings->output.checkpoint;
    return failed;
}

static int has_bed(struct resume *r)
{
    if (r->early == NULL) return 0;
    char *const text = state_file_text(r->early, RESUME_SETTLING);
    const int has = strcmp(text, "yes") == 0;

    free(text);
    return has;
}

static void forget_early(struct resume *r)
{
    r->is_there |= r->early != NULL;
    state_file_free(r->early);
    r->early = NULL;
}

/* The exit code, after a message if it is not 0. */
static int load_early(struct resume *r, struct bed_settling *b)
{
    struct state *const s = state_file_state(r->early);

    bed_settling_state(b, s);
    if (s->failed || state_file_all_visited(r->early) != 0) return WRONG;
    if (!r->settings->quiet)
        fprintf(stderr, "%s: the bed continues to settle from t = %g s\n",
                folder_name(r->folder), bed_settling_time(b));
    forget_early(r);
    return 0;
}

static int interrupted(struct resume *r, struct bed_settling *b)
{
    r->stays = 1;
    if (save_early(r, b) != 0) return NOT_WRITTEN;
    fprintf(stderr,
            "winnow: interrupted while the bed settled, at t = %g s; --resume "
            "goes on in %s\n",
            bed_settling_time(b), folder_name(r->folder));
    return INTERRUPT_CODE;
}

int resume_settle(struct resume *r, struct bed_settling *b, enum bed_stage when)
{
    const double every = r->settings->output.checkpoint;

    if (when == BED_STAGE_START) r->due = clock_now() + fmin(least_time, every);
    if (when == BED_STAGE_START) return has_bed(r) ? load_early(r, b) : 0;
    if (interrupt_arrived()) return interrupted(r, b);
    const int asked = interrupt_save_requested();
    const int is_due =
        when == BED_STAGE_END ? r->is_there : clock_now() >= r->due;
    if (!asked && !is_due) return 0;
    if (save_early(r, b) != 0) return NOT_WRITTEN;
    if (asked)
        fprintf(stderr, "%s: saved at t = %g s of settling\n", r->ahead,
                bed_settling_time(b));
    return 0;
}

int resume_before(struct resume *r)
{
    if (r->found != NULL) return 0;
    forget_early(r);
    r->stays = 1;
    if (r->is_there || access(r->path, F_OK) != 0) return 0;
    return save_early(r, NULL);
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
    if (!r->settings->quiet)
        fprintf(stderr, "%s: resumed at t = %g s, after %ld steps%s\n",
                folder_name(r->folder), r->sim->t, r->sim->steps,
                r->sim->steps < case_steps_until_end(r->settings)
                    ? ""
                    : "; that is its end, and a later output.end goes further");
    return recorder_begin(r->recorder) != 0 ? NOT_WRITTEN : 0;
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
        goes_on
            ? case_text_restore_copy(r->copy, folder_name(r->folder)) != 0 ||
                  copy_state(r) != 0
            : case_text_write_copy(r->copy, r->folder) != 0 ||
                  folder_add(r->folder, RESUME_FILE) != 0 ||
                  folder_add(r->folder, RESUME_FILE_BEFORE) != 0 ||
                  resume_save(r) != 0;
    if (failed) return NOT_WRITTEN;
    unlink(r->ahead);
    r->is_there = 0;
    return 0;
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
