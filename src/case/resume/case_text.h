/* case_text.h -- a case as text: all that it says, with its overrides. Chapter
 * "Nothing is lost".
 */
#ifndef CASE_RESUME_CASE_TEXT_H
#define CASE_RESUME_CASE_TEXT_H

#include <stdio.h>

#include "case/settings.h"

/* Calls each(of, file) for a file that a key names: for the folder of a mesh
 * for each of its files, packed or not, in a fixed order. */
void case_text_each_file(const struct settings *s, const struct key *row,
                         const char *name,
                         void (*each)(void *of, const struct input *file),
                         void *of);

/* One line for each value, "fluid.density = 1.2", defaults too; a file that the
 * case names stands for its contents, by their checksum; and the step of the
 * loop, which may follow from what is written. A new string. */
#define CASE_TEXT_STEP "step_of_the_loop"
char *case_text_lines(const struct settings *s);

/* 1 if the key of such a line, or a group that it is in, has the mark. */
int case_text_is(const char *line, enum key_mark mark);

/* Whether two such texts are of the same case, but for what may change when a
 * run is resumed. Non-zero after a message that names the first other key with
 * both values; without one if path, of the first, is NULL. */
int case_text_differs(const char *was, const char *is, const char *path);

/* The value of a key in such a text, as a new string; NULL if it is not there.
 */
char *case_text_value(const char *lines, const char *key);

/* The case as a file that `winnow run` reads: no defaults, and files by the
 * names that `file_name` gives them (a new string each). */
void case_text_write(const struct settings *s, FILE *out,
                     char *(*file_name)(void *of, const struct key *row,
                                        const char *name),
                     void *of);

#endif
