/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The liquid between particles that are close. */
#include "coupling/effects/forces.h"

#include <gsl/gsl_math.h>

#include "coupling/effects.h"
#include "dem/dem_method.h"
#include "facts.h"
#include "spheres.h"

static const double d = 1e-3, mu = 1e-3, z_min = 1e-6, z_out = 1e-4;

static struct attraction water(double viscosity)
{
    const double numbers[] = {z_min, z_out};
    const struct attraction_scene scene = {.viscosity = viscosity};
    return effect_named("lubrication")->attraction(numbers, &scene);
}

static struct dem_options with(const struct attraction *a, const char *method,
                               double step)
{
    struct dem_options o = spheres_options(&contact_linear, step, 0.01);

    o.attractions = a;
    o.n_attractions = 1;
    o.method = dem_method_named(method);
    return o;
}

static void run(struct particles *ps, const struct dem_options *o, int steps)
{
    struct dem *const dem = dem_create(ps, o);
    struct dem_report r;

    ck_assert_ptr_nonnull(dem);
    ck_assert_int_eq(dem_run(dem, steps, &r), 0);
    dem_free(dem);
}

FACT(cox67_force_begins_at_its_range_and_ends_at_the_roughness)
{
    const double k = 6.0 * M_PI * mu * 0.25 * d * 0.25 * d;
    const double R = 0.25 * d;

    ck_assert_double_eq(lubrication_coefficient(mu, R, z_out, z_min, z_out),
                        0.0);
    ck_assert_double_eq_tol(lubrication_coefficient(mu, R, 1e-5, z_min, z_out),
                            k * 9e4, 1e-17);
    ck_assert_double_eq(lubrication_coefficient(mu, R, 0.0, z_min, z_out),
                        lubrication_coefficient(mu, R, z_min, z_min, z_out));
}

/* m* dv/dt = -c(z) v with dz/dt = v has dv/dz = -c(z)/m*: two spheres, or one
 * and a wall, lose K (ln(z_out/z_min) + z_min/z_out - 1) on the way from z_out
 * to z_min, K = 6 pi mu R*^2/m*, and K (1 - z_min/z_out) more until they touch.
 * Both loops of the particles. 0.1 %: the steps, 1/2000 of the way through
 * z_min each. */
FACT_FOR_EACH(cox67_speed_lost_on_approach_is_the_logarithm_of_the_gaps, 4)
{
    const struct attraction a = water(mu);
    const int wall = _i / 2;
    const struct dem_options o =
        with(&a, _i % 2 ? "all-pairs" : "verlet", 1e-8);
    const double v = 0.1, gap = 2e-7; /* [m] left when it ends */
    struct particles *const ps = particles_create(2);

    if (wall) {
        spheres_add(ps, -0.01 + 0.5 * d + 1.1 * z_out, 0.0, 0.0, d);
        ps->vx[0] = -v;
    } else {
        spheres_add(ps, 0.0, 0.0, 0.0, d);
        spheres_add(ps, d + 1.1 * z_out, 0.0, 0.0, d);
        ps->vx[0] = 0.5 * v;
        ps->vx[1] = -0.5 * v;
    }
    const double m = wall ? ps->m[0] : 0.5 * ps->m[0];
    const double R = wall ? 0.5 * d : 0.25 * d;
    const double K = 6.0 * M_PI * mu * R * R / m;
    double z = 1.1 * z_out, speed = v;
    while (z > gap) {
        run(ps, &o, 1000);
        const int i = spheres_place(ps, 0), j = spheres_place(ps, 1);
        z = wall ? ps->x[i] + 0.01 - 0.5 * d : ps->x[j] - ps->x[i] - d;
        speed = wall ? -ps->vx[i] : ps->vx[i] - ps->vx[j];
        if (z < 2e-6) break;
    }
    /* From here on z is between z_min and z_out. */
    ck_assert_double_gt(z, z_min);
    ck_assert_double_eq_tol(
        (v - speed) / (K * (log(z_out / z) + z / z_out - 1.0)), 1.0, 1e-3);
    if (!wall) ck_assert_double_eq(ps->vx[0], -ps->vx[1]);
    particles_free(ps);
}

/* In honey a step of any length stops a sphere among twelve neighbours, none of
 * which is thrown anywhere: a pair takes at most half of its reduced mass. */
FACT(lubrication_is_stable_however_stiff)
{
    const struct attraction a = water(1e3);
    const struct dem_options o = with(&a, "verlet", 1e-5);
    struct particles *const ps = particles_create(64);
    uint64_t state = 3;
    double before = 0.0, after = 0.0;

    for (int i = -2; i < 2; i++) /* face-centred: layers of d/sqrt(2) */
        for (int j = -2; j < 2; j++)
            for (int k = -2; k < 2; k++) {
                const double h = (d + 0.01 * z_out) / sqrt(2.0);
                const int n =
                    spheres_add(ps, h * (j + k), h * (i + k), h * (i + j), d);
                spheres_throw(ps, n, 0.01 * spheres_random(&state),
                              0.01 * spheres_random(&state),
                              0.01 * spheres_random(&state));
            }
    for (int i = 0; i < 64; i++)
        before += ps->vx[i] * ps->vx[i];
    run(ps, &o, 100);
    for (int i = 0; i < 64; i++)
        after += ps->vx[i] * ps->vx[i];
    ck_assert_double_lt(after, 0.5 * before);
    particles_free(ps);
}
