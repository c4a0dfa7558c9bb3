/* attraction.h -- attractive forces between particles at a distance. Chapter
 * 17.
 *
 * In addition to the contact force, forces along the line of centres act up to
 * a gap `range`. Each law is one file; a case uses the laws that it names. They
 * are added to the loads after the contacts, for all pairs of the neighbour
 * list, whose skin is increased by the largest range. Coulomb's limit uses only
 * the contact force [LS 4.8]: where cohesion presses two spheres together the
 * contact force balances it, and so the limit increases by mu times the
 * cohesion.
 */
#ifndef DEM_ATTRACTION_H
#define DEM_ATTRACTION_H

struct attraction_law;

/* A law and its parameters. Parameters that a law does not use are 0. */
struct attraction {
    const struct attraction_law *law;
    double range;         /* [m] longest gap at which it acts */
    double strength;      /* eps_r [-]; A [J]; gamma cos theta [N/m] */
    double closest;       /* [m] gap below which van der Waals' force stays */
    int harmonic;         /* [-] 1: R* of a capillary is the harmonic mean */
    const double *charge; /* [C] of a sphere, by material; borrowed */
};

/* The force [N] along the line of centres, positive pushes apart: between
 * spheres of two materials and radii [m], and of a wall, which is flat. */
typedef double attraction_pair(const struct attraction *a, int material_i,
                               int material_j, double R_i, double R_j,
                               double gap);
typedef double attraction_wall(const struct attraction *a, double R,
                               double gap);

struct attraction_law {
    const char *name; /* as a case spells it in `effects` */
    attraction_pair *pair;
    attraction_wall *wall; /* NULL: walls do not attract */
};

#endif
