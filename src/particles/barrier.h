/* barrier.h -- where the threads of a team wait for each other.
 *
 * OpenMP's own barrier spins for long when nobody comes: fast on a machine
 * that is ours alone, but on a busy one each wait can last until the scheduler
 * takes the processor away, and a step of the particles has two. This one
 * looks around for a fraction of a millisecond and sleeps then.
 */
#ifndef BARRIER_H
#define BARRIER_H

struct barrier;

struct barrier *barrier_create(void);
void barrier_free(struct barrier *b);

/* Returns when as many threads as `team` have called it. */
void barrier_wait(struct barrier *b, int team);

#endif
