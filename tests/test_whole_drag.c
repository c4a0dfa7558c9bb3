/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects.h"
#include "coupling/transfer.h"
#include "facts.h"
#include "suspension.h"

/* One sphere in the centre of each cell, at rest, and so heavy that it stays.
 */
static struct scene even_bed(int whole)
{
    struct scene s = air;

    s.n = 64;
    s.cells = 4;
    s.size = 0.008;
    s.averaging = "pcm";
    s.d = 1.8e-3; /* eps_f = 0.62 */
    s.rho_s = 1e12;
    s.pressure_gradient = !whole;
    s.whole_drag = whole;
    return s;
}

static void stop_particles(struct simulation *sim)
{
    const size_t size = (size_t)sim->particles->n * sizeof(double);

    memset(sim->particles->vx, 0, size);
    memset(sim->particles->vy, 0, size);
    memset(sim->particles->vz, 0, size);
}

/* [SX15 3]: with each law that has a range of eps_f, on spheres that move. */
FACT_FOR_EACH(ew18_a5_whole_force_is_the_drag_over_the_fluid_fraction, 4)
{
    static const char *const laws[] = {"syamlal-obrien", "gidaspow", "beetstra",
                                       "di-felice"};
    struct scene s = air;

    s.drag = laws[_i];
    s.pressure_gradient = 0;
    struct simulation *const plain = build(&s);
    s.whole_drag = 1;
    struct simulation *const whole = build(&s);
    transfer_drag_terms(plain);
    transfer_drag_terms(whole);
    for (int i = 0; i < s.n; i++) {
        const double eps = whole->coupling->eps[i];
        ck_assert_double_lt(eps, 0.95);
        ck_assert_double_eq_tol(whole->coupling->rate[i] * eps /
                                    plain->coupling->rate[i],
                                1.0, 1e-14);
    }
    discard(plain);
    discard(whole);
}

/* A gradient drives air through a lattice of spheres until the velocity is
 * steady: eps_f G = n F_d where it is shared, G = n F_d / eps_f where it is
 * not [SX15 2b], which is the same equation. 1e-6: the relaxation takes some 30
 * steps, and 400 are made. */
FACT(ew18_11_flow_through_an_even_bed_is_that_of_model_a)
{
    double u[2];

    for (int whole = 0; whole < 2; whole++) {
        struct scene s = even_bed(whole);
        s.mean_gradient = -400.0;
        struct simulation *const sim = build(&s);
        stop_particles(sim);
        run(sim, 400);
        u[whole] = sim->fluid->u[0];
        discard(sim);
    }
    ck_assert_double_gt(u[0], 0.1);
    ck_assert_double_eq_tol(u[1] / u[0], 1.0, 1e-6);
}

/* m g - V rho_f g = V (rho_s - rho_f) g, and nothing else of the fluid at rest.
 */
FACT(ew18_13_weight_is_less_by_the_buoyancy)
{
    struct scene s = air;

    s.rho = 400.0;
    s.gravity[1] = -9.81;
    s.pressure_gradient = 0;
    s.whole_drag = 1;
    struct simulation *const sim = build(&s);
    memset(sim->held_force, 0, 3 * (size_t)s.n * sizeof *sim->held_force);
    effects_call(sim, EFFECTS_BEFORE_PARTICLES);
    const double V = M_PI / 6.0 * s.d * s.d * s.d;
    for (int i = 0; i < s.n; i++) {
        ck_assert_double_eq_tol(
            sim->held_force[3 * i + 1] / (-9.81 * 600.0 * V), 1.0, 1e-12);
        ck_assert_double_eq(sim->held_force[3 * i], 0.0);
    }
    discard(sim);
}

/* The fluid gets minus the buoyancy of the solids that it carries: with spheres
 * of its own density nothing moves, but for the first step, before which none
 * was charged: 1 g dt at most. */
FACT_FOR_EACH(ew18_13_neutral_spheres_stay_where_they_are, 2)
{
    struct scene s = air;

    s.rho = s.rho_s;
    s.gravity[1] = -9.81;
    s.pressure_gradient = 0;
    s.whole_drag = 1;
    s.averaging = _i ? "pcm" : "diffusion";
    s.cap = _i ? 0.02 : 0.0;
    struct simulation *const sim = build(&s);
    stop_particles(sim);
    memset(sim->fluid->u, 0,
           3 * (size_t)sim->mesh->n_cells * sizeof *sim->fluid->u);
    memset(sim->fluid->phi, 0,
           (size_t)sim->mesh->n_faces * sizeof *sim->fluid->phi);
    run(sim, 40);
    for (int i = 0; i < s.n; i++)
        ck_assert_double_lt(fabs(sim->particles->vy[i]), 9.81 * s.dt);
    discard(sim);
}
