/* study_words.h -- the command line of a study, and the study file.
 *
 *     winnow study CASE -s fluid.step=2e-3,1e-3 --measure mean_height
 *
 * A study file says the same in libconfig's syntax; its keys are in
 * study_words_keys. What the command line says besides goes before: a choice of
 * the same keys replaces that of the file, a measure its measures.
 */
#ifndef STUDY_STUDY_WORDS_H
#define STUDY_STUDY_WORDS_H

#include "base/key.h"
#include "case/settings.h"
#include "study/plan.h"

/* A truth belongs to the measure before it; that of the last measure also to
 * those that have none. */
struct study_words {
    const char *file;       /* as it was given */
    char *case_file;        /* that file, or the one that a study file names */
    const char *title;      /* NULL: that of the case */
    const char *dir, *cost; /* NULL: not given */
    int n_choices, n_measures;
    const char **choice;
    const char *measure[PLAN_MEASURES], *truth[PLAN_MEASURES];
    int seeds, times, jobs; /* 0: not given */
    int quiet, dry;
    struct settings *study; /* of a study file; else NULL */
    int n_texts;
    char **text; /* made of it, owned */
};

/* Keys of a study file. */
extern const struct key study_words_keys[];

/* Takes the words apart, and reads the study file if the first is one. 0; or
 * after a message 2 or 4. What it points to is borrowed from the words, or
 * lives as long as it does. */
int study_words_take(struct study_words *w, int n, const char *const *words);
void study_words_free(struct study_words *w);

#endif
