/* study.h -- `winnow study`: error against time, for any choice in any case. */
#ifndef STUDY_STUDY_H
#define STUDY_STUDY_H

/* The words that the command takes. Its exit code is 0 also if runs broke down:
 * that is a result. */
#define STUDY_ARGUMENTS                                                        \
    "CASE|STUDY [-s key=value,value...]... [--measure NAME [--truth "          \
    "WHAT]]... "                                                               \
    "[--cost NAME] [--seeds N] [--times N] [-o DIR] [-j RUNS] [--dry-run] "    \
    "[--quiet]"

/* Says on stderr what is wrong with a study; returns 2. */
int study_wrong(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
