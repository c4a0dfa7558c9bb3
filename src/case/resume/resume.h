/* resume.h -- where the state of a run is kept.  Chapter "Nothing is lost". */
#ifndef CASE_RESUME_RESUME_H
#define CASE_RESUME_RESUME_H

/* In the folder of the run: the last state that was saved, and the one before
 * it; and that of a run that has not begun yet, whose bed is settling. */
#define RESUME_FILE "checkpoint"
#define RESUME_FILE_BEFORE "checkpoint.before"
#define RESUME_FILE_AHEAD "checkpoint.ahead"

/* A text of the last: "yes" if it has a bed that settles, "no" if
 * the run has none to settle. */
#define RESUME_SETTLING "bed_settles"

#endif
