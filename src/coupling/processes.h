/* processes.h -- the hooks of a simulation that several processes compute.
 * Chapter "Past one machine".
 *
 * Each process has a part of the cells and the particles there as a simulation
 * of its own, and no process has the whole one. The first process runs the
 * program; before an operation that all processes do with their parts, it sends
 * an order to the others (join). A simulation in one process has NULL for
 * these.
 */
#ifndef COUPLING_PROCESSES_H
#define COUPLING_PROCESSES_H

#include "coupling/simulation.h"

struct settings;
struct snapshot;

/* The operations of all processes: coupling_start, coupling_step,
 * snapshot_take, and the numbers of a row of history.csv, for which only the
 * own cells of a part count until the row is done. */
enum processes_order {
    PROCESSES_START,
    PROCESSES_STEP,
    PROCESSES_SNAPSHOT,
    PROCESSES_ROW,
    PROCESSES_ROW_DONE
};

struct processes {
    double cells, particles; /* [-] of all parts */
    const double *V; /* [m^3] of this part's cells; 0 of those that are copies
                        of another's */
    /* What is drawn of the whole: its box, and its particles if these are
     * drawn. NULL: nothing is drawn. */
    const struct simulation *whole;
    /* Orders the other processes to begin the same operation. */
    void (*join)(struct processes *self, enum processes_order order);
    /* Over all parts: sums of n numbers, and the largest of a number. */
    void (*sum)(struct processes *self, int n, double *x);
    int (*largest)(struct processes *self, int x);
    /* Writes fields or particles to the path, a piece a process. Non-zero after
     * a message. */
    int (*write)(struct processes *self, const char *path,
                 const struct snapshot *s);
    /* Copies what is drawn to the first process. */
    void (*gather)(struct processes *self, const struct snapshot *part,
                   struct snapshot *whole);
    /* Visits all parts instead of the particles and the fields. */
    void (*state)(struct processes *self, struct state *s);
    void (*free)(struct processes *self);
};

/* An implementation of several processes, which a build has or has not. */
struct processes_engine {
    /* Whether it can compute the case; else 2, after a message. */
    int (*check)(const struct settings *s);
    /* Builds the part of the first process, before the first step, or to be
     * loaded from the folder. NULL after a message, with the exit code. */
    struct simulation *(*build)(const struct settings *s, const char *dir,
                                int resumes, int *code);
    const struct recorder_part *summary; /* what it adds to the summary */
};

/* That of this program; NULL: it computes on one machine (processes_none.c). */
extern const struct processes_engine *const processes_engine;

/* The same for any simulation: where sim->processes is NULL, join has no
 * effect, a sum is the number itself, and the cells and particles are those of
 * sim. */
void processes_join(const struct simulation *sim, enum processes_order order);
void processes_sum(const struct simulation *sim, int n, double *x);
double processes_total(const struct simulation *sim, double x);
int processes_largest(const struct simulation *sim, int x);
double processes_cells(const struct simulation *sim);
double processes_particles(const struct simulation *sim);

/* What a case says of several machines (distributed/processes_check.c). Whether
 * their engine can compute the case: 0, or 2 after a message; processes_check:
 * 0 also where the case does not ask for it. LAMMPS ends the whole program at a
 * word that it does not know, so a case is looked at before. */
struct case_scales;
extern const struct key processes_check_keys[];
int processes_check_all(const struct settings *s);
int processes_check(const struct settings *s);

/* Whether this program can compute the case; and what the export, which needs
 * only what LAMMPS does, cannot tell it: 0, or 2 after a message that names the
 * key. */
int processes_check_run(const struct settings *s);
int processes_check_export(const struct settings *s);

/* Prints its lines for `winnow check`. */
void processes_check_print(const struct settings *s,
                           const struct case_scales *k);

#endif
