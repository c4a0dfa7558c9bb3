/* barrier.h -- a barrier for the threads of a team.
 *
 * OpenMP's own barrier spins for a long time: this is fast on an idle machine,
 * but on a busy one each wait can last until the scheduler takes the processor
 * away, and a particle step has two barriers. This barrier spins for a fraction
 * of a millisecond and then sleeps.
 */
#ifndef DEM_FAST_BARRIER_H
#define DEM_FAST_BARRIER_H

struct barrier;

struct barrier *barrier_create(void);
void barrier_free(struct barrier *b);

/* Returns when as many threads as `team` have called it. */
void barrier_wait(struct barrier *b, int team);

#endif
