/* runs.h -- the runs of a study, each a process of its own.
 *
 * A run is `winnow run CASE -s ... -o DIR/runs/NAME -j 1 --quiet`. Its folder
 * also holds variant.txt, which says what it is a run of, and log.txt, what it
 * said. A run whose summary tells of its end, and whose variant.txt is the same
 * as now, is not done again. It has a checksum of all values of the case, its
 * defaults, and the contents of the files that it names.
 */
#ifndef STUDY_RUNS_H
#define STUDY_RUNS_H

#include "study/plan.h"

struct run {
    int variant, seed, time; /* [-] which of each, from 0 */
    char *name;              /* of its folder */
    char *folder;            /* DIR/runs/NAME */
    char *identity;          /* what variant.txt says */
    unsigned long contents;  /* checksum of the case, overrides and all */
    struct texts overrides;
    double expected; /* [s] processor time, roughly; only ratios count */
    int code;        /* exit code; below 0 if it has not ended */
};

/* Codes of a run that has not ended; exit codes of one that was refused, or
 * that could not write, which is no result of it. */
enum { RUN_GOES_ON = -2, RUN_TO_DO = -1, RUN_REFUSED = 2, RUN_NOT_WRITTEN = 4 };

/* The runs of a plan: for each variant its seeds, for each of them its
 * repetitions. *n is their number. NULL with *code 2 or 4 after a message, or
 * 130 if a signal came. */
struct run *runs_create(const struct plan *p, int *n, int *code);
void runs_free(int n, struct run *runs);

/* The variant that the case itself is, defaults included; what is set for all
 * runs counts as the case's. -1 if none is. */
int runs_standing(const struct plan *p, int n, const struct run *runs);

/* Finds out which have ended before; returns how many. */
int runs_find_ended(int n, struct run *runs);

/* 1 if the folder says that it is of this very run, ended or not. */
int runs_is_begun(const struct run *r);

/* Does those that have not ended, p->jobs at a time, with progress on stderr.
 * 0; or after a message 4 if something could not be written, 130 if a signal
 * came: the runs have then been told to stop. */
int runs_perform(const struct plan *p, int n, struct run *runs);

#endif
