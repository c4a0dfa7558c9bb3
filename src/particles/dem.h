/* dem.h -- the particles' own steps.  Chapter 2.
 *
 * Velocity Verlet: half a kick, a drift, new forces, half a kick. The outside
 * forces ex, ey, ez stay the same during one dem_run.
 */
#ifndef DEM_H
#define DEM_H

#include "particles/contact.h"
#include "particles/particles.h"

struct dem_options {
    const struct contact_law *law;
    struct material material;
    double step;     /* [s] */
    double skin;     /* [m] of the neighbour list; 0: 0.3 of the largest d */
    double low[3];   /* [m] the box; its sides are walls ... */
    double high[3];  /* [m] */
    int periodic[3]; /* ... unless the direction is periodic */
};

/* What the last dem_run did. */
struct dem_report {
    long steps;         /* [-] so far, over all runs */
    long rebuilds;      /* [-] of the neighbour list, so far */
    int contacts;       /* [-] touching pairs and walls at the last step */
    double max_overlap; /* [-] over the pair's mean diameter, in any step */
    double max_speed;   /* [m/s] at the last step */
    int lost;           /* [-] particles outside the box, or not finite */
    int lost_id;        /* [-] the first of them; -1 */
    double lost_at[3];  /* [m] where it is */
};

struct dem;

/* The particles are borrowed; they may be added to only before. */
struct dem *dem_create(struct particles *ps, const struct dem_options *o);
void dem_free(struct dem *dem);

/* `steps` steps. Non-zero if a particle was lost; the report says which. */
int dem_run(struct dem *dem, int steps, struct dem_report *report);

/* Forgets all contacts: each begins anew without a spring. For a caller who has
 * put particles elsewhere between two runs. */
void dem_forget(struct dem *dem);

#endif
