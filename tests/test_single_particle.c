/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Case 3 of XS11: one grain accelerated by a stream. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "coupling/drag.h"
#include "facts.h"
#include "suspension.h"

static const double stream = 0.05, step = 1.1e-3; /* [m/s], [s] */

/* One way; the grain at rest, the stream along x. */
static struct scene grain(int substeps)
{
    struct scene s = air;

    s.n = s.one_way = 1;
    s.pressure_gradient = 0;
    s.rho = 1000.0;
    s.mu = 1e-3;
    s.rho_s = 2000.0;
    s.d = 8.3e-5;
    s.dt = step;
    s.dem_steps = 50;
    s.substeps = substeps;
    return s;
}

static struct simulation *let_go(const struct scene *s)
{
    struct simulation *const sim = build(s);

    sim->particles->vx[0] = sim->particles->vy[0] = sim->particles->vz[0] = 0.0;
    for (int c = 0; c < sim->mesh->n_cells; c++)
        sim->fluid->u[3 * c] = stream;
    for (int f = 0; f < sim->mesh->n_faces; f++)
        sim->fluid->phi[f] = stream * mesh_S(sim->mesh, f)[0];
    coupling_start(sim);
    return sim;
}

/* dv/dt = (beta/eps_s) (u - v) / rho_s, of one grain. */
static int acceleration(double t, const double v[], double dvdt[], void *scene)
{
    const struct scene *const s = scene;

    (void)t;
    dvdt[0] = drag_law_named(s->drag)->resistance(1.0, s->rho, s->mu, s->d,
                                                  fabs(stream - v[0])) *
              (stream - v[0]) / s->rho_s;
    return GSL_SUCCESS;
}

/* v(t) by a Runge-Kutta method of order 8, to 1e-10. */
static double exact(struct scene *s, double t)
{
    gsl_odeiv2_system system = {acceleration, NULL, 1, s};
    gsl_odeiv2_driver *const driver = gsl_odeiv2_driver_alloc_y_new(
        &system, gsl_odeiv2_step_rk8pd, 1e-6, 1e-12, 1e-10);
    double v[1] = {0.0}, now = 0.0;

    ck_assert_int_eq(gsl_odeiv2_driver_apply(driver, &now, t, v), GSL_SUCCESS);
    gsl_odeiv2_driver_free(driver);
    return v[0];
}

/* Frozen drag is explicit Euler: with 50 sub-steps of 0.044 tau the error is
 * at most x/(2 e) = 0.8 % of the stream, and with 25 it is twice that. */
FACT(xs11_4_1_sub_steps_converge_to_the_exact_course)
{
    double error[2];

    for (int i = 0; i < 2; i++) {
        struct scene s = grain(i == 0 ? 25 : 50);
        struct simulation *const sim = let_go(&s);
        run(sim, 1);
        error[i] = sim->particles->vx[0] - exact(&s, step);
        discard(sim);
    }
    ck_assert_double_lt(fabs(error[1]), 8e-3 * stream);
    ck_assert_double_eq_tol(error[0] / error[1], 2.0, 0.1);
}

/* XS11 Fig. 8: one sub-step of 2.2 tau accelerates the grain to 2.2 times the
 * velocity of the stream, and it diverges; two sub-steps are stable; so is the
 * exponential integration. */
FACT(xs11_4_1_without_sub_steps_the_grain_overshoots_and_diverges)
{
    struct scene s = grain(1);
    struct simulation *sim = let_go(&s);

    run(sim, 1);
    ck_assert_double_eq_tol(sim->particles->vx[0], 0.1108, 5e-4);
    run(sim, 5);
    ck_assert_double_gt(fabs(sim->particles->vx[0]), 1.0);
    discard(sim);
    for (int i = 0; i < 2; i++) {
        s = grain(i == 0 ? 2 : 1);
        if (i == 1) s.relaxation = SLIP_INTEGRATION_EXPONENTIAL;
        sim = let_go(&s);
        run(sim, 6);
        ck_assert_double_eq_tol(sim->particles->vx[0], stream, 1e-5);
        discard(sim);
    }
}
