/* model.h -- the description of a model, for cases and their readers.
 *
 * A model that a case chooses by name has one descriptor. Its first members are
 * MODEL_MEMBERS; then follow its functions and numbers, as in struct drag_law.
 * A kind whose models differ by a constant of an enumeration has nothing more,
 * and its descriptors are of the type struct model. The allowed words of a key,
 * `winnow list`, `explain` and `check` are made from the descriptors.
 */
#ifndef BASE_MODEL_H
#define BASE_MODEL_H

#include <string.h>

#include "base/key.h"

#define MODEL_MEMBERS                                                          \
    const char *name;      /* as a case spells it */                           \
    const char *what;      /* one line */                                      \
    const char *equations; /* keys in chapters/references.md; "" if none */    \
    const char *function;  /* the one that computes it */                      \
    const struct key *keys[KEY_TABLES] /* tables of the keys it reads */

struct model {
    MODEL_MEMBERS;
    int value; /* of the enumeration */
};

/* The definition of a function that finds a model of a kind by its name, or
 * returns NULL: of `struct drag_law` it is drag_law_named, which looks through
 * drag_laws. The name is the first member of each descriptor. */
#define MODEL_NAMED(kind)                                                      \
    const struct kind *kind##_named(const char *name)                          \
    {                                                                          \
        const struct kind *const *k = kind##s;                                 \
        while (*k != 0 && strcmp((*k)->name, name) != 0)                       \
            k++;                                                               \
        return *k;                                                             \
    }

/* Calls a function of the descriptors of a list that have it: of each, or up to
 * the first that returns another code than 0. The arguments may depend on
 * i_model, the place in the list. */
#define MODELS_EACH(list, function, ...)                                       \
    for (int i_model = 0; (list)[i_model] != 0; i_model++)                     \
        if ((list)[i_model]->function != 0)                                    \
    (list)[i_model]->function(__VA_ARGS__)
#define MODELS_UNTIL(code, list, function, ...)                                \
    for (int i_model = 0; (list)[i_model] != 0 && (code) == 0; i_model++)      \
        if ((list)[i_model]->function != 0)                                    \
    (code) = (list)[i_model]->function(__VA_ARGS__)

/* A model may have keys of its own: one of its tables, of numbers that nothing
 * else reads. It is given them in the order of the rows; so many at most. */
enum { MODEL_NUMBERS = 4 };

#endif
