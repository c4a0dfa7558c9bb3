/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main.c -- the command line, nothing else. */
#include "base/alloc.h"
#include "base/text.h"
#include "case/command.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void usage(FILE *out)
{
    fputs("Winnow: particles in a fluid, each grain and every cell.\n\n", out);
    for (const struct command *const *c = commands; *c != NULL; c++)
        fprintf(out, "  winnow %s %s\n      %s\n", (*c)->name, (*c)->arguments,
                (*c)->what);
    fputs("  winnow --help | --version\n\n"
          "Exit codes: 0 done, 2 the input is wrong, 3 the computation broke\n"
          "down, 4 reading or writing failed, 130 interrupted.\n",
          out);
}

static int unknown_command(const char *name)
{
    struct nearest n;
    char hint[NEAREST_HINT];

    nearest_init(&n, name);
    for (const struct command *const *c = commands; *c != NULL; c++)
        nearest_offer(&n, (*c)->name);
    fprintf(
        stderr, "winnow: no command %s%s\n", name,
        nearest_hint(nearest_best(&n), "; winnow --help names them all", hint));
    return 2;
}

/* One message, and how the command is called. */
static int main_wrong(const struct command *c, const char *what,
                      const char *why)
{
    fprintf(stderr, "winnow: %s%s\nwinnow %s %s\n", what, why, c->name,
            c->arguments);
    return 2;
}

/* Options that are words, and how a command says that it takes one. */
static const struct {
    const char *word;
    char letter;
} words[] = {{"--quiet", '-'}, {"--resume", 'r'}, {"--fresh", 'f'},
             {"--to", 't'},    {"--try", 'y'},    {NULL, 0}};

/* 1 if the option is such a word; its member of the command line is then set.
 */
static int read_word(const struct command *c, const char *option,
                     struct command_line *l)
{
    int *const member[] = {&l->quiet, &l->resume, &l->fresh, &l->to, &l->tries};

    for (int i = 0; words[i].word != NULL; i++)
        if (strcmp(option, words[i].word) == 0 &&
            strchr(c->options, words[i].letter) != NULL)
            return *member[i] = 1;
    return 0;
}

static int wrong_option(const struct command *c, const char *option)
{
    const char *near = NULL;
    char hint[NEAREST_HINT];

    for (int i = 0; words[i].word != NULL && near == NULL; i++)
        if (strchr(c->options, words[i].letter) != NULL &&
            nearest_edits(option, words[i].word) < 4)
            near = words[i].word;
    fprintf(stderr, "winnow: %s has no option %s%s\nwinnow %s %s\n", c->name,
            option, nearest_hint(near, "", hint), c->name, c->arguments);
    return 2;
}

/* Reads an option and its value, "-o DIR" or "-oDIR"; *i moves to the last word
 * used. */
static int read_option(const struct command *c, int argc, char **argv, int *i,
                       struct command_line *l)
{
    const char *const option = argv[*i];
    const char *value =
        option[1] != '\0' && option[2] != '\0' ? option + 2 : NULL;

    if (read_word(c, option, l)) return 0;
    if (option[1] == '\0' || option[1] == '-' ||
        strchr(c->options, option[1]) == NULL)
        return wrong_option(c, option);
    if (value == NULL && *i + 1 < argc) value = argv[++*i];
    if (value == NULL) return main_wrong(c, option, " needs a value");
    if (option[1] == 'o')
        l->dir = value;
    else if (option[1] == 's')
        l->overrides[l->n_overrides++] = value;
    else if ((l->threads = command_count(value)) == 0)
        return main_wrong(c, "-j needs a number of threads, 1 to 1024, not ",
                          value);
    return 0;
}

static int is_help(const char *word)
{
    return strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0;
}

static int main_help(const struct command *c)
{
    printf("winnow %s %s\n  %s\n", c->name, c->arguments, c->what);
    return 0;
}

static int main_act(const struct command *c, int argc, char **argv,
                    struct command_line *l)
{
    for (int i = 2; i < argc; i++) {
        if (is_help(argv[i])) return main_help(c);
        if (c->options == NULL || argv[i][0] != '-')
            l->words[l->n_words++] = argv[i];
        else if (read_option(c, argc, argv, &i, l) != 0)
            return 2;
    }
    if (l->n_words < c->min_words)
        return main_wrong(c, c->name, " needs more than its name");
    if (c->max_words >= 0 && l->n_words > c->max_words)
        return main_wrong(c, l->words[c->max_words], ": one argument too many");
    return c->act(l);
}

/* What is said of the words, and what is written of them, has lines. To a case
 * a line break in a value is a blank. */
static int main_wrong_word(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        const int sets =
            strncmp(argv[i], "-s", 2) == 0 || strcmp(argv[i - 1], "-s") == 0;
        for (char *c = argv[i]; sets && *c != '\0'; c++)
            if (strchr("\t\r\n", *c) != NULL) *c = ' ';
        if (argv[i][0] == '\0') {
            fprintf(stderr, "winnow: word %d is empty\n", i);
            return 2;
        }
        if (text_control(argv[i]) == NULL) continue;
        text_blank(argv[i]);
        fprintf(stderr,
                "winnow: word %d, %s, has a line break or another control "
                "character in it\n",
                i, argv[i]);
        return 2;
    }
    return 0;
}

/* The next file that is opened would get the number of a closed stream, and
 * messages would be written to it. So closed streams are opened on /dev/null;
 * results on a closed stdout still count as not written. Non-zero if that
 * fails. */
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
    signal(SIGXFSZ,
           SIG_IGN); /* beyond `ulimit -f` a write fails, and is told */

    const char *const first = argc > 1 ? argv[1] : "";
    if (main_wrong_word(argc, argv) != 0) return 2;

    const char **const texts = alloc_zeroed(2 * (size_t)argc, sizeof *texts);
    struct command_line l = {.words = texts, .overrides = texts + argc};
    const int helps = strcmp(first, "help") == 0;
    const char *const name = helps && argc > 2 ? argv[2] : first;
    const struct command *const c = command_named(name);
    int code = 0;

    if (is_help(first) || (helps && argc == 2))
        usage(stdout);
    else if (strcmp(first, "--version") == 0)
        puts("winnow " VERSION_TEXT);
    else if (c == NULL)
        code = argc < 2 ? 2 : unknown_command(name);
    else
        code = helps ? main_help(c) : main_act(c, argc, argv, &l);
    if (argc < 2) usage(stderr);
    free(texts);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        perror("winnow: cannot write the results");
        return 4;
    }
    return code;
}
