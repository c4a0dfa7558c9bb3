/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/basset.h"

#include <gsl/gsl_math.h>
#include <math.h>

#include "base/number.h"

/* How long the past counts, over the step: what is older has faded in the
 * slowest term. */
static const double longest = 1e6;

/* The spacing makes the error of the rule, 2 exp(-pi^2/q), half of the
 * tolerance; the ends are where what is cut off is that small. The two add up
 * at the far end, with a tenth for the term that the end halves. */
struct basset_kernel basset_kernel_create(double dt, double tolerance)
{
    const double half = tolerance / 2.2;
    const double q = M_PI * M_PI / log(2.0 / half);
    const double low = log(gsl_pow_2(half) * M_PI / (4.0 * longest * dt));
    const double high = log(log(2.0 / half) / dt);
    const double terms = 1.0 + ceil((high - low) / q);
    struct basset_kernel k = {.n = number_clamped(terms, 1, BASSET_TERMS)};

    for (int i = 0; i < k.n; i++) {
        const double y = low + i * q;
        k.s[i] = exp(y);
        k.c[i] = q * exp(0.5 * y) / M_SQRTPI;
    }
    return k;
}

double basset_kernel_value(const struct basset_kernel *k, double t)
{
    double sum = 0.0;

    for (int i = 0; i < k->n; i++)
        sum += k->c[i] * exp(-k->s[i] * t);
    return sum;
}

double basset_coefficient(double rho, double mu, double d)
{
    return 1.5 * d * d * sqrt(M_PI * rho * mu);
}

double basset_force(double rho, double mu, double d, double t, double rate)
{
    return basset_coefficient(rho, mu, d) * 2.0 * sqrt(t) * rate; /* [LS 5.4] */
}
