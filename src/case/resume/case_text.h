/* case_text.h -- a case as text: all that it says, with its overrides. Chapter
 * "Nothing is lost".
 */
#ifndef CASE_RESUME_CASE_TEXT_H
#define CASE_RESUME_CASE_TEXT_H

#include <stdio.h>

#include "case/run.h"
#include "case/settings.h"
#include "output/folder.h"

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

/* DIR/case.cfg is the case with its overrides, and DIR/case/ holds the files
 * that it names: `winnow run DIR/case.cfg` repeats the run, wherever the folder
 * is taken. */
struct case_copy;

/* Reads what is to be copied, before the files of an earlier run, which may be
 * those, are removed. */
struct case_copy *case_text_copy(const struct settings *s,
                                 const struct run_options *o);
void case_text_free_copy(struct case_copy *c);

/* Writes it all; non-zero after a message. */
int case_text_write_copy(struct case_copy *c, struct folder *folder);

/* In the folder of a run that goes on: writes again what is not there, and the
 * case if it has changed, as by a later end. Non-zero after a message. */
int case_text_restore_copy(struct case_copy *c, const char *dir);

#endif
