/* attraction.h -- forces between particles at a distance. Chapter "Materials,
 * rolling and cohesion".
 *
 * In addition to the contact force, forces along the line of centres act up to
 * a gap `range`. Each law is one file; a case uses the laws that it names. They
 * are added to the loads after the contacts, for all pairs of the neighbour
 * list, whose skin is increased by the largest range. Coulomb's limit uses only
 * the contact force [LS 4.8]: where cohesion presses two spheres together the
 * contact force balances it, and so the limit increases by mu times the
 * cohesion. A law may also damp the approach, as a liquid between two spheres
 * does.
 */
#ifndef DEM_ATTRACTION_H
#define DEM_ATTRACTION_H

struct attraction_law;

/* A law and its parameters. Parameters that a law does not use are 0. */
struct attraction {
    const struct attraction_law *law;
    double range;    /* [m] longest gap at which it acts */
    double strength; /* eps_r [-]; A [J]; gamma cos theta [N/m] */
    double closest;  /* [m] gap below which van der Waals' force is constant */
    int harmonic;    /* [-] 1: R* of a capillary is the harmonic mean */
    const double *charge; /* [C] of a sphere, by material; borrowed */
};

/* Quantities of a case that a law may need besides its own parameters. */
struct attraction_scene {
    const double *charge; /* [C] by material */
    double viscosity;     /* [Pa s] of the fluid; 0 without one */
    int charged;          /* [-] 1: one of the charges is not 0 */
};

/* The force [N] along the line of centres, positive pushes apart: between
 * spheres of two materials and radii [m], and of a wall, which is flat. */
typedef double attraction_pair(const struct attraction *a, int material_i,
                               int material_j, double R_i, double R_j,
                               double gap);
typedef double attraction_wall(const struct attraction *a, double R,
                               double gap);

/* The coefficient [kg/s] of a force against the rate at which the gap closes;
 * R_star [m] is R of the sphere at a wall. */
typedef double attraction_damping(const struct attraction *a, double R_star,
                                  double gap);

struct attraction_law {
    const char *name;            /* as a case spells it in `effects` */
    attraction_pair *pair;       /* NULL: no force at rest */
    attraction_wall *wall;       /* NULL: walls do not attract */
    attraction_damping *damping; /* NULL: the force does not depend on motion */
    /* Between parcels of l diameters the gaps are l times as long, and the
     * strength is l to this power times that of grains, so that the force is
     * l^2 times theirs. 1: only the charge is that of all grains, and the
     * range, which is not of the order of the gap, stays. */
    int parcel_power, far_field;
};

/* The damping force [N] during a step of dt [s] if the gap closes at `closing`
 * [m/s] and the two have 1/m_i + 1/m_j = per_mass [1/kg]: the mean over the
 * step for a pair of half the reduced mass that nothing else slows. With half
 * the mass, a step of any length is stable also where twelve neighbours damp
 * one sphere. */
double attraction_damp(const struct attraction *a, double R_star, double gap,
                       double closing, double per_mass, double dt);

/* The whole force [N] in a step, of rest and motion: between spheres, and of a
 * wall. Of a law without damping `closing` may be anything. 0 beyond the range.
 */
double attraction_of_pair(const struct attraction *a, int material_i,
                          int material_j, double R_i, double R_j, double gap,
                          double closing, double per_mass, double dt);
double attraction_of_wall(const struct attraction *a, double R, double gap,
                          double closing, double per_mass, double dt);

/* --- van der Waals' attraction.
 *
 *   F = A / (12 l^2) D_i D_j / (D_i + D_j)                      [LS 4.14]
 *
 * is the attraction of two spheres with a gap l between their surfaces, for l
 * much smaller than the spheres; A is Hamaker's constant. LS calls l the
 * separation at which the particles start to interact, and prints no sign: it
 * is the gap, and the force is an attraction. For l to 0 the formula has no
 * limit. Below `closest`, the distance of molecules that touch, the force stays
 * what it is there, also where the spheres overlap. A wall is a sphere without
 * end: D_i D_j / (D_i + D_j) becomes D_i.
 */

extern const struct attraction_law van_der_waals;

/* [m] D_i D_j / (D_i + D_j). */
double van_der_waals_diameter(double D_i, double D_j);

/* [N] of attraction; A [J], D_star [m], l [m]. */
double van_der_waals_force(double A, double D_star, double l);

/* --- capillary: the force of a capillary bridge.
 *
 *   F = -2 pi R* gamma cos theta                                [LS 4.15]
 *
 * gamma is the surface tension, theta the angle of contact. The force of a
 * bridge of little liquid does not depend on the gap, and ends where the gap
 * exceeds the range, in LS as soon as the spheres separate.
 *
 * LS takes the mean of the radii for R*, which is right for equal spheres. For
 * unequal ones Derjaguin's geometry gives the harmonic mean 2 R_i R_j/(R_i +
 * R_j); the mean would make the bridge between a grain and a boulder as strong
 * as the boulder is large. For a wall it has no value, so there we always take
 * the harmonic one, 2 R: F = -4 pi R gamma cos theta.
 */

extern const struct attraction_law capillary;

/* [m] R*: the mean of the radii [LS 4.15], and Derjaguin's. */
double capillary_mean(double R_i, double R_j);
double capillary_harmonic_mean(double R_i, double R_j);

/* [N] negative: it pulls; tension = gamma cos theta [N/m]. */
double capillary_force(double tension, double R_star);

/* --- electrostatic: the force between charged spheres.
 *
 *   F = q_i q_j / (4 pi eps_0 eps_r l^2)                        [LS 4.13]
 *
 * l is the distance of the centres; like signs repel. Each sphere of a material
 * has that material's charge. Walls have none, and the force ends at the range.
 */

extern const struct attraction_law electrostatic;

/* [N] q [C], l [m], eps_r [-]; positive pushes apart. */
double electrostatic_force(double q_i, double q_j, double eps_r, double l);

#endif
