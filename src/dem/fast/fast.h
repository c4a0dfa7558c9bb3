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

struct fast {
    struct neighbours *neighbours;
    double min_margin; /* [m] */
    long steps_done;   /* [-] steps of the run at hand */
    struct dem_crossing crossing;
    int interrupted;  /* [-] 1: by a signal */
    struct heun heun; /* empty with another integrator */
};

/* The state of a dem with this method. */
static inline struct fast *fast_of(const struct dem *dem)
{
    return dem->state;
}

/* So many steps, by one thread of the team. */
void fast_move(struct dem *dem, int steps);

/* All that the next run depends on (dem_method.h). */
void fast_state(struct dem *dem, struct state *s);

/* The contact histories as a list, and back (dem_method.h). */
struct dem_history *fast_histories(struct dem *dem, int *n);
void fast_restore_histories(struct dem *dem, const struct dem_history *list,
                            int n, const int *index);

#endif
