/* body_options.h -- what a case chooses of its bodies. */
#ifndef RESOLVED_BODY_OPTIONS_H
#define RESOLVED_BODY_OPTIONS_H

#include "dem/dem_options.h"
#include "resolved/body_method.h"

enum body_motion {
    BODY_FREE,
    BODY_FIXED,
    BODY_PRESCRIBED,
    BODY_SPRING /* free along each axis with a spring, without a spin */
};

/* Gaps narrower than cells (squeeze_film.h). */
struct squeeze_film {
    double mu;    /* [Pa s] */
    double z_min; /* [m] */
    double reach; /* [m] squeeze_film_cells; 0: no such force */
};

struct solid_bodies;

/* How bodies touch that are not all spheres (blocks/block_contacts.h). */
struct body_contacts {
    /* The forces of a time dt [s] change the velocities of what touches. The
     * deepest overlap over a width [-]. */
    double (*act)(struct solid_bodies *b, double dt);
    /* Those of the films in their gaps. */
    void (*film)(struct solid_bodies *b, double dt);
    /* 1 if contacts keep bodies i and j apart, of which one moves. */
    int (*touch)(const struct solid_bodies *b, int i, int j);
};

struct solid_bodies_options {
    const struct body_method *method; /* NULL: friction by distance */
    double virtual_mass;              /* [-] C_v */
    double gravity[3];                /* [m/s^2] */
    double max_overlap; /* [-] a deeper one ends the run; 0: none does */
    int dem_steps;      /* [-] particle steps in a step of the fluid */
    const struct dem_options *dem; /* borrowed; NULL: all bodies rest */
    struct squeeze_film lubrication;
    const struct body_contacts *others; /* NULL: only spheres touch */
};

#endif
