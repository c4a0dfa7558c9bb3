/* resume.h -- where the state of a run is kept.  Chapter "Nothing is lost". */
#ifndef CASE_RESUME_RESUME_H
#define CASE_RESUME_RESUME_H

#include "case/run.h"
#include "case/settings.h"
#include "dem/bed.h"
#include "record/recorder.h"

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

/* --- bed cache: large beds that were settled once. */

/* The bed of this case, if it is kept, is settled anew. */
void bed_cache_forget(const struct settings *s);

/* The path of the file that keeps a bed for which the case names none; 0: no
 * file, as without a folder that can be written, which is no error. */
int bed_cache_file(const struct settings *s, char *path, size_t room);

/* The bed from a file, or made anew and kept there; NULL: it is not kept. `run`
 * was created for ps, which has no particles yet. Returns what bed_create does;
 * BED_REFUSED also if the file is of another bed, and BED_UNSAVED, after a
 * message, if it cannot be written. */
int bed_cache_create(const struct input *file, struct particles *ps,
                     struct dem *run, const struct bed_options *bed,
                     const struct dem_options *dem, struct bed_report *r);

/* --- case text: all that a case says, with its overrides. */

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
