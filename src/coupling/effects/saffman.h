/* saffman.h -- Saffman's lift in a shear.  Chapter "Further forces".
 *
 *   Re_G = d^2 |curl u| / nu                                        [LS 5.5]
 *   F = 1.615 mu d |w| sqrt(Re_G),  along w x curl u                [LS 5.6]
 *
 * w = u - v. 1.615 is 6.46/4 of Saffman's correction of 1968; LS rounds it to
 * 1.61. In the vector form F = 1.615 d^2 sqrt(rho mu/|curl u|) w x curl u. It
 * holds for Re << sqrt(Re_G) << 1; Mei's factor (1992) carries it to Re = 100
 * and 0.005 < alpha < 0.4, alpha = d |curl u|/(2 |w|).
 */
#ifndef COUPLING_EFFECTS_SAFFMAN_H
#define COUPLING_EFFECTS_SAFFMAN_H

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

#endif
