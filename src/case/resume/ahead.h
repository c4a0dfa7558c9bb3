/* ahead.h -- the state of a run that has not begun: of its bed, which settles.
 * Chapter "Nothing is lost".
 *
 * DIR/checkpoint.ahead is written while the bed settles, and before the files
 * of an earlier run are removed; it is removed when the run has its first
 * checkpoint. So there is a whole state at any moment.
 */
#ifndef CASE_RESUME_AHEAD_H
#define CASE_RESUME_AHEAD_H

#include "case/run.h"
#include "dem/bed_settling.h"
#include "output/folder.h"

struct ahead;

/* All is borrowed; lines: of the case (case_text.h). */
struct ahead *ahead_create(const struct settings *s, struct folder *folder,
                           const struct run_options *o, const char *lines);

/* Where the run was refused before it began nothing is left. */
void ahead_free(struct ahead *a);

/* Opens the file that is there. 0 if there is none that is whole, after a
 * message if it is damaged. */
int ahead_find(struct ahead *a);

/* Whether what was found is of another case: non-zero, after a message if
 * `tell` is not 0. */
int ahead_is_other(struct ahead *a, int tell);

/* Saves the bed, or loads it when it begins to settle, as resume_settle says.
 */
int ahead_settle(struct ahead *a, struct bed_settling *b, enum bed_stage when);

/* Writes the file, if it is not there, for a run that will remove the
 * checkpoint of another. Non-zero after a message. */
int ahead_replaces(struct ahead *a, const char *checkpoint);

/* The run has its first checkpoint: removes the file. */
void ahead_is_over(struct ahead *a);

#endif
