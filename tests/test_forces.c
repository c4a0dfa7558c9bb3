/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The forces besides drag: virtual mass, pressure, and their reactions on the
 * fluid. */
#include "averaging/cell_of_particle.h"
#include "coupling/coupling.h"

#include <omp.h>

#include "facts.h"
#include "suspension.h"

/* Density of the spheres over that of the fluid: sand in air is far above. */
static const double ratios[] = {10.0, 2.65, 1.0, 0.1};

/* Without friction to speak of: over the few steps of a test the drag changes
 * a velocity by less than 1e-9 of itself. */
static struct scene inviscid(double ratio)
{
    struct scene s = air;

    s.one_way = s.substeps = 1;
    s.n = 1;
    s.rho = 1000.0;
    s.rho_s = ratio * s.rho;
    s.mu = 1e-13;
    s.drag = "schiller-naumann";
    s.virtual_mass = 0.5;
    return s;
}

static void let_go(struct simulation *sim, double u)
{
    for (int i = 0; i < sim->particles->n; i++)
        sim->particles->vx[i] = sim->particles->vy[i] = sim->particles->vz[i] =
            0.0;
    for (int c = 0; c < sim->mesh->n_cells; c++)
        sim->fluid->u[3 * c] = u;
    for (int f = 0; f < sim->mesh->n_faces; f++)
        sim->fluid->phi[f] = u * mesh_S(sim->mesh, f)[0];
    coupling_start(sim);
}

/* A sphere of the fluid's density that only the effect of its name acts on,
 * apart from the steps: the field is the test's. */
static struct scene held(double virtual_mass)
{
    struct scene s = inviscid(1.0);

    s.averaging = "pcm";
    s.pressure_gradient = 0;
    s.virtual_mass = virtual_mass;
    s.viscous_stress = virtual_mass == 0.0;
    s.mu = 0.7;
    return s;
}

/* The held force [N] of the first effect on the sphere where the cell is. */
static const double *force_in(struct simulation *sim, int cell)
{
    const double *const at = &sim->mesh->centre[3 * cell];
    const struct effect_state *const e = &sim->effects[0];

    sim->particles->x[0] = at[0];
    sim->particles->y[0] = at[1];
    sim->particles->z[0] = at[2];
    averaging_bind(sim->averaging);
    memset(sim->held_force, 0, 3 * sizeof *sim->held_force);
    e->effect->before_particles(e->memory, sim);
    return sim->held_force;
}

/* (rho_s + rho/2) dv/dt = (rho_s - rho) g from rest: light spheres rise with
 * up to 2 g, not with 9 g. The drag of 10 steps, 0.44 of the dynamic pressure,
 * comes to 3 C_d v^2/(4 d (ratio + 1/2)) t, below 1e-5 of v after 1e-4 s. */
FACT_FOR_EACH(ls_5_3_a_released_sphere_falls_with_its_added_mass, 4)
{
    struct scene s = inviscid(ratios[_i]);
    s.gravity[1] = -9.81;
    s.dt = 1e-6;
    struct simulation *const sim = build(&s);
    const double g = s.gravity[1] * (ratios[_i] - 1.0) / (ratios[_i] + 0.5);

    let_go(sim, 0.0);
    run(sim, 10);
    ck_assert_double_eq_tol(sim->particles->vy[0], g * 1e-5,
                            1e-5 * fabs(g) * 1e-5 + 1e-18);
    discard(sim);
}

/* A fluid that is accelerated as a whole accelerates a sphere: pressure and
 * virtual mass give (ratio + C) dv/dt = (1 + C) du/dt, so that a sphere of the
 * fluid's density moves with it and a lighter one moves faster. The first step
 * has no earlier field and so only the pressure: it is left out. */
FACT_FOR_EACH(ls_5_3_an_accelerating_stream_takes_a_light_sphere_ahead, 4)
{
    struct scene s = inviscid(ratios[_i]);
    const double step = 1e-6, a = 5.0;
    s.dt = step;
    s.mean_gradient = -a * s.rho;
    struct simulation *const sim = build(&s);

    let_go(sim, 0.0);
    run(sim, 1);
    const double v = sim->particles->vx[0], u = sim->fluid->u[0];
    ck_assert_double_eq_tol(u, a * step, 1e-12 * u);
    run(sim, 10);
    ck_assert_double_eq_tol(sim->particles->vx[0] - v,
                            1.5 / (ratios[_i] + 0.5) * (sim->fluid->u[0] - u),
                            1e-4 * u);
    discard(sim);
}

/* u . grad u: a steady stream that speeds up along its way. u = c x between
 * the centres gives c^2 x; this is the acceleration that acts on a free sphere
 * there. */
FACT(ls_5_3_a_converging_stream_accelerates_what_is_in_it)
{
    const struct scene s = held(0.5);
    struct simulation *const sim = build(&s);
    const struct mesh *const m = sim->mesh;
    const double c = 3.0, dx = s.size / s.cells;
    const int host = m->n_cells / 2 + s.cells / 2;
    const double *force = NULL;

    for (int i = 0; i < 2; i++) { /* twice, so that the field has an earlier
                                     level, which is the same */
        for (int k = 0; k < m->n_cells; k++)
            sim->fluid->u[3 * k] = c * m->centre[3 * k];
        for (int f = 0; f < m->n_internal; f++)
            sim->fluid->phi[f] =
                c * mesh_S(m, f)[0] *
                (m->centre[3 * m->owner[f]] + 0.5 * mesh_d(m, f)[0]);
        force = force_in(sim, host);
        sim->steps = 1;
    }
    const double V = particles_volume(sim->particles, 0);
    ck_assert_double_gt(m->centre[3 * host], 2.0 * dx);
    ck_assert_double_eq_tol(force[0] / (0.5 * s.rho * V),
                            c * c * m->centre[3 * host], 1e-12);
    discard(sim);
}

/* The momentum of the added mass is taken from the fluid: 4 densities x 2
 * treatments x 2 relaxations x both forms of the momentum equation. 1e-12: as
 * in test_coupling. Light spheres would be unstable without the added mass. */
FACT_FOR_EACH(ls_5_3_virtual_mass_and_model_b_keep_total_momentum, 32)
{
    struct scene s = air;
    double before[3], after[3];
    s.rho = 1000.0;
    s.mu = 1e-3;
    s.rho_s = ratios[_i % 4] * s.rho;
    s.virtual_mass = 0.5;
    s.treatment = _i / 4 % 2 ? TREATMENT_EXPLICIT : TREATMENT_SEMI_IMPLICIT;
    s.relaxation =
        _i / 8 % 2 ? SLIP_INTEGRATION_EXPONENTIAL : SLIP_INTEGRATION_FROZEN;
    s.model_b = _i / 16 % 2;
    struct simulation *const sim = build(&s);
    coupling_total_momentum(sim, before);
    const double scale = gross_momentum(sim) + fabs(before[0]);
    run(sim, 10);
    coupling_total_momentum(sim, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_lt(
            fabs(after[k] - before[k] - sim->fluid->relabelled[k]),
            1e-12 * scale);
    for (int i = 0; i < s.n; i++) /* bounded by the initial velocities */
        ck_assert_double_lt(fabs(sim->particles->vx[i]), 0.6);
    discard(sim);
}

/* The stress alone acts on the sphere in the centre of a cell, along one axis,
 * by the volume times this gradient [Pa/m]. */
static void is_pushed_along(struct simulation *sim, int cell, int axis,
                            double gradient, double tolerance)
{
    const double *const force = force_in(sim, cell);
    const double f = particles_volume(sim->particles, 0) * gradient;

    ck_assert_double_eq_tol(force[axis], f, tolerance * f);
    ck_assert_double_lt(fabs(force[1 - axis]), tolerance * f);
}

/* u_x = a y^2 between the centres: lap u = 2 a in every cell but those at the
 * ends, wherever the sphere is. */
FACT(ls_5_1_the_stress_of_a_parabola_pushes_by_the_volume)
{
    const struct scene s = held(0.0);
    struct simulation *const sim = build(&s);
    const struct mesh *const m = sim->mesh;
    const int host = m->n_cells / 2 + s.cells / 2 * s.cells + s.cells / 2;
    const double a = 3.0;

    for (int c = 0; c < m->n_cells; c++) {
        sim->fluid->u[3 * c] = a * gsl_pow_2(m->centre[3 * c + 1]);
        sim->fluid->u[3 * c + 1] = -5.0 * m->centre[3 * c]; /* shear: none */
    }
    is_pushed_along(sim, host, 0, s.mu * 2.0 * a, 1e-10);
    discard(sim);
}

/* The same of u_y = a x^2 where links are oblique: without the rest of S, the
 * terms along x and along the slanted links would add up to 1 + 2 s^2 times
 * it. */
FACT(ls_5_1_oblique_links_do_not_change_the_stress_of_a_parabola)
{
    struct scene s = held(0.0);
    s.shear = 0.5;
    struct simulation *const sim = build(&s);
    const struct mesh *const m = sim->mesh;
    const int host =
        mesh_cell_at(m, 0.65 * s.size, 0.55 * s.size, 0.55 * s.size);
    const double a = 3.0;

    for (int c = 0; c < m->n_cells; c++)
        sim->fluid->u[3 * c + 1] = a * gsl_pow_2(m->centre[3 * c]);
    is_pushed_along(sim, host, 1, s.mu * 2.0 * a, 1e-9);
    discard(sim);
}

/* A decaying shear wave: the force of the stress on the sphere is that on the
 * fluid in its place, rho V du/dt, to the tolerance of the predictor. */
FACT(ls_5_1_a_sphere_is_slowed_like_the_fluid_in_its_place)
{
    struct scene s = held(0.0);
    s.mu = 10.0;
    struct simulation *const sim = build(&s);
    const struct mesh *const m = sim->mesh;

    for (int f = 0; f < m->n_faces; f++)
        sim->fluid->phi[f] = 0.0;
    for (int c = 0; c < m->n_cells; c++)
        sim->fluid->u[3 * c] = sin(2.0 * M_PI * m->centre[3 * c + 1] / s.size);
    const int host = averaging_cells(sim->averaging)->cell[0];
    const double before = sim->fluid->u[3 * host];
    run(sim, 1);
    const double decay = (sim->fluid->u[3 * host] - before) / s.dt;
    const double force = s.rho * particles_volume(sim->particles, 0) * decay;
    ck_assert_double_gt(fabs(decay), 100.0); /* [m/s^2] not zero */
    ck_assert_double_eq_tol(sim->held_force[0], force, 1e-8 * fabs(force));
    discard(sim);
}

/* The fluid receives the reaction: explicit and implicit drag, frozen and
 * relaxed, model A and B, in a liquid thick enough for stress to matter. 1e-12
 * as above. */
FACT_FOR_EACH(ls_5_1_viscous_stress_keeps_total_momentum, 4)
{
    struct scene s = air;
    double before[3], after[3];
    s.viscous_stress = 1;
    s.rho = 1000.0;
    s.mu = 0.5;
    s.substeps = 10;
    s.relaxation = SLIP_INTEGRATION_EXPONENTIAL;
    s.treatment = _i % 2 ? TREATMENT_EXPLICIT : TREATMENT_SEMI_IMPLICIT;
    s.model_b = _i / 2 % 2;
    s.dt = _i % 2 ? 1e-6 : 2e-4;
    struct simulation *const sim = build(&s);
    coupling_total_momentum(sim, before);
    const double scale = gross_momentum(sim) + fabs(before[0]);
    run(sim, 40);
    coupling_total_momentum(sim, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_lt(
            fabs(after[k] - before[k] - sim->fluid->relabelled[k]),
            1e-12 * scale);
    discard(sim);
}

/* Largest difference of a velocity between the two forms after 2 ms, before any
 * two of 64 spheres in a liquid meet. */
static double difference(int halvings)
{
    double vx[64], most = 0.0;

    for (int form = 0; form < 2; form++) {
        struct scene s = air;
        s.dt /= 1 << halvings;
        s.n = 64;
        s.rho = 100.0;
        s.mu = 1e-3;
        s.model_b = form;
        s.gravity[1] = -9.81;
        struct simulation *const sim = build(&s);
        run(sim, 10 << halvings);
        for (int i = 0; i < s.n; i++) {
            const int id = sim->particles->id[i];
            const double v = sim->particles->vx[i];
            if (form == 1) most = fmax(most, fabs(v - vx[id]));
            if (form == 0) vx[id] = v;
        }
        discard(sim);
    }
    return most;
}

/* The same forces, with the reaction at once (A) or a step later (B): the
 * trajectories differ by what a step is worth, and half of it with half the
 * step. */
FACT(sx15_2b_models_a_and_b_agree_as_the_step_goes_to_zero)
{
    const double coarse = difference(0), fine = difference(2);

    ck_assert_double_lt(coarse, 1e-5); /* of 0.5 m/s */
    ck_assert_double_gt(coarse / fine, 3.4);
    ck_assert_double_lt(coarse / fine, 4.6);
}
