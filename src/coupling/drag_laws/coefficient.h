/* coefficient.h -- a force on a sphere as a drag coefficient.
 * Chapter "Drag".
 *
 * EW18 measures a force by the superficial slip, eps times the interstitial
 * slip u_r [m/s]; F [N] is the whole force along it.
 */
#ifndef COUPLING_DRAG_LAWS_COEFFICIENT_H
#define COUPLING_DRAG_LAWS_COEFFICIENT_H

/* C_d = 8 F / (pi rho_f d^2 eps^2 u_r^2) [-] [EW18 26]; it has the sign of F
 * and u_r. */
double coefficient_of_force(double F, double rho_f, double d, double eps,
                            double u_r);

/* Re_p = rho_f d eps |u_r| / mu [-] [EW18 27, A.1]. */
double coefficient_reynolds(double eps, double rho_f, double mu, double d,
                            double u_r);

#endif
