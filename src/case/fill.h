/* fill.h -- from the keys of a case to the members of its structs. */
#ifndef CASE_FILL_H
#define CASE_FILL_H

#include "case/settings.h"
#include "coupling/effect.h"

/* Stores the value of each key that has a place (KEY_AT) in the struct of its
 * group. What the case leaves out without a default stays 0. */
void fill_settings(struct settings *s, const struct key *const *tables);

/* The path of the key that fills the member, or whose mark it is. */
const char *fill_path(const struct settings *s, const struct key *const *tables,
                      const void *member);

/* Releases the lists. */
void fill_release(struct settings *s, const struct key *const *tables);

/* The numbers that the case gives for a table of keys, in their order: one for
 * a number, three for a vector, none for a group. Returns how many there are;
 * at most `max` are stored. */
int fill_numbers(const struct settings *s, const struct key *keys,
                 double *numbers, int max);

/* The same of an effect, 0 of what has no value; 1 if the case names it. */
enum { EFFECT_NUMBERS = 16 }; /* of an effect, at most */
int fill_effect_numbers(const struct settings *s, const struct effect *e,
                        double numbers[EFFECT_NUMBERS]);

#endif
