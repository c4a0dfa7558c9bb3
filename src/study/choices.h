/* choices.h -- what a study varies: keys of a case, each with its values.
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
#ifndef STUDY_CHOICES_H
#define STUDY_CHOICES_H

#include "study/texts.h"

/* The value that leaves a key as the case has it, there or not. */
#define CHOICES_AS_IS "as-is"

/* One choice: entries with a value for each of its keys, side by side. */
struct choice {
    int n; /* [-] entries */
    struct texts key, value;
};

struct choices {
    int n;
    struct choice *of;
};

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
 * have. The key `but` is left out. */
void choices_overrides(const struct choices *c, int variant, const char *but,
                       struct texts *set);

/* What tells a variant from others, "step=1e-3, method=pcm", without the choice
 * `but` (-1: with all); a key as short as it can be, "" if nothing is left. To
 * be freed. */
char *choices_label(const struct choices *c, int variant, int but);

/* A number that falls from entry to entry as they get finer: the value of the
 * first key, or one over it if the values rise; of a vector the geometric mean
 * of its components that change. Only ratios of it mean anything. A word
 * between numbers, such as "auto", has none, nan, and so have all entries if
 * the first or the last is a word, or if they neither fall nor rise. */
double choices_size(const struct choice *c, int entry);

/* 1 if the cells of its first key become fewer, or the step longer: the entries
 * go from fine to coarse, and the last one is not the finest. */
int choices_is_reversed(const struct choice *c);

/* The choice with the most entries, words included, of those with two sizes or
 * more; -1 if none. */
int choices_axis(const struct choices *c);

#endif
