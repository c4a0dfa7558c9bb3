/* SPDX-License-Identifier: GPL-3.0-or-later */
/* status.c -- `winnow status`: what the folder of a run holds. Chapter "Nothing
 * is lost". */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "base/file.h"
#include "base/text.h"
#include "case/build.h"
#include "case/case_file.h"
#include "case/command.h"
#include "case/resume/resume.h"
#include "output/summary.h"
#include "coupling/processes.h"
#include "output/checkpoint/state_file.h"
#include "output/folder.h"

/* What others wrote is shown without control characters. */
static void status_line(const char *name, const char *value)
{
    printf("%-11s ", name);
    text_put(stdout, value, TEXT_PLAIN);
    putchar('\n');
}

/* Words of a command as a shell reads them: one that is copied from here runs
 * what it shows, whatever a folder or a case is called. */
static void word(const char *before, const char *text)
{
    fputs(before, stdout);
    text_put(stdout, text, TEXT_SHELL);
}

/* The time of a state [s], and what its case says. */
struct found {
    struct state_file *file;
    double t;
};

static int open_state(const char *dir, const char *name, struct found *f)
{
    char *const path = file_join(dir, name);
    const char *why = NULL;

    f->file = state_file_open(path, &why);
    if (f->file != NULL) f->t = state_file_number(f->file, "/t");
    if (f->file != NULL && isnan(f->t) &&
        strcmp(name, RESUME_FILE_AHEAD) != 0) {
        state_file_free(f->file);
        f->file = NULL;
        why = "it has no time";
    }
    if (f->file == NULL && why != NULL)
        printf("%-11s %s: %s\n", name, "cannot be used", why);
    free(path);
    return f->file != NULL;
}

/* When a state was written, how large it is. */
static void print_state(const char *dir, const char *name, double t)
{
    char *const path = file_join(dir, name);
    struct stat info;
    char when[64] = "";

    if (stat(path, &info) == 0) {
        struct tm local;
        localtime_r(&info.st_mtime, &local);
        strftime(when, sizeof when, "%Y-%m-%d %H:%M:%S", &local);
        printf("%-11s t = %g s, %.3g MB, written %s (%s)\n", "state", t,
               (double)info.st_size / 1e6, when, name);
    }
    free(path);
}

/* The i-th from 1, as a new string; NULL if there are less. */
static char *override_of(struct state_file *f, int i)
{
    char name[32];

    snprintf(name, sizeof name, "override_%d", i);
    char *const text = state_file_text(f, name);
    if (text[0] != '\0') return text;
    free(text);
    return NULL;
}

static void status_print_case(struct state_file *f)
{
    static const char *const texts[][2] = {{"program", "program"},
                                           {"case", "case_file"}};

    for (int i = 0; i < 2; i++) {
        char *const text = state_file_text(f, texts[i][1]);
        status_line(texts[i][0], text);
        free(text);
    }
    for (int i = 1;; i++) {
        char *const text = override_of(f, i);
        if (text == NULL) return;
        printf("%-11s", "");
        word(" -s ", text);
        putchar('\n');
        free(text);
    }
}

static double end_of(struct state_file *f)
{
    char *const lines = state_file_text(f, "settings");
    char *const end = case_text_value(lines, "output.end");
    const double t = end != NULL ? strtod(end, NULL) : 0.0;

    free(end);
    free(lines);
    return t;
}

/* 1 if the run goes on. */
static int print_holder(const char *dir)
{
    const long process = folder_process(dir);

    if (process > 0)
        printf("%-11s process %ld is running\n", "running", process);
    return process > 0;
}

/* How the run ended, or that it goes on. */
static void print_end(const char *dir, const char *reason)
{
    if (print_holder(dir)) return;
    if (reason == NULL)
        status_line("ended", "before it began");
    else if (strcmp(reason, "running") == 0)
        status_line("ended", "killed, or the machine stopped");
    else
        status_line("ended", reason);
}

/* The command that continues the run; t of the saved state, if there is one. */
static void print_what_next(const char *dir, const struct found *f, int done)
{
    char *const case_file = file_join(dir, "case.cfg");

    if (f->file != NULL) {
        printf("%-11s", done ? "go further" : "resume");
        word(" winnow run ", case_file);
        word(" --resume -o ", dir);
        if (done) printf(" -s output.end=%g", 2.0 * end_of(f->file));
        putchar('\n');
    }
    printf("%-11s", "repeat");
    word(" winnow run ", case_file);
    puts(" -o ANOTHER");
    free(case_file);
}

/* The command that continues a run that has not begun. */
static void print_beginning(const char *dir, struct state_file *f)
{
    char *const case_file = state_file_text(f, "case_file");

    printf("%-11s", "resume");
    word(" winnow run ", case_file);
    word(" --resume -o ", dir);
    free(case_file);
    for (int i = 1;; i++) {
        char *const text = override_of(f, i);
        if (text == NULL) break;
        word(" -s ", text);
        free(text);
    }
    putchar('\n');
}

/* Of a run that has not begun, whose bed settles; 0 if there is none. */
static int print_ahead(const char *dir)
{
    struct found f = {NULL, 0.0};

    if (!open_state(dir, RESUME_FILE_AHEAD, &f)) return 0;
    char *const bed = state_file_text(f.file, RESUME_SETTLING);
    status_print_case(f.file);
    print_holder(dir);
    if (strcmp(bed, "yes") == 0)
        printf("%-11s its bed settles, at t = %g s; the run has not begun\n",
               "reached", state_file_number(f.file, "/settling/time"));
    else
        status_line("reached", "the run has not begun");
    print_beginning(dir, f.file);
    free(bed);
    state_file_free(f.file);
    return 1;
}

/* 1, after a message, if a run of the case could not load the state. */
static int is_refused(const struct settings *s, struct state_file *f)
{
    int code, refused;

    if (processes_engine != NULL || strcmp(s->engine, "one") != 0) return 0;
    struct simulation *const sim = build_for_run(s, 0, NULL, &code);
    refused = sim == NULL || simulation_state(sim, state_file_state(f)) != 0;
    build_free(sim);
    return refused;
}

/* Why the case in the folder does not go on from the state, after a message
 * that names the first other value; NULL if it does. */
static const char *not_of_use(const char *dir, const char *name,
                              const struct found *f)
{
    char *const case_file = file_join(dir, "case.cfg");
    char *const path = file_join(dir, name);
    const char *why = NULL;
    int code;
    struct settings *const s = case_file_read(case_file, 0, NULL, &code);

    if (s != NULL) {
        char *const was = state_file_text(f->file, "settings");
        char *const is = case_text_lines(s);
        if (case_text_differs(was, is, path))
            why = "is of another case";
        else if (is_refused(s, f->file))
            why = "cannot be used by the case";
        free(was);
        free(is);
    }
    settings_free(s);
    free(case_file);
    free(path);
    return why;
}

/* The state that a run goes on from: the last one, or the one before it; none
 * if there is none of the case in the folder. Returns its name. */
static const char *find_state(const char *dir, struct found *f)
{
    const char *name = RESUME_FILE;

    if (!open_state(dir, name, f))
        open_state(dir, name = RESUME_FILE_BEFORE, f);
    const char *const why = f->file != NULL ? not_of_use(dir, name, f) : NULL;
    if (why != NULL) {
        printf("%-11s %s %s\n", "not used", name, why);
        state_file_free(f->file);
        f->file = NULL;
    }
    return name;
}

static int print_folder(const char *dir)
{
    struct found f = {NULL, 0.0};
    char *const reason = read_summary_text(dir, "exit_reason");
    const char *const name = find_state(dir, &f);
    const int ahead = print_ahead(dir);

    if (ahead && f.file == NULL) {
        free(reason);
        return 0;
    }
    if (ahead) puts("\nThe run before it:");
    if (f.file != NULL) status_print_case(f.file);
    print_end(dir, reason);
    if (f.file != NULL) {
        printf("%-11s t = %g of %g s\n", "reached", f.t, end_of(f.file));
        print_state(dir, name, f.t);
    } else {
        status_line("state", "none: nothing can be resumed");
    }
    print_what_next(dir, &f, reason != NULL && strcmp(reason, "done") == 0);
    state_file_free(f.file);
    free(reason);
    return 0;
}

static int status_act(const struct command_line *l)
{
    const char *const dir = l->words[0];
    char *const manifest = file_join(dir, "manifest.txt");
    const int is_run = input_wrong(manifest) == NULL;
    int code = 2;

    if (is_run)
        code = print_folder(dir);
    else
        fprintf(stderr,
                "winnow: %s is not the folder of a run: there is no "
                "manifest.txt\n",
                dir);
    free(manifest);
    return code;
}

const struct command command_status = {
    "status",
    "DIR",
    "what the folder of a run holds: its case, how it ended, what resumes it",
    "",
    1,
    1,
    status_act};
