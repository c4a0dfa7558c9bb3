/* recorder_part.h -- what a run writes besides the rows of its history: each
 * file of results, or a few that belong together, is a part.
 *
 * A part that has nothing to write in this run is not created. All but create
 * may be NULL; row, fields and finish return non-zero after a message.
 */
#ifndef RECORD_RECORDER_PART_H
#define RECORD_RECORDER_PART_H

#include "base/state.h"
#include "coupling/simulation.h"
#include "output/folder.h"
#include "output/means/means.h"
#include "output/output_options.h"
#include "output/summary.h"
#include "record/history.h"
#include "record/snapshot.h"

/* What a case says of what is recorded; all is borrowed. */
struct recording {
    const char *file, *title; /* of the case */
    const struct output_options *output;
    const int *seed; /* [-] of the bed; NULL: there is none */
    double filter;   /* [m] of the means around bodies; 0: none */
    int quiet;       /* [-] 1: stderr has no remarks */
    /* [-] steps of the loop: between two rows and two pictures, and all */
    long row_every, picture_every, steps;
};

/* What a part can read; all is borrowed. Where several processes compute the
 * simulation, `sim` is the part of this process, and `drawn` and `whole` are
 * what pictures show of all processes; in one process they are the same. */
struct recorder_view {
    const struct recording *of;
    const struct simulation *sim, *drawn;
    struct snapshot *snapshot;    /* of sim; a part may add fields to it */
    const struct snapshot *whole; /* of drawn */
    struct folder *folder;
};

struct recorder_part {
    /* What the functions below get, released by free, also with *failed, after
     * a message that a file cannot be written. NULL if this simulation has
     * nothing of the kind. */
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

/* All of them, ended by NULL (recorder.c). */
extern const struct recorder_part recorder_second_half, recorder_profiles,
    recorder_probes, recorder_effect_shares, recorder_contacts, recorder_forces,
    recorder_walls, recorder_particle_fields, recorder_clumps, recorder_bodies,
    recorder_bodies_among, recorder_outlines, recorder_bodies_left,
    recorder_statistics, recorder_surface_table, recorder_surfaces,
    recorder_pictures;
extern const struct recorder_part *const recorder_parts[];

/* The collection NAME.pvd of files of the format that the case asks for; NULL
 * after a message. */
struct series *recorder_series(const struct recorder_view *v, const char *name);

/* The means over the second half of a run, to `end` [s], which several
 * processes sum together (second_half.c). The simulation is borrowed. */
void *second_half_create(const struct simulation *sim, double end);
void second_half_free(void *second_half);
int second_half_add(void *second_half); /* a sample, if there is a fluid */

/* --- profiles: how what a case asks for is called in the files. */

/* Where the line of a profile is; `across` is -1 where the case does not say
 * it. */
struct profile_line profiles_line(const struct output_profile *p);

/* What the file of the i-th profile is called, without its ending: "eps_f" at
 * the height of 0.0164 m is "eps_f_y16.4mm", along y at x = 0.011 m it is
 * "eps_f_along_y_x11mm"; a later one of the same field and line has the
 * beginning of its average besides, "_from1s". */
enum { PROFILES_NAME = 64 };
void profiles_name(const struct output_options *o, int i,
                   char name[PROFILES_NAME]);

/* How the columns of one begin in forces.csv: its name, or its patches or
 * surfaces, of which the first letters are taken if there are many. */
void recorder_forces_name(const struct output_force *o,
                          char name[PROFILES_NAME]);

#endif
