/* SPDX-License-Identifier: GPL-3.0-or-later */
/* runs.c -- what the runs of a study are, which have ended, and the processes
 * of the others, some at a time. */
#include "study/outcome.h"

#include "base/alloc.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "base/text.h"
#include "case/checks/checks.h"
#include "case/resume/resume.h"
#include "output/summary.h"
#include "output/folder.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <zlib.h>

enum { LONGEST_NAME = 100 };

/* --- what a run is -------------------------------------------------------- */

/* The text without the ".0" of whole numbers, for a case may write 1 or 1.0. */
static void drop_points(char *text)
{
    char *to = text;

    for (const char *at = text; *at != '\0'; at++) {
        if (at > text && isdigit((unsigned char)at[-1]) &&
            strncmp(at, ".0", 2) == 0 && strchr(",)]\n", at[2]) != NULL)
            at++;
        else
            *to++ = *at;
    }
    *to = '\0';
}

static unsigned long crc_of(const char *text)
{
    return crc32_z(0, (const unsigned char *)text, strlen(text));
}

/* Of all that the case says, and of the files that it names. */
static unsigned long runs_contents_of(const struct settings *s)
{
    char *const lines = case_text_lines(s);

    drop_points(lines);
    const unsigned long sum = crc_of(lines);
    free(lines);
    return sum;
}

/* The text of variant.txt. */
static char *identity_of(const struct plan *p, const struct run *r)
{
    const char *const threads =
        choices_value(&p->choices, r->variant, PLAN_THREADS);
    char *text;
    size_t length;
    FILE *const out = open_memstream(&text, &length);

    fprintf(out, "winnow %s, %s, contents crc32 %08lx\n", VERSION_TEXT,
            p->case_file, r->contents);
    for (int i = 0; i < r->overrides.n; i++)
        fprintf(out, "%s\n", r->overrides.text[i]);
    if (threads != NULL) fprintf(out, PLAN_THREADS "=%s\n", threads);
    fclose(out);
    return text;
}

/* A folder's name from what tells the run from others: letters that no shell
 * minds. A name that had to be changed has a hash behind it. */
static char *runs_name_of(const struct plan *p, const struct run *r)
{
    char *const label = choices_label(&p->choices, r->variant, -1);
    char *const name = alloc_zeroed(LONGEST_NAME + 64, 1);
    const char *c = label;
    int changed = 0;
    size_t n = 0;

    for (; *c != '\0' && n < LONGEST_NAME; c++) {
        const int between = strncmp(c, ", ", 2) == 0;
        const int plain =
            isalnum((unsigned char)*c) || strchr("=.+-_", *c) != NULL;
        name[n++] = between ? '+' : plain ? *c : '_';
        changed |= !between && !plain;
        c += between;
    }
    if (n == 0) n = (size_t)sprintf(name, "as-it-stands");
    if (changed || *c != '\0')
        n += (size_t)sprintf(name + n, "-%08x", (unsigned)crc_of(label));
    if (p->seeds > 1) n += (size_t)sprintf(name + n, "+seed-%d", r->seed);
    if (p->times > 1) sprintf(name + n, "+time-%d", r->time);
    free(label);
    return name;
}

static int runs_make_folder(const struct plan *p, struct run *r)
{
    int code = plan_overrides(p, r->variant, r->seed, &r->overrides);
    struct settings *const s =
        code == 0 ? plan_case(p, &r->overrides, &code) : NULL;

    if (s == NULL) return code;
    r->code = RUN_TO_DO;
    r->name = runs_name_of(p, r);
    char *const runs = file_join(p->dir, "runs");
    r->folder = file_join(runs, r->name);
    free(runs);
    r->expected = case_scales_seconds(s);
    r->contents = runs_contents_of(s);
    r->identity = identity_of(p, r);
    settings_free(s);
    return 0;
}

struct run *runs_create(const struct plan *p, int *n, int *code)
{
    *n = choices_variants(&p->choices) * p->seeds * p->times;
    *code = 0;
    struct run *const runs = alloc_zeroed((size_t)*n, sizeof *runs);
    for (int i = 0; i < *n && *code == 0; i++) {
        runs[i].variant = i / p->times / p->seeds;
        runs[i].seed = i / p->times % p->seeds;
        runs[i].time = i % p->times;
        *code = interrupt_arrived() ? INTERRUPT_CODE
                                    : runs_make_folder(p, &runs[i]);
    }
    if (*code == 0) return runs;
    runs_free(*n, runs);
    return NULL;
}

void runs_free(int n, struct run *runs)
{
    for (int i = 0; i < n; i++) {
        free(runs[i].name);
        free(runs[i].folder);
        free(runs[i].identity);
        texts_free(&runs[i].overrides);
    }
    free(runs);
}

int runs_standing(const struct plan *p, int n, const struct run *runs)
{
    struct texts set = {0};
    int found = -1, code = plan_overrides(p, -1, 0, &set);
    struct settings *const s = code == 0 ? plan_case(p, &set, &code) : NULL;

    texts_free(&set);
    if (s == NULL) return -1;
    const unsigned long own = runs_contents_of(s);
    for (int i = 0; i < n && found < 0; i++)
        if (runs[i].seed == 0 && runs[i].contents == own)
            found = runs[i].variant;
    settings_free(s);
    return found;
}

/* --- what has ended ------------------------------------------------------- */

/* variant.txt is the identity; a run that was refused while it was built has a
 * line "exit code N" behind it, RUN_TO_DO if there is none. */
static int runs_is_same(const struct run *r, int *code)
{
    char *const path = file_join(r->folder, "variant.txt");
    const char *why;
    size_t length;
    char *const text = input_text(path, &length, &why);
    const size_t n = strlen(r->identity);
    const int same = text != NULL && strncmp(text, r->identity, n) == 0;

    *code = RUN_TO_DO;
    if (same) sscanf(text + n, "exit code %d", code);
    free(text);
    free(path);
    return same;
}

static void find_end(struct run *r)
{
    if (!runs_is_same(r, &r->code) || r->code != RUN_TO_DO) return;
    const double code = read_summary_number(r->folder, "exit_code");
    if (isfinite(code) && code != RUN_NOT_WRITTEN && code != INTERRUPT_CODE)
        r->code = number_clamped(code, INT_MIN, INT_MAX);
}

int runs_find_ended(int n, struct run *runs)
{
    int ended = 0;

    for (int i = 0; i < n; i++) {
        find_end(&runs[i]);
        ended += runs[i].code != RUN_TO_DO;
    }
    return ended;
}

/* --- the processes -------------------------------------------------------- */

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
    struct worker *worker; /* plan->jobs of them */
    double began;          /* [s] */
    double done;           /* [s] expected, of the runs ended since then */
    int failed;            /* exit code of the study; 0 so far */
    int on_terminal;       /* [-] 1: progress is drawn over itself */
};

static void show(const struct pool *c, const struct run *r)
{
    double left = 0.0; /* [s] expected, of the runs that go on or are to do */
    int ended = 0;

    if (c->plan->quiet) return;
    for (int i = 0; i < c->n_runs; i++) {
        ended += c->run[i].code >= 0;
        if (c->run[i].code < 0) left += c->run[i].expected;
    }
    fprintf(stderr, "%s%d of %d runs", c->on_terminal ? "\r\033[K" : "", ended,
            c->n_runs);
    if (c->done > 0.0 && left > 0.0) /* as the ended ones took */
        fprintf(stderr, ", about %.0f s left",
                (clock_now() - c->began) * left / c->done);
    fprintf(stderr, "; %s%s", r->name,
            r->code == 0 ? "" : ", which did not come to its end");
    if (!c->on_terminal || ended == c->n_runs) fputc('\n', stderr);
    fflush(stderr);
}

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
                                          "checkpoint.ahead", NULL};

/* 1 if the folder has a checkpoint of this very run. */
static int can_go_on(const struct run *r)
{
    int found = 0, code;

    for (int i = 0; checkpoints[i] != NULL && !found; i++) {
        char *const path = file_join(r->folder, checkpoints[i]);
        found = access(path, F_OK) == 0;
        free(path);
    }
    return found && runs_is_same(r, &code);
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
                                 p->case_file,
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

extern char **environ; /* POSIX: the program declares it itself */

/* The file of the running program under Linux, also after it was built anew. */
static const char myself[] = "/proc/self/exe";

/* Starts this program with the arguments, ended by NULL, the first its name;
 * what it says goes to the file `log`, anew. 0 with errno if it could not. */
static pid_t start_process(const char *const *arguments, const char *log)
{
    posix_spawn_file_actions_t where;
    pid_t process = 0;

    unlink(log); /* which might be a link */
    posix_spawn_file_actions_init(&where);
    posix_spawn_file_actions_addopen(
        &where, 1, log, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
    posix_spawn_file_actions_adddup2(&where, 1, 2);
    errno = posix_spawn(&process, myself, &where, NULL,
                        (char *const *)(size_t)arguments, environ);
    if (errno == ENOENT)
        errno = posix_spawnp(&process, arguments[0], &where, NULL,
                             (char *const *)(size_t)arguments, environ);
    posix_spawn_file_actions_destroy(&where);
    return errno == 0 ? process : 0;
}

/* Starts a run, or waits for the one that a former study has left in its
 * folder. */
static int perform_start(struct pool *c, struct worker *w, struct run *r)
{
    const long owner = folder_process(r->folder);

    *w = (struct worker){r, 0, 0};
    r->code = RUN_GOES_ON;
    if (owner != 0) {
        if (!c->plan->quiet)
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
    w->process = start_process((const char *const *)words.text, log);
    if (w->process == 0)
        fprintf(stderr, "winnow: cannot start a run: %s\n", strerror(errno));
    free(log);
    texts_free(&words);
    return w->process != 0 ? 0 : RUN_NOT_WRITTEN;
}

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

/* The exit code of a process that has ended; -1 while it goes on. One that a
 * signal ended has 128 and the number of the signal. */
static int code_of_process(pid_t process)
{
    int status;

    if (waitpid(process, &status, WNOHANG) != process) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* A worker whose run has ended is free again. */
static void check_worker(struct pool *c, struct worker *w)
{
    struct run *const r = w->run;

    if (r == NULL) return;
    if (w->process > 0) {
        const int code = code_of_process(w->process);
        if (code < 0) return;
        if (code == RUN_NOT_WRITTEN && folder_process(r->folder) != 0)
            w->process = 0; /* a killed study's run has the folder: wait */
        if (w->process == 0) return;
        const int anew =
            w->resumed && (code == RUN_REFUSED || code == RUN_NOT_WRITTEN);
        *w = (struct worker){NULL, 0, 0};
        if (!anew) {
            record_end(c, r, code);
            return;
        }
        r->code = RUN_TO_DO; /* for there is nothing to go on from */
        for (int i = 0; checkpoints[i] != NULL; i++)
            remove_from(r, checkpoints[i]);
        return;
    }
    if (folder_process(r->folder) != 0) return;
    *w = (struct worker){NULL, 0, 0};
    runs_find_ended(1, r);
    if (r->code != RUN_TO_DO) record_end(c, r, r->code);
}

/* Tells the processes to end, once; those of a former study are left alone. */
static void stop(struct pool *c)
{
    for (int i = 0; i < c->plan->jobs; i++) {
        struct worker *const w = &c->worker[i];
        if (w->run != NULL && w->process > 0) kill(w->process, SIGTERM);
        if (w->process == 0) w->run = NULL;
    }
}

/* Gives free workers their runs; returns how many have one. */
static int start_next(struct pool *c)
{
    int n = 0;

    if (interrupt_arrived() && c->failed == 0) c->failed = INTERRUPT_CODE;
    for (int i = 0; i < c->plan->jobs; i++) {
        struct worker *const w = &c->worker[i];
        struct run *const r = next_run(c);
        if (w->run == NULL && r != NULL && c->failed == 0) {
            c->failed = perform_start(c, w, r);
            if (c->failed != 0) w->run = NULL;
        }
        n += w->run != NULL;
    }
    return n;
}

static void run_all(struct pool *c)
{
    const struct timespec interval = {0, 5000000}; /* 5 ms */
    int stopped = 0;

    while (start_next(c) > 0) {
        if (c->failed != 0 && !stopped++) stop(c);
        for (int i = 0; i < c->plan->jobs; i++)
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

    c.worker = alloc_zeroed((size_t)p->jobs, sizeof *c.worker);
    run_all(&c);
    free(c.worker);
    if (c.failed == INTERRUPT_CODE)
        fprintf(stderr,
                "winnow: interrupted; the runs that have ended are in %s, and "
                "the same command goes on from there\n",
                p->dir);
    return c.failed;
}
