/* stochastic_drag.h -- the random part of the drag.  Chapter "Agitation".
 *
 * The fluctuations that the averaging removes act on each particle as a random
 * force: its drag coefficient is C_d + C' [EW18 32], and C' is a correlated
 * signal,
 *
 *   C'(t + dt) = a C'(t) + b sqrt(1 - a^2) w,   a = exp(-dt / T),   [EW18 33]
 *
 * with normal numbers w [EW18 34] and b = sigma(C_d). With a from dt it is
 * exact for any step: an Ornstein-Uhlenbeck process of the time T.
 */
#ifndef COUPLING_EFFECTS_STOCHASTIC_DRAG_H
#define COUPLING_EFFECTS_STOCHASTIC_DRAG_H

/* The correlation a [-] after a step, and T [s] from a [EW18 37]. */
double stochastic_drag_memory(double dt, double T);
double stochastic_drag_time(double a, double dt);

/* C' after a step [EW18 33]. */
double stochastic_drag_step(double a, double b, double C, double w);

/* Mean and variance of C' that are to be expected n steps after it was C
 * [EW18 35, 36]; the document prints a^(n dt) for a^n. */
double stochastic_drag_mean(double a, double n, double C);
double stochastic_drag_variance(double a, double b, double n);

/* sigma(C_d) [-] at Re_p [-]: low at Re_low and high at Re_high, held beyond,
 * between them a power of Re_p, or linear where that is asked for or low is 0.
 */
struct stochastic_drag_sigma {
    double low, high;
    double Re_low, Re_high;
    int linear;
};
double stochastic_drag_sigma(const struct stochastic_drag_sigma *s, double Re);

#endif
