/* fast.h -- the fast method: neighbour lists, chunks and vector loops.
 * The chapters Neighbours and Fast particles explain it.
 */
#ifndef DEM_FAST_FAST_H
#define DEM_FAST_FAST_H

#include "dem/dem_method.h"
#include "dem/fast/neighbours.h"

/* The state at the beginning of a step of Heun's method. */
struct heun {
    struct row_place *place;
    struct row_motion *motion;
    struct row_load *load;
    struct row_load (*part)[ENERGY_PARTS]; /* NULL without a budget */
};

/* What the length of a step that adapts follows from (heun.c). */
struct adaptive {
    double fall, pull; /* [m/s], [m/s^2] the largest speed of a fall by a
                          diameter, and external acceleration */
    double *changed;   /* [m/s] |a* - a| dt/2, the largest of each chunk */
    double *closes;    /* [s] when the first gap closes, of each chunk */
    double next;       /* [s] the length of the next step */
};

/* The contacts are chosen with a margin of at least d / MARGIN_PARTS. */
enum { MARGIN_PARTS = 600 };

struct fast {
    struct neighbours *neighbours;
    double min_margin; /* [m] */
    long steps_done;   /* [-] steps of the run at hand */
    struct dem_crossing crossing;
    int interrupted;          /* [-] 1: by a signal */
    struct heun heun;         /* empty with another integrator */
    struct adaptive adaptive; /* likewise */
    long parts;               /* [-] that the steps of the run were split in */
};

/* The state of a dem with this method. */
static inline struct fast *fast_of(const struct dem *dem)
{
    return dem->state;
}

/* So many steps, by one thread of the team. */
void fast_move(struct dem *dem, int steps);

/* --- steps (fast_move.c, heun.c) ------------------------------------------ *
 * All functions here are called by every thread of the team. Each thread has
 * its own copy of the margin [m] by which gaps may decrease before the contacts
 * are chosen again, and of the part of it that is used. */
struct contact_margin {
    double margin, used;
    double next; /* [s] length of the next step, of one that adapts */
    int cut;     /* [-] 1: where a gap closes */
    long parts;  /* [-] steps so far */
    int looked;  /* [-] 1: the last step has found what is left */
};

/* The time after k steps of this run, for the prescribed motions. */
double fast_move_time(const struct dem *dem, int k);

/* Those of a step: the tangential displacements advance by dt; the length of
 * the kick and of the drift [s]. */
struct step_parameters fast_move_parameters(const struct dem *dem, double dt,
                                            double kick, double drift);

/* Computes the loads alone; the tangential displacements advance by dt.
 * Prescribed velocities are not set. */
void fast_move_loads(const struct dem *dem, double dt);

/* Gives surfaces under load their velocity from t [s] on; puts all surfaces
 * where they are at t; and makes the prescribed particles ready for a drift of
 * dt from there [s]. */
void fast_move_follow_loads(const struct dem *dem, double t);
void fast_move_surfaces(const struct neighbours *nb, double t);
void fast_move_prescribed(const struct neighbours *nb, double t, double dt);

/* Chooses the contacts for steps in which gaps close by `closer` [m] each,
 * unless the margins are not used up, or will not be by the next step of an
 * integrator that predicts. */
void fast_move_choose(struct dem *dem, struct contact_margin *r, double closer);

/* 1 if two have crossed in the last drift, in which a gap became smaller by
 * `closer` [m] at most: where that is less than the smallest diameter, no two
 * can have. 1 if a signal ends the run after step k: one thread looks for all.
 */
int fast_move_crossed(const struct dem *dem, double closer);
int fast_move_interrupted(const struct dem *dem, int k);

/* Heun's method; the number of steps done. */
int heun_steps(struct dem *dem, int steps, struct contact_margin *r);

/* All that the next run depends on (dem_method.h). */
void fast_state(struct dem *dem, struct state *s);

/* The contact histories as a list, and back (dem_method.h). */
struct dem_history *fast_histories(struct dem *dem, int *n);
void fast_restore_histories(struct dem *dem, const struct dem_history *list,
                            int n, const int *index);

#endif
