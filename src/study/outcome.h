/* outcome.h -- the runs of a study, each a process of its own; what they come
 * to; and what the study writes and says of it.
 *
 * A run is `winnow run CASE -s ... -o DIR/runs/NAME -j 1 --quiet`. Its folder
 * also holds variant.txt, which says what it is a run of, and log.txt, what it
 * said. A run whose summary tells of its end, and whose variant.txt is the same
 * as now, is not done again. It has a checksum of all values of the case, its
 * defaults, and the contents of the files that it names.
 *
 * The error of a measure is the root mean square of its difference from the
 * truth over that of the truth; of one number |q - q_0| / |q_0|. Its standard
 * error is that of the samples and seeds, over the same.
 */
#ifndef STUDY_OUTCOME_H
#define STUDY_OUTCOME_H

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

/* Does those that have not ended, p->jobs at a time, with progress on stderr.
 * 0; or after a message 4 if something could not be written, 130 if a signal
 * came: the runs have then been told to stop. */
int runs_perform(const struct plan *p, int n, struct run *runs);

/* One measure of one variant. */
struct finding {
    struct curve found; /* mean over the seeds */
    double value;       /* of one number; of a curve its root mean square */
    double truth;       /* the same of the truth; nan if there is none */
    double error;       /* [-] relative */
    double uncertainty; /* [-] standard error of it, relative to the truth;
                     without one of the value, relative to that */
    double order;       /* [-] from the next coarser one on the axis; or nan */
};

struct outcome {
    double cost;    /* least of the repetitions, mean over the seeds; or nan */
    double scatter; /* standard error of the cost */
    double seconds; /* [s] processor time, likewise */
    int ended;      /* [-] 1: all its runs came to their end */
    const struct run *broken; /* the first that did not, or NULL */
    char *label;
    struct finding of[PLAN_MEASURES];
};

struct outcomes {
    const struct plan *plan;
    int n_runs;
    const struct run *run;
    int n;
    struct outcome *variant;
    int standing; /* the variant that the case itself is; -1: none */
    int axis;     /* the choice along which a line goes; -1: none */
};

/* Everything is borrowed but what it holds. */
struct outcomes outcomes_create(const struct plan *p, int n_runs,
                                const struct run *runs);
void outcomes_free(struct outcomes *o);

/* The order that the extrapolation of a variant's line has found; nan if its
 * last three do not approach each other, or the truth is no extrapolation. */
double outcomes_fitted_order(const struct outcomes *o, int variant, int m);

/* By two standard errors: 1 if the error is certainly within the limit; if it
 * is larger than chance explains; if chance explains the difference of two. */
int outcome_is_within(const struct finding *f, double limit);
int outcome_is_resolved(const struct finding *f);
int outcome_is_chance(const struct finding *a, const struct finding *b);

/* 1 if two variants cost the same, as far as can be told: up to two standard
 * errors of the difference, and times up to a tenth. */
int outcome_costs_the_same(const struct outcome *a, const struct outcome *b);

/* Words for pictures and pages, to be freed: what the keys of a choice mean; a
 * measure, "mean height, mean from 0.2 s on", or what a run costs; and what a
 * measure is compared with. */
char *words_choice(const struct choice *c);
char *words_measure(const struct measure *m);
char *words_cost(const struct plan *p);
char *words_truth(const struct outcomes *o, int m);

/* Between models there are differences, and errors from what is right. */
const char *words_error(const struct truth *t);

/* What a study writes and says:
 *
 *     study.csv    a row a run: its choices, processor seconds in all and wall
 *                  seconds by part, steps, memory, each measure with its truth,
 *                  its error and the standard error of that
 *     study.md     a row a variant, orders, and the advice: which variant is
 *                  the cheapest within 5 %, 1 %, 0.1 % of the truth, and the
 *                  case as it stands beside it
 *     study.html   the same to choose from, in a browser (html.c)
 *     study.svg, study.png, study.gp
 *                  error against cost, the script with its data
 *
 * Non-zero after a message if a file could not be written; a picture that could
 * not be drawn, for want of gnuplot, is told and nothing else. */
int report_write(const struct outcomes *o);
void report_advice(const struct outcomes *o, FILE *out);
int outcome_draw(const struct outcomes *o);

/* study.html: the table as a page with a picture in which one can choose. It
 * also tells of a study that was interrupted. */
int html_write(const struct outcomes *o);

/* Why a run did not come to its end: its summary says so, or the first line of
 * what it said. To be freed. */
char *report_reason(const struct run *r);

/* A file in the folder of the study, to be committed; NULL after a message. */
struct file *report_file(const struct plan *p, const char *name);

#endif
