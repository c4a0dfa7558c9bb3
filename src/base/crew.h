/* crew.h -- how many threads pay.  Chapter 18.
 *
 * Two threads are faster than one if there is work enough to share and a
 * processor for each. Neither is known beforehand: a bed may be small, and
 * others may want the processors, too, now or in a minute. So a run begins with
 * one thread and tries: now and then it takes some steps with more or fewer,
 * and stays with them if they were faster. It may, because its bits do not
 * depend on how many there are.
 */
#ifndef CREW_H
#define CREW_H

struct crew {
    int most;      /* [-] threads that there are */
    int now;       /* [-] at work, if no others are tried */
    int tried;     /* [-] in the trial at hand; 0: none is */
    int up;        /* [-] 1: the last trial was with more */
    int target;    /* [-] the next one with more tries so many */
    int measuring; /* [-] 1: what a trial is to be held against */
    int left;      /* [-] steps of this trial or measurement */
    double begin;  /* [s] when the step at hand began */
    double spent;  /* [s] in this trial, measurement or rest */
    double known;  /* [s] that a trial's steps take with `now` */
    double rest;   /* [-] of the known time, between two trials */
};

/* One of them is at work first. */
void crew_init(struct crew *c, int most);

/* How many are to take the next step; the last one took so long [s]. */
int crew_next(struct crew *c, double seconds);

/* The same with OpenMP's threads: of all that it has, around each step, and
 * all again. */
void crew_gather(struct crew *c);
void crew_begin(struct crew *c);
void crew_end(struct crew *c);
void crew_dismiss(const struct crew *c);

#endif
