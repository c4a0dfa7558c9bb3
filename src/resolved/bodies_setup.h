/* bodies_setup.h -- what a case says about its bodies.
 * Chapter "Resolving the grains".
 */
#ifndef RESOLVED_BODIES_SETUP_H
#define RESOLVED_BODIES_SETUP_H

#include "base/model.h"
#include "dem/dem.h"
#include "fluid/hooks.h"

/* A way in which bodies hold the fluid. */

struct solid_bodies;

struct body_method {
    MODEL_MEMBERS;         /* base/model.h */
    int by_fraction;       /* 1: links have solid fractions */
    struct immersed hooks; /* its place in a step of the fluid */
};

/* All of them, ended by NULL; the first is the default. */
extern const struct body_method hold_method, fraction_methods_fictitious,
    fraction_methods_piso_ib;
extern const struct body_method *const solid_bodies_methods[];

/* What a case chooses of its bodies. */

enum body_motion {
    BODY_FREE,
    BODY_FIXED,
    BODY_PRESCRIBED,
    BODY_SPRING /* free along each axis with a spring, without a spin */
};

/* Gaps narrower than cells (body_motion.h). */
struct squeeze_film {
    double mu;    /* [Pa s] */
    double z_min; /* [m] */
    double reach; /* [m] squeeze_film_cells; 0: no such force */
};

struct solid_bodies_options {
    const struct body_method *method; /* NULL: friction by distance */
    double virtual_mass;              /* [-] C_v */
    double gravity[3];                /* [m/s^2] */
    double max_overlap; /* [-] a deeper one ends the run; 0: none does */
    int dem_steps;      /* [-] particle steps in a step of the fluid */
    const struct dem_options *dem; /* borrowed; NULL: all bodies rest */
    struct squeeze_film lubrication;
};

/* The lists in the order in which their bodies are numbered. */
enum body_list {
    BODY_SPHERES,
    BODY_BOXES,
    BODY_CYLINDERS,
    BODY_CLUMPS,
    BODY_SURFACES,
    BODY_LISTS
};

/* A body of any list, which has no use for some of the members. */
struct body_setup {
    double position[3];               /* [m] */
    double diameter, length, size[3]; /* [m] */
    double rotation[3], axis[3];      /* [rad], [-] */
    const char *file;
    double scale;   /* [-] of what the file gives */
    double density; /* [kg/m^3] 0: not given */
    enum body_motion motion;
    double velocity[3], spin[3]; /* [m/s], [rad/s] at time 0 */
    double spring[3];            /* [N/m] */
};

struct bodies_setup {
    const struct body_method *method;
    struct {
        int n;
        struct body_setup *item;
    } list[BODY_LISTS];
    double virtual_mass;          /* [-] C_v at least */
    double stiffness;             /* [N/m] 0: by the length of an impact */
    double restitution, friction; /* [-] */
    double max_overlap;           /* [-] */
    int lubrication;              /* [-] 1: in the gaps */
    double roughness;             /* [-] over the smallest radius */
    double filter;                /* [m] 0: none */
};

extern const struct key bodies_setup_keys[];

#endif
