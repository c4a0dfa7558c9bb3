/* engine.h -- what the first rank asks of all ranks.
 * Chapter "Past one machine".
 *
 * The first rank runs the program as on one machine, with its part as the
 * simulation. Where that starts, steps, is looked at, written or saved, it asks
 * all ranks to do so with their parts. The others wait for what they are asked.
 */
#ifndef DISTRIBUTED_RANKS_ENGINE_H
#define DISTRIBUTED_RANKS_ENGINE_H

#include "coupling/processes.h"
#include "distributed/ranks/pieces.h"
#include "record/recorder_part.h"

/* Serves until the first rank stops; returns its exit code. The words are those
 * of the command line. */
int engine_serve(int argc, char **argv);

/* Called by the first rank at its end. */
void engine_stop(int code);

/* What the first rank asks, besides coupling/processes.h. */
enum { BUILD = 16, WRITE, GATHER, COUNT, SAVE, LOAD, RELEASE, STOP };
enum { ENGINE_PATH = 4096 };

struct message {
    int order, detail;
    char path[ENGINE_PATH];
};

/* Of each rank. */
struct engine {
    struct processes
        hooks; /* the first member: a pointer to it is one to all */
    const struct settings *settings;
    struct part *part;
    struct simulation whole; /* of what is drawn, on the first rank */
    char dir[ENGINE_PATH];   /* there, and the folder */
    struct folder *folder;
    struct snapshot *last; /* elsewhere: the last one */
    void *rows;            /* and for the sums of a row */
};

/* Numbers of each rank, three one after the other: particles [-], own cells
 * [-], peak memory [byte]; and how many particles have changed the rank. On the
 * first rank a new list, elsewhere NULL. What the effects have summed up goes
 * to the first rank, too. */
double *engine_count(struct engine *e, long *moved);

/* The largest of the codes: all ranks go on, or none does. */
int engine_agree(int code);

/* Builds the part, of a run that goes on with the spheres of a file of LAMMPS,
 * else "". Returns the code, the same on all ranks. */
int engine_build_part(struct engine *e, const char *file);

/* Saves or loads the part, by the files of a slot in the folder. Returns a
 * checksum of the cells, or -1 after a message. */
long engine_visit_part(struct engine *e, const char *dir, int slot,
                       struct state *to, int loading);
void engine_slot_file(const char *dir, const char *what, int slot,
                      char path[ENGINE_PATH]);

#endif
