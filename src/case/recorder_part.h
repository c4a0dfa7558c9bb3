/* recorder_part.h -- a file of results that a folder adds to those of a run.
 *
 * Its descriptor is named in the models.txt of the folder. keys, check, row,
 * fields and state may be NULL.
 */
#ifndef CASE_RECORDER_PART_H
#define CASE_RECORDER_PART_H

#include "base/state.h"
#include "case/settings.h"
#include "coupling/simulation.h"
#include "output/folder.h"

struct recorder_part {
    const struct key *keys; /* its table; NULL: none */
    /* 0 if what the case says is possible; else 2 after a message. */
    int (*check)(const struct settings *s);
    /* What the functions below get, released by free. NULL if this simulation
     * has nothing of the kind, and, with *failed, after a message if the file
     * cannot be written. */
    void *(*create)(const struct settings *s, const struct simulation *sim,
                    struct folder *folder, int *failed);
    void (*free)(void *part);
    /* With each row of history.csv, and with the fields of time t [s]. Both
     * return non-zero after a message. */
    int (*row)(void *part);
    int (*fields)(void *part, double t);
    /* Visits what the rows to come depend on (state.h). */
    void (*state)(void *part, struct state *s);
};

/* All of them, ended by NULL. */
extern const struct recorder_part *const recorder_parts[];

#endif
