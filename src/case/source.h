/* source.h -- the case file as a tree with the source of each value.
 *
 * libconfig reads the file and keeps file and line of every setting. A value
 * that is not from a file has its source in its hook: the text of an override,
 * or the mark of a default. So every message can name the place where the case
 * has to be changed. The hook of the root is the path of the case.
 */
#ifndef CASE_SOURCE_H
#define CASE_SOURCE_H

#include <libconfig.h>

#include "base/file.h"

enum { SOURCE_TEXT = 512 }; /* bytes of a place or a value, at most */

/* Reads the file and what it includes, looked for beside it. 0; or after one
 * message 2 for wrong syntax or a file that cannot be included, 4 for a case
 * that cannot be read. tree is initialised in any case, and borrows `file`.
 * What is read is kept. */
int source_read(config_t *tree, struct inputs **files, const char *file);

/* 1 if the value is a default. */
int source_is_default(const config_setting_t *setting);

/* A number, whole or real; 0 for a word that stands in its place. */
double source_number(const config_setting_t *setting);

/* A member, by its number; and its path within the group of that path. */
static inline config_setting_t *source_element(const config_setting_t *s, int i)
{
    return config_setting_get_elem(s, (unsigned)i);
}
void source_path(char below[SOURCE_TEXT], const char *path,
                 const config_setting_t *member);

/* The place of a setting: its override, or its file and line. */
void source_place(const config_setting_t *setting, char text[SOURCE_TEXT]);

/* "PLACE: KEY: " of the setting whose text this very one is, within a group
 * of that path; allocated, NULL if there is none. */
char *source_place_of(const config_setting_t *in, const char *path,
                      const char *text);

/* Prints "winnow: PLACE: message" on stderr. Returns 2. */
int source_wrong(const config_setting_t *at, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The value in words, for "found ...". */
void source_value(const config_setting_t *setting, char text[SOURCE_TEXT]);

/* Applies an override "path.to.key=value", whose text is borrowed for as long
 * as the tree exists; its value is written as a case would, and a bare word is
 * a text. Missing groups of the path are created; a group of a list is named by
 * its number, counted from 0. 0, or 2 after a message. */
int source_override(config_t *tree, const char *text);

/* Adds a key that the group leaves out. */
void source_add_default(config_setting_t *group, const char *name,
                        const char *value);

/* --- scan: the text of a case, looked at before libconfig reads it.
 *
 * libconfig ends the program where an included file is a folder, and waits for
 * ever where it is a pipe. It holds a whole number without a point in an int
 * and silently reads a larger one as another number: 70000000000 Pa of Young's
 * modulus would become 1280523264. */

/* Numbers of both kinds, [0, -9.81, 0], are a list for libconfig, and no array:
 * the brackets around them become round. */
void scan_mixed(char *text);

/* The first number that is too large in the text, outside strings and comments;
 * NULL if there is none. *line is its line, the first being 1. */
const char *scan_digits(const char *text, int *line);

/* The case file and what it includes, which lies in `folder` or, if that is
 * NULL, where the program runs; all are kept with the files that were read. 0,
 * or the exit code after one message. */
int scan_file(struct inputs **files, const char *file, const char *folder);

/* The value of an override, the text of one value: what is wrong with it, or
 * NULL. */
const char *scan_value(const char *value);

#endif
