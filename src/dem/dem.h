/* dem.h -- the motion of the particles.
 * Chapter "Particles and contact".
 *
 *   m dv/dt = sum F_c + F,   I domega/dt = sum T_c,   I = (2/5) m R^2
 *                                       [LS 4.1-4.3] [XS11 2.1, 2.2] [SX15 1]
 *
 * with the contact forces F_c and torques T_c of contact.h, to which the
 * attractions of attraction.h are added, and an external force F (gravity, the
 * fluid) that is constant during a run. The integrator is velocity Verlet
 * unless the options name another (integrator.h); the force is evaluated with
 * the velocity half a step earlier, which needs one evaluation a step and is of
 * second order for forces without damping.
 *
 * How the pairs are found, and by which loop the forces are computed, is the
 * method of the options (dem_method.h). The result has the same bits for any
 * number of threads.
 */
#ifndef DEM_DEM_H
#define DEM_DEM_H

#include "base/state.h"
#include "dem/attraction.h"
#include "dem/box_domain.h"
#include "dem/integrator.h"
#include "dem/materials.h"
#include "dem/particles.h"

/* --- crossing: two spheres that are past each other before they have met.
 * Chapter "Time steps".
 *
 * A contact is found at the places after a step. Where a sphere moves by more
 * than its radius in one, it can be beyond another one by then, and no force
 * ever says so: the pair has crossed. */

struct dem_crossing {
    int found; /* [-] 1: two have crossed */
    int id[2]; /* [-] these */
};

/* 1 if two whose centres are at x_i, x_j now [m], and moved with v_i, v_j [m/s]
 * in the step of dt [s], passed each other within `reach` [m]: the line of
 * centres has turned round, and was shorter than that in between. */
static inline int crossing(const struct box_domain *box, const double x_i[3],
                           const double x_j[3], const double v_i[3],
                           const double v_j[3], double dt, double reach)
{
    double old2 = 0.0, along = 0.0, way2 = 0.0, turned = 0.0;

    for (int k = 0; k < 3; k++) {
        const double x = box_domain_nearest(box, k, x_i[k] - x_j[k]);
        const double way = dt * (v_i[k] - v_j[k]), old = x - way;
        old2 += old * old;
        along += old * way;
        way2 += way * way;
        turned += old * x;
    }
    return turned < 0.0 && old2 - along * along / way2 < reach * reach;
}

/* --- dem: the options. One that a case does not set is 0 here and has no
 * effect. */

struct dem_method;
struct surface;
struct prescribed_particle;

struct dem_options {
    char where[256]; /* in the case, before messages; or empty */
    const struct contact_law *law;
    struct material material;          /* number 0 */
    const struct materials *materials; /* with others; NULL: there is no other.
                                          Borrowed for as long as the dem is */
    const struct integrator *integrator; /* NULL: velocity Verlet */
    const struct dem_method *method;     /* NULL: the first of dem_methods */
    double step;                         /* [s] */
    double shortest_step, step_error;    /* [s], [-] of one that adapts */
    double skin;                         /* [m] of the neighbour list; 0: d/3 */
    double lo[3], hi[3];                 /* [m] walls of the box */
    int periodic[3]; /* [-] 1: no walls, hi and lo coincide; the box must be at
                        least 2 (d + skin + range) long there */
    const struct surface *surfaces; /* walls besides the box; borrowed */
    int n_surfaces;
    unsigned long surfaces_checksum; /* [-] of their shapes and materials: a
                                        settled bed in a file is for these */
    const struct attraction *attractions; /* borrowed likewise */
    int n_attractions; /* [-] 0: forces act at contact only */
    const struct prescribed_particle
        *prescribed; /* particles that move as prescribed; borrowed */
    int n_prescribed;
};

struct dem_report {
    long steps;         /* [-] of this run, that were done */
    long parts;         /* [-] that these were split in, if the step adapts */
    long rebuilds;      /* [-] of the neighbour list, in this run */
    int contacts;       /* [-] touching at the end, walls included */
    double max_overlap; /* [-] largest of the run, over the mean diameter
                           of the two */
    double max_speed;   /* [m/s] at the end */
    double translation; /* [J] kinetic energy at the end, (1/2) m v^2 */
    double rotation;    /* [J] and (1/2) I omega^2 */
    int lost;    /* [-] particles that left the box by more than their radius or
                    whose position is not finite */
    int lost_id; /* [-] the first of them; -1: none */
    double lost_at[3]; /* [m] where it was found */
    int lost_through;  /* [-] the surface that it passed through; -1: none */
    struct dem_crossing crossing; /* the run ends there */
};

struct dem;
struct energy;

/* 1, after a message, if a periodic direction is too short for spheres of up to
 * `widest` [m] that have this mean diameter; else 0. */
int dem_period_wrong(const struct dem_options *o, double widest, double mean);

/* ps is borrowed. NULL after a message if the options do not fit. */
struct dem *dem_create(struct particles *ps, const struct dem_options *o);
void dem_free(struct dem *dem);

/* The options that it was created with, with the integrator filled in. */
const struct dem_options *dem_created_with(const struct dem *dem);

/* Moves the particles by this number of steps. Non-zero if one is lost (the run
 * ends when this is found), if two have crossed, if a signal ended it early
 * (base/interrupt.h, once dem_clock was called) or if an overlap was deeper
 * than dem_limit_overlap allows. The order of the particles may have changed.
 */
int dem_run(struct dem *dem, int steps, struct dem_report *r);

/* The deepest overlap of all runs so far, if it is deeper than expected. */
struct dem_overlap {
    double depth;  /* [-] over the mean diameter of the two */
    int id, other; /* [-] the two ids; -1: no overlap was deeper than expected.
                      other: -1 - w for wall w = 2 k or 2 k + 1 of direction k,
                      -7 - f for surface f */
    double at[3];  /* [m] centre of the first */
    double expected; /* [-] limit of dem_limit_overlap */
    double most;     /* [-] the other limit */
};

/* Records overlaps deeper than `expected`; those deeper than `most` make a run
 * fail. Both are over the mean diameter of the two [-]. */
void dem_limit_overlap(struct dem *dem, double expected, double most);
struct dem_overlap dem_deepest(const struct dem *dem);

/* Computes the budget of energy.h from now on. dem_energy: the budget after the
 * last run; NULL if there is none. */
void dem_start_energy_budget(struct dem *dem);
const struct energy *dem_energy(const struct dem *dem);

/* The caller calls this after moving or adding particles. Tangential
 * displacements stay with their pairs as long as the indices are unchanged. */
void dem_changed(struct dem *dem);

/* Starts the prescribed motions at this number of steps; without this call
 * surfaces and prescribed particles rest at their positions of time 0. */
void dem_clock(struct dem *dem, long steps);

/* Removes the particles i with removed[i] between two runs. The others keep
 * their contact histories. */
void dem_remove(struct dem *dem, const int *removed);

/* The contact histories of all touching pairs, tangential displacements and
 * rolling angles: together with the particles they are the whole state. `other`
 * is an id too, or -1 - w for wall w; w = 2 k is the lower and 2 k + 1 the
 * upper wall of direction k, 6 any surface. */
struct dem_history {
    int id, other;
    double xi[3];         /* [m] of id against other */
    double roll_angle[3]; /* [rad] theta likewise; 0 without rolling friction */
    double
        n[3]; /* [-] normal of a contact with a surface, which identifies it */
};

/* A new list of them, released with free(). */
struct dem_history *dem_histories(struct dem *dem, int *n);

/* Starts the next run with these contact histories and no others;
 * entries of particles that do not exist are ignored. */
void dem_restore_histories(struct dem *dem, const struct dem_history *list,
                           int n);

/* Visits all that the next run depends on besides the particles, which are
 * visited first (state.h). */
void dem_state(struct dem *dem, struct state *s);

/* Changes restitution or friction of material 0; the tangential displacements
 * are unchanged. */
void dem_change_material(struct dem *dem, const struct material *m);

#endif
