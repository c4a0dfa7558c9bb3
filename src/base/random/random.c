/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/random/random.h"

#include <gsl/gsl_cdf.h>
#include <stdint.h>

static const double two_to_53 = 9007199254740992.0;

static uint64_t mix(unsigned long seed, long i, long j, int which)
{
    const uint64_t part[4] = {seed, (uint64_t)i, (uint64_t)j, (uint64_t)which};
    uint64_t z = 0;

    for (int k = 0; k < 4; k++) {
        z += part[k] + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        z ^= z >> 31;
    }
    return z >> 11;
}

double random_uniform(unsigned long seed, long i, long j, int which)
{
    return (double)mix(seed, i, j, which) / two_to_53;
}

/* The middles of the 2^53 parts of 0 .. 1, so that neither 0 nor 1 is returned.
 */
double random_normal(unsigned long seed, long i, long j, int which)
{
    return gsl_cdf_ugaussian_Pinv(((double)mix(seed, i, j, which) + 0.5) /
                                  two_to_53);
}
