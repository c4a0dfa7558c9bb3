/* exact.h -- solutions in time that runs can be held against. */
#ifndef CASE_REPORT_EXACT_H
#define CASE_REPORT_EXACT_H

/* Velocity after the time t of a particle at rest that a fluid of velocity u_f
 * takes along, du/dt = (u_f - u) / tau_p(|u_f - u|) with tau_p of
 * Syamlal-O'Brien at a constant solids fraction [m/s]; nan for t < 0.
 * [XS11 4.1] */
double exact_released(double rho_s, double eps_s, double rho_f, double mu,
                      double d, double u_f, double t);

#endif
