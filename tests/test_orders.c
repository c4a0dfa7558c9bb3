/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The order in the step of each force of the fluid (orders.h). */
#include "orders.h"

#include "facts.h"

/* With steps of a twentieth of the time, and a quarter and a sixteenth of them:
 * order one, to a tenth. What a step takes as constant, the stream of its end
 * and the coefficients of its start, is of this order, and so is a reaction of
 * the particles that acts on the fluid a step late. The history force alone is
 * better: order 1.5, of the root of the time after the throw. The least error
 * is 1e-4; that no scene is exact by chance. */
FACT_FOR_EACH(ls_5_8_order_in_the_step_of_each_force, ORDERS)
{
    const int n = orders_all[_i].steps;
    const int history = orders_all[_i].miss == orders_history;
    const double coarse = orders_all[_i].miss(4 * n);
    const double fine = orders_all[_i].miss(16 * n);
    const double order = log2(coarse / fine) / 2.0;

    ck_assert_msg(fabs(order - (history ? 1.5 : 1.05)) < 0.15,
                  "%s: order %g, %g and %g", orders_all[_i].what, order, coarse,
                  fine);
    ck_assert_double_lt(fine, 3e-3);
    ck_assert_double_gt(fine, 1e-5);
}

static const double ratios[] = {0.05, 0.1, 0.3, 1.0, 1.7, 2.65, 8.0, 50.0};

/* A sphere thrown into a fluid at rest, whose slip begins with a jump, from a
 * 20th of its density on to 50 times it: alone, and many in a closed box, where
 * the fluid takes up what they lose. 80 steps in two relaxation times: 4e-3;
 * without the history the slip is a fifth too small at the least. */
FACT_FOR_EACH(ls_5_4_a_thrown_sphere_slows_as_boussinesq_basset_oseen, 16)
{
    const int two_way = _i / 8;
    const struct scene s = orders_spheres(two_way);

    ck_assert_double_lt(orders_relax(&s, ratios[_i % 8], 80), 4e-3);
}
