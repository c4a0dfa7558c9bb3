/* neighbours.h -- when the lists are made anew, and how.  Chapter 3.
 *
 * Particles that move at most v come closer by at most 2 v dt in a step
 * [LS 5.16]. The contacts were chosen with a margin; while the sum of 2 v dt
 * stays below it, no pair that is not among them can touch. Then they are
 * chosen again from the vicinity, which is complete for gaps up to the skin
 * less twice the largest distance anybody moved since it was made (measured,
 * not estimated). When that is too little, the particles are sorted and the
 * vicinity is made anew; the springs go with their pairs.
 *
 * The functions are called by every thread of a team together; each works on
 * its share of the strips.
 */
#ifndef NEIGHBOURS_H
#define NEIGHBOURS_H

#include "particles/barrier.h"
#include "particles/driven.h"
#include "particles/grid.h"
#include "particles/strip.h"
#include "particles/surfaces.h"

struct neighbours {
    struct particles *ps; /* borrowed */
    struct bodies *bodies;
    struct grid *grid;
    struct strip *strips;
    int count;                 /* [-] strips */
    struct surfaces *surfaces; /* besides the box; NULL without any */
    struct drive *drive;       /* particles with a motion of their own; NULL */
    struct barrier *barrier;
    int *rank;     /* [-] new place of each particle after a sort */
    double skin;   /* [m] set by the caller before neighbours_open */
    double range;  /* [m] gap that the vicinity must hold in any case, for
                      what acts without touching; 0 */
    double margin; /* [m] of the contacts */
    double spent;  /* [m] of it since they were chosen */
    int fresh;     /* [-] 1: link cells, no list outlives a step */
    int stale;     /* [-] 1: the particles were changed from outside */
    int recalled;  /* [-] 1: the kept springs are given, not taken */
    long rebuilds;
};

struct neighbours *neighbours_create(struct particles *ps,
                                     const struct domain *box);
void neighbours_free(struct neighbours *nb);

/* Contacts have a spring of rolling too. Before the first run. */
void neighbours_keep_rolling(struct neighbours *nb);

/* From now on the deepest overlap beyond this share of the mean diameter is
 * known with its place and its two; HUGE_VAL: none. */
void neighbours_watch(struct neighbours *nb, double overlap);

/* Strips first ... last - 1 are this thread's. */
struct neighbours_share {
    int first, last;
};
struct neighbours_share neighbours_share(const struct neighbours *nb);

/* The same for a step, whose work is not spread evenly. Between the two ways to
 * share all must meet. */
struct neighbours_share neighbours_work(const struct neighbours *nb);

/* Waits until every thread of the team is here. */
void neighbours_meet(const struct neighbours *nb);

/* The springs of all touching pairs, collected from the strips; or room for
 * `n` that the next run starts with. Borrowed. */
const struct kept *neighbours_keep(struct neighbours *nb, int *n);
struct kept *neighbours_recall(struct neighbours *nb, int n);

/* Before a team starts. */
void neighbours_open(struct neighbours *nb);

/* First and last in a team: from the particles to the bodies, and back. */
void neighbours_fetch(struct neighbours *nb);
void neighbours_park(struct neighbours *nb);

/* Largest speed that the last bodies_advance of any strip bounds [m/s]. */
double neighbours_speed(const struct neighbours *nb);

/* Chooses the contacts, with a margin of `wanted` [m] or what the skin allows,
 * from a vicinity that is made anew where needed. All meet in the end. Gives
 * the margin, or -1 if a particle is lost. */
double neighbours_refresh(struct neighbours *nb, double wanted);

/* Looks for lost particles in this thread's share. */
void neighbours_look(struct neighbours *nb);

#endif
