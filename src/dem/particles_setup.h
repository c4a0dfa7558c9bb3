/* particles_setup.h -- what a case says of the particles.
 *
 * The rows of particles_keys.c, and those of the models that a case chooses,
 * name the members that they fill. A name that is left out is NULL, a number 0.
 */
#ifndef DEM_PARTICLES_SETUP_H
#define DEM_PARTICLES_SETUP_H

#include "dem/bed.h"
#include "dem/dem_method.h"
#include "dem/population/population.h"
#include "dem/surfaces/prescribed_particles.h"
#include "dem/surfaces/surface.h"

#define PARTICLES_LIST(type)                                                   \
    struct {                                                                   \
        int n;                                                                 \
        struct type *item;                                                     \
    }

struct material_setup {
    const char *name; /* NULL of the grains */
    double density;   /* [kg/m^3] */
    double parcel;    /* [-] grains in a parcel of it; 0: as of all */
    struct material of;
};

struct pair_setup {
    const char *between, *and;
    struct materials_measured of; /* without a and b */
    int has_restitution, has_friction, has_rolling;
};

struct clump_setup {
    const char *name, *file;
    double scale;   /* [-] of the file */
    double share;   /* [-] of a mixture; 0: none is given */
    double half[3]; /* [m] of an ellipsoid of revolution */
    int has_half, has_balls, balls;
};

struct place_setup {
    double position[3]; /* [m] */
    double velocity[3]; /* [m/s] */
    double spin[3];     /* [rad/s] */
    double diameter;    /* [m] of a clump, that of the sphere around it */
    double rotation[3]; /* [rad] of a clump */
    const char *material, *clump;
};

/* A source. The case completes its options and keeps what they borrow. */
struct insert_setup {
    struct insertion_options of;
    int count;            /* [-] */
    int has_from, has_to; /* [-] 1: of.lo, of.hi are given */
    const char *sizes, *material, *file, *clump;
    double offset[3]; /* [m] of the file */
    struct sizes *distribution;
    struct insertion_sphere *list; /* of the file */
};

struct particles_setup {
    const struct contact_law *contact;
    const struct integrator *integrator;
    const struct dem_method *list;
    double step;                          /* [s] */
    double shortest_step, step_error;     /* [s], [-] of one that adapts */
    double skin;                          /* [m] 0: d/3 */
    double expected_overlap, max_overlap; /* [-] over the mean diameter */
    int unsafe_step;                      /* [-] 1: any step is taken */
    const char *overlaps;                 /* "refuse", "relax" or "allow" */
    struct material_setup grains;         /* material number 0 */
    const char *walls;                    /* the material of the box */
    struct {
        double grains;           /* [-] in one; 0: no parcels */
        const char *restitution; /* what of it is kept */
        double asked, made; /* [-] grains of the case, and of its parcels */
    } parcel;
    int has_bed, has_place, has_insert, has_sinks;
    struct bed_options bed; /* without its sizes and surroundings */
    const char *bed_sizes, *bed_file, *bed_clump;
    PARTICLES_LIST(clump_setup) clumps;
    struct clump_shape *shapes; /* of these; made by the case */
    PARTICLES_LIST(material_setup) materials;
    PARTICLES_LIST(pair_setup) pairs;
    PARTICLES_LIST(place_setup) place;
    PARTICLES_LIST(sizes_setup) sizes;
    PARTICLES_LIST(insert_setup) insert;
    PARTICLES_LIST(sink_setup) sinks;
    PARTICLES_LIST(surface_setup) surfaces;
    PARTICLES_LIST(prescribed_setup) prescribed;
};

extern const struct key particles_keys[], clumps_keys[];

#endif
