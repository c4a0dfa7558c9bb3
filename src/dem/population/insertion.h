/* insertion.h -- insertion of particles during a run.
 * Chapter "Insertion, removal and energy".
 *
 * A source inserts spheres at random positions in a region where they overlap
 * no other particle: all at once, or at a given rate. Diameter and positions of
 * the k-th sphere are drawn from random numbers that depend on the seed and on
 * k alone. A large sphere without a free position waits, and all later ones
 * wait with it, because otherwise the inserted sizes would not follow the
 * distribution. A resumed run needs two numbers of a source.
 */
#ifndef DEM_POPULATION_INSERTION_H
#define DEM_POPULATION_INSERTION_H

#include "base/file.h"
#include "dem/bed.h"
#include "dem/box_domain.h"
#include "dem/clumps.h"
#include "dem/particles.h"
#include "dem/population/sizes.h"

/* One sphere of a list. */
struct insertion_sphere {
    double x[3]; /* [m] */
    double d;    /* [m] */
};

struct insertion_options {
    double lo[3], hi[3]; /* [m] the region that contains the whole spheres */
    double velocity[3];  /* [m/s] initial velocity */
    double diameter;     /* [m] of all, unless there are sizes */
    const struct sizes *sizes;       /* borrowed; or NULL */
    const struct clump_shape *clump; /* borrowed; of that shape or mixture,
                                        turned at random; NULL: spheres */
    double density;                  /* [kg/m^3] */
    int material;                    /* [-] its number */
    long count;                      /* [-] of spheres in all */
    double rate;                     /* [1/s] or 0 */
    double mass_rate;                /* [kg/s] or 0; both 0: all at once */
    double start;                    /* [s] time of the first */
    int seed;                        /* [-] of sizes and places */
    struct placement_region region;  /* places outside count as attempts */
    /* So many, borrowed, instead of chance; NULL: none. They may overlap others
     * by `overlap` of the mean diameter [-]. */
    const struct insertion_sphere *list;
    double overlap;
};

struct insertion {
    struct insertion_options options;
    long n_inserted; /* [-] spheres inserted so far */
    long n_attempts; /* [-] places tried for the next one */
    /* With a mass rate, the spheres found due so far and their mass [kg]; a
     * resumed run adds them up again, in the same order. */
    long n_due;
    double mass_due;
};

static inline int insertion_at_once(const struct insertion_options *o)
{
    return o->rate <= 0.0 && o->mass_rate <= 0.0;
}

/* The diameter of sphere k of a source [m], of a clump that of the sphere
 * around it, and place number `attempt` [m]. */
double insertion_diameter(const struct insertion_options *o, long k);
void insertion_place(const struct insertion_options *o, long k, long attempt,
                     double d, double x[3]);

/* Adds the spheres due at time t [s] to ps, with a limited number of attempts
 * each; returns how many were added. Spheres without a free position wait. */
int insertion_step(struct insertion *in, struct particles *ps,
                   const struct box_domain *box, double t);

/* 1 if two spheres of the list, number who[0] and who[1], overlap by more than
 * this share of their mean diameter, and cannot be inserted together. */
int insertion_overlap(const struct insertion_options *o,
                      const struct box_domain *box, double share, int who[2]);

/* Number of spheres due by then [-]; with a mass rate no fewer than before. */
long insertion_count_due(struct insertion *in, double t);

/* Adds `by` [m] to the places of a list, and brings those back that are then
 * outside a periodic direction. */
void insertion_move(struct insertion_sphere *list, long n, const double by[3],
                    const struct box_domain *box);

/* --- overlaps: spheres that overlap before time 0.
 *
 * A contact stores k delta^2 / 2, so spheres that overlap strongly at the
 * start separate at high speed. Such a case is either refused, or the spheres
 * are moved apart first: each overlapping pair along its line of centres, each
 * sphere by half of the overlap, repeatedly for all pairs and walls until no
 * overlap is left. */

/* An overlap of more than this part of the mean diameter of the two is too deep
 * for a start [-]. */
#define OVERLAPS_MAX 0.01

struct overlap {
    int i, j;     /* [-] indices; j = -1: none */
    double depth; /* [-] over the mean diameter of the two */
};

/* The deepest of all pairs, nearest images. */
struct overlap overlaps_deepest(const struct particles *ps,
                                const struct box_domain *box);

/* Moves spheres apart until no overlap is deeper than OVERLAPS_MAX. Returns
 * the number of rounds, or -1 if `most` rounds were not sufficient. */
int overlaps_relax(struct particles *ps, const struct box_domain *box,
                   int most);

/* --- grain table: grains from files, of other programs too.
 *
 * A dump of LAMMPS or LIGGGHTS: of several snapshots the last. Or a data file
 * of theirs, with atoms of the style sphere. Or a table with a line of names
 * (base/csv.h). All have columns x, y, z [m] and one of d, diameter, radius, r
 * [m], in any order, among others. Or rows x y z d alone. What a file says of
 * its columns, units and number of grains must agree with its rows. */

/* The list in a file, to be freed; NULL after a message. */
struct insertion_sphere *grain_table_parse(const struct input *in, long *n);

#endif
