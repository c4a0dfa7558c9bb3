/* fluidization.h -- minimum fluidization.  Chapter "Drag". */
#ifndef COUPLING_DRAG_LAWS_FLUIDIZATION_H
#define COUPLING_DRAG_LAWS_FLUIDIZATION_H

/* The superficial velocity u_mf [m/s] at which Ergun's pressure drop carries
 * the weight of a bed of the fluid fraction eps_mf less its buoyancy [EW18 22];
 * g [m/s^2]. 0 for a bed that is not heavier than the fluid. */
double fluidization_velocity(double eps_mf, double rho_f, double rho_s,
                             double mu, double d, double g);

#endif
