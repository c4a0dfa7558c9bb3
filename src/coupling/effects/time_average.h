/* time_average.h -- exponential moving averages of the averaged fields.
 * Chapter "The coupled loop".
 *
 *   d<eps>/dt = (eps - <eps>) / b_t                            [SX15 11-13]
 *   <eps>^n = (1 - alpha) eps^n + alpha <eps>^(n-1)            [SX15 14]
 */
#ifndef COUPLING_EFFECTS_TIME_AVERAGE_H
#define COUPLING_EFFECTS_TIME_AVERAGE_H

struct time_average {
    int n;          /* [-] cells */
    double alpha;   /* [-] weight of the past in one step */
    double *eps;    /* [-] mean fluid fraction */
    double *eps_us; /* [m/s] mean of eps_s u_s, 3 a cell */
};

/* alpha = 1 / (1 + dt / b_t) [-] [SX15 14]. */
double time_average_weight(double dt, double b_t);

/* mean = (1 - alpha) now + alpha mean for n values [SX15 14]. */
void time_average_update(double alpha, int n, const double *now, double *mean);

#endif
