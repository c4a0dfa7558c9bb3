/* brenner.h -- for tests: a sphere that comes near in a viscous fluid. */
#ifndef TESTS_BRENNER_H
#define TESTS_BRENNER_H

#include <math.h>

/* Force on a sphere that comes slowly to a plane wall, or on one of two that
 * meet, each at U, over 6 pi mu R U, at the gap z/R to the wall or to the other
 * one [Brenner61]. */
static inline double brenner_force(double gap, int of_two)
{
    const double a = acosh(1.0 + (of_two ? 0.5 : 1.0) * gap);
    double sum = 0.0;

    for (int n = 1; (n + 0.5) * a < 40.0; n++) {
        const double k = 2.0 * n + 1.0, s = sinh(0.5 * k * a),
                     c = cosh(0.5 * k * a), ks = k * sinh(a);
        const double term = of_two ? (4.0 * c * c + ks * ks) /
                                         (2.0 * sinh(k * a) - k * sinh(2.0 * a))
                                   : (2.0 * sinh(k * a) + k * sinh(2.0 * a)) /
                                         (4.0 * s * s - ks * ks);
        sum +=
            n * (n + 1.0) / ((2.0 * n - 1.0) * (2.0 * n + 3.0)) * (term - 1.0);
    }
    return 4.0 / 3.0 * sinh(a) * sum;
}

#endif
