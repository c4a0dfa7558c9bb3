/* table_numbers.h -- the numbers that a case gives for a table of keys, in the
 * order in which effects and models expect them.
 */
#ifndef CASE_TABLE_NUMBERS_H
#define CASE_TABLE_NUMBERS_H

#include "base/key.h"
#include "case/settings.h"
#include "coupling/effect.h"

/* The numbers that the case gives for a table of keys, in their order: one for
 * a number, three for a vector, none for a group. Returns how many there are;
 * at most `max` are stored. */
int table_numbers(const struct settings *s, const struct key *keys,
                  double *numbers, int max);

/* The same of an effect, 0 of what has no value; 1 if the case names it. */
enum { EFFECT_NUMBERS = 16 }; /* of an effect, at most */
int table_numbers_of_effect(const struct settings *s, const struct effect *e,
                            double numbers[EFFECT_NUMBERS]);

#endif
