/* SPDX-License-Identifier: GPL-3.0-or-later */
/* study.c -- `winnow study`: error against time, for any choice in any case. */
#include "study/outcome.h"

#include "base/file.h"
#include "base/interrupt.h"
#include "case/command.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static void print_plan(const struct plan *p, int n, struct run *runs)
{
    const int ended = runs_find_ended(n, runs);
    double seconds = 0.0;

    for (int i = 0; i < n; i++) {
        const int to_do = runs[i].code == RUN_TO_DO;
        printf("%s  %s\n", to_do ? "to do" : "done ", runs[i].name);
        seconds += to_do ? runs[i].expected : 0.0;
    }
    printf("%d runs, %d of them done; the others take about %.3g s of "
           "processor time, after settling, %d at a time (a guess by the "
           "speed of one machine; winnow check times a case)\n",
           n, ended, seconds, p->jobs);
}

/* The folder, kept for this study as long as the descriptor is open; negative
 * after a message. */
static int lock_folder(const struct plan *p)
{
    struct flock l = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    char *const path = file_join(p->dir, "study.lock");
    int file = -1;

    if (file_make_dirs(p->dir) == 0) {
        file = open(path, O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (file < 0)
            fprintf(stderr, "winnow: cannot write %s: %s\n", path,
                    strerror(errno));
    }
    if (file >= 0 && fcntl(file, F_SETLK, &l) != 0) {
        fprintf(stderr,
                "winnow: another study works in %s; wait for its end, or "
                "choose another folder with -o\n",
                p->dir);
        close(file);
        file = -1;
    }
    free(path);
    return file;
}

/* Non-zero after a message if a folder of the runs is a link: what they write
 * stays below the study's own. */
static int leads_elsewhere(const struct plan *p, int n, const struct run *runs)
{
    char *const above = file_join(p->dir, "runs");
    const char *link = NULL;
    struct stat s;

    for (int i = -1; i < n && link == NULL; i++) {
        const char *const folder = i < 0 ? above : runs[i].folder;
        if (lstat(folder, &s) == 0 && S_ISLNK(s.st_mode)) link = folder;
    }
    if (link != NULL)
        fprintf(stderr,
                "winnow: %s is a link, and runs are written into folders only; "
                "move it away, or choose another folder with -o\n",
                link);
    free(above);
    return link != NULL;
}

/* With a signal only the page, of those that have ended before it. */
static int tell(const struct plan *p, int n, const struct run *runs, int all)
{
    struct outcomes o = outcomes_create(p, n, runs);
    const int failed = all ? report_write(&o) != 0 || outcome_draw(&o) != 0
                           : html_write(&o) != 0;

    if (all && !failed && !p->quiet) {
        report_advice(&o, stdout);
        printf("see %s/study.html, study.md, study.csv and study.svg\n",
               p->dir);
    }
    outcomes_free(&o);
    return failed ? RUN_NOT_WRITTEN : 0;
}

/* What is there: runs of this study, or what another one has told. */
static void tell_before(const struct plan *p, int n, int before)
{
    char *const table = file_join(p->dir, "study.csv");

    if (before > 0 && !p->quiet)
        fprintf(stderr, "%d of %d runs were done before\n", before, n);
    if (before == 0 && access(table, F_OK) == 0)
        fprintf(stderr,
                "%s: the tables and pictures of another study are replaced; "
                "-o names another folder\n",
                p->dir);
    free(table);
}

static int perform(const struct plan *p, int n, struct run *runs)
{
    const int file = lock_folder(p);
    int code = RUN_NOT_WRITTEN;

    if (file < 0 || leads_elsewhere(p, n, runs)) {
        if (file >= 0) close(file);
        return code;
    }
    tell_before(p, n, runs_find_ended(n, runs));
    code = runs_perform(p, n, runs);
    if (code == 0)
        code = tell(p, n, runs, 1);
    else if (code == INTERRUPT_CODE)
        tell(p, n, runs, 0);
    close(file);
    return code;
}

static int study(const struct command_line *l)
{
    struct plan p;

    interrupt_hold();
    int n, code = plan_create(&p, l->n_words, l->words);
    if (code != 0) return code;
    struct run *const runs = runs_create(&p, &n, &code);
    if (runs != NULL && p.dry)
        print_plan(&p, n, runs);
    else if (runs != NULL)
        code = perform(&p, n, runs);
    if (runs != NULL) runs_free(n, runs);
    if (runs == NULL && code == INTERRUPT_CODE)
        fputs("winnow: interrupted before the first run\n", stderr);
    plan_free(&p);
    return code;
}

const struct command study_command = {
    "study",
    PLAN_ARGUMENTS,
    "variants of a case, or those of a study file: what accuracy costs",
    NULL,
    1,
    -1,
    study};
