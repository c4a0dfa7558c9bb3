/* limits.h -- how long a particle step may be.  Chapter 2. */
#ifndef LIMITS_H
#define LIMITS_H

/* T_R = pi r sqrt(rho / G) / (0.1631 nu + 0.8766) [s] [LS 5.11]: the time in
 * which a wave runs over the surface of a sphere. r [m], rho [kg/m^3], G
 * [Pa]. */
double limits_rayleigh(double r, double rho, double G, double nu);

/* Steps that resolve a collision of this length [s]: one fifteenth of it is
 * safe, one twenty-fifth is what we suggest. */
double limits_safe_step(double collision_time);
double limits_suggested_step(double collision_time);

#endif
