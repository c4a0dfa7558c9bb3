/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main.c -- the command line, nothing else. */
#include "base/alloc.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/version.h"
#include "case/report/report.h"
#include "case/report/eval.h"
#include "case/report/explain.h"
#include "case/report/equation_index.h"
#include "case/report/list.h"
#include "case/nearest.h"
#include "case/run.h"
#include "case/case_file.h"
#include "study/study.h"

#include <fcntl.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The command line taken apart: words, and the values of options. */
struct line {
    int n_words, n_overrides;
    const char **words, **overrides;
    const char *dir; /* NULL: chosen from the name of the case */
    int threads;     /* most; 0: as many as OpenMP likes */
    int quiet;
};

struct command {
    const char *name, *arguments, *what;
    const char *options; /* first letters of those it takes; NULL: it takes
                            all that follows as words */
    int least, most;     /* words after the name; most < 0: any number */
    int (*act)(const struct line *l);
};

/* out/NAME for a case some/where/NAME.cfg, as a new string. A name that begins
 * with a dot stays whole, lest it become another folder's. */
static char *default_dir(const char *file)
{
    const char *const slash = strrchr(file, '/');
    const char *const name = slash != NULL ? slash + 1 : file;
    char *const dir = file_join("out", name);
    char *const dot = strrchr(dir, '.');

    if (dot != NULL && name[0] != '.') *dot = '\0';
    return dir;
}

static struct settings *read_case(const struct line *l, int *code)
{
    return case_file_read(l->words[0], l->n_overrides, l->overrides, code);
}

static int run(const struct line *l)
{
    int code;
    struct interrupt_watch watch;
    char *const dir = default_dir(l->words[0]);
    const struct run_options o = {l->dir != NULL ? l->dir : dir, l->quiet};

    interrupt_hold();
    interrupt_watch_begin(&watch, NULL, NULL);
    struct settings *const s = read_case(l, &code);
    interrupt_watch_end(&watch);
    if (l->threads > 0) omp_set_num_threads(l->threads);
    if (s != NULL && l->quiet) settings_be_quiet(s);
    if (s != NULL) code = run_case(s, &o);
    settings_free(s);
    free(dir);
    return code;
}

static int check(const struct line *l)
{
    int code;
    struct settings *const s = read_case(l, &code);

    if (s != NULL) code = report_case(s);
    settings_free(s);
    return code;
}

static int explain(const struct line *l)
{
    int code;

    if (equation_index_is_key(l->words[0]))
        return equation_index_explain(l->words[0]);
    if (equation_index_is_function(l->words[0]) &&
        access(l->words[0], F_OK) != 0)
        return equation_index_explain_function(l->words[0]);

    struct settings *const s = read_case(l, &code);

    if (s != NULL) code = explain_case(s);
    settings_free(s);
    return code;
}

static int wrong_word(const char *word)
{
    fprintf(stderr,
            "winnow: %s: one argument too many\n"
            "winnow list [KIND] | keys [PART]\n",
            word);
    return 2;
}

static int list(const struct line *l)
{
    if (l->n_words > 1 && strcmp(l->words[0], "keys") == 0)
        return list_keys(l->words[1]);
    if (l->n_words > 1) return wrong_word(l->words[1]);
    if (l->n_words > 0) return list_models(l->words[0]);
    list_kinds();
    return 0;
}

static int study(const struct line *l)
{
    return study_command(l->n_words, l->words);
}

static int eval(const struct line *l)
{
    if (l->n_words > 0)
        return eval_print(l->words[0], l->n_words - 1, l->words + 1);
    eval_list();
    return 0;
}

static const struct command commands[] = {
    {"run", "CASE [-o DIR] [-s path.to.key=value]... [-j THREADS] [--quiet]",
     "run a case; DIR is out/ and the name of the case if not given", "osj-", 1,
     1, run},
    {"check", "CASE [-s path.to.key=value]...",
     "check a case and print the numbers that follow from it", "s", 1, 1,
     check},
    {"explain", "CASE [-s path.to.key=value]... | KEY | FUNCTION",
     "the equations that a case switches on, and what it leaves off; or where "
     "an equation is computed, tested and explained; or what a function "
     "computes",
     "s", 1, 1, explain},
    {"list", "[KIND] | keys [PART]",
     "the models of a kind with their keys; or the keys of a part of a case",
     "", 0, 2, list},
    {"eval", "[KEY name=value ...]", "the value of one equation", "", 0, -1,
     eval},
    {"study", STUDY_ARGUMENTS,
     "variants of a case, or those of a study file: what accuracy costs", NULL,
     1, -1, study},
    {NULL, NULL, NULL, NULL, 0, 0, NULL}};

static void usage(FILE *out)
{
    fputs("Winnow: particles in a fluid, each grain and every cell.\n\n", out);
    for (const struct command *c = commands; c->name != NULL; c++)
        fprintf(out, "  winnow %s %s\n      %s\n", c->name, c->arguments,
                c->what);
    fputs("  winnow --help | --version\n\n"
          "Exit codes: 0 done, 2 the input is wrong, 3 the computation broke\n"
          "down, 4 reading or writing failed, 130 interrupted.\n",
          out);
}

static const struct command *command_named(const char *name)
{
    struct nearest n;

    nearest_init(&n, name);
    for (const struct command *c = commands; c->name != NULL; c++) {
        if (strcmp(c->name, name) == 0) return c;
        nearest_offer(&n, c->name);
    }
    if (nearest_best(&n) != NULL)
        fprintf(stderr, "winnow: no command %s; did you mean %s?\n", name,
                nearest_best(&n));
    else
        fprintf(stderr, "winnow: no command %s; winnow --help names them all\n",
                name);
    return NULL;
}

/* One message, and how the command is called. */
static int wrong(const struct command *c, const char *what, const char *why)
{
    fprintf(stderr, "winnow: %s%s\nwinnow %s %s\n", what, why, c->name,
            c->arguments);
    return 2;
}

static int wrong_option(const struct command *c, const char *option)
{
    const int near =
        strchr(c->options, '-') != NULL && nearest_edits(option, "--quiet") < 4;

    fprintf(stderr, "winnow: %s knows no option %s%s\nwinnow %s %s\n", c->name,
            option, near ? "; did you mean --quiet?" : "", c->name,
            c->arguments);
    return 2;
}

/* A whole number of threads, 1 to 1024, or 0. */
static int threads_of(const char *text)
{
    char *end;
    const long n = strtol(text, &end, 10);

    return end != text && *end == '\0' && n >= 1 && n <= 1024 ? (int)n : 0;
}

/* Takes in option and value "-o DIR" or "-oDIR"; *i moves to the last word
 * used. */
static int take_option(const struct command *c, int argc, char **argv, int *i,
                       struct line *l)
{
    const char *const option = argv[*i];
    const char *value =
        option[1] != '\0' && option[2] != '\0' ? option + 2 : NULL;

    if (strcmp(option, "--quiet") == 0 && strchr(c->options, '-') != NULL) {
        l->quiet = 1;
        return 0;
    }
    if (option[1] == '\0' || option[1] == '-' ||
        strchr(c->options, option[1]) == NULL)
        return wrong_option(c, option);
    if (value == NULL && *i + 1 < argc) value = argv[++*i];
    if (value == NULL) return wrong(c, option, " asks for a value");
    if (option[1] == 'o' && value[0] == '\0')
        return wrong(c, "-o asks for a folder, not for an empty name", "");
    if (option[1] == 'o')
        l->dir = value;
    else if (option[1] == 's')
        l->overrides[l->n_overrides++] = value;
    else if ((l->threads = threads_of(value)) == 0)
        return wrong(c, "-j asks for a number of threads, 1 to 1024, not ",
                     value);
    return 0;
}

static int perform(const struct command *c, int argc, char **argv,
                   struct line *l)
{
    for (int i = 2; i < argc; i++) {
        if (c->options == NULL || argv[i][0] != '-')
            l->words[l->n_words++] = argv[i];
        else if (take_option(c, argc, argv, &i, l) != 0)
            return 2;
    }
    if (l->n_words < c->least)
        return wrong(c, c->name, " asks for a case file");
    if (c->most >= 0 && l->n_words > c->most)
        return wrong(c, l->words[c->most], ": one argument too many");
    return c->act(l);
}

/* A stream that is closed would lend its number to the next file, and what is
 * said on it would land there. Each gets /dev/null; results that nobody reads
 * still count as not written. Non-zero if that fails. */
static int open_streams(void)
{
    static const int how[] = {O_RDONLY, O_RDONLY, O_WRONLY};

    for (int d = 0; d < 3; d++)
        if (fcntl(d, F_GETFD) < 0 && open("/dev/null", how[d]) != d) return 1;
    return 0;
}

int main(int argc, char **argv)
{
    if (open_streams() != 0) return 4;

    const char *const first = argc > 1 ? argv[1] : "";
    const char **const room = alloc_zeroed(2 * (size_t)argc, sizeof *room);
    struct line l = {0, 0, room, room + argc, NULL, 0, 0};
    const struct command *c = NULL;
    int code = 0;

    if (strcmp(first, "--help") == 0 || strcmp(first, "-h") == 0)
        usage(stdout);
    else if (strcmp(first, "--version") == 0)
        puts("winnow " VERSION_TEXT);
    else if (argc < 2 || (c = command_named(first)) == NULL)
        code = 2;
    else
        code = perform(c, argc, argv, &l);
    if (argc < 2) usage(stderr);
    free(room);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        perror("winnow: cannot write the results");
        return 4;
    }
    return code;
}
