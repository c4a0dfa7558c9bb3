/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resume/ahead.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "case/resume/case_text.h"
#include "case/resume/resume.h"
#include "case/resume/state_texts.h"
#include "output/checkpoint/state_file.h"

enum { WRONG = 2, NOT_WRITTEN = 4 };

/* A bed that settles sooner is not worth a file [s]. */
static const double least_time = 1.0;

struct ahead {
    const struct settings *settings;
    const struct run_options *options;
    struct folder *folder;
    const char *lines;
    char *path;               /* for reading */
    struct state_file *found; /* to go on from; NULL */
    int is_there;             /* [-] 1: the file is of this run */
    int stays;                /* [-] 1: and stays when the program ends */
    double due;               /* [s] wall clock of the next writing */
};

struct ahead *ahead_create(const struct settings *s, struct folder *folder,
                           const struct run_options *o, const char *lines)
{
    struct ahead *const a = alloc_zeroed(1, sizeof *a);

    a->settings = s;
    a->options = o;
    a->folder = folder;
    a->lines = lines;
    a->path = file_join(folder_name(folder), RESUME_FILE_AHEAD);
    return a;
}

void ahead_free(struct ahead *a)
{
    if (a == NULL) return;
    if (a->is_there && !a->stays) unlink(a->path);
    state_file_free(a->found);
    free(a->path);
    free(a);
}

/* --- finding -------------------------------------------------------------- */

int ahead_find(struct ahead *a)
{
    const char *why;

    a->found = state_file_open(a->path, &why);
    if (a->found == NULL && why != NULL)
        fprintf(stderr, "winnow: %s is not used: %s\n", a->path, why);
    return a->found != NULL;
}

int ahead_is_other(struct ahead *a, int tell)
{
    char *const was = state_file_text(a->found, "settings");
    const int other = case_text_differs(was, a->lines, tell ? a->path : NULL);

    free(was);
    if (!other && tell) state_texts_print_version(a->found, a->path);
    return other;
}

/* --- the file ------------------------------------------------------------- */

/* With the bed, or only the case if b is NULL. Non-zero after a message. */
static int ahead_save(struct ahead *a, struct bed_settling *b)
{
    struct state_file *const f = state_file_create();
    char *const path = folder_early_file(a->folder);

    state_texts_put(f, a->settings, a->options, a->lines);
    state_file_put_text(f, RESUME_SETTLING, b != NULL ? "yes" : "no");
    if (b != NULL) bed_settling_state(b, state_file_state(f));
    struct state_image image = state_file_image(f);
    const int failed = path == NULL || image.bytes == NULL ||
                       state_file_write(&image, path, NULL) != 0;
    free(image.bytes);
    free(path);
    a->is_there |= !failed;
    a->stays |= failed;
    a->due = clock_now() + a->settings->output.checkpoint;
    return failed;
}

/* --- the bed -------------------------------------------------------------- */

static int has_bed(struct ahead *a)
{
    if (a->found == NULL) return 0;
    char *const text = state_file_text(a->found, RESUME_SETTLING);
    const int has = strcmp(text, "yes") == 0;

    free(text);
    return has;
}

static void forget_found(struct ahead *a)
{
    a->is_there |= a->found != NULL;
    state_file_free(a->found);
    a->found = NULL;
}

/* The exit code, after a message if it is not 0. */
static int ahead_load(struct ahead *a, struct bed_settling *b)
{
    struct state *const s = state_file_state(a->found);

    bed_settling_state(b, s);
    if (s->failed || state_file_all_visited(a->found) != 0) return WRONG;
    if (!settings_quiet(a->settings))
        fprintf(stderr, "%s: the bed continues to settle from t = %g s\n",
                folder_name(a->folder), bed_settling_time(b));
    forget_found(a);
    return 0;
}

static int interrupted(struct ahead *a, struct bed_settling *b)
{
    a->stays = 1;
    if (ahead_save(a, b) != 0) return NOT_WRITTEN;
    fprintf(stderr,
            "winnow: interrupted while the bed settled, at t = %g s; --resume "
            "goes on in %s\n",
            bed_settling_time(b), folder_name(a->folder));
    return INTERRUPT_CODE;
}

int ahead_settle(struct ahead *a, struct bed_settling *b, enum bed_stage when)
{
    const double every = a->settings->output.checkpoint;

    if (when == BED_STAGE_START) a->due = clock_now() + fmin(least_time, every);
    if (when == BED_STAGE_START) return has_bed(a) ? ahead_load(a, b) : 0;
    if (interrupt_arrived()) return interrupted(a, b);
    const int asked = interrupt_save_requested();
    const int is_due =
        when == BED_STAGE_END ? a->is_there : clock_now() >= a->due;
    if (!asked && !is_due) return 0;
    if (ahead_save(a, b) != 0) return NOT_WRITTEN;
    if (asked)
        fprintf(stderr, "%s: saved at t = %g s of settling\n", a->path,
                bed_settling_time(b));
    return 0;
}

/* --- the run -------------------------------------------------------------- */

int ahead_replaces(struct ahead *a, const char *checkpoint)
{
    forget_found(a);
    a->stays = 1;
    if (a->is_there || access(checkpoint, F_OK) != 0) return 0;
    return ahead_save(a, NULL);
}

void ahead_is_over(struct ahead *a)
{
    unlink(a->path);
    a->is_there = 0;
}
