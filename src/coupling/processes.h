/* processes.h -- the hooks of a simulation that several processes compute.
 * Chapter "Past one machine".
 *
 * Each process has a part of the cells and the particles there as a simulation
 * of its own. The whole simulation, which only the first process has, is the
 * record: what is written, saved and loaded. Its pointer to these is NULL on
 * one machine.
 */
#ifndef COUPLING_PROCESSES_H
#define COUPLING_PROCESSES_H

#include "base/state.h"

struct simulation;
struct settings;

enum processes_extent {
    PROCESSES_FIELDS, /* what output is made of */
    PROCESSES_ALL     /* and what the next step depends on */
};

struct processes {
    /* The same as coupling_start and coupling_step. */
    int (*start)(struct processes *self);
    int (*step)(struct processes *self);
    /* Brings the record up to date. */
    void (*collect)(struct processes *self, enum processes_extent extent);
    /* Visits what only the processes have; after loading, hands the record out
     * to them. */
    void (*state)(struct processes *self, struct state *s);
    void (*free)(struct processes *self);
};

/* A way to compute in parts, which a program has or has not. */
struct processes_engine {
    const char *name;
    /* Whether it can compute the case; else 2, after a message. */
    int (*check)(const struct settings *s);
    /* NULL after a message, with the exit code. All is borrowed. */
    struct processes *(*create)(const struct settings *s,
                                struct simulation *whole, int *code);
};

/* All of them, ended by NULL: there is one, or none. */
extern const struct processes_engine *const processes_engines[];

#endif
