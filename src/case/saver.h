/* saver.h -- the hook of a run by which its state is saved and resumed. Chapter
 * "Nothing is lost".
 */
#ifndef CASE_SAVER_H
#define CASE_SAVER_H

#include "case/recorder.h"
#include "case/run.h"
#include "dem/bed_settling.h"

struct saver {
    const char *name;
    /* Before the simulation is built; where the run is to be resumed, finds the
     * state. NULL after a message, with the exit code. All is borrowed. */
    void *(*create)(const struct settings *s, struct folder *folder,
                    const struct run_options *o, int *code);
    /* 1 if the state is that of a run that has begun. */
    int (*is_of_run)(const void *memory);
    /* While a bed settles (bed_settling.h). Returns the exit code if the run is
     * to end there. */
    int (*settle)(void *memory, struct bed_settling *b, enum bed_stage stage);
    /* Before the files of an earlier run are removed; non-zero after a message.
     */
    int (*before)(void *memory);
    /* Before the first step. Simulation and recorder are borrowed; of a run
     * that is resumed they are loaded. Non-zero after a message. */
    int (*begin)(void *memory, struct simulation *sim, struct recorder *r);
    /* After each step that was sampled; non-zero after a message. */
    int (*after_step)(void *memory);
    /* After the last step, which need not have been sampled and, if it broke
     * down or was cut short, is no state to save; non-zero after a message. */
    int (*end)(void *memory, int broke_down);
    void (*free)(void *memory);
};

/* All of them, ended by NULL: there is one, or none. */
extern const struct saver *const savers[];

#endif
