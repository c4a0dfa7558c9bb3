/* case_copy.h -- the case in the folder of its run.  Chapter "Nothing is lost".
 *
 * DIR/case.cfg is the case with its overrides, and DIR/case/ holds the files
 * that it names: `winnow run DIR/case.cfg` repeats the run, wherever the folder
 * is taken.
 */
#ifndef CASE_RESUME_CASE_COPY_H
#define CASE_RESUME_CASE_COPY_H

#include "case/run.h"
#include "output/folder.h"

struct case_copy;

/* Reads what is to be copied, before the files of an earlier run, which may be
 * those, are removed. */
struct case_copy *case_copy_create(const struct settings *s,
                                   const struct run_options *o);
void case_copy_free(struct case_copy *c);

/* Writes it all; non-zero after a message. */
int case_copy_write(struct case_copy *c, struct folder *folder);

/* In the folder of a run that goes on: writes again what is not there, and the
 * case if it has changed, as by a later end. Non-zero after a message. */
int case_copy_restore(struct case_copy *c, const char *dir);

#endif
