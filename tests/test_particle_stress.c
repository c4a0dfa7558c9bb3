/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laws of a stress in the place of contacts. The rest are facts of runs:
 * tests/tables/stress.txt. */
#include "coupling/effects/forces.h"

#include <math.h>

#include "facts.h"

static const struct particle_stress_law laws[] = {
    {.exponent = 2.0, .packing = 0.6},
    {.exponent = 3.0, .packing = 0.64},
    {.lun = 1, .packing = 0.6, .e = 0.9}};

static const double fractions[] = {1e-6, 0.01, 0.3, 0.55, 0.599, 0.5999999};
enum { FRACTIONS = sizeof fractions / sizeof *fractions };

START_TEST(a_stress_has_its_fraction_and_its_slope)
{
    const struct particle_stress_law *const law = &laws[_i];

    for (int k = 0; k < FRACTIONS; k++) {
        const double eps = fractions[k], tau = particle_stress(law, 7.0, eps);
        const double h = 1e-3 * fmin(eps, law->packing - eps);
        const double slope = (particle_stress(law, 7.0, eps + h) -
                              particle_stress(law, 7.0, eps - h)) /
                             (2.0 * h);
        ck_assert_double_eq_tol(particle_stress_fraction(law, 7.0, tau) / eps,
                                1.0, 1e-10);
        ck_assert_double_eq_tol(particle_stress_slope(law, 7.0, eps) / slope,
                                1.0, 1e-5);
    }
}
END_TEST

/* For a stress of any size the fraction is below that of the packing. */
START_TEST(no_stress_is_too_large_for_the_packing)
{
    for (double tau = 1e-30; tau < 1e12; tau *= 10.0) {
        const double eps = particle_stress_fraction(&laws[_i], 1e-3, tau);
        ck_assert_double_gt(eps, 0.0);
        ck_assert_double_le(eps, laws[_i].packing);
    }
}
END_TEST

/* Two facts by hand: 0.4^2 P/0.2; and of elastic grains Z = 1 + 4 eps g_0, of
 * which a source that halves the collisions has 1 + 2 eps g_0. */
START_TEST(snider01_lun84_stresses_have_their_values)
{
    const struct particle_stress_law elastic = {
        .lun = 1, .packing = 0.6, .e = 1.0};
    const double g_0 = 0.6 / (1.0 - 0.5); /* of an eighth of the packing */

    ck_assert_double_eq_tol(particle_stress(&laws[0], 10.0, 0.4), 8.0, 1e-13);
    ck_assert_double_eq_tol(particle_stress(&elastic, 10.0, 0.075),
                            0.75 * (1.0 + 4.0 * 0.075 * g_0), 1e-13);
}
END_TEST

FACTS("particle_stress")
{
    FACT_FOR_EACH(a_stress_has_its_fraction_and_its_slope, 3);
    FACT_FOR_EACH(no_stress_is_too_large_for_the_packing, 3);
    FACT(snider01_lun84_stresses_have_their_values);
}
