/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/prescribed.h"

void prescribed_move(const struct neighbours *nb, double t)
{
    const struct neighbours_share mine = neighbours_share(nb);

    if (nb->surfaces == NULL) return;
    for (int s = mine.first; s < mine.last; s++)
        surfaces_move(nb->surfaces, s, t);
}

void prescribed_steer(const struct neighbours *nb, double t, double dt)
{
    const struct neighbours_share mine = neighbours_share(nb);

    if (nb->drive == NULL) return;
    for (int s = mine.first; s < mine.last; s++)
        driven_steer(nb->drive, nb->bodies, nb->ps, nb->strips[s].begin,
                     nb->strips[s].end, NULL, t, dt);
}
