/* body_numbers.h -- the numbers that a flow around bodies depends on.
 * Chapter "Resolving the grains".
 *
 * V and L are a velocity and a length that the case is measured by: EW18 take
 * the velocity of the inlet and the diameter.
 */
#ifndef RESOLVED_BODY_NUMBERS_H
#define RESOLVED_BODY_NUMBERS_H

/* rho V L / mu [-], of kg/m^3, m/s, m and Pa s [EW18 6]. */
double body_numbers_reynolds(double rho, double V, double L, double mu);

/* g L / V^2 [-], of m/s^2, m and m/s [EW18 7]. */
double body_numbers_inverse_froude(double g, double L, double V);

/* rho_p / rho [-] [EW18 8]. */
double body_numbers_density_ratio(double rho_p, double rho);

/* rho_r Re / 18 [-] [EW18 9]. */
double body_numbers_stokes(double rho_r, double Re);

/* C_a [-]: the fluid that a body accelerates with it where it is widest, over
 * the fluid that it displaces, about: sqrt(6 V / (pi w^3)) / 2, of its volume
 * [m^3] and smallest width [m]. 1/2 of a sphere. */
double body_numbers_added_mass(double volume, double width);

/* C_v [-] in a step of the velocity of one of n bodies, and of its spin: the
 * least that is asked for, or what keeps them from growing with the other sign
 * in each step (24.10), with x = nu dt / R^2 [-] of half its smallest width. */
double body_numbers_virtual_mass(double least, double x, double rho_r,
                                 double C_a, int n);
double body_numbers_virtual_spin(double least, double x, double rho_r,
                                 double C_a);

/* C_c [-] that contacts have to accelerate: what no body has less of, 1/2, so
 * that they gain nothing; not more than C_v (24.15). */
double body_numbers_contact_mass(double C_v);

/* The added mass of a body within others over that of one alone [-]: a sphere
 * in the middle of a closed one, of which it fills the fraction phi (24.12). */
double body_numbers_crowding(double phi);

#endif
