/* surfaces.h -- all surfaces of a run, for the loop over its steps. Chapter 14.
 *
 * One surface_contacts a strip, so that each thread has its own and the sums
 * have the same bits for any number of threads. Functions with a strip number s
 * are called by the thread that works on this strip.
 */
#ifndef SURFACES_H
#define SURFACES_H

#include "particles/surface_contacts.h"

struct surfaces {
    struct surface_scene scene;
    struct surface_contacts *strip;
    int count;    /* [-] strips */
    double speed; /* [m/s] no point of a surface in the box is faster */
    int *where;   /* [-] index of each id after a sort, or -1 */
    int ids;      /* [-] that there is room for in `where` */
};

/* The list and the box are borrowed. */
struct surfaces *surfaces_create(const struct surface *list, int n,
                                 const struct domain *box, int count);
void surfaces_free(struct surfaces *sf);

/* Puts them where they are at time t [s]. */
void surfaces_move(struct surfaces *sf, int s, double t);

/* How far any of them may have moved since surfaces_find [m]. */
double surfaces_moved(const struct surfaces *sf, int s);

/* When the lists are made anew: the springs go from the footprints to `kept`
 * under the ids of their particles; one thread notes who is where now; then
 * faces are found, and the springs return. */
void surfaces_keep(struct surfaces *sf, int s, const struct particles *ps);
void surfaces_index(struct surfaces *sf, const struct particles *ps);
void surfaces_find(struct surfaces *sf, int s, const struct strip *strip,
                   const struct bodies *b, double skin);

void surfaces_choose(struct surfaces *sf, int s, const struct bodies *b,
                     double margin);
void surfaces_push(struct surfaces *sf, int s, struct strip *strip,
                   const struct bodies *b, contact_sweep *sweep,
                   const struct contact_constants *k, double dt);

/* Adds to the survey who is in the solid of a plane or cylinder by more than
 * its radius and, if there are `marks`, whose way since then leads through a
 * triangle. */
void surfaces_look(const struct surfaces *sf, int s, const struct strip *strip,
                   const struct bodies *b, int marks, double skin,
                   struct bodies_survey *found);

/* The footprints of strip s, of the particles ps, or as kept if that is NULL;
 * none from now on; and one that the next run starts with. */
const struct footprints *surfaces_springs(struct surfaces *sf, int s,
                                          const struct particles *ps);
void surfaces_forget(struct surfaces *sf);
void surfaces_recall(struct surfaces *sf, const struct footprint *one);

/* Before a run, and after it: contacts that touch [-], and the largest overlap
 * of the run over the diameter [-]. */
void surfaces_open(struct surfaces *sf);
int surfaces_contacts(const struct surfaces *sf);
double surfaces_deepest(const struct surfaces *sf);

/* The energy budget of the contacts with them, strip by strip. */
struct strip_energy *surfaces_energy(struct surfaces *sf, int s);
double surfaces_work(const struct surfaces *sf); /* [J] on the particles */

/* What a surface received, over all strips; where its centre is. */
struct surface_account surfaces_account(const struct surfaces *sf, int surface);

#endif
