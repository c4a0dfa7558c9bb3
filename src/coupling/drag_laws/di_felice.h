/* di_felice.h -- drag after Di Felice.  Chapter "Drag". */
#ifndef COUPLING_DRAG_LAWS_DI_FELICE_H
#define COUPLING_DRAG_LAWS_DI_FELICE_H

/* The exponent chi [-] of the fluid fraction [EW18 A.3]. */
double drag_di_felice_exponent(double Re);

/* Drag [N] without the mean pressure gradient [EW18 A.2]: u_r [m/s] is the
 * interstitial slip, of which the superficial one, eps u_r, is squared. */
double drag_di_felice_force(double eps, double rho_f, double mu, double d,
                            double u_r);

#endif
