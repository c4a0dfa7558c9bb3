/* factor.h -- laws that are given as a factor to Stokes' law.
 * Chapter "Drag".
 *
 * Simulations that resolve the flow around the spheres report the drag on one
 * of them over Stokes' law at the superficial slip U = eps_f u_r,
 *
 *   F_d = 3 pi mu d U F(eps_f, Re),   Re = rho_f d U / mu.
 *
 * F_d is what law->resistance wants: without the force -V_p grad p of the mean
 * pressure gradient. In an even, steady bed the whole force is F_d / eps_f, for
 * the fluid's share eps_f of the gradient balances the drag. Some papers give
 * the whole force; their factor times eps_f is F.
 */
#ifndef COUPLING_DRAG_LAWS_FACTOR_H
#define COUPLING_DRAG_LAWS_FACTOR_H

#include "coupling/drag.h"

/* beta / eps_s [kg/(m^3 s)] of the factor F. From Re = 1e9 on, and without
 * viscosity, the drag coefficient is that of Re = 1e9. An averaged eps_f may be
 * above 1 by rounding or by an undershoot; F, with roots of 1 - eps_f, is then
 * that of eps_f = 1. */
static inline double drag_by_factor(double (*F)(double eps_f, double Re),
                                    double eps_f, double rho_f, double mu,
                                    double d, double u_r)
{
    const double fast = 1e9, Re = drag_reynolds(rho_f, mu, d, eps_f * u_r);
    const double eps = eps_f < 1.0 ? eps_f : 1.0;

    if (Re < fast) return 18.0 * mu / (d * d) * eps_f * F(eps, Re);
    return 18.0 * rho_f * eps_f * u_r / d * eps_f * F(eps, fast) / fast;
}

/* Drag after Di Felice. */

/* The exponent chi [-] of the fluid fraction [EW18 A.3]. */
double drag_di_felice_exponent(double Re);

/* Drag [N] without the mean pressure gradient [EW18 A.2]: u_r [m/s] is the
 * interstitial slip, of which the superficial one, eps u_r, is squared. */
double drag_di_felice_force(double eps, double rho_f, double mu, double d,
                            double u_r);

/* Drag after Beetstra and others. */

/* The factor g [-] to Stokes' law [EW18 A.6]; Re with the superficial slip. */
double drag_beetstra_factor(double eps, double Re);

/* 3 pi mu d u_r g [N], u_r [m/s] interstitial [EW18 A.5]: the whole force,
 * with the part of the mean pressure gradient. */
double drag_beetstra_force(double eps, double rho_f, double mu, double d,
                           double u_r);

#endif
