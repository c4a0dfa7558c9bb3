/* plan.h -- what a study is to do, from the command line or a study file.
 *
 *     winnow study CASE -s fluid.step=2e-3,1e-3 --measure mean_height
 *
 * A study varies keys of a case, each with its values:
 *
 *     fluid.step=4e-3,2e-3,1e-3                            a key, three values
 *     mesh.cells:fluid.step=[8,8,8]:2e-3,[16,16,16]:1e-3   two keys together
 *     effects.saffman=as-is,{}                             without and with it
 *     threads=1,2                                          no key: run -j 1
 *
 * Commas separate values where they stand in no brackets, braces or quotes, and
 * colons the values of keys that change together. Choices are crossed: a
 * variant takes one entry of each. Entries go from coarse to fine.
 */
#ifndef STUDY_PLAN_H
#define STUDY_PLAN_H

#include "base/key.h"
#include "base/text.h"
#include "study/curve.h"

/* The words that the command takes. Its exit code is 0 also if runs broke down:
 * that is a result. */
#define PLAN_ARGUMENTS                                                         \
    "CASE|STUDY [-s key=value,value...]... [--measure NAME [--truth "          \
    "WHAT]]... "                                                               \
    "[--cost NAME] [--seeds N] [--times N] [-o DIR] [-j RUNS] [--dry-run] "    \
    "[--quiet]"

/* What is varied beside the keys of a case: threads of a run. What a run costs,
 * where nothing else is named: processor time [s]. */
#define PLAN_THREADS "threads"
#define PLAN_COST "seconds.processor"

/* One choice: entries with a value for each of its keys, side by side. */
struct choice {
    int n; /* [-] entries */
    struct texts key, value;
};

struct choices {
    int n;
    struct choice *of; /* those of one entry are the same for all runs */
};

enum { PLAN_MEASURES = 16 }; /* at most */

struct plan {
    const char *file;      /* as it was given */
    const char *case_file; /* that file, or the one that a study file names */
    const char *title;     /* of the picture; that of the case */
    const char *dir;       /* of the study's own files */
    int seeds, times;      /* [-] runs of a variant with other seeds;
                              repetitions of each, for its processor time */
    int jobs;              /* [-] processes at a time */
    int quiet, dry;        /* [-] 1: no progress; 1: only say what would run */
    struct choices choices;
    int n_measures;
    struct measure measure[PLAN_MEASURES];
    struct truth truth[PLAN_MEASURES];
    struct measure cost;    /* the abscissa of the picture */
    struct texts fixed;     /* overrides of every run: few pictures */
    struct settings *study; /* of a study file; else NULL */
    struct texts made;      /* what is borrowed above */
};

/* Keys of a study file. */
extern const struct key plan_keys[];

/* Makes a plan of the words after `winnow study`. What the command line says
 * goes before what a study file says: a choice of the same keys takes the place
 * of that of the file, a measure that of its measures. 0; or after one message
 * 2 for what is wrong, 4 for what cannot be read. Nothing is written. */
int plan_create(struct plan *p, int n_words, const char *const *words);
void plan_free(struct plan *p);

/* Says on stderr what is wrong with a study; returns 2. */
int plan_wrong(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Adds the overrides of a variant, or of -1 (choices_overrides), "key=value"
 * each, with the k-th of several seeds. 0, or the exit code after a message. */
int plan_overrides(const struct plan *p, int variant, int seed,
                   struct texts *set);

/* The case with these overrides; NULL after a message, with its exit code. */
struct settings *plan_case(const struct plan *p, const struct texts *set,
                           int *code);

/* 1 if a run costs its processor time. */
int plan_cost_is_processor(const struct plan *p);

/* Adds a choice, or a key that every run has; 0, or 2 after a message. */
int choices_add(struct choices *c, const char *text);
void choices_free(struct choices *c);

/* Number of variants; at most INT_MAX is told. */
int choices_variants(const struct choices *c);

/* The entry of the i-th choice in a variant, and the variant that has another
 * entry there. The last choice changes fastest. */
int choices_entry(const struct choices *c, int variant, int i);
int choices_with(const struct choices *c, int variant, int i, int entry);

/* The value of the k-th key of a choice in an entry; and that of a key in a
 * variant, NULL if no choice has it. Both are borrowed. */
const char *choices_in_entry(const struct choice *c, int entry, int k);
const char *choices_value(const struct choices *c, int variant,
                          const char *key);

/* Adds all that a variant sets, "key=value" each; of variant -1 what all runs
 * have. Threads are no key. */
void choices_overrides(const struct choices *c, int variant, struct texts *set);

/* What tells a variant from others, "step=1e-3, method=pcm", without the choice
 * `but` (-1: with all); a key as short as it can be, "" if nothing is left. Its
 * values alone, "1e-3, pcm". To be freed. */
char *choices_label(const struct choices *c, int variant, int but);
char *words_variant(const struct choices *c, int variant, int but);

/* A number that falls from entry to entry as they get finer: the value of the
 * first key, or one over it if the values rise; of a vector the geometric mean
 * of its components that change. Only ratios of it mean anything. A word
 * between numbers, such as "auto", has none, nan, and so have all entries if
 * the first or the last is a word, or if they neither fall nor rise. */
double choices_size(const struct choice *c, int entry);

/* Says on stderr of which choice the cells of the first key become fewer, or
 * the step longer: its last entry is not the finest. */
void choices_tell_reversed(const struct choices *c);

/* The choice with the most entries, words included, of those with two sizes or
 * more; -1 if none. */
int choices_axis(const struct choices *c);

#endif
