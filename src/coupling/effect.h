/* effect.h -- optional effects of a case.
 * Chapter "The coupled loop".
 *
 * An effect is one descriptor. An effect that a case does not
 * name allocates nothing, and the time loop, which goes through the list of
 * created effects, does not call it. Its keys are one table, whose first row is
 * its own name; its parameters are given as numbers in the order of the rows (a
 * vector gives three, a group none), already checked. Its hooks report the
 * force on each particle; their time is measured in effects_call.
 */
#ifndef COUPLING_EFFECT_H
#define COUPLING_EFFECT_H

#include "base/model.h"
#include "base/state.h"

struct simulation;
struct effect_columns;
struct effect_mover;
struct effect_scales;
struct effect_estimate;
struct effect_count;
struct attraction;
struct added_mass;
struct attraction_scene;

/* A field of the cells that an effect has written with those of the fluid. */
struct effect_field {
    const char *name;
    int components;
    const double *values; /* borrowed */
};
enum { EFFECT_FIELDS = 4 }; /* of one effect, at most */

/* What an effect costs while it is on, as tests/bench/effects.sh measures it:
 * time of one core, within a factor of two. */
struct effect_cost {
    double particle, cell; /* [ns] each of these and step of the loop */
    double particle_step;  /* [ns] each and step of the particles */
};

enum { EFFECT_TRIAL = 160 };

struct effect {
    MODEL_MEMBERS; /* base/model.h */
    /* Any of these may be NULL. create makes its memory. */
    void *(*create)(struct simulation *sim, const double *parameters);
    void (*before_particles)(void *memory, struct simulation *sim);
    /* For forces that follow the slip: adds to the external force of
     * particles.h for the sub-step of the drag that follows. */
    void (*before_substep)(void *memory, struct simulation *sim);
    void (*after_particles)(void *memory, struct simulation *sim);
    const struct effect_mover *mover; /* of what else moves */
    /* How the computation broke down in this step; NULL: it did not. */
    const char *(*failure)(const void *memory);
    void (*after_step)(void *memory, struct simulation *sim);
    int (*fields)(const void *memory, struct effect_field *f); /* how many */
    /* Visits its memory, but for arrays that are attached to the particles. */
    void (*state)(void *memory, struct state *s);
    const struct effect_columns *columns; /* of history.csv */
    void (*free)(void *memory);           /* NULL: owner_free (base/alloc.h) */
    /* Changes the drag coefficients k[i] [kg/s] before their use. */
    void (*drag)(void *memory, struct simulation *sim, double *k);
    int (*counts)(const void *memory, struct effect_count *c); /* how many */
    /* A force between particles and walls that are close (attraction.h). */
    struct attraction (*attraction)(const double *parameters,
                                    const struct attraction_scene *scene);
    /* What is wrong with its parameters, in words; NULL: nothing is. */
    const char *(*wrong)(const double *parameters,
                         const struct attraction_scene *scene);
    /* Estimates its force in a case before the run. */
    struct effect_estimate (*estimate)(const struct effect_scales *k);
    /* Adds the mass that it lets accelerate with a particle. */
    void (*added_mass)(const struct effect_scales *k, struct added_mass *sum);
    /* What the group of a case that does not name it would be for a try, where
     * it has keys without a default. */
    void (*trial)(const struct effect_scales *k, char text[EFFECT_TRIAL]);
    struct effect_cost cost;
};

/* An effect that a case names, while the case runs. */

struct effect;

/* The forces that an effect has exerted. */
struct effect_tally {
    double sum;     /* [N] of their sizes, over particles and steps */
    double largest; /* [N] on one particle */
    double weight;  /* [-] number of these */
    double seconds; /* [s] wall-clock time in its hooks */
};

/* An active effect: its descriptor and its state. */
struct effect_state {
    const struct effect *effect;
    void *memory; /* released by effects_free */
    struct effect_tally tally;
};

/* The number of events that an effect has counted. */

struct effect_count {
    const char *name; /* as in summary.json */
    long value;       /* [-] in the run so far */
};
enum { EFFECT_COUNTS = 4 }; /* of one effect, at most */

/* Columns of history.csv that an effect adds. */

struct effect_columns {
    const char *const *names; /* with units, "mixing [-]"; ended by NULL */
    /* Their values now; returns how many. */
    int (*row)(void *memory, const struct simulation *sim, double *values);
};

/* What an effect moves that is neither fluid nor particle. */

struct effect_mover {
    /* Moves it by a step, after fluid and particles; non-zero if the
     * computation broke down. NULL: it has moved with the particles. */
    int (*move)(void *memory, struct simulation *sim);
    /* Moves the particles by so many steps, and itself with them, in place of
     * dem_run. Non-zero as dem_run. NULL: it does not move with the particles.
     */
    int (*move_particles)(void *memory, struct simulation *sim, int steps);
    /* Adds its momentum [N s] to the sum that is conserved in a closed box. */
    void (*momentum)(const void *memory, double total[3]);
};

/* --- effect scales -------------------------------------------------------- */

/* The scales of a case, from which each effect estimates its force before the
 * run.  Chapter "Further forces".
 *
 * A scale that the case does not have is 0. */

struct effect_scales {
    double rho_f, mu;     /* [kg/m^3], [Pa s] */
    double dt;            /* [s] step of the fluid */
    double rho_s, d;      /* [kg/m^3], [m] of the mean particle, a grain */
    double across;        /* [-] diameter of a parcel of them over theirs */
    double gravity;       /* [m/s^2] */
    double mean_gradient; /* [Pa/m] that drives the fluid through a period */
    double eps_s;         /* [-] solids fraction where the particles are */
    double passed;        /* [-] of what a stream passes: less, over a bed */
    int partners;         /* [-] 1: there are others that a particle can meet */
    int carried;     /* [-] 1: the particles move with the stream, or fall */
    int held;        /* [-] 1: the fluid cannot go along with the drag on it */
    int decays;      /* [-] 1: nothing drives the slip, so that it dies out */
    int turns;       /* [-] 1: the slip rises and falls, in `time` each */
    int rests;       /* [-] 1: they lie on each other, at the end at least */
    int stirred;     /* [-] 1: the spin is what collisions leave */
    double jet;      /* [-] the part of them in a jet, which turns all alike */
    double slip;     /* [m/s] of a particle in the stream */
    double length;   /* [m] over which the velocity changes by that */
    double shear;    /* [1/s] of the stream */
    double spin;     /* [rad/s] of a particle against the fluid */
    double rolls;    /* [-] mean of slip times spin over that of these */
    double tau;      /* [s] relaxation time */
    double meetings; /* [1/s] of a particle with others */
    double acceleration; /* [m/s^2] of the slip, in the mean */
    double fluctuation;  /* [m/s^2] of the slip besides, in a crowd */
    double slows;        /* [m/s^2] of the fluid of a jet, in the mean of all */
    double changes;      /* [m/s^2] of the stream that comes in, in the mean */
    double time;         /* [s] that the slip has had to develop, or takes to
                            die out */
    double end;          /* [s] of the run */
    double weight, drag; /* [N] */
    double force;        /* [N] the largest one of the two, and of the push of
                            mean_gradient */
    double net;          /* [N] what buoyancy leaves of it */
    const struct attraction *pair; /* of the effect, if it is named */
    const double *numbers;         /* its parameters, if it is named */
};

/* What an effect would do, as a share of `of`; and whether that is known before
 * a run, from the range of the data behind it. */
struct effect_estimate {
    double share;     /* [-] its size, in the mean or at most */
    double loss;      /* [-] of this the part that is missed without it: less
                         where its direction is random */
    const char *of;   /* "the force on a grain" */
    int unknown;      /* [-] 1: only what the remark says would tell */
    int bound;        /* [-] 1: share is no scale, it is at most that */
    char remark[112]; /* "" if there is nothing to add */
};

/* The mass that accelerates with a particle, over the mass of the fluid that it
 * displaces. */
struct added_mass {
    double C;         /* [-] for a change of the slip in this step */
    double C_history; /* [-] for one in the step before, as a force */
};

#endif
