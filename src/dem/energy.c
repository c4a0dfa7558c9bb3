/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/energy.h"

double energy_residual(const struct energy *e)
{
    return e->kinetic + e->normal + e->tangential + e->damped_n + e->damped_t +
           e->slid + e->released + e->rolled - e->work - e->attracted -
           e->walls - e->added;
}

void energy_state(struct energy *e, struct state *s)
{
    double *const all[] = {&e->kinetic,   &e->normal,   &e->tangential,
                           &e->damped_n,  &e->damped_t, &e->slid,
                           &e->released,  &e->rolled,   &e->work,
                           &e->attracted, &e->walls,    &e->added};

    state_several(s, "energy", "J", all, sizeof all / sizeof *all);
}
