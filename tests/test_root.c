/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/power.h"
#include "base/root.h"
#include "dem/contact_hertz.h"
#include "facts.h"

#include <float.h>

enum { TRIES = 300000 };

/* From 1e-37 to 1e37, at random in each of TRIES equal parts of the logarithm.
 */
static double nth(int i)
{
    return pow(10.0,
               74.0 * (i + 0.6180339887 * (i % 97) / 97.0) / TRIES - 37.0);
}

/* [-] in units of the last place of `want`, which has more digits */
static double units_off(double got, long double want)
{
    const double below = (double)want;
    return (double)fabsl(got - want) / (nextafter(below, HUGE_VAL) - below);
}

/* The error of each is 1.42 and 0.95 units. */
FACT(inverse_roots_are_right_to_two_units_in_the_last_place)
{
    double worst[2] = {0.0};

    for (int i = 0; i < TRIES; i++) {
        const double x = nth(i);
        const long double root = sqrtl((long double)x);
        worst[0] = fmax(worst[0], units_off(root_inverse(x), 1.0L / root));
        worst[1] = fmax(worst[1],
                        units_off(root_inverse_fourth(x), 1.0L / sqrtl(root)));
    }
    ck_assert_double_le(worst[0], 2.0);
    ck_assert_double_le(worst[1], 2.0);
}

/* x^a with x from 1e-37 to 1e37 and a of the drag laws, and as much below 0,
 * over the error that is allowed. */
static double power_off(double x, double a)
{
    const long double want = powl((long double)x, (long double)a);
    const double got = power_exp(a * power_log(x));
    const double allowed = (2.0 + fabs(a * log(x))) * DBL_EPSILON;

    return (double)fabsl(got / want - 1.0L) / allowed;
}

/* The worst is 0.94 of what is allowed. */
FACT(powers_without_a_call_are_right_to_rounding)
{
    static const double powers[] = {4.14, 2.65, 1.28, 0.5, -1.0, -2.65, 1e-9};
    double worst = 0.0;

    for (int i = 0; i < TRIES; i += 3)
        for (int k = 0; k < 7; k++)
            worst = fmax(worst, power_off(nth(i), powers[k]));
    for (int i = 1; i <= TRIES; i++) /* fluid fractions */
        worst = fmax(worst, power_off((double)i / TRIES, powers[i % 7]));
    ck_assert_double_le(worst, 1.0);
    ck_assert_double_eq(power_exp(4.14 * power_log(1.0)), 1.0);
}

/* Spheres of 1e-10 m to 100 m with overlaps of 1e-16 to 1 of their radius. The
 * five numbers are products of a few, each right to some units. */
FACT(hertz_in_the_contact_loop_is_that_of_the_reference)
{
    static const struct contact_constants k = {
        .normal = 1.2e7, .tangential = 4e6, .damping_n = 0.3, .damping_t = 0.7};
    for (double R = 0.5e-10; R < 100.0; R *= 3.1)
        for (double part = 1e-16; part < 1.0; part *= 1.7) {
            const double m = 4000.0 * R * R * R, delta = part * R;
            const struct contact_response want =
                contact_hertz_respond(&k, delta, R, m);
            const struct contact_response got =
                contact_hertz_quick(&k, delta, R, sqrt(m));
            const double w[] = {want.elastic, want.stored, want.eta_n, want.k_t,
                                want.eta_t};
            const double g[] = {got.elastic, got.stored, got.eta_n, got.k_t,
                                got.eta_t};
            for (int q = 0; q < 5; q++)
                ck_assert_double_eq_tol(g[q], w[q], 10.0 * DBL_EPSILON * w[q]);
        }
}
