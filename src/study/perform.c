/* SPDX-License-Identifier: GPL-3.0-or-later */
/* perform.c -- the processes of a study, some at a time. */
#include "study/runs.h"

#include "base/alloc.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "output/manifest/ownership.h"
#include "study/workers.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* A slot for a process. */
struct worker {
    struct run *run; /* NULL: free */
    pid_t process;   /* a child of ours; 0: of a former study, waited for */
    int resumed;     /* [-] 1: it goes on from a checkpoint */
};

struct pool {
    const struct plan *plan;
    int n_runs;
    struct run *run;
    struct worker *worker; /* plan->words.jobs of them */
    double began;          /* [s] */
    double done;           /* [s] expected, of the runs ended since then */
    int failed;            /* exit code of the study; 0 so far */
    int on_terminal;       /* [-] 1: progress is drawn over itself */
};

/* --- progress ------------------------------------------------------------- */

/* How long it will take: what the ended runs took, for the rest. */
static void put_left(const struct pool *c)
{
    const double elapsed = clock_now() - c->began;
    double left = 0.0;

    for (int i = 0; i < c->n_runs; i++)
        if (c->run[i].code < 0) left += c->run[i].expected;
    if (c->done > 0.0 && left > 0.0)
        fprintf(stderr, ", about %.0f s left", elapsed * left / c->done);
}

static void show(const struct pool *c, const struct run *r)
{
    int ended = 0;

    if (c->plan->words.quiet) return;
    for (int i = 0; i < c->n_runs; i++)
        ended += c->run[i].code >= 0;
    fprintf(stderr, "%s%d of %d runs", c->on_terminal ? "\r\033[K" : "", ended,
            c->n_runs);
    put_left(c);
    fprintf(stderr, "; %s%s", r->name,
            r->code == 0 ? "" : ", which did not come to its end");
    if (!c->on_terminal || ended == c->n_runs) fputc('\n', stderr);
    fflush(stderr);
}

/* --- one run -------------------------------------------------------------- */

/* Writes variant.txt, which tells from now on what the folder is for. */
static int write_identity(const struct run *r, int code)
{
    char *const path = file_join(r->folder, "variant.txt");
    struct file *const f =
        file_make_dirs(r->folder) == 0 ? file_create(path) : NULL;

    free(path);
    if (f == NULL) return RUN_NOT_WRITTEN;
    fputs(r->identity, file_stream(f));
    if (code == RUN_REFUSED) fprintf(file_stream(f), "exit code %d\n", code);
    return file_commit(f) == 0 ? 0 : RUN_NOT_WRITTEN;
}

/* Removes a file of the folder of a run. */
static void remove_from(const struct run *r, const char *name)
{
    char *const path = file_join(r->folder, name);

    remove(path);
    free(path);
}

/* What a run goes on from, or a bed that settles. */
static const char *const checkpoints[] = {"checkpoint", "checkpoint.before",
                                          "checkpoint.ahead"};
enum { CHECKPOINTS = sizeof checkpoints / sizeof checkpoints[0] };

/* 1 if the folder has a checkpoint of this very run. */
static int can_go_on(const struct run *r)
{
    int found = 0;

    for (int i = 0; i < CHECKPOINTS && !found; i++) {
        char *const path = file_join(r->folder, checkpoints[i]);
        found = access(path, F_OK) == 0;
        free(path);
    }
    return found && runs_is_begun(r);
}

/* The words of the command: winnow run CASE -o DIR -j 1 --quiet -s ..., where
 * the threads are no choice. */
static struct texts command(const struct plan *p, const struct run *r,
                            int resumed)
{
    const char *const threads =
        choices_value(&p->choices, r->variant, PLAN_THREADS);
    const char *const begin[] = {"winnow",
                                 "run",
                                 p->words.case_file,
                                 "-o",
                                 r->folder,
                                 "-j",
                                 threads != NULL ? threads : "1",
                                 "--quiet",
                                 resumed ? "--resume" : NULL};
    struct texts words = {0};

    for (size_t i = 0; i < sizeof begin / sizeof begin[0]; i++)
        if (begin[i] != NULL) texts_add(&words, "%s", begin[i]);
    for (int i = 0; i < r->overrides.n; i++) {
        texts_add(&words, "-s");
        texts_add(&words, "%s", r->overrides.text[i]);
    }
    return words;
}

/* Starts a run, or waits for the one that a former study has left in its
 * folder. */
static int perform_start(struct pool *c, struct worker *w, struct run *r)
{
    const long owner = ownership_process(r->folder);

    *w = (struct worker){r, 0, 0};
    r->code = RUN_GOES_ON;
    if (owner != 0) {
        if (!c->plan->words.quiet)
            fprintf(stderr, "%s is being run by process %ld; waiting for it\n",
                    r->name, owner);
        return 0;
    }
    w->resumed = can_go_on(r);
    /* The end of an earlier run must not pass for that of this one. */
    if (!w->resumed) remove_from(r, "summary.json");
    if (write_identity(r, 0) != 0) return RUN_NOT_WRITTEN;
    struct texts words = command(c->plan, r, w->resumed);
    char *const log = file_join(r->folder, "log.txt");
    w->process = workers_start((const char *const *)words.text, log);
    if (w->process == 0)
        fprintf(stderr, "winnow: cannot start a run: %s\n", strerror(errno));
    free(log);
    texts_free(&words);
    return w->process != 0 ? 0 : RUN_NOT_WRITTEN;
}

/* --- all of them ---------------------------------------------------------- */

static struct run *next_run(const struct pool *c)
{
    for (int i = 0; i < c->n_runs; i++)
        if (c->run[i].code == RUN_TO_DO) return &c->run[i];
    return NULL;
}

/* Keeps the exit code of a run. A run that broke down, that was refused
 * or that a signal ended is a result; one that could not write, or that was
 * interrupted, ends the study. */
static void record_end(struct pool *c, struct run *r, int code)
{
    if (code == RUN_NOT_WRITTEN || code == INTERRUPT_CODE) {
        c->failed = code;
        if (code == RUN_NOT_WRITTEN)
            fprintf(stderr, "winnow: a run could not write; see %s/log.txt\n",
                    r->folder);
        return;
    }
    r->code = code;
    c->done += r->expected;
    if (code == RUN_REFUSED && write_identity(r, code) != 0)
        c->failed = RUN_NOT_WRITTEN;
    show(c, r);
}

/* A worker whose run has ended is free again. */
static void check_worker(struct pool *c, struct worker *w)
{
    struct run *const r = w->run;

    if (r == NULL) return;
    if (w->process > 0) {
        const int code = workers_code(w->process);
        if (code < 0) return;
        const int anew =
            w->resumed && (code == RUN_REFUSED || code == RUN_NOT_WRITTEN);
        *w = (struct worker){NULL, 0, 0};
        if (!anew) {
            record_end(c, r, code);
            return;
        }
        r->code = RUN_TO_DO; /* for there is nothing to go on from */
        for (int i = 0; i < CHECKPOINTS; i++)
            remove_from(r, checkpoints[i]);
        return;
    }
    if (ownership_process(r->folder) != 0) return;
    *w = (struct worker){NULL, 0, 0};
    runs_find_ended(1, r);
    if (r->code != RUN_TO_DO) record_end(c, r, r->code);
}

static int working(const struct pool *c)
{
    int n = 0;

    for (int i = 0; i < c->plan->words.jobs; i++)
        n += c->worker[i].run != NULL;
    return n;
}

/* Tells the processes to end, once; those of a former study are left alone. */
static void stop(struct pool *c)
{
    for (int i = 0; i < c->plan->words.jobs; i++) {
        struct worker *const w = &c->worker[i];
        if (w->run != NULL && w->process > 0) kill(w->process, SIGTERM);
        if (w->run != NULL && w->process == 0) w->run = NULL;
    }
}

static void start_next(struct pool *c)
{
    for (int i = 0; i < c->plan->words.jobs && c->failed == 0; i++) {
        struct run *const r = next_run(c);
        if (c->worker[i].run != NULL || r == NULL) continue;
        c->failed = perform_start(c, &c->worker[i], r);
        if (c->failed != 0) c->worker[i].run = NULL;
    }
}

static void run_all(struct pool *c)
{
    const struct timespec interval = {0, 5000000}; /* 5 ms */
    int stopped = 0;

    while (working(c) > 0 || (c->failed == 0 && next_run(c) != NULL)) {
        if (interrupt_arrived() && c->failed == 0) c->failed = INTERRUPT_CODE;
        if (c->failed == 0) start_next(c);
        if (c->failed != 0 && !stopped++) stop(c);
        for (int i = 0; i < c->plan->words.jobs; i++)
            check_worker(c, &c->worker[i]);
        nanosleep(&interval, NULL);
    }
}

int runs_perform(const struct plan *p, int n, struct run *runs)
{
    struct pool c = {.plan = p,
                     .n_runs = n,
                     .run = runs,
                     .began = clock_now(),
                     .on_terminal = isatty(STDERR_FILENO)};

    c.worker = alloc_zeroed((size_t)p->words.jobs, sizeof *c.worker);
    run_all(&c);
    free(c.worker);
    if (c.failed == INTERRUPT_CODE)
        fprintf(stderr,
                "winnow: interrupted; the runs that have ended are in %s, and "
                "the same command goes on from there\n",
                p->words.dir);
    return c.failed;
}
