/* models.h -- every model that a case can choose, by kind.
 *
 * The models of a kind stand in the room that computes them, each in one
 * descriptor (base/model.h). Here is what they have in common: the key that
 * chooses one of them.
 */
#ifndef CASE_MODELS_H
#define CASE_MODELS_H

#include "base/model.h"

#include <stddef.h>

struct kind {
    const char *name;  /* "drag" */
    const char *what;  /* "drag laws" */
    const char *key;   /* that chooses: "exchange.drag" */
    const char *group; /* with which it is in use; NULL: that of the key */
    const void *list;  /* of its descriptors, ended by NULL */
};

/* All kinds, ended by one without a name. */
extern const struct kind models_kinds[];

/* The i-th model of a kind; 0 past the last. */
int models_at(const struct kind *kind, int i, struct model *m);

/* The kind of that name, or NULL. */
const struct kind *models_kind(const char *name);

/* The tables of keys of all models, each once. Returns how many there are; at
 * most `max` are stored. */
int models_tables(const struct key **tables, int max);

/* 1 if one of the tables of the model has the key. */
int models_reads(const struct model *m, const char *path);

/* The names that a key allows, "a | b"; "" if it chooses no model. Of a side
 * those without keys, which a case writes as a word. */
void models_words(const struct key *key, char *text, size_t size);

/* 1 if a group with these n keys is one patch: one of them is the first of a
 * kind of patch, and each other belongs to it or to a model that it chooses. */
int models_make_patch(int n, const char *const *name);

/* The value of the choice of that name, which is in the list. */
int models_value(const struct model *const *choices, const char *name);

#endif
