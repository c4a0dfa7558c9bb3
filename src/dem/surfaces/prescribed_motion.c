/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/prescribed_motion.h"

void prescribed_motion_move_surfaces(const struct neighbours *nb, double t)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    if (nb->surfaces == NULL) return;
    for (int s = mine.first; s < mine.last; s++)
        surfaces_move(nb->surfaces, s, t);
}

void prescribed_motion_set_velocities(const struct neighbours *nb, double t,
                                      double dt)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    if (nb->prescribed == NULL) return;
    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        own->energy.prescribed += prescribed_particles_set_velocities(
            nb->prescribed, nb->bodies, nb->ps, own->begin, own->end, NULL, t,
            dt, 0.0);
    }
}
