/* resume.h -- where the state of a run is kept.  Chapter "Nothing is lost". */
#ifndef CASE_RESUME_RESUME_H
#define CASE_RESUME_RESUME_H

/* In the folder of the run: the last state that was saved, and the one before
 * it. */
#define RESUME_FILE "checkpoint"
#define RESUME_FILE_BEFORE "checkpoint.before"

#endif
