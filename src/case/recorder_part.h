/* recorder_part.h -- output that a folder adds to the recorder's own.
 *
 * Its descriptor is named in the models.txt of the folder; its keys are those
 * of a part of a case (case_part.h). It is on where its group is given.
 */
#ifndef CASE_RECORDER_PART_H
#define CASE_RECORDER_PART_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "output/folder.h"

struct recorder_part {
    const char *group; /* "output.statistics" */
    /* All borrowed; NULL after a message. */
    void *(*create)(const struct settings *s, const struct simulation *sim,
                    struct folder *folder);
    int (*add)(void *memory);    /* with each row; non-zero after a message */
    int (*finish)(void *memory); /* at the end; non-zero after a message */
    void (*free)(void *memory);
};

/* All descriptors, ended by NULL. */
extern const struct recorder_part *const recorder_parts[];

/* Those that are on; the others have no memory. */
enum { RECORDER_PART_MOST = 8 };
struct recorder_part_list {
    void *memory[RECORDER_PART_MOST];
};

/* Non-zero after a message. */
int recorder_part_create(struct recorder_part_list *l, const struct settings *s,
                         const struct simulation *sim, struct folder *folder);
int recorder_part_add(const struct recorder_part_list *l);
int recorder_part_finish(const struct recorder_part_list *l);
void recorder_part_free(struct recorder_part_list *l);

#endif
