/* thread_tuner.h -- the number of threads that is fastest.
 * Chapter "Fast particles".
 *
 * Two threads are faster than one if there is enough work and a free processor
 * for each. Neither is known in advance: a bed may be small, and other programs
 * may use the processors. A run therefore begins with one thread; from time to
 * time it takes some steps with more or fewer threads and keeps that number if
 * it was faster. Results do not depend on the number of threads.
 */
#ifndef BASE_THREAD_TUNER_H
#define BASE_THREAD_TUNER_H

struct thread_tuner {
    int max_threads;      /* [-] threads available */
    int threads;          /* [-] in use between trials */
    int trial_threads;    /* [-] in the present trial; 0: no trial */
    int trial_was_larger; /* [-] 1: the last trial was with more */
    int target;           /* [-] threads of the next trial with more of them */
    int measuring;        /* [-] 1: measures the reference time for a trial */
    int steps_left;       /* [-] steps of this trial or measurement */
    double step_start;    /* [s] start of the present step */
    double elapsed;       /* [s] spent in this trial, measurement or interval */
    double reference_time; /* [s] reference: time of as many steps with `now`
                              threads */
    double trial_interval; /* [-] interval between trials, in reference times */
};

/* The first steps use one thread. */
void thread_tuner_init(struct thread_tuner *c, int most);

/* Number of threads for the next step; seconds: wall time of the last step. */
int thread_tuner_next(struct thread_tuner *c, double seconds);

/* The same for a loop of steps: before the first, around each, and after the
 * last one. */
struct thread_tuner *thread_tuner_create(void);
void thread_tuner_before_step(struct thread_tuner *c);
void thread_tuner_after_step(struct thread_tuner *c);
void thread_tuner_free(struct thread_tuner *c);

#endif
