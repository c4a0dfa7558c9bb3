/* convection.h -- the velocity with which a face carries momentum.  Chapter 5.
 *
 * u_f = share u_owner + (1 - share) u_neighbour: a scheme is a way to choose
 * the share from the flux and the linear weight of the face.
 */
#ifndef CONVECTION_H
#define CONVECTION_H

struct convection_scheme {
    const char *name; /* as a case spells it */
    const char *cite;
    const char *what;
    double (*share)(double phi /* [m^3/s] */, double w /* [-] linear */);
};

/* All schemes, ended by a row without a name; NULL for an unknown name. */
extern const struct convection_scheme convection_schemes[];
const struct convection_scheme *convection_scheme_named(const char *name);

#endif
