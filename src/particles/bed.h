/* bed.h -- the particles before time 0: a settled bed.  Chapter 2.
 *
 * Spheres on a cubic lattice, from the bottom up, each shifted at random within
 * its free room; then gravity, first with a very dissipative material and a
 * drag, so that the bed comes to rest soon, then with the real material. The
 * same options give the same bed, bit for bit. Of several sizes, the lattice is
 * that of the largest, and who stands where is left to chance.
 */
#ifndef BED_H
#define BED_H

#include "particles/dem.h"
#include "particles/room.h"
#include "particles/sizes.h"

struct bed_options {
    int count;                 /* [-] */
    double diameter;           /* [m] of all, or the mean of sizes */
    const struct sizes *sizes; /* borrowed; NULL: all have that diameter */
    double density;            /* [kg/m^3] */
    unsigned long seed;        /* [-] of the jitter */
    double jitter;             /* [-] shift over the free room, 0 ... 1 */
    double gravity[3]; /* [m/s^2] points to the bottom; the walls of the box
                          are those of the dem_options */
    double settle;     /* [s] longest time; 0 leaves the lattice */
    struct room room;  /* sites without room stay empty */
};

struct bed_report {
    int settled;    /* [-] 1: kinetic is below BED_REST */
    double kinetic; /* [-] kinetic energy a particle over m g d */
    double time;    /* [s] that settling took */
    long steps;     /* [-] */
    double height;  /* [m] twice the mean height of the centres */
    double top;     /* [m] highest point of any particle over the bottom */
    double packing; /* [-] volume of the particles over base times height */
    struct dem_report dem; /* of the last run */
};

/* A bed is settled when a particle has, on average, less kinetic energy than
 * it gains by falling this part of its diameter [-]. */
#define BED_REST 1e-5

/* The springs of a settled bed (dem.h). */
struct bed_springs {
    int n;
    struct dem_spring *list; /* released with free() */
};

/* All of it: the bed from the file, if path is not NULL and the file is there;
 * else the lattice, settled, and written to the file. ps has room for it; `run`
 * was made for ps with `dem` and starts with the springs of the bed. A bed
 * that was read and one that was made go on alike, bit for bit. Non-zero after
 * a message, BED_UNSAVED if the file cannot be written; BED_LOST without one if
 * a particle is lost (see r->dem). */
enum { BED_MADE, BED_ABSENT, BED_REFUSED, BED_LOST, BED_UNSAVED };
int bed_make(const char *path, struct particles *ps, struct dem *run,
             const struct bed_options *bed, const struct dem_options *dem,
             struct bed_report *r);

/* Of the diameters that its seed draws: the smallest and the largest [m], and
 * the volume of all spheres [m^3]. */
struct bed_range {
    double least, most, volume;
};
struct bed_range bed_range(const struct bed_options *bed);

/* Its parts. Adds the lattice to ps; non-zero after a message if the box is
 * too small. */
int bed_fill(struct particles *ps, const struct bed_options *bed,
             const struct dem_options *dem);

/* Lets ps settle, with a step of limits.h. Positive if a particle is lost,
 * negative after a message if there is no room to run in. A
 * bed that is not settled in time is not an error here: see r->settled. */
int bed_settle(struct particles *ps, const struct bed_options *bed,
               const struct dem_options *dem, struct bed_report *r,
               struct bed_springs *springs);

/* Height and packing of what is in ps. */
void bed_measure(const struct particles *ps, const struct bed_options *bed,
                 const struct dem_options *dem, struct bed_report *r);

#endif
