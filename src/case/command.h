/* command.h -- a command of the program, such as `winnow run`.
 *
 * A command is one descriptor, listed in commands.c. The
 * command line, `winnow --help` and the messages about words that are missing
 * or too many are made from the descriptors.
 */
#ifndef CASE_COMMAND_H
#define CASE_COMMAND_H

/* The arguments of the command: words, and the values of options. */
struct command_line {
    int n_words, n_overrides;
    const char **words, **overrides;
    const char *dir; /* of -o; NULL: chosen from the name of the case */
    int threads;     /* of -j, at most; 0: as OpenMP chooses */
    int quiet;       /* 1: --quiet was given */
    int resume;      /* 1: --resume was given */
    int fresh;       /* 1: --fresh was given */
    int to;          /* 1: --to was given, before a further word */
    int tries;       /* 1: --try was given, before a further word */
};

struct command {
    const char *name, *arguments, *what;
    const char *options; /* first letters of those it takes, - for --quiet, r
                            for --resume, f for --fresh, t for --to, y for
                            --try; NULL: all that follows is words */
    int min_words, max_words; /* after the name; max_words < 0: any number */
    /* Returns the exit code, after a message if it is not 0. */
    int (*act)(const struct command_line *l);
};

/* All of them, ended by NULL. */
extern const struct command run_command, study_command, export_command,
    check_command, explain_command, list_command, list_new_command,
    eval_command, command_status, report_command;
extern const struct command *const commands[];
/* The one of that name, or NULL. */
const struct command *command_named(const char *name);

/* A whole number from 1 to 1024, as of threads or runs; 0 if it is none. */
int command_count(const char *text);

#endif
