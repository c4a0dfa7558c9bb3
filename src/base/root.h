/* root.h -- 1 over roots, for the loops in which they take most of the time.
 *
 * A processor takes as long for eight roots or divisions in double precision as
 * for some thirty additions, and for single precision a fourth of that. So the
 * roots are made in single precision, and a step of third order follows:
 * x^(-1/n) = y (1 - h)^(-1/n) with h = 1 - x y^n, which is of the size of the
 * error of y, 1e-7.
 *
 * For 1e-37 <= x <= 1e37 the error is at most two units in the last place
 * (test_root.c); elsewhere sqrt is to be used.
 */
#ifndef BASE_ROOT_H
#define BASE_ROOT_H

#include <math.h>

/* x^(-1/2) */
static inline double root_inverse(double x)
{
    const double y = (double)(1.0F / sqrtf((float)x));
    const double h = 1.0 - x * y * y;

    return y + y * h * (0.5 + 0.375 * h);
}

/* x^(-1/4) */
static inline double root_inverse_fourth(double x)
{
    const double y = (double)(1.0F / sqrtf(sqrtf((float)x)));
    const double y2 = y * y, h = 1.0 - x * y2 * y2;

    return y + y * h * (0.25 + 0.15625 * h);
}

#endif
