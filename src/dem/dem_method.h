/* dem_method.h -- how pairs are found and loads computed. Chapters "Particles
 * and contact" and "Neighbours".
 *
 * The motion of the particles is computed by one of several methods. The
 * reference loop (reference.h), which is written to be read, and the fast one
 * (fast/fast.h) give the same numbers up to rounding; the former can leave the
 * contacts out. dem.c calls them through this table of functions only.
 */
#ifndef DEM_DEM_METHOD_H
#define DEM_DEM_METHOD_H

#include "base/model.h"
#include "dem/dem.h"
#include "dem/energy.h"

struct dem {
    struct dem_options options;
    struct particles *ps;                /* borrowed */
    struct contact_constants *constants; /* of each pair of materials */
    const struct dem_method *method;
    void *state;                /* of the method */
    long motion_steps;          /* [-] steps of the surfaces' clock */
    int motion_on;              /* [-] 1: it runs */
    double max_overlap;         /* [-] largest of the last run */
    struct dem_overlap deepest; /* of all runs, and its limits */
    struct energy *energy;      /* NULL: no budget is kept */
};

/* 1 if it is time to look for a signal after step k of a run: about every 1e5
 * steps of a particle, which take some ms, and not in each step. A run that
 * ends there has fewer steps than it was asked for, and its state is not whole.
 * Without the clock, as where a bed settles, the caller looks between runs. */
static inline int dem_looks(const struct dem *dem, int k)
{
    return dem->motion_on && k % (2 + 100000 / (dem->ps->n + 1)) == 1;
}

/* Mean diameter of the particles [m]; 0 without any. */
double dem_mean_diameter(const struct particles *ps);

/* The smallest [m]; HUGE_VAL without any. */
double dem_least_diameter(const struct particles *ps);

/* Largest gap [m] at which a force acts. */
double dem_range(const struct dem_options *o);

/* The option that their method does not support, in words; NULL: none. */
const char *dem_unsupported(const struct dem_options *o);

struct dem_method {
    MODEL_MEMBERS;   /* base/model.h */
    int no_contacts; /* [-] 1: particles pass through each other */
    /* For dem_unsupported; NULL: it supports all. */
    const char *(*unsupported)(const struct dem_options *o);
    /* Gap [m] up to which it lists pairs of particles that have this mean
     * diameter [m]; NULL: 0. */
    double (*skin)(const struct dem_options *o, double mean);
    /* Sets dem->state; non-zero after a message. NULL: that is set later. free
     * releases it. */
    int (*create)(struct dem *dem);
    void (*free)(struct dem *dem);
    /* Moves the particles by this number of steps and fills in the report,
     * dem->deepest and dem->energy. */
    void (*run)(struct dem *dem, int steps, struct dem_report *r);
    /* The particles were changed, or the budget begins; NULL: no matter. */
    void (*changed)(struct dem *dem);
    /* dem->deepest has been set anew; NULL: it is read where it is. */
    void (*limit_overlap)(struct dem *dem);
    /* Visits dem->state (state.h). */
    void (*visit)(struct dem *dem, struct state *s);
    /* A new list of the contact histories (dem.h). */
    struct dem_history *(*histories)(struct dem *dem, int *n);
    /* The next run starts with these histories, whose particles all exist;
     * index: the present index of each id. */
    void (*restore_histories)(struct dem *dem, const struct dem_history *list,
                              int n, const int *index);
};

/* All methods, ended by NULL, the default first; dem_method_named: NULL for an
 * unknown name. */
extern const struct dem_method fast_verlet, reference_link_cells,
    reference_all_pairs, reference_no_contacts;
extern const struct dem_method *const dem_methods[];
const struct dem_method *dem_method_named(const char *name);

#endif
