/* recorder_part.h -- a file of results that a folder adds to those of a run.
 *
 * Its descriptor is named in the models.txt of the folder. All but
 * create and free may be NULL.
 */
#ifndef CASE_RECORDER_PART_H
#define CASE_RECORDER_PART_H

#include "base/state.h"
#include "coupling/simulation.h"
#include "case/history.h"
#include "output/folder.h"
#include "output/summary.h"

struct recorder_part {
    /* What the functions below get, released by free. NULL if this simulation
     * has nothing of the kind, and, with *failed, after a message if the file
     * cannot be written. */
    void *(*create)(const struct simulation *sim, struct folder *folder,
                    int *failed);
    void (*free)(void *part);
    /* With each row of history.csv, and with the fields of time t [s]. Both
     * return non-zero after a message. */
    int (*row)(void *part);
    int (*fields)(void *part, double t);
    /* What it adds to history.csv, ended by a column without a name; to the
     * summary; and to what is printed at the end. */
    const struct history_column *columns;
    void (*summarize)(const void *part, struct summary *f);
    void (*print)(const void *part);
    /* Visits what the rows to come depend on (state.h). */
    void (*state)(void *part, struct state *s);
};

/* All of them, ended by NULL. */
extern const struct recorder_part *const recorder_parts[];

#endif
