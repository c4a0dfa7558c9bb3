/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/energy.h"

#include <stddef.h>

double energy_residual(const struct energy *e)
{
    return e->kinetic + e->normal + e->tangential + e->damped_n + e->damped_t +
           e->slid + e->released + e->rolled - e->work - e->attracted -
           e->walls - e->brought;
}

/* (1/2) m_a v^2 of the added mass (response.h). */
static double taken_along(const struct bodies *b)
{
    double sum = 0.0;

    for (int i = 0; i < b->n && b->response != NULL; i++) {
        const double *const v = b->motion[i];
        const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        sum += 0.5 * (1.0 / b->response[i][3] - 1.0 / v[7]) * v2;
    }
    return sum;
}

static void add(struct energy *e, const struct strip_energy *part,
                double elastic)
{
    e->normal += elastic * part->normal;
    e->tangential += part->tangential;
    e->damped_n += part->damped_n;
    e->damped_t += part->damped_t;
    e->slid += part->slid;
    e->released += part->released;
    e->rolled += part->rolled;
    e->work += part->work;
    e->attracted += part->attracted;
    e->walls += part->driven;
}

struct energy energy_collect(const struct neighbours *nb, double elastic)
{
    struct energy e = {.kinetic = taken_along(nb->bodies)};

    for (int s = 0; s < nb->count; s++) {
        const struct strip *const own = &nb->strips[s];
        e.kinetic += own->measures.translation + own->measures.rotation;
        add(&e, &own->energy, elastic);
        if (nb->surfaces != NULL)
            add(&e, surfaces_energy(nb->surfaces, s), elastic);
    }
    if (nb->surfaces != NULL) e.walls += surfaces_work(nb->surfaces);
    return e;
}
