/* bed.h -- a bed of equal spheres at rest, made before time 0.  Chapter 2.
 *
 * A lattice with jitter from a seed fills the box from the bottom (where
 * gravity points); then the spheres fall and come to rest as very dissipative
 * ones, which is quick. What remains is positions: at time 0 nothing moves or
 * is strained by friction, so a bed read from a file and one just made run
 * alike, bit for bit.
 */
#ifndef BED_H
#define BED_H

#include "particles/dem.h"

struct bed_options {
    int count;
    double diameter; /* [m] */
    double density;  /* [kg/m^3] */
    int seed;
    double jitter;     /* [-] of the free room between neighbours, 0 to 1 */
    double gravity[3]; /* [m/s^2]; zero: the lattice stays as it is */
    double settle;     /* [s] longest time for settling; 0: not at all */
};

struct bed_report {
    double time;           /* [s] it took */
    double kinetic_energy; /* [-] left, a particle over m g d */
    double height;         /* [m] of the highest surface above the bottom */
    double fraction;       /* [-] solids in the lower half of that */
};

/* Adds the lattice to ps. Non-zero after a message if the box is too small. */
int bed_fill(struct particles *ps, const struct bed_options *b,
             const struct dem_options *dem);

/* Lets it settle. Non-zero after a message if a particle was lost. */
int bed_settle(struct particles *ps, const struct bed_options *b,
               const struct dem_options *dem, struct bed_report *report);

/* The file: exact, with all that the bed depends on. Writing returns non-zero
 * after a message. Reading returns 0 when ps is filled, 1 if there is no such
 * file, 2 after a message if it belongs to another bed or is damaged. */
int bed_write(const char *path, const struct particles *ps,
              const struct bed_options *b, const struct dem_options *dem);
int bed_read(const char *path, struct particles *ps,
             const struct bed_options *b, const struct dem_options *dem);

#endif
