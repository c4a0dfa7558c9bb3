/* bodies_setup.h -- what a case says about its bodies.
 * Chapter "Resolving the grains".
 */
#ifndef RESOLVED_BODIES_SETUP_H
#define RESOLVED_BODIES_SETUP_H

#include "resolved/body_method.h"
#include "resolved/body_options.h"

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
