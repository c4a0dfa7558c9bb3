/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies that are resolved among particles that are not. */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "averaging/averaging.h"
#include "case/build.h"
#include "case/case_file.h"
#include "coupling/coupling.h"
#include "coupling/effects.h"
#include "facts.h"
#include "resolved/solid_bodies.h"
#include "resolved/among/among_grains.h"

static const char
    sphere[] =
        "spheres = ( { position = [0.0065, 0.0065, 0.0065];\n"
        "  diameter = 0.006; density = 2000.0; velocity = [0.05, -0.5, 0.0];\n"
        "  spin = [5.0, 0.0, 20.0]; } );",
    block[] = "boxes = ( { position = [0.0065, 0.0065, 0.0065];\n"
              "  size = [0.0038, 0.0035, 0.0036]; rotation = [0.3, 0.2, 0.5];\n"
              "  motion = \"free\"; density = 2000.0;\n"
              "  velocity = [0.05, -0.5, 0.0]; spin = [5.0, 0.0, 20.0]; } );";

/* A periodic box of water with 500 grains of 1 mm, and a body that moves into
 * them. */
/* The case of the simulation, whose shapes it borrows. */
static struct settings *borrowed;

static struct simulation *build_with(const char *body, const char *averaging,
                                     const char *more)
{
    static const char *const rest =
        "mesh = { size = [0.013, 0.013, 0.013]; cells = [13, 13, 13];\n"
        "  periodic = [true, true, true]; };\n"
        "fluid = { density = 1000.0; viscosity = 1e-3; step = 5e-4;\n"
        "  tolerance = 1e-10; };\n"
        "particles = { contact = \"linear\"; step = 2.5e-5;\n"
        "  grains = { density = 2500; stiffness = 20.0; restitution = 0.9;\n"
        "             friction = 0.3; };\n"
        "  bed = { count = 500; diameter = 1e-3; settle = 0.0; }; };\n"
        "exchange = { drag = \"di-felice\"; };\n"
        "output = { end = 1.0; every = 1.0; };\n";
    char path[] = "/tmp/winnow-among-XXXXXX";
    FILE *const f = fdopen(mkstemp(path), "w");
    int code;

    fprintf(f, "%s bodies = { %s }; averaging = { %s };\n%s", rest, body,
            averaging, more);
    fclose(f);
    borrowed = case_file_read(path, 0, NULL, &code);
    remove(path);
    ck_assert_ptr_nonnull(borrowed);
    struct simulation *const sim = build_simulation(borrowed, &code);
    ck_assert_ptr_nonnull(sim);
    ck_assert_int_eq(coupling_start(sim), 0);
    return sim;
}

static void release(struct simulation *sim)
{
    build_free(sim);
    settings_free(borrowed);
}

static struct simulation *build(const char *averaging, const char *more)
{
    return build_with(sphere, averaging, more);
}

static struct solid_bodies *bodies_of(const struct simulation *sim)
{
    return effects_memory(sim, &among_effect);
}

static const char *const averages[] = {
    "method = \"pcm\";", "method = \"kernel\"; bandwidth = 2.5e-3;",
    "method = \"diffusion\"; bandwidth = 2e-3; interpolation = \"linear\";"};
enum { N_AVERAGES = sizeof averages / sizeof averages[0] };

/* --- what the averaging puts into a body -----------------------------------
 */

/* Without mirrors 8 % of the volume is within the body by the diffusion. */
FACT_FOR_EACH(sx15_a1_a_body_loses_no_volume_and_has_none_in_it, N_AVERAGES)
{
    struct simulation *const sim = build(averages[_i], "");
    const struct solid_bodies *const b = bodies_of(sim);
    const double V_p = M_PI / 6.0 * 1e-9;
    double sum = 0.0;
    int inside = 0;

    for (int c = 0; c < sim->mesh->n_cells; c++) {
        const double *const x = &sim->mesh->centre[3 * c];
        const double r[3] = {x[0] - 0.0065, x[1] - 0.0065, x[2] - 0.0065};
        sum += sim->mesh->V[c] * (1.0 - sim->fluid->eps[c]);
        if (body_shape_distance(&b->shape[0], r) > 0.0) continue;
        inside++;
        ck_assert_double_eq(sim->fluid->eps[c], 1.0);
    }
    ck_assert_int_ge(inside, 100);
    /* 1 - eps is rounded in 2000 cells */
    ck_assert_double_eq_tol(sum / (500.0 * V_p), 1.0, 1e-12);
    release(sim);
}

/* Sum over the particles of q gather(f) = sum over the cells of V f spread(q).
 */
FACT_FOR_EACH(sx15_a1_spread_and_gather_stay_adjoint_around_a_body, N_AVERAGES)
{
    struct simulation *const sim = build(averages[_i], "");
    const int n = sim->particles->n, cells = sim->mesh->n_cells;
    double *const q = calloc((size_t)n, sizeof *q),
                  *const f = calloc((size_t)cells, sizeof *f),
                  *const g = calloc((size_t)n, sizeof *g),
                  *const s = calloc((size_t)cells, sizeof *s);
    double one = 0.0, other = 0.0;

    for (int i = 0; i < n; i++)
        q[i] = 1.0 + sin(3.0 * i);
    for (int c = 0; c < cells; c++)
        f[c] = 2.0 + cos(7.0 * c);
    averaging_spread(sim->averaging, 1, q, s);
    averaging_gather(sim->averaging, 1, f, g);
    for (int i = 0; i < n; i++)
        one += q[i] * g[i];
    for (int c = 0; c < cells; c++)
        other += sim->mesh->V[c] * f[c] * s[c];
    ck_assert_double_eq_tol(one / other, 1.0, 1e-12);
    free(q), free(f), free(g), free(s);
    release(sim);
}

/* A field that is the same everywhere out of the body is so at the grains
 * beside it, whatever it is inside. */
FACT_FOR_EACH(xs11_3_9_nothing_of_a_body_is_interpolated_to_grains, N_AVERAGES)
{
    struct simulation *const sim = build(averages[_i], "");
    const struct solid_bodies *const b = bodies_of(sim);
    double *const f = calloc((size_t)sim->mesh->n_cells, sizeof *f),
                  *const g = calloc((size_t)sim->particles->n, sizeof *g);

    for (int c = 0; c < sim->mesh->n_cells; c++) {
        const double *const x = &sim->mesh->centre[3 * c];
        const double r[3] = {x[0] - 0.0065, x[1] - 0.0065, x[2] - 0.0065};
        f[c] = body_shape_distance(&b->shape[0], r) > 0.0 ? 1.0 : 1e6;
    }
    sim->coupling->options.interpolation->apply(sim->averaging, 1, f, NULL, g);
    for (int i = 0; i < sim->particles->n; i++)
        ck_assert_double_eq_tol(g[i], 1.0, 1e-12);
    free(f), free(g);
    release(sim);
}

/* --- momentum ---------------------------------------------------------------
 */

/* A sphere, and a box that turns. The fluid is solved to 1e-10 of what flows,
 * of 2e-4 N s; that the loads of the last particle step have been paid by half
 * only would be 1e-8. */
FACT_FOR_EACH(momentum_of_grains_bodies_and_fluid_is_constant, N_AVERAGES + 1)
{
    struct simulation *const sim = _i < N_AVERAGES
                                       ? build(averages[_i], "")
                                       : build_with(block, averages[0], "");
    const struct solid_bodies *const b = bodies_of(sim);
    double before[3], after[3], pushed = 0.0, scale = 0.0;

    coupling_total_momentum(sim, before);
    for (int k = 0; k < 3; k++)
        scale += fabs(before[k]);
    for (int step = 0; step < 30; step++) {
        ck_assert_int_eq(coupling_step(sim), 0);
        coupling_total_momentum(sim, after);
        pushed += fabs(b->among->pushed[0][1]) * sim->dt;
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(after[k] - sim->fluid->relabelled[k],
                                    before[k], 1e-9 * scale);
    }
    ck_assert_double_ge(pushed, 1e-3 * scale); /* they did touch */
    release(sim);
}

/* Where grains were put in or taken out, all loads are found anew before the
 * next step, with velocities that have changed since. A body that goes without
 * the difference is off by 7e-12 N s in these 20 steps; 1e-17 is what rounding
 * and the fluid's solution leave. */
FACT(momentum_is_constant_where_the_loads_are_found_anew)
{
    struct simulation *const sim = build(averages[0], "");
    double before[3], after[3], scale = 0.0;

    coupling_total_momentum(sim, before);
    for (int k = 0; k < 3; k++)
        scale += fabs(before[k]);
    for (int step = 0; step < 20; step++) {
        ck_assert_int_eq(coupling_step(sim), 0);
        dem_changed(sim->dem);
    }
    coupling_total_momentum(sim, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(after[k] - sim->fluid->relabelled[k], before[k],
                                1e-9 * scale);
    release(sim);
}

/* --- contacts ----------------------------------------------------------------
 */

/* A grain that falls on a fixed body stays on it, at rest on its top. */
FACT(grains_do_not_enter_a_body)
{
    struct simulation *const sim = build(averages[2], "");
    const struct solid_bodies *const b = bodies_of(sim);

    for (int step = 0; step < 60; step++)
        ck_assert_int_eq(coupling_step(sim), 0);
    for (int i = 0; i < sim->particles->n; i++) {
        const struct particles *const ps = sim->particles;
        double r[3] = {ps->x[i] - b->ps->x[0], ps->y[i] - b->ps->y[0],
                       ps->z[i] - b->ps->z[0]};
        for (int k = 0; k < 3; k++)
            r[k] -= 0.013 * rint(r[k] / 0.013);
        /* overlaps of the soft spring are below a tenth of the diameter */
        ck_assert_double_ge(body_shape_distance(&b->shape[0], r), 0.4e-3);
    }
    ck_assert_double_ge(fabs(b->ps->y[0] - 0.0065),
                        1e-3); /* through the seam */
    release(sim);
}
