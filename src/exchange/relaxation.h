/* relaxation.h -- the drag on a particle during one sub-step.  Chapter 20.
 *
 * Within a sub-step of length T the rate k, the fluid velocity u and all other
 * forces F stand still; the particle's own velocity does not:
 *
 *   m dv/dt = k (u - v) + F
 *
 * With x = k T / m the mean drag over the sub-step and the particle's mean
 * velocity are
 *
 *   f = k (u - v_0) - (1 - phi_1) (k (u - v_0) + F)
 *   v_mean = v_0 + phi_2 (k (u - v_0) + F) T / m
 *
 * so that f = k (u - v_mean), whatever phi_1 and phi_2 = (1 - phi_1) / x are.
 * frozen       phi_1 = 1: the drag of the sub-step's start [XS11 3.18].
 * exponential  phi_1 = (1 - e^-x) / x: the exact solution. A particle never
 *              overshoots the fluid, however long the sub-step is.
 */
#ifndef RELAXATION_H
#define RELAXATION_H

struct relaxation {
    const char *name, *cite, *what;
    double (*lag)(double x); /* [-] phi_2 */
};

/* All of them, ended by a row without a name; relaxation_named: NULL if the
 * name is unknown. */
extern const struct relaxation relaxations[];
const struct relaxation *relaxation_named(const char *name);

/* (1 - phi_1(x)) / x = (x - 1 + e^-x) / x^2 of the exponential [-], to
 * rounding for all x >= 0. */
double relaxation_lag(double x);

#endif
