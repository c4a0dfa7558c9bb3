/* driven.h -- single particles that move as prescribed.  Chapter 14.
 *
 * While its motion is on, a particle goes where the motion carries it, as a
 * point of a rigid body that is there already; before and after it is free. The
 * others feel it as they feel a wall: in a contact it has no 1/m. Each step is
 * one of the motion, from where the particle is, so that the state of a run is
 * its particles and the time.
 */
#ifndef DRIVEN_H
#define DRIVEN_H

#include "particles/bodies.h"
#include "particles/motion.h"

struct driven {
    int id; /* of the particle */
    struct motion motion;
};

struct drive {
    const struct driven *list; /* borrowed */
    int n;
    int *index; /* [-] where each is now, or -1 */
    int *on;    /* [-] 1: it is driven in this step */
};

struct drive *driven_create(const struct driven *list, int n);
void driven_free(struct drive *d);

/* Notes where they are. */
void driven_index(struct drive *d, const struct particles *ps);

/* Sets the velocities of those among begin ... end - 1 for a step from t to
 * t + dt [s]; dt = 0 gives those of the time t. Of those whose motion has ended
 * it clears the loads, from begin on; NULL: there are none yet. */
void driven_steer(struct drive *d, struct bodies *b, const struct particles *ps,
                  int begin, int end, double (*load)[8], double t, double dt);

/* Rows that were fetched anew: those that are driven have no 1/m again; or,
 * to measure what there is, their own. */
void driven_weigh(const struct drive *d, struct bodies *b,
                  const struct particles *ps, int begin, int end);
void driven_release(const struct drive *d, struct bodies *b,
                    const struct particles *ps, int begin, int end);

#endif
