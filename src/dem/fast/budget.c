/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/budget.h"

#include <stddef.h>

/* (1/2) m_a v^2 of the added mass (implicit_drag.h). */
static double added_mass_energy(const struct bodies *b)
{
    double sum = 0.0;

    for (int i = 0; i < b->n && b->implicit_drag != NULL; i++) {
        const double *const v = b->velocity[i];
        const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        sum += 0.5 * (1.0 / b->implicit_drag[i][3] - 1.0 / v[7]) * v2;
    }
    return sum;
}

static void budget_add(struct energy *e, const struct chunk_energy *part)
{
    e->normal += part->normal;
    e->tangential += part->tangential;
    e->damped_n += part->damped_n;
    e->damped_t += part->damped_t;
    e->slid += part->slid;
    e->released += part->released;
    e->rolled += part->rolled;
    e->work += part->work;
    e->attracted += part->attracted;
    e->walls += part->prescribed;
}

struct energy budget_collect(const struct neighbours *nb)
{
    struct energy e = {.kinetic = added_mass_energy(nb->bodies)};

    for (int s = 0; s < nb->n_chunks; s++) {
        const struct chunk *const own = &nb->chunks[s];
        e.kinetic += own->measures.translation + own->measures.rotation +
                     own->energy.ahead;
        budget_add(&e, &own->energy);
        if (nb->surfaces != NULL)
            budget_add(&e, surfaces_energy(nb->surfaces, s));
    }
    return e;
}
