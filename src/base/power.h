/* SPDX-License-Identifier: GPL-3.0-or-later */
/* power.h -- powers x^a = exp(a ln x) for loops over many numbers, without a
 * call, a branch or a table, so that a vector unit takes eight of them at once.
 *
 * For x and x^a from 1e-300 to 1e300 the relative error is at most
 * (2 + |a ln x|) times that of rounding, 2^-52 (test_root.c); elsewhere, and
 * where one number is wanted, pow is to be used. */
#ifndef BASE_POWER_H
#define BASE_POWER_H

#include <stdint.h>
#include <string.h>

/* ln 2, the first with so few bits that its products with whole numbers up to
 * 2000 are exact. */
#define POWER_LN2 0x1.62e42fee00000p-1
#define POWER_LN2_REST 0x1.a39ef35793c76p-33

static inline double power_of_bits(uint64_t bits)
{
    double x;
    return *(double *)memcpy(&x, &bits, sizeof x);
}

static inline uint64_t power_bits(double x)
{
    uint64_t bits;
    return *(uint64_t *)memcpy(&bits, &x, sizeof bits);
}

/* ln x: x = 2^e m with m from sqrt(1/2) to sqrt(2), and ln m = 2 artanh(s) with
 * s = (m - 1) / (m + 1), |s| < 0.172. The bits are those of e + 1024, which is
 * positive, and of 2^52 + e + 1024. */
static inline double power_log(double x)
{
    const uint64_t bits = power_bits(x), root = 0x3fe6a09e667f3bcd;
    const uint64_t e = (bits - root + (1024ULL << 52)) >> 52;
    const double m = power_of_bits(bits - ((e - 1024) << 52));
    const double exponent =
        power_of_bits(0x4330000000000000 | e) - (0x1p52 + 1024.0);
    const double s = (m - 1.0) / (m + 1.0), q = s * s;
    double rest = 2.0 / 21.0;

#pragma GCC unroll 9
    for (int k = 19; k >= 3; k -= 2)
        rest = rest * q + 2.0 / k;
    return exponent * POWER_LN2 +
           (2.0 * s + (s * q * rest + exponent * POWER_LN2_REST));
}

/* exp(t) = 2^n exp(r) with n whole and |r| < 0.35; 1.5 * 2^52 rounds to whole
 * numbers, whose bits are then the last of the sum. */
static inline double power_exp(double t)
{
    const double whole = 0x1.8p52, sum = t * 0x1.71547652b82fep+0 + whole;
    const double n = sum - whole;
    const double r = (t - n * POWER_LN2) - n * POWER_LN2_REST;
    double series = 1.0;

#pragma GCC unroll 13
    for (int k = 13; k >= 1; k--)
        series = 1.0 + series * r * (1.0 / k);
    return series * power_of_bits((power_bits(sum) + 1023) << 52);
}

#endif
