/* run_part.h -- messages that a folder adds to a run. Its descriptor is named
 * in the models.txt of the folder, and each function may be NULL. */
#ifndef CASE_RUN_PART_H
#define CASE_RUN_PART_H

#include "coupling/simulation.h"

enum { RUN_PART_TEXT = 512 };

struct run_part {
    /* After a step; *told is 0 until the message has been printed. */
    void (*after_step)(const struct simulation *sim, int *told);
    /* Why the computation broke down: where, when, what, and a remedy, in one
     * paragraph; 0: it does not know. */
    int (*broke_down)(const struct simulation *sim, char text[RUN_PART_TEXT]);
    void (*after_run)(const struct simulation *sim);
};

/* All of them, ended by NULL. */
extern const struct run_part *const run_parts[];

#endif
