/* snapshot.h -- a copy of the last valid state.
 *
 * Copied at each row of the history. All files with fields and particles are
 * written from here: so when a step breaks down, what is on disk in the end is
 * the last state that was whole.
 */
#ifndef CASE_SNAPSHOT_H
#define CASE_SNAPSHOT_H

#include "coupling/simulation.h"

struct snapshot {
    double t; /* [s] */
    /* Fluid; NULL without one. */
    double *eps;   /* [-] */
    double *eps_s; /* [-] */
    double *u;     /* [m/s] 3 a cell */
    double *p;     /* [Pa] */
    double *u_s;   /* [m/s] mean velocity of the particles, 3 a cell; 0 where
                      there are none */
    /* Particles; n = 0 without any. */
    int n, capacity;
    double *x[3];  /* [m] */
    double *v[3];  /* [m/s] */
    double *w[3];  /* [rad/s] */
    double *d;     /* [m] */
    double *speed; /* [m/s] */
    int *id;
    int *material; /* [-] NULL where all are of one */
};

struct snapshot *snapshot_create(const struct simulation *sim);
void snapshot_free(struct snapshot *s);
/* All of it (state.h). */
void snapshot_state(struct snapshot *s, const struct mesh *mesh,
                    struct state *state);
void snapshot_take(struct snapshot *s, const struct simulation *sim);

#endif
