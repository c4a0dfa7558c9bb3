/* convection.h -- the velocity with which a face carries momentum.  Chapter 5.
 *
 * u_f = share u_owner + (1 - share) u_neighbour + beyond
 *
 * A scheme is a way to choose the share from the flux and the linear weight of
 * the face; the share goes into the matrix. A scheme that looks farther than
 * the two cells has a second part, `beyond`, which is taken from the velocities
 * known so far and goes to the right side (deferred correction).  Chapter 19.
 */
#ifndef CONVECTION_H
#define CONVECTION_H

/* What a scheme knows of faces 0 .. n - 1. */
struct convection_faces {
    int n;
    const double *phi; /* [m^3/s] */
    const double *w;   /* [-] the owner's share in a linear mean */
    double blend;      /* [-] of linear, if the scheme asks */
};

struct convection_scheme {
    const char *name; /* as a case spells it */
    const char *cite;
    const char *what;
    const char *function; /* the one that makes the scheme what it is */
    void (*shares)(const struct convection_faces *faces,
                   double *share /* [-] */);
    /* What a face has beyond the velocity of the cell C upstream. step: u_D -
     * u_C, D being downstream; rise: grad u_C along the link from C to D;
     * reach: the part of the link that is within C [-]. NULL: nothing. */
    double (*beyond)(double step, double rise, double reach);
    int damps; /* 1: its own error damps what varies from cell to cell */
};

/* All schemes, ended by a row without a name; NULL for an unknown name. */
extern const struct convection_scheme convection_schemes[];
const struct convection_scheme *convection_scheme_named(const char *name);

#endif
