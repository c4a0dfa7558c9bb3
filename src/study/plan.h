/* plan.h -- what a study is to do, from the command line or a study file. */
#ifndef STUDY_PLAN_H
#define STUDY_PLAN_H

#include "study/choices.h"
#include "study/measure.h"
#include "study/study_words.h"
#include "study/truth.h"

/* Most measures of a study. */
enum { PLAN_MEASURES = STUDY_WORDS_MEASURES };

/* What is varied beside the keys of a case: threads of a run. */
#define PLAN_THREADS "threads"

/* What a run costs, where nothing else is named: processor time [s]. */
#define PLAN_COST "seconds.processor"

struct plan {
    struct study_words words; /* as they were given; title, dir and jobs are
                                 filled in where they were not */
    struct choices choices;   /* those of one entry are the same for all runs */
    int n_measures;
    struct measure measure[PLAN_MEASURES];
    struct truth truth[PLAN_MEASURES];
    struct measure cost; /* the abscissa of the picture */
    struct texts fixed;  /* overrides of every run: few pictures */
};

/* Makes a plan of the words after `winnow study`. 0; or after one message 2 for
 * what is wrong, 4 for what cannot be read. Nothing is written. */
int plan_create(struct plan *p, int n_words, const char *const *words);
void plan_free(struct plan *p);

/* Adds the overrides of a variant, or of -1 (choices_overrides), "key=value"
 * each, with the k-th of several seeds. 0, or the exit code after a message. */
int plan_overrides(const struct plan *p, int variant, int seed,
                   struct texts *set);

/* The case with these overrides; NULL after a message, with its exit code. */
struct settings *plan_case(const struct plan *p, const struct texts *set,
                           int *code);

/* 1 if a run costs its processor time. */
int plan_cost_is_processor(const struct plan *p);

#endif
