/* schema.h -- finding, wording and applying the rows of the key tables.
 *
 * A list of tables, ended by NULL, is searched as if it were one table. The
 * condition of a row is its text: "> 0, <= 1" are comparisons that all hold,
 * "a | b" are words of which one is given, "auto | >= 1" is either. A row
 * without a text that chooses a model allows the names of its kind (models.h).
 */
#ifndef CASE_SCHEMA_H
#define CASE_SCHEMA_H

#include "base/key.h"

#include <libconfig.h>
#include <stddef.h>

enum { SCHEMA_TEXT = 512 }; /* bytes of a path or a phrase, at most */

/* What <patch> stands for in a path: the sides of the box, as in
 * mesh_sides, and the three pairs of opposite sides. Ended by NULL. */
extern const char *const schema_patches[];

/* The row of a path, or NULL. */
const struct key *schema_find(const struct key *const *tables,
                              const char *path);
/* Loops over the rows of all tables. */
#define SCHEMA_EACH(found, tables)                                             \
    for (const struct key *const *table_of_##found = (tables);                 \
         *table_of_##found != NULL; table_of_##found++)                        \
        for (const struct key *found = *table_of_##found; found->path != NULL; \
             found++)

/* The name of a row within its group if the row is a direct member of the
 * group, else NULL. The group "" is the whole case. */
const char *schema_member(const struct key *key, const char *group);

/* 1 if the row is that of the path or is in the group of that path, at any
 * depth. */
int schema_is_within(const struct key *key, const char *path);

/* 1 if the number fulfils the conditions, or the word is one of the row. */
int schema_allow_number(const struct key *key, double value);
int schema_allow_word(const struct key *key, const char *word);

/* 1 if the key has a default; 1 if it must be given, by its group or by a model
 * that is chosen. */
int schema_has_default(const struct key *key);
int schema_is_required(const struct key *key);

/* The default as a case would write it; there is one. */
void schema_default(const struct key *key, char text[SCHEMA_TEXT]);

/* The expected value of the row as a phrase: "a number > 0 [kg/m^3]". */
void schema_expected(const struct key *key, char text[SCHEMA_TEXT]);

/* The row nearest to an unknown path, among the keys of its group and then
 * everywhere, and its path as a case would write it: with a side of the box in
 * the place of <patch>. NULL if none is near. */
const struct key *schema_nearest(const struct key *const *tables,
                                 const char *path, char nearest[SCHEMA_TEXT]);

/* The word of the row nearest to an unknown one; 0 if none is near. */
int schema_nearest_word(const struct key *key, const char *word,
                        char nearest[SCHEMA_TEXT]);

/* --- schema_check.c: a tree against the tables of keys.
 *
 * Every setting must have a row, the type of the row and a value it allows;
 * every required key of a group that the case has must be given, and the case
 * must have the groups that a row needs. Then the defaults are filled in. */

/* 0, or 2 after a message for the first text, of whatever key, with a control
 * character in it: texts end in scripts, pages and terminals. */
int schema_check_texts(const config_t *tree);

/* 0, or 2 after one message about the first thing that is wrong. */
int schema_check_check(config_t *tree, const struct key *const *tables);
/* Adds the default of every key that is left out of a group of the case. */
void schema_check_fill(config_t *tree, const struct key *const *tables);

#endif
