/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/energy.h"

double energy_residual(const struct energy *e)
{
    return e->kinetic + e->normal + e->tangential + e->damped_n + e->damped_t +
           e->slid + e->released + e->rolled - e->work - e->brought;
}

struct energy energy_collect(const struct neighbours *nb, double elastic)
{
    struct energy e = {.brought = 0.0};

    for (int s = 0; s < nb->count; s++) {
        const struct strip *const own = &nb->strips[s];
        const struct strip_energy *const part = &own->energy;
        e.kinetic += own->measures.translation + own->measures.rotation;
        e.normal += elastic * part->normal;
        e.tangential += part->tangential;
        e.damped_n += part->damped_n;
        e.damped_t += part->damped_t;
        e.slid += part->slid;
        e.released += part->released;
        e.rolled += part->rolled;
        e.work += part->work;
    }
    return e;
}
