/* run.h -- a case from its settings to its last output file. */
#ifndef CASE_RUN_H
#define CASE_RUN_H

#include "case/settings.h"

struct run_options {
    const char *dir; /* where the output goes, borrowed */
    int resume;      /* [-] 1: goes on where the run in dir ended */
    int fresh;       /* [-] 1: settles the bed anew */
    int n_overrides; /* [-] of the case, borrowed */
    const char *const *overrides;
};

/* Builds and runs the simulation that the case describes, with the fastest
 * number of threads up to that of OpenMP. Returns the exit code of the program:
 * 0 done, 2 the input is wrong after all, 3 the computation broke down, 4
 * reading or writing failed, 130 interrupted; after a message if not 0. */
int run_case(const struct settings *s, const struct run_options *o);

#endif
