/* beetstra.h -- drag after Beetstra and others.  Chapter "Drag". */
#ifndef COUPLING_DRAG_LAWS_BEETSTRA_H
#define COUPLING_DRAG_LAWS_BEETSTRA_H

/* The factor g [-] to Stokes' law [EW18 A.6]; Re with the superficial slip. */
double drag_beetstra_factor(double eps, double Re);

/* 3 pi mu d u_r g [N], u_r [m/s] interstitial [EW18 A.5]: the whole force,
 * with the part of the mean pressure gradient. */
double drag_beetstra_force(double eps, double rho_f, double mu, double d,
                           double u_r);

#endif
