/* lift.h -- forces and torque of the fluid on a particle in a shear, or that
 * spins.  Chapter "Further forces". */
#ifndef COUPLING_EFFECTS_LIFT_H
#define COUPLING_EFFECTS_LIFT_H

/* Saffman's lift in a shear.
 *
 *   Re_G = d^2 |curl u| / nu                                        [LS 5.5]
 *   F = 1.615 mu d |w| sqrt(Re_G),  along w x curl u                [LS 5.6]
 *
 * w = u - v. 1.615 is 6.46/4 of Saffman's correction of 1968; LS rounds it to
 * 1.61. In the vector form F = 1.615 d^2 sqrt(rho mu/|curl u|) w x curl u. It
 * holds for Re << sqrt(Re_G) << 1; Mei's factor (1992) carries it to Re = 100
 * and 0.005 < alpha < 0.4, alpha = d |curl u|/(2 |w|).
 */

/* Re_G [-] of a shear G [1/s] [LS 5.5]. */
double saffman_reynolds(double d, double nu, double G);

/* The force [N] with the printed coefficient 1.61 [LS 5.6]. */
double saffman_force(double mu, double d, double u_r, double Re_G);

/* Mei's factor [-]. */
double saffman_factor(double Re, double alpha);

/* The force F [N] on a sphere of diameter d [m] for a slip w [m/s] and a curl
 * [1/s], in a fluid of rho [kg/m^3] and mu [Pa s]. */
void saffman_lift(double rho, double mu, double d, const double w[3],
                  const double curl[3], double F[3]);

/* Forces and torque of the fluid on a particle that spins.
 *
 *   F = (1/2) rho A C_LR |w| w x Omega / |Omega|                    [LS 5.7]
 *
 * with w = u - v, A = pi d^2/4 and Omega = omega - curl u/2, the spin against
 * that of the fluid. LS writes |v - u| (v - u) for the size, and the direction
 * in words. C_LR = d |Omega|/|w| of Rubinow and Keller (1961) at small Re, as
 * the limit of Oesterle and Bui Dinh (1998), to Re = 140.
 *
 *   T = -(1/2) rho (d/2)^5 C_R |Omega| Omega
 *   C_R = 64 pi/Re_r to Re_r = 32, 12.9/sqrt(Re_r) + 128.4/Re_r above
 *
 * with Re_r = rho d^2 |Omega|/mu; the first is the exact T = -pi mu d^3 Omega,
 * the second Dennis, Singh and Ingham (1980), to Re_r = 1000.
 */

/* Re_r = rho d^2 |Omega| / mu [-]. */
double spin_reynolds(double rho, double mu, double d, double Omega);

/* C_LR [-] for Re of the slip and Re_r of the spin. */
double spin_lift_coefficient(double Re, double Re_r);

/* The force [N] for a spin normal to the slip u_r [m/s] [LS 5.7]; it turns with
 * the slip. */
double spin_force(double rho, double C_LR, double d, double u_r);

/* F [N] for a slip w [m/s] and a spin Omega [rad/s] against the fluid's. */
void spin_lift(double rho, double mu, double d, const double w[3],
               const double Omega[3], double F[3]);

/* C_R Re_r [-] of the torque: 64 pi in slow rotation. */
double spin_torque_factor(double Re_r);

/* The rate [1/s] at which the torque slows a sphere of density rho_s. */
double spin_decay_rate(double rho, double mu, double d, double rho_s,
                       double Omega);

#endif
