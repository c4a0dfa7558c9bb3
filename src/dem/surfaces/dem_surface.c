/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/dem_surface.h"

#include <string.h>

#include "dem/fast/fast.h"

struct dem_surface dem_surface(const struct dem *dem, int k)
{
    const struct surface_received a =
        surfaces_received(fast_of(dem)->neighbours->surfaces, k);
    struct dem_surface r = {.work = a.work,
                            .t = (double)dem->motion_steps * dem->options.step};

    r.pose = motion_pose(&dem->options.surfaces[k].motion, r.t);
    memcpy(r.force, a.force, sizeof r.force);
    memcpy(r.impulse, a.impulse, sizeof r.impulse);
    memcpy(r.angular, a.angular, sizeof r.angular);
    return r;
}
