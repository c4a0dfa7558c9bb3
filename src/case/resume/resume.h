/* resume.h -- where the state of a run is kept.  Chapter "Nothing is lost". */
#ifndef CASE_RESUME_RESUME_H
#define CASE_RESUME_RESUME_H

#include "record/recorder.h"
#include "case/run.h"
#include "dem/bed.h"

/* In the folder of the run: the last state that was saved, and the one before
 * it; and that of a run that has not begun yet, whose bed is settling. */
#define RESUME_FILE "checkpoint"
#define RESUME_FILE_BEFORE "checkpoint.before"
#define RESUME_FILE_AHEAD "checkpoint.ahead"

/* A text of the last: "yes" if it has a bed that settles, "no" if
 * the run has none to settle. */
#define RESUME_SETTLING "bed_settles"

/* A run whose state is saved. */
struct resume;

/* Where particles.step = "auto", a run that is resumed keeps the step that it
 * had, also to a later end, which may have suggested another one. */
void resume_keep_step(struct settings *s, const char *dir);

/* Before the simulation is built; where the run is to be resumed, finds the
 * state. NULL after a message, with the exit code. All is borrowed. */
struct resume *resume_create(const struct settings *s, struct folder *folder,
                             const struct run_options *o, int *code);
void resume_free(struct resume *r);

/* 1 if the state is that of a run that has begun. */
int resume_is_of_run(const struct resume *r);

/* While a bed settles (bed_settling.h). Returns the exit code if the run is to
 * end there. */
int resume_settle(struct resume *r, struct bed_settling *b,
                  enum bed_stage stage);

/* Before the files of an earlier run are removed; non-zero after a message. */
int resume_before(struct resume *r);

/* Before the first step. Simulation and recorder are borrowed; of a run that is
 * resumed they are loaded. Returns the exit code: 2 if the state is refused. */
int resume_begin(struct resume *r, struct simulation *sim,
                 struct recorder *recorder);

/* After each step that was sampled; non-zero after a message. */
int resume_after_step(struct resume *r);

/* After the last step, which need not have been sampled and, if it broke down,
 * is no state to save; non-zero after a message. */
int resume_end(struct resume *r, int broke_down);

#endif
