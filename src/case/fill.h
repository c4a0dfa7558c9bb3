/* fill.h -- from the keys of a case to the members of its structs. */
#ifndef CASE_FILL_H
#define CASE_FILL_H

#include "case/settings.h"

/* Stores the value of each key that has a place (KEY_AT) in the struct of its
 * group. What the case leaves out without a default stays 0. */
void fill_settings(struct settings *s, const struct key *const *tables);

/* Releases the lists. */
void fill_release(struct settings *s, const struct key *const *tables);

#endif
