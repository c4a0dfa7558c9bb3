/* SPDX-License-Identifier: GPL-3.0-or-later */
/* advance.c -- divides a step where its Courant number would be too large. */

#include "fluid/piso.h"

#include <math.h>
#include <stddef.h>

/* Largest Courant number of a cell divided by the step: half the sum of the
 * fluxes through the cell over its fluid volume [1/s]. */
static double fastest_cell(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double fastest = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        double through = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
            through += 0.5 * fabs(fl->phi[m->cell_face[a]]);
        fastest = fmax(fastest, through / (fl->eps[c] * m->V[c]));
    }
    return fastest;
}

/* The same for the cells at inlets, with the inflow at time t: before the first
 * step only the inflow is known. */
static double fastest_inlet(const struct fluid *fl, double t)
{
    const struct mesh *const m = fl->mesh;
    double fastest = 0.0;

    FOR_EACH_BOUNDARY_FACE (fl, b, j, f) {
        if (b->kind != BOUNDARY_INLET) continue;
        const int c = m->owner[f];
        const double U =
            boundary_inlet_velocity(b, t) * boundary_inlet_profile(b, j, t);
        fastest = fmax(fastest, fabs(U) * sqrt(fl->geometry->SS[f]) /
                                    (fl->eps[c] * m->V[c]));
    }
    return fastest;
}

int fluid_advance(struct fluid *fl, double dt)
{
    double left = dt, cfl = 0.0;
    int parts = 0, failed = 0;

    while (parts == 0 || (left > 1e-9 * dt && !failed)) {
        double n = 1.0;
        if (fl->options.cfl > 0.0)
            n = fmax(1.0, ceil(left / fl->options.cfl *
                               fmax(fastest_cell(fl),
                                    fastest_inlet(fl, fl->t + left))));
        n = shared_largest(fl->options.shared, n);
        fl->options.dt = left / n;
        left -= fl->options.dt;
        failed = fluid_step(fl);
        cfl = fmax(cfl, fl->report.cfl);
        parts++;
    }
    fl->report.cfl = cfl;
    fl->report.flow_substeps = parts;
    return failed;
}
