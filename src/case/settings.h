/* settings.h -- a case, read and checked.
 *
 * A case is a libconfig file (which may @include others), changed by
 * overrides "path.to.key=value". settings_create checks all of it against the
 * tables of keys and fills in the defaults, so that reading a value later
 * cannot fail: asking for a key that no table has, with the wrong type, or in
 * a group that the case does not name is a bug and asserted.
 *
 * A path is the row's ("fluid.density"), with the side in place of <patch>
 * ("fluid.bottom.inlet"), and in a list with the number of the group
 * ("output.profiles.[0].height"), which the item functions write.
 */
#ifndef CASE_SETTINGS_H
#define CASE_SETTINGS_H

#include <stddef.h>

#include "averaging/averaging.h"
#include "base/file.h"
#include "base/key.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "dem/particles_setup.h"
#include "fluid/boundary.h"
#include "fluid/fluid.h"
#include "mesh/mesh.h"
#include "output/output_options.h"
#include "resolved/bodies_setup.h"

/* What a case says, each group in the options of its room, where the rows of
 * its keys put it (KEY_AT). What the case leaves out has its default or is 0.
 */
struct settings {
    const char *file;  /* the case as it was given */
    int quiet;         /* [-] 1: no progress is printed on stderr */
    struct mesh *poly; /* the mesh, where it is no plain box; else NULL */
    struct {
        /* [-] 1: the case names the group */
        int fluid, particles, averaging, exchange, effects, bodies;
    } has;
    const char *title, *cites;  /* "" if left out */
    const char *engine;         /* "one" or "distributed" */
    int ranks[3], layers;       /* [-] of several machines; 0: left out */
    struct mesh_options mesh;   /* mesh/mesh.c */
    struct fluid_options fluid; /* fluid/fluid.c */
    struct {
        int n;
        struct boundary_options *item;
    } sides;                          /* or patches, that the case describes */
    struct particles_setup particles; /* dem/particles_keys.c */
    struct averaging_options averaging; /* averaging/averaging.c */
    struct coupling_options exchange;   /* coupling/coupling_options.c */
    struct effects_options effects;     /* each in the file of the effect */
    struct bodies_setup bodies;         /* resolved/bodies_setup.c */
    struct output_options output;       /* output/output_keys.c */
    struct case_bodies *all_bodies;     /* case/resolved/case_bodies.h */
    struct settings_text *text;         /* the case as it is written */
};

/* Reads and checks. tables: a list of tables, ended by NULL (the tables are
 * borrowed, and so are the overrides). NULL after one message on stderr; *code
 * is then 2 if the input is wrong, 4 if it could not be read, and else 0. */
struct settings *settings_create(const char *file, int n_overrides,
                                 const char *const *overrides,
                                 const struct key *const *tables, int *code);
void settings_free(struct settings *s);

/* All that the case says, with its overrides and defaults. */
struct config_setting_t;
const struct config_setting_t *settings_root(const struct settings *s);

/* 1 if the case itself names the key or group, 0 if it is left out or has its
 * default, and if this build leaves the key's folder out. */
int settings_has(const struct settings *s, const char *path);
/* 1 if it has a value, its own or a default; 0 too where there is no such key.
 */
int settings_is_set(const struct settings *s, const char *path);

double settings_real(const struct settings *s, const char *path);
int settings_int(const struct settings *s, const char *path); /* word: 0 */
const char *settings_text(const struct settings *s, const char *path);

/* The row of a path, which may have the numbers of groups of lists in it; NULL:
 * none. */
const struct key *settings_row(const struct settings *s, const char *path);

/* 1 if the path is that of a list. The groups of one; 0 for a list that is left
 * out. */
int settings_is_list(const struct settings *s, const char *path);
int settings_length(const struct settings *s, const char *list);

/* The path of a key of the i-th group of a list, for the functions above, and
 * these with such a path. */
enum { SETTINGS_ITEM_SIZE = 128 };
const char *settings_item(char path[SETTINGS_ITEM_SIZE], const char *list,
                          int i, const char *key);
#define SETTINGS_ITEM(list, i, key)                                            \
    settings_item((char[SETTINGS_ITEM_SIZE]){0}, list, i, key)
#define settings_item_has(s, l, i, k) settings_has(s, SETTINGS_ITEM(l, i, k))
#define settings_item_is_set(s, l, i, k)                                       \
    settings_is_set(s, SETTINGS_ITEM(l, i, k))
#define settings_item_real(s, l, i, k) settings_real(s, SETTINGS_ITEM(l, i, k))
#define settings_item_int(s, l, i, k) settings_int(s, SETTINGS_ITEM(l, i, k))
#define settings_item_text(s, l, i, k) settings_text(s, SETTINGS_ITEM(l, i, k))

/* What the case says about a side of the box or a patch of its mesh, under
 * "fluid.left" or "fluid.sides" for "left"; NULL if it says nothing. */
const struct boundary_options *settings_side(const struct settings *s,
                                             const char *patch);

/* The i-th of all keys of sides or patches that a case could have; NULL after
 * the last. */
const char *settings_any_side(const struct settings *s, int i);

/* Every file or folder that a case names lies beside the case, unless it begins
 * with /. */
enum { SETTINGS_PATH = 4096 };
void settings_beside(const struct settings *s, const char *file, char *path,
                     size_t size);

/* A file that the case names, which is read once and kept with the case; and
 * all of them, by their paths. */
const struct input *settings_input(const struct settings *s, const char *file);
struct inputs **settings_files(const struct settings *s);

/* The path of the key, list or group that has its value or its mark in this
 * member of the settings. */
const char *settings_key(const struct settings *s, const void *member);
#define KEY_OF(s, member) settings_key(s, &(s)->member)

/* The place of a key and its name, "case.cfg:3: mesh.periodic: ", with which
 * messages of other rooms begin. */
void settings_where(const struct settings *s, const char *path, char *where,
                    size_t size);

/* Prints on stderr what is wrong with a key, with the place where the case sets
 * it. Returns 2. For errors that only the builder of the simulation finds. */
int settings_wrong(const struct settings *s, const char *path,
                   const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* --- fill: from the keys of a case to the members of its structs. */

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
