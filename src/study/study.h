/* study.h -- `winnow study`: error against time, for any choice in any case. */
#ifndef STUDY_STUDY_H
#define STUDY_STUDY_H

/* The words that the command takes, for the list of commands. */
#define STUDY_ARGUMENTS                                                        \
    "CASE|STUDY [-s key=value,value...]... [--measure NAME [--truth "          \
    "WHAT]]... "                                                               \
    "[--cost NAME] [--seeds N] [--times N] [-o DIR] [-j RUNS] [--dry-run] "    \
    "[--quiet]"

/* Does the study that the words after `winnow study` ask for. Returns the exit
 * code of the program: 0 done, also if runs broke down; 2 the input is wrong, 4
 * reading or writing failed, 130 interrupted. */
int study_command(int n_words, const char *const *words);

#endif
