/* reference.h -- the readable contact loop.  Chapter "Particles and contact".
 *
 * The pairs are computed one after the other, and each formula has its printed
 * form: no lists, no chunks, no vectors, one thread. The candidates are all
 * pairs ("all-pairs"), the pairs of neighbouring cells ("link-cells"), or none:
 * then spheres pass through each other, and walls reflect them at once. The
 * fast loop (fast/) gives the same numbers up to rounding, and is tested
 * against this one.
 */
#ifndef DEM_REFERENCE_H
#define DEM_REFERENCE_H

#include "dem/clumps.h"
#include "dem/dem_method.h"
#include "dem/energy.h"
#include "dem/box_domain.h"

extern const struct dem_method reference_all_pairs, reference_link_cells,
    reference_no_contacts;

struct loads {
    double F[3], T[3]; /* [N], [N m] */
};

struct sphere {
    double x[3], v[3], w[3]; /* [m], [m/s], [rad/s] */
    double R, m;             /* [m], [kg] */
    int material;            /* [-] number of it */
    int clump;               /* [-] number of its clump; -1: none */
    double external[3];      /* [N] gravity, the fluid: constant in a run */
    struct loads all;        /* of the contacts and the attractions */
    struct loads part[ENERGY_PARTS]; /* those that the budget counts */
};

/* The history of a contact: what depends on the path, and not on the present
 * positions and velocities alone. */
struct history {
    int partner;          /* [-] a sphere, or -1 - w for wall w */
    double xi[3];         /* [m] tangential displacement */
    double roll_angle[3]; /* [rad] theta (contact.h) */
};

/* The histories of sphere i are list[start[i]] ... list[start[i + 1] - 1]. A
 * pair belongs to the sphere with the smaller index. */
struct histories {
    struct history *list;
    int n, capacity;
    int *start;
};

struct reference {
    const struct dem_options *options;
    const struct contact_constants *constants; /* of each pair of materials */
    struct box_domain box;
    int n, capacity; /* [-] spheres */
    struct sphere *sphere;
    struct clumps *clumps;        /* rigid bodies of some of them; or NULL */
    struct link_cells *cells;     /* NULL: all pairs */
    struct histories now, before; /* of this step, and of the one before */
    struct energy *energy;        /* the budget (energy.h) */
    int no_contacts;              /* [-] 1: spheres pass through each other */
    int budget;                   /* [-] 1: a case asks for it */
    double max_overlap;           /* [-] largest of this run */
    struct dem_overlap *deepest;  /* of all runs */
    const int *id;                /* [-] of each sphere */
    long sorts;                   /* [-] into cells, in this run */
};

/* From the centre of clump c to its ball s [m]. */
static inline void reference_arm(const struct reference *r,
                                 const struct clump *c, const struct sphere *s,
                                 double arm[3])
{
    for (int k = 0; k < 3; k++)
        arm[k] = box_domain_nearest(&r->box, k, s->x[k] - c->x[k]);
}

/* Computes F and T of all spheres; the contact histories advance by dt [s]. */
void reference_forces(struct reference *r, double dt);

/* The places of the balls of clumps, and their velocities. */
void reference_put_balls(struct reference *r);

/* What the sum of all loads about their centres changes of clumps in dt [s];
 * the balls follow later. */
void reference_kick_clumps(struct reference *r, double dt);

/* Returns the number of lost particles, and reports the first. */
int reference_check_lost(const struct reference *r, struct dem_report *report);

/* The first pair that crossed in the last drift of dt [s]: each that moved by
 * more than the smallest radius is compared with all. */
struct dem_crossing reference_crossing(const struct reference *r, double dt);

#endif
