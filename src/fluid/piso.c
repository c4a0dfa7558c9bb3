/* SPDX-License-Identifier: GPL-3.0-or-later */
/* piso.c -- one step of the flow: the PISO algorithm. */
#include "fluid/piso.h"

#include <math.h>
#include <stddef.h>

#include "fluid/systems.h"
#include "linear/reduce.h"

/* Change of the total momentum by the subtracted term u times the residual of
 * continuity: rho dt sum u_P defect_P, with the weight of this step. */
static void count_relabelled(struct fluid *fl)
{
    const double scale = fl->options.rho * fl->options.dt * fl->impulse_weight;
    double sum[3] = {0.0, 0.0, 0.0};

    vec3_sum(fl->mesh->n_cells, fl->momentum->defect, fl->u, sum);
    for (int k = 0; k < 3; k++)
        fl->relabelled[k] += scale * sum[k];
}

/* Keeps the report of the solution with the most iterations, or that failed. */
static void keep_worst_report(struct solve_report *worst,
                              struct solve_report now)
{
    if (now.iterations > worst->iterations || !now.converged) *worst = now;
}

enum { MOST_CORRECTORS = 100 };

static void piso_correct(struct fluid *fl)
{
    keep_worst_report(&fl->report.pressure, pressure_correct(fl));
    gradient_update(fl);
    velocity_correct(fl);
    if (fl->options.shared != NULL)
        fl->options.shared->corrected(fl->options.shared->parts, fl);
    if (fl->immersed != NULL && fl->immersed->corrected != NULL)
        fl->immersed->corrected(fl->immersed, fl);
    fl->report.correctors++;
}

/* PISO as [XS11 section 3.2] lists it: predict the velocity with the old
 * pressure, then correct pressure, fluxes and velocity in turn. */
static void predict_and_correct(struct fluid *fl)
{
    momentum_assemble(fl);
    gradient_begin(fl);
    if (fl->options.coupled || fl->dt_older == 0.0)
        gradient_update(fl); /* with the present drag, or in the first step */
    keep_worst_report(&fl->report.momentum, velocity_predict(fl));
    velocity_predicted_sum(fl);
    pressure_assemble(fl);
    continuity_source(fl);
    boundary_face_inlet_fluxes(fl, fl->phi);
    for (int i = 0; i < fl->options.correctors; i++) {
        if (i > 0) velocity_neighbour_sum(fl);
        piso_correct(fl);
    }
}

/* The residual acts as a force in the next step. Beside the inertia it has to
 * be small too, or it keeps a flow in motion that would become steady; down to
 * a thousandth of the tolerance, and as long as a correction reduces it. */
static int must_correct(const struct fluid *fl, double before)
{
    const double tolerance = fl->options.piso_tolerance;
    const double residual = fl->report.piso_residual;

    if (tolerance == 0.0 || fl->report.correctors >= MOST_CORRECTORS) return 0;
    return residual > tolerance ||
           (residual > 1e-3 * tolerance && residual < before &&
            residual > 0.03 * fl->momentum->inertia);
}

/* Each corrector uses the velocities of the neighbours before it. Where
 * viscosity or a long step couples cells strongly, the residual after two
 * correctors is large, and would grow if it were added to the next step; then
 * more correctors follow. A central scheme adds nothing to the diagonal, and
 * above a Courant number of 1 its residual would grow from corrector to
 * corrector; it is removed by another prediction with the present pressure, in
 * which the velocities of the neighbours are unknowns. */
static void correct_further(struct fluid *fl)
{
    double before = INFINITY;
    int helps = 1;

    fl->report.piso_residual = velocity_residual(fl);
    while (must_correct(fl, before)) {
        const int again = helps && fl->report.piso_residual > before;

        if (again) {
            keep_worst_report(&fl->report.momentum, velocity_predict(fl));
            velocity_predicted_sum(fl);
            pressure_assemble(fl); /* the solver has used its arrays */
        }
        before = fl->report.piso_residual;
        piso_correct(fl); /* velocity_residual has set H to its present value */
        fl->report.piso_residual = velocity_residual(fl);
        if (again) helps = fl->report.piso_residual < before;
    }
}

/* One step; an outer iteration starts from the result of the previous one. */
int fluid_step(struct fluid *fl)
{
    struct fluid_report *const report = &fl->report;
    const double *const r = fl->relabelled;
    const double relabelled[3] = {r[0], r[1], r[2]};
    double before[3];

    fluid_momentum(fl, before);
    fl->t += fl->options.dt;
    ddt_begin(fl);
    if (fl->immersed != NULL) fl->immersed->begin(fl->immersed, fl);
    report->momentum = (struct solve_report){-1, 0.0, 0.0, 1};
    report->pressure = (struct solve_report){0, 0.0, 0.0, 1};
    report->correctors = 0;
    predict_and_correct(fl);
    for (int i = 0; i < fl->options.outer_correctors; i++) {
        ddt_renew_flux(fl);
        predict_and_correct(fl);
    }
    correct_further(fl);
    count_relabelled(fl); /* with the velocity that solves the equation */
    if (fl->immersed != NULL) fl->immersed->end(fl->immersed, fl);
    report->mass_residual = continuity_residual(fl);
    ddt_end(fl);
    report->momentum_residual =
        momentum_balance_residual(fl, before, relabelled);
    /* The sum is no number where a velocity is none, nor has the pressure
     * converged then. */
    const int failed =
        !(isfinite(report->momentum_residual) && report->pressure.converged &&
          report->momentum.converged);
    return fl->options.shared == NULL
               ? failed
               : fl->options.shared->finished(fl->options.shared->parts, fl,
                                              failed);
}

/* Divides a step where its Courant number would be too large. */

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
        fastest = fmax(fastest, fabs(U) * sqrt(piso_square(fl, f)) /
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
