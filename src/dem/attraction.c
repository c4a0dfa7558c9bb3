/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/attraction.h"

#include "dem/implicit_drag.h"

double attraction_damp(const struct attraction *a, double R_star, double gap,
                       double closing, double per_mass, double dt)
{
    const double c = a->law->damping(a, R_star, gap);
    return c * implicit_drag_gain(2.0 * c * per_mass * dt) * closing;
}
