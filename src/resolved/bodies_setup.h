/* bodies_setup.h -- what a case says about its bodies, but for the lists of
 * them.
 * Chapter "Resolving the grains".
 */
#ifndef RESOLVED_BODIES_SETUP_H
#define RESOLVED_BODIES_SETUP_H

#include "resolved/body_method.h"

struct bodies_setup {
    const struct body_method *method;
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
