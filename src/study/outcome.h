/* outcome.h -- the runs of a study as results: what each variant costs, what it
 * gives, how far that is from the truth, and how sure all this is.
 *
 * The error of a measure is the root mean square of its difference from the
 * truth over that of the truth; of one number |q - q_0| / |q_0|. Its standard
 * error is that of the samples and seeds, over the same.
 */
#ifndef STUDY_OUTCOME_H
#define STUDY_OUTCOME_H

#include "study/plan.h"
#include "study/runs.h"

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

/* 1 if the error of the measure is surely within the limit: by two standard
 * errors. */
int outcome_is_within(const struct finding *f, double limit);

/* 1 if chance explains the difference of two errors, up to two standard errors
 * of it. */
int outcome_is_chance(const struct finding *a, const struct finding *b);

/* 1 if two variants cost the same, as far as can be told: up to two standard
 * errors of the difference, and times up to a tenth. */
int outcome_costs_the_same(const struct outcome *a, const struct outcome *b);

/* 1 if the error is larger than chance explains, two standard errors. */
int outcome_is_resolved(const struct finding *f);

#endif
