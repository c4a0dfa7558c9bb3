/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A flow with all its options, in other axes and other units: the same
 * numbers. */
#include "fluid/fluid.h"
#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "facts.h"
#include "turned.h"

/* What is switched on. */
struct variant {
    const char *convection, *time, *slope;
    int shared, mixture, closed, periodic, repeats, coupled;
};

static const struct variant variants[] = {
    {"upwind", "euler", "gauss", 1, 0, 0, 0, 0, 1},
    {"linear", "euler", "gauss", 1, 1, 0, 0, 0, 1},
    {"blended", "bdf2", "gauss", 0, 0, 0, 0, 0, 1},
    {"second-upwind", "euler", "least-squares", 1, 1, 0, 0, 1, 1},
    {"van-leer", "bdf2", "gauss", 1, 0, 0, 0, 0, 1},
    {"linear", "bdf2", "gauss", 1, 1, 1, 0, 1, 1},
    {"second-upwind", "euler", "gauss", 0, 1, 1, 0, 0, 1},
    {"linear", "euler", "gauss", 1, 0, 0, 1, 0, 1},
    {"van-leer", "euler", "least-squares", 0, 1, 0, 2, 0, 1},
    {"blended", "euler", "gauss", 0, 0, 0, 0, 0, 0},
    {"linear", "bdf2", "gauss", 0, 0, 0, 2, 0, 0}};
enum { VARIANTS = sizeof variants / sizeof *variants };

static const struct box_spec original = {
    {0.10, 0.16, 0.09}, {4, 5, 3}, {2.0, 0.4, 1.5}, {0, 0, 0}};
static const double zero = 0.0;

struct scene {
    const struct frame *t;
    const struct variant *v;
    struct units in;
    double speed, pressure,
        inward;             /* [m/s], [Pa] in these units; the inlet's */
    struct mesh *plain, *m; /* of the original, of the frame */
    struct boundary b[6];
    double profile[12];
    struct fluid *fl;
};

/* In from below with a profile over x, out at the top and at the right, a wall
 * that moves along itself behind, one at rest in front, slip at the left. */
static struct boundary boundary_of(const struct scene *s, int side)
{
    struct boundary b = {.kind = BOUNDARY_NO_SLIP};
    if (side == 4) b.wall[0] = 0.3 * s->speed, b.wall[1] = -0.2 * s->speed;
    if (side == 0) b.kind = BOUNDARY_SLIP;
    if (s->v->closed) return b;
    if (side == 2)
        b = (struct boundary){.kind = BOUNDARY_INLET,
                              .n_points = 1,
                              .time = &zero,
                              .velocity = &s->inward};
    if (side == 3) b = (struct boundary){.kind = BOUNDARY_OUTLET};
    if (side == 1)
        b = (struct boundary){.kind = BOUNDARY_OUTLET,
                              .pressure = 3.0 * s->pressure};
    return b;
}

/* More comes in where x of the original is larger. */
static void set_profile(struct scene *s, int patch)
{
    const struct patch *const p = &s->m->patches[patch];
    for (int j = 0; j < p->n; j++) {
        const double *const x = &s->m->centre[3 * s->m->owner[p->first + j]];
        for (int k = 0; k < 3; k++)
            if (s->t->axis[k] == 0)
                s->profile[j] =
                    1.0 + 4.0 * s->t->sign[k] * (x[k] / s->in.L - 0.05);
    }
    s->b[patch].profile = s->profile;
}

static void set_boundaries(struct scene *s)
{
    static const char *const names[] = {"left", "right", "bottom",
                                        "top",  "back",  "front"};
    for (int side = 0; side < 6; side++) {
        const struct patch *const p = mesh_patch(s->m, names[side]);
        if (p == NULL) continue;
        const int i = (int)(p - s->m->patches), of = turned_side(s->t, side);
        s->b[i] = boundary_of(s, of);
        turned_vector(s->t, s->b[i].wall, s->b[i].wall);
        if (s->b[i].kind == BOUNDARY_INLET) set_profile(s, i);
    }
}

static struct fluid_options options_of(const struct scene *s)
{
    const struct variant *const v = s->v;
    const struct units in = s->in;
    struct fluid_options o = {
        .rho = 2.0 * in.M / (in.L * in.L * in.L),
        .mu = 0.05 * s->pressure * in.T,
        .dt = 0.02 * in.T,
        .time = time_scheme_named(v->time),
        .convection = convection_scheme_named(v->convection),
        .velocity_gradient = velocity_gradient_scheme_named(v->slope),
        .blend = 0.7,
        .continuity = v->mixture ? CONTINUITY_MIXTURE : CONTINUITY_VOID_RATE,
        .correctors = 3,
        .outer_correctors = v->repeats,
        .tolerance = 1e-13,
        .cfl = 0.8,
        .coupled = v->coupled,
        .pressure_shared = v->shared,
        .boundaries = s->b};
    for (int k = 0; k < 3 && v->periodic; k++) {
        static const double drive[3] = {4.0, -2.0, 3.0};
        static const double keep[3] = {0.3, -0.2, 0.1};
        const int a = s->t->axis[k];
        if (v->periodic == 1 || a == 0)
            o.mean_gradient[k] = s->t->sign[k] * drive[a] * s->pressure / in.L;
        o.keeps_flow[k] = v->periodic == 2 && a != 0;
        o.mean_flow[k] = s->t->sign[k] * keep[a] * s->speed;
    }
    return o;
}

/* A number of cell c of the original in [-1, 1], for quantity q at step n. */
static double any(int c, int q, int n)
{
    return sin(7.0 * c + 3.1 * q + 1.7 * n + 0.13 * c * q);
}

/* Sets the fields that the particles would set. The volume of the solids is
 * constant. */
static void set_particles(struct scene *s, int n)
{
    const double force = s->pressure / s->in.L; /* [N/m^3] */
    double mean = 0.0, V = 0.0;
    for (int c = 0; c < s->plain->n_cells; c++) {
        mean += s->plain->V[c] * any(c, 0, n);
        V += s->plain->V[c];
    }
    for (int c = 0; c < s->plain->n_cells; c++) {
        const int to = turned_cell(s->t, s->plain, s->m, c);
        const double F[3] = {any(c, 1, n), any(c, 2, n), any(c, 3, n)};
        const double q[3] = {0.1 * any(c, 4, 0), 0.1 * any(c, 5, 0),
                             0.1 * any(c, 6, 0)};
        s->fl->eps[to] =
            0.6 + 0.02 * (any(c, 0, n) - mean / V) + (c % 3 == 0 ? 0.1 : 0.0);
        s->fl->K[to] = 20.0 * (1.0 + any(c, 7, n)) * force / s->speed;
        turned_vector(s->t, F, &s->fl->F[3 * to]);
        turned_vector(s->t, q, &s->fl->eps_us[3 * to]);
        turned_scale(force, &s->fl->F[3 * to]);
        turned_scale(s->speed, &s->fl->eps_us[3 * to]);
    }
    if (n == 0) fluid_reset_eps_history(s->fl);
}

static void begin(struct scene *s)
{
    const double U[3] = {0.2, 0.3, -0.1};
    double turned[3];
    turned_vector(s->t, U, turned);
    for (int c = 0; c < s->plain->n_cells; c++) {
        const int to = turned_cell(s->t, s->plain, s->m, c);
        const double u[3] = {U[0] + 0.1 * any(c, 8, 0),
                             U[1] + 0.1 * any(c, 9, 0),
                             U[2] + 0.1 * any(c, 10, 0)};
        turned_vector(s->t, u, &s->fl->u[3 * to]);
        turned_scale(s->speed, &s->fl->u[3 * to]);
    }
    for (int f = 0; f < s->m->n_internal; f++)
        for (int k = 0; k < 3; k++)
            s->fl->phi[f] += 0.5 * turned[k] * s->speed * mesh_S(s->m, f)[k];
}

static struct scene *create(const struct variant *v, const struct frame *t,
                            struct units in)
{
    struct scene *const s = calloc(1, sizeof *s);
    struct box_spec plain = original;
    for (int k = 0; k < 3; k++)
        plain.periodic[k] = v->periodic != 0;
    turned_scale(in.L, plain.size);
    const struct box_spec spec = turned_box(t, &plain);
    s->t = t;
    s->v = v;
    s->in = in;
    s->speed = in.L / in.T;
    s->pressure = in.M / (in.L * in.T * in.T);
    s->inward = 0.4 * s->speed;
    s->plain = mesh_create_box(&plain);
    s->m = mesh_create_box(&spec);
    set_boundaries(s);
    const struct fluid_options o = options_of(s);
    s->fl = fluid_create(s->m, &o);
    begin(s);
    for (int n = 0; n < 3; n++) {
        if (v->coupled) set_particles(s, n);
        ck_assert_int_eq(
            fluid_advance(s->fl, in.T * 0.02 * (n == 1 ? 0.7 : 1.0)), 0);
    }
    return s;
}

static void discard(struct scene *s)
{
    owner_free(s->fl);
    mesh_free(s->m);
    mesh_free(s->plain);
    free(s);
}

/* The fields of the second case in the cells and axes of the first. A closed
 * flow has no level of pressure: there it is that of cell 0. */
static void assert_alike(const struct scene *a, const struct scene *b)
{
    const int n = a->m->n_cells, open = !a->v->closed && !a->v->periodic;
    const int zeroth = turned_cell(b->t, b->plain, b->m, 0);
    const double pa = open ? 0.0 : a->fl->p[0];
    const double pb = open ? 0.0 : b->fl->p[zeroth];
    for (int c = 0; c < n; c++) {
        const int to = turned_cell(b->t, b->plain, b->m, c);
        double u[3], grad[3];
        turned_vector(b->t, &a->fl->u[3 * c], u);
        turned_vector(b->t, &a->fl->grad_p[3 * c], grad);
        ck_assert_double_eq_tol(a->fl->p[c] - pa, b->fl->p[to] - pb, 1e-8);
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(b->fl->u[3 * to + k], u[k], 1e-9);
            ck_assert_double_eq_tol(b->fl->grad_p[3 * to + k], grad[k], 1e-6);
        }
    }
}

static void assert_sums(const struct scene *a, const struct scene *b)
{
    double one[3], two[3];
    fluid_momentum(a->fl, one);
    turned_vector(b->t, one, one);
    fluid_momentum(b->fl, two);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(one[k], two[k], 1e-11);
    turned_vector(b->t, a->fl->relabelled, one);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(one[k], b->fl->relabelled[k], 1e-11);
    fluid_mean_flow(a->fl, one);
    turned_vector(b->t, one, one);
    fluid_mean_flow(b->fl, two);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(one[k], two[k], 1e-9);
    turned_vector(b->t, a->fl->mean_gradient, one);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(one[k], b->fl->mean_gradient[k], 1e-7);
    ck_assert_double_eq_tol(fluid_kinetic_energy(a->fl),
                            fluid_kinetic_energy(b->fl), 1e-11);
    ck_assert_double_eq_tol(a->fl->report.cfl, b->fl->report.cfl, 1e-8);
    ck_assert_int_eq(a->fl->report.flow_substeps, b->fl->report.flow_substeps);
    ck_assert_int_eq(a->fl->report.backflow_faces,
                     b->fl->report.backflow_faces);
    ck_assert_int_eq(a->fl->report.correctors, b->fl->report.correctors);
    ck_assert_double_lt(b->fl->report.momentum_residual, 1e-12);
}

/* Velocities are some 0.3 m/s, pressures some 10 Pa over cells of 0.02 m; the
 * solvers leave 1e-13 of their right sides. A term of one component or one side
 * that is wrong shows as 1e-4 and more. */
FACT_FOR_EACH(a_flow_does_not_depend_on_the_axes, VARIANTS)
{
    struct scene *const a = create(&variants[_i], &turned_frames[0], turned_si);
    for (int t = 1; t < TURNED; t++) {
        struct scene *const b =
            create(&variants[_i], &turned_frames[t], turned_si);
        assert_alike(a, b);
        assert_sums(a, b);
        discard(b);
    }
    discard(a);
}

/* To the last bit: all units are powers of two. */
FACT_FOR_EACH(a_flow_does_not_depend_on_the_units, VARIANTS)
{
    const struct frame *const t = &turned_frames[0];
    struct scene *const a = create(&variants[_i], t, turned_si);
    struct scene *const b = create(&variants[_i], t, turned_units);
    const double mass = turned_units.M, speed = b->speed;
    double one[3], two[3];
    for (int c = 0; c < a->m->n_cells; c++)
        ck_assert_double_eq(a->fl->p[c] * b->pressure, b->fl->p[c]);
    for (int i = 0; i < 3 * a->m->n_cells; i++) {
        ck_assert_double_eq(a->fl->u[i] * speed, b->fl->u[i]);
        ck_assert_double_eq(a->fl->grad_p[i] * b->pressure / turned_units.L,
                            b->fl->grad_p[i]);
    }
    fluid_momentum(a->fl, one);
    fluid_momentum(b->fl, two);
    for (int k = 0; k < 3; k++) {
        ck_assert_double_eq(one[k] * mass * speed, two[k]);
        ck_assert_double_eq(a->fl->relabelled[k] * mass * speed,
                            b->fl->relabelled[k]);
    }
    ck_assert_double_eq(fluid_kinetic_energy(a->fl) * mass * speed * speed,
                        fluid_kinetic_energy(b->fl));
    ck_assert_double_eq(a->fl->report.cfl, b->fl->report.cfl);
    ck_assert_double_eq(a->fl->report.piso_residual,
                        b->fl->report.piso_residual);
    ck_assert_double_eq(a->fl->report.mass_residual,
                        b->fl->report.mass_residual);
    ck_assert_double_eq(a->fl->report.momentum_residual,
                        b->fl->report.momentum_residual);
    discard(a);
    discard(b);
}
