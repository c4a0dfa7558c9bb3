/* study_words.h -- the command line of a study, and the study file.
 *
 *     winnow study CASE -s fluid.step=2e-3,1e-3 --measure mean_height
 *
 * A study file says the same in libconfig's syntax; its keys are in
 * study_words_keys. What the command line says besides goes before: a choice of
 * the same keys takes the place of that of the file, a measure that of its
 * measures.
 */
#ifndef STUDY_STUDY_WORDS_H
#define STUDY_STUDY_WORDS_H

#include "base/key.h"
#include "case/settings.h"
#include "study/texts.h"

/* Most measures of a study. */
enum { STUDY_WORDS_MEASURES = 16 };

/* A truth belongs to the measure before it; that of the last measure also to
 * those that have none. */
struct study_words {
    const char *file;       /* as it was given */
    const char *case_file;  /* that file, or the one that a study file names */
    const char *title;      /* NULL: that of the case */
    const char *dir, *cost; /* NULL: not given */
    int n_choices, n_measures;
    const char **choice;
    const char *measure[STUDY_WORDS_MEASURES], *truth[STUDY_WORDS_MEASURES];
    int seeds, times; /* [-] runs of a variant with other seeds; repetitions of
                         each, for its processor time */
    int jobs;         /* [-] processes at a time; 0: not given */
    int quiet, dry;   /* [-] 1: no progress; 1: only say what would run */
    int old_choices, old_measures; /* those of the file, until replaced */
    struct settings *study;        /* of a study file; else NULL */
    struct texts made;             /* of it, owned */
};

/* Keys of a study file. */
extern const struct key study_words_keys[];

/* Takes the words apart, and reads the study file if the first is one. 0; or
 * after a message 2 or 4. What it points to is borrowed from the words, or
 * lives as long as it does. */
int study_words_take(struct study_words *w, int n, const char *const *words);
void study_words_free(struct study_words *w);

#endif
