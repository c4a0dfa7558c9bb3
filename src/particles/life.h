/* life.h -- particles that come and go.  Chapter 15.
 *
 * Between two steps of the loop the sources put particles in and the sinks take
 * them out. An id is given once: who has left is never mistaken for who came
 * later. The springs of those that stay, stay.
 */
#ifndef LIFE_H
#define LIFE_H

#include "particles/dem.h"
#include "particles/insertion.h"

/* Takes out whose centre is in a box; or who would touch a side of the domain
 * within the next step, and so leaves through it. */
struct life_sink {
    double lo[3], hi[3]; /* [m] */
    int side;            /* [-] -1: the box; else 2 k the lower, 2 k + 1 the
                            upper side of direction k */
};

/* What has come and gone so far. */
struct life_account {
    long came, went;        /* [-] */
    double mass_in;         /* [kg] */
    double mass_out;        /* [kg] */
    double momentum_in[3];  /* [N s] of those that came */
    double momentum_out[3]; /* [N s] of those that went */
    long waiting;           /* [-] that are due and find no room */
};

struct life {
    struct domain box;
    int n_sources, n_sinks;
    struct insertion *sources;
    struct life_sink *sinks;
    struct life_account account;
    int *gone; /* [-] 1 for each particle that goes now; grows with them */
    int room;  /* [-] entries of it */
};

/* Sources and sinks are all 0, for the caller to fill in. */
struct life *life_create(const struct domain *box, int n_sources, int n_sinks);
void life_free(struct life *l);

/* Between two steps of the loop: first life_mark, then life_remove if any were
 * marked, then life_insert.
 *
 * Marks in `gone` the particles that leave before a step of dt [s], and enters
 * them in the account. Returns how many there are. */
int life_mark(struct life *l, const struct particles *ps, double dt);

/* Takes the marked particles out. Those that stay keep their springs. */
void life_remove(struct life *l, struct dem *dem);

/* Adds the particles that are due at time t [s]. They stand behind the others,
 * from the index it returns on. */
int life_insert(struct life *l, struct particles *ps, struct dem *dem,
                double t);

/* What a resumed run must know, besides particles and springs. */
void life_save(const struct life *l, const struct particles *ps, FILE *f);
int life_load(struct life *l, struct particles *ps, FILE *f);

#endif
