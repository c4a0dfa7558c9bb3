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
#include <string.h>

struct kind {
    const char *name;  /* "drag" */
    const char *what;  /* "drag laws" */
    const char *key;   /* that chooses: "exchange.drag" */
    const char *group; /* with which it is in use; NULL: that of the key */
    /* The i-th model; 0 past the last. */
    int (*model)(int i, struct model *m);
};

/* All kinds, ended by NULL. */
extern const struct kind models_contact, models_integrator, models_list,
    case_population_sizes, case_surfaces_kind, models_averaging, models_scheme,
    models_variation, models_interpolation, models_drag, models_shape,
    models_treatment, models_slip_integration, models_form, models_direction,
    models_time_scheme, models_convection, models_gradient, models_continuity,
    models_patch, models_profile, models_effect;
extern const struct kind case_bodies_method;
extern const struct kind *const models_kinds[];

/* Defines the kind of a list of descriptors, which ends with NULL; then follow
 * its name, what it is, its key and its group. */
#define MODELS_KIND(descriptor, list, ...)                                     \
    static int descriptor##_row(int i, struct model *m)                        \
    {                                                                          \
        for (int k = 0; k <= i; k++)                                           \
            if ((list)[k] == NULL) return 0;                                   \
        *m = (struct model){.name = (list)[i]->name,                           \
                            .what = (list)[i]->what,                           \
                            .equations = (list)[i]->equations,                 \
                            .function = (list)[i]->function};                  \
        memcpy(m->keys, (list)[i]->keys, sizeof m->keys);                      \
        return 1;                                                              \
    }                                                                          \
    const struct kind descriptor = {__VA_ARGS__, descriptor##_row};

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
