/* model_choice.h -- which models a case chooses, and what these ask for. */
#ifndef CASE_CHECKS_MODEL_CHOICE_H
#define CASE_CHECKS_MODEL_CHOICE_H

#include "case/models.h"
#include "case/settings.h"

/* 1 if the case chooses this model, by a word, a group or in a list. Of a kind
 * whose key belongs to other models one of these must be chosen. */
int model_choice_is_on(const struct settings *s, const struct kind *kind,
                       const struct model *m);

/* 0 if the model that the case chooses of a kind reads the key; else 2, after a
 * message with those that do. */
int model_choice_unread(const struct settings *s, const char *kind,
                        const char *path);

/* For validate_case: a model has the keys that it cannot do without. 0, or 2
 * after one message. */
int model_choice_check(const struct settings *s);

#endif
