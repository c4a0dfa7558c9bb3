/* run_part.h -- what a folder does with a run: messages on its progress and its
 * end, and whether its last step counts.
 *
 * Its descriptor is named in the models.txt of the folder, and each function
 * may be NULL.
 */
#ifndef CASE_RUN_PART_H
#define CASE_RUN_PART_H

#include "case/settings.h"
#include "coupling/simulation.h"

enum { RUN_PART_TEXT = 512, RUN_PARTS = 16 };

struct run_part {
    /* Before the first step: what after_step and after_run get. */
    void *(*create)(const struct settings *s, const struct simulation *sim);
    void (*after_step)(void *part, const struct simulation *sim);
    /* After the last step; releases the part. */
    void (*after_run)(void *part, const struct simulation *sim);
    /* 1 if the last step must not count, because a signal has ended it early.
     */
    int (*is_cut_short)(const struct simulation *sim);
    /* Why the computation broke down: where, when, what, and a remedy, in one
     * paragraph; 0: it does not know. */
    int (*broke_down)(const struct simulation *sim, char text[RUN_PART_TEXT]);
};

/* All of them, ended by NULL. */
extern const struct run_part *const run_parts[];

#endif
