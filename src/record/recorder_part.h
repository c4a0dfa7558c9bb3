/* recorder_part.h -- a file of results that a folder adds to those of a run.
 *
 * Its descriptor stands in recorder_part.c. All but
 * create and free may be NULL; row, fields and finish return non-zero after a
 * message.
 */
#ifndef RECORD_RECORDER_PART_H
#define RECORD_RECORDER_PART_H

#include "base/state.h"
#include "record/history.h"
#include "case/settings.h"
#include "record/snapshot.h"
#include "coupling/simulation.h"
#include "output/folder.h"
#include "output/summary.h"

/* What a part can read; all is borrowed. Where several processes compute the
 * simulation, `sim` is the part of this process, and `drawn` and `whole` are
 * what pictures show of all processes; in one process they are the same. */
struct recorder_view {
    const struct settings *settings;
    const struct simulation *sim, *drawn;
    struct snapshot *snapshot;    /* of sim; a part may add fields to it */
    const struct snapshot *whole; /* of drawn */
    struct folder *folder;
};

struct recorder_part {
    const struct key *keys; /* its table; NULL: none */
    /* 0 if what the case says is possible; else 2 after a message. */
    int (*check)(const struct settings *s);
    /* What the functions below get, released by free. NULL if this simulation
     * has nothing of the kind, and, with *failed, after a message if the file
     * cannot be written. */
    void *(*create)(const struct recorder_view *v, int *failed);
    void (*free)(void *part);
    int (*row)(void *part);               /* with each row of history.csv */
    int (*last_row)(void *part);          /* with one that the end adds */
    int (*fields)(void *part, double t);  /* with the fields of time t [s] */
    int (*finish)(void *part);            /* at the end of the run */
    const struct history_column *columns; /* of history.csv; the last has no
                                             name */
    void (*summarize)(const void *part, struct summary *f);
    void (*print)(const void *part); /* on stdout, at the end */
    /* Visits what the rows to come depend on (state.h). */
    void (*state)(void *part, struct state *s);
};

/* All of them, ended by NULL. */
extern const struct recorder_part second_half_part, profiles_part, probes_part,
    effect_shares_part, contacts_part, forces_part, walls_part,
    particle_fields_part, grains_record, outlines_record, exit_record,
    surface_table_part, surface_fields_part, pictures_part;
extern const struct recorder_part bodies_record, case_statistics_output;
extern const struct recorder_part *const recorder_parts[];

/* Those that this simulation uses, ended by NULL. */
enum { RECORDER_PART_MAX = 32 };
struct recorder_part_list {
    const struct recorder_part *part[RECORDER_PART_MAX + 1];
    void *state[RECORDER_PART_MAX];
};
/* Non-zero after a message: a file cannot be written. */
int recorder_part_create(struct recorder_part_list *l,
                         const struct recorder_view *v);

#endif
