/* bed.h -- the particles before time 0: a settled bed.
 * Chapter "Particles and contact".
 *
 * Spheres are placed on a cubic lattice, from the bottom up, each shifted at
 * random within its site; then they settle under gravity, first with a very
 * dissipative material and a drag, so that the bed comes to rest soon, then
 * with the real material. The same options give the same bed, bit for bit. With
 * several sizes the lattice is that of the largest, and sizes are assigned to
 * sites at random.
 */
#ifndef DEM_BED_H
#define DEM_BED_H

#include "dem/dem.h"

struct particles;

struct placement_region {
    /* 1 if a sphere of radius R [m] around x [m] overlaps no wall; NULL: the
     * region is the whole box. */
    int (*has_room)(const void *state, const double x[3], double R);
    /* Non-zero after a message if a particle overlaps a wall other than those
     * of the box; NULL: there is no such wall. */
    int (*start_wrong)(const void *state, const struct particles *ps);
    const void *state; /* borrowed */
};

struct sizes;
struct bed_saver;

struct bed_options {
    char where[256]; /* in the case, before messages; or empty */
    int count;       /* [-] */
    double diameter; /* [m] of all, or the mean of sizes */
    double density;  /* [kg/m^3] */
    int seed;        /* [-] of the jitter */
    double jitter; /* [-] random shift over the free space of a site, 0 ... 1 */
    double gravity[3]; /* [m/s^2] points to the bottom; the walls of the box
                          are those of the dem_options */
    double settle;     /* [s] longest time; 0 leaves the lattice */
    struct placement_region region;  /* sites without space stay empty */
    const struct clump_shape *clump; /* borrowed: of that shape or mixture,
                                        turned at random, and diameters are of
                                        spheres around them; NULL: spheres */
    struct sizes *sizes;           /* borrowed; NULL: all have that diameter */
    const struct bed_saver *saver; /* borrowed; NULL: settling is not saved
                                        on the way (bed_settling.h) */
};

struct bed_report {
    int settled;    /* [-] 1: kinetic is below BED_SETTLED_ENERGY */
    double kinetic; /* [-] kinetic energy a particle over m g d */
    double time;    /* [s] that settling took */
    long steps;     /* [-] */
    int stopped;    /* [-] not 0: the saver has ended the settling, with this
                       exit code */
    double height;  /* [m] twice the mean height of the centres */
    double top;     /* [m] highest point of any particle over the bottom */
    double packing; /* [-] volume of the particles over base times height */
    struct dem_report dem; /* of the last run */
};

/* A bed is settled when a particle has, on average, less kinetic energy than
 * it gains by falling this part of its diameter [-]. */
#define BED_SETTLED_ENERGY 1e-5

/* The contact histories of a settled bed (dem.h). */
struct bed_histories {
    int n;
    struct dem_history *list; /* released with free() */
};

/* Fills the lattice and settles the bed. ps has capacity for it; a run starts
 * with the histories of the contacts by dem_restore_histories.
 *
 * Returns BED_CREATED; BED_REFUSED after a message; or without one BED_LOST if
 * a particle is lost (see r->dem), and BED_STOPPED if the saver ended the
 * settling. BED_UNSAVED is for who keeps it in a file. */
enum { BED_CREATED, BED_REFUSED, BED_LOST, BED_UNSAVED, BED_STOPPED };
int bed_create(struct particles *ps, const struct bed_options *bed,
               const struct dem_options *dem, struct bed_report *r,
               struct bed_histories *histories);

/* What decides the bed, a line a fact; released with free(). */
char *bed_made_with(const struct bed_options *bed, const struct dem_options *o);

/* The bed as a state: a bed that was loaded, into a ps without particles, and
 * one that was settled continue identically, bit for bit. One that cannot be of
 * these options is refused. */
void bed_state(struct particles *ps, struct bed_histories *h,
               const struct bed_options *bed, const struct dem_options *dem,
               struct state *s);

/* The smallest and the largest diameter [m] that the seed of the bed draws, the
 * smallest of a ball, the volume of all spheres [m^3], and how many balls. */
struct bed_range {
    double min, max, ball, volume;
    double balls; /* [-] all of them */
};
struct bed_range bed_range(const struct bed_options *bed);

/* The parts of bed_create. bed_fill adds the lattice to ps; non-zero after a
 * message if the box is too small, or if a sphere overlaps a wall. */
int bed_fill(struct particles *ps, const struct bed_options *bed,
             const struct dem_options *dem);

/* Calls put for each sphere of the lattice in a box, one after the other, with
 * its number from 0 on, centre and diameter [m]; non-zero after a message. */
typedef void bed_put(void *to, int i, const double x[3], double d);
int bed_each(const struct bed_options *bed, const struct dem_options *dem,
             bed_put *put, void *to);

/* Lets ps settle, with a step of contact.h. Positive if a particle is lost,
 * negative after a message if the options do not fit (dem_create). A bed that
 * is not settled in time is not an error here: see r->settled. */
int bed_settle(struct particles *ps, const struct bed_options *bed,
               const struct dem_options *dem, struct bed_report *r,
               struct bed_histories *histories);

/* Height and packing of what is in ps. */
void bed_measure(const struct particles *ps, const struct bed_options *bed,
                 const struct dem_options *dem, struct bed_report *r);

/* --- bed settling: the settling of a bed.
 *
 * A bed settles first with a very dissipative material and a viscous drag,
 * without which rolling spheres would not stop; then with the real material.
 */

/* The stages of the settling at which a saver is called. */
enum bed_stage { BED_STAGE_START, BED_STAGE_STEPS, BED_STAGE_END };

struct bed_settling;

/* All that the rest of the settling depends on (state.h). */
void bed_settling_state(struct bed_settling *b, struct state *s);

/* The time since it was dropped [s]. */
double bed_settling_time(const struct bed_settling *b);

/* Saves a bed while it settles. */
struct bed_saver {
    void *memory; /* borrowed */
    /* Called once before the first step, where a bed that was saved may be
     * loaded; before each fifty steps; and once when the bed is at rest.
     * Settling ends where it returns an exit code that is not 0. */
    int (*visit)(void *memory, struct bed_settling *b, enum bed_stage stage);
};

#endif
