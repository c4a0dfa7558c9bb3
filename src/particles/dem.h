/* dem.h -- the motion of the particles.  Chapter 2.
 *
 *   m dv/dt = sum F_c + F,   I domega/dt = sum T_c,   I = (2/5) m R^2
 *                                       [LS 4.1-4.3] [XS11 2.1, 2.2] [SX15 1]
 *
 * with the contact forces F_c and torques T_c of contact.h, to which the
 * attractions of attraction.h are added, and an outside force F (gravity, the
 * fluid) that is constant during a run. Velocity Verlet; the force is taken
 * with the velocity of half a step before, which keeps one evaluation a step
 * and second order for what does not damp.
 *
 * The same bits for any number of threads. Nothing is allocated in a run but
 * lists that grow until they fit.
 */
#ifndef DEM_H
#define DEM_H

#include "particles/dem_options.h"
#include "particles/particles.h"
#include "particles/surface.h"

struct dem_report {
    long steps;         /* [-] of this run, that were done */
    long rebuilds;      /* [-] of the neighbour list, in this run */
    int contacts;       /* [-] touching at the end, walls included */
    double max_overlap; /* [-] largest of the run, over the mean diameter
                           of the two */
    double max_speed;   /* [m/s] at the end */
    double translation; /* [J] kinetic energy at the end, (1/2) m v^2 */
    double rotation;    /* [J] and (1/2) I omega^2 */
    int lost;           /* [-] particles that left the box by more than
                           their radius or are nowhere */
    int lost_id;        /* [-] the first of them; -1: none */
    double lost_at[3];  /* [m] where it was found */
    int lost_through;   /* [-] the surface that it went through; -1: none */
};

struct dem;
struct energy;

/* ps is borrowed. NULL after a message if the options do not fit. */
struct dem *dem_create(struct particles *ps, const struct dem_options *o);
void dem_free(struct dem *dem);

/* Moves the particles by so many steps. Non-zero if one is lost: then the run
 * ended where this was seen; or if two were deeper in each other than
 * dem_limit_overlap allows. The particles may have changed places. */
int dem_run(struct dem *dem, int steps, struct dem_report *r);

/* The deepest overlap of all runs so far, if it is deeper than expected. */
struct dem_overlap {
    double depth;    /* [-] over the mean diameter of the two */
    int id, other;   /* [-] of whom; -1: no overlap was deeper than expected.
                        other: -1 - w for wall w = 2 k or 2 k + 1 of direction
                        k, -7 - f for surface f */
    double at[3];    /* [m] centre of the first */
    double expected; /* [-] as it was given */
    double most;     /* [-] likewise */
};

/* Looks out for overlaps deeper than `expected`; those deeper than `most` make
 * a run fail. Both are shares of the mean diameter of the two [-]. */
void dem_limit_overlap(struct dem *dem, double expected, double most);
struct dem_overlap dem_deepest(const struct dem *dem);

/* Keeps the budget of energy.h from now on. dem_energy: as the last run left
 * it; NULL if none is kept. */
void dem_keep_energy(struct dem *dem);
const struct energy *dem_energy(const struct dem *dem);

/* To be called when particles were moved or added from outside. Springs stay
 * with their pairs as long as the indices do. */
void dem_changed(struct dem *dem);

/* Starts the clock of all that moves as prescribed at this number of steps;
 * before that they rest where they are at time 0. */
void dem_clock(struct dem *dem, long steps);

/* What the particles did to surface k since the run began (steps of which no
 * time passed do not count). */
struct dem_surface {
    double impulse[3]; /* [N s] force over time */
    double angular[3]; /* [N m s] torque about the centre of its motion */
    double work;       /* [J] that it did on the particles */
    struct pose pose;  /* where it is */
};
struct dem_surface dem_surface(const struct dem *dem, int k);

/* Takes out the particles i with gone[i] between two runs. Who stays keeps its
 * springs. */
void dem_remove(struct dem *dem, const int *gone);

/* The tangential springs of all touching pairs: what a state consists of
 * besides the particles. `other` is an id too, or -1 - w for wall w; w = 2 k is
 * the lower and 2 k + 1 the upper wall of direction k, 6 any
 * surface. */
struct dem_spring {
    int id, other;
    double xi[3];   /* [m] of id against other */
    double roll[3]; /* [rad] theta likewise; 0 without rolling friction */
    double n[3];    /* [-] of the contact with a surface, to know it again */
};

/* A new list of them, released with free(). */
struct dem_spring *dem_springs(struct dem *dem, int *n);

/* Starts the next run with these springs and no others; those of particles that
 * are not there are left out. */
void dem_recall(struct dem *dem, const struct dem_spring *list, int n);

/* Another restitution or friction of material 0 from now on; the springs stay
 * as they are. */
void dem_change_material(struct dem *dem, const struct material *m);

#endif
