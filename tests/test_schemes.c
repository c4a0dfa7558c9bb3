/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/fluid.h"
#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- time schemes ------------------------------------------------------- */

/* A polynomial of the degree that the scheme is exact for, at arbitrary steps:
 * with 1 + 2 r in place of (1 + 2 r)/(1 + r) it would be wrong by far. */
FACT_FOR_EACH(time_weights_give_the_slope_of_a_line_or_of_a_parabola, 6)
{
    const struct time_scheme *const s = time_schemes[_i % 2];
    const double dt = 0.3, ratios[] = {1.0, 0.5, 3.0}, r = ratios[_i / 2];
    const double t = 2.0, t1 = t - dt, t2 = t1 - dt / r;
    const double curve = s->time_levels > 1 ? 0.7 : 0.0;
    const struct time_weights w = s->weights(r);
    const double slope = (w.now * (5.0 * t + curve * t * t) -
                          w.old * (5.0 * t1 + curve * t1 * t1) +
                          w.older * (5.0 * t2 + curve * t2 * t2)) /
                         dt;
    ck_assert_double_eq_tol(slope, 5.0 + 2.0 * curve * t, 1e-12);
    ck_assert_double_eq_tol(w.now - w.old + w.older, 0.0, 1e-15);
    if (s->time_levels > 1) ck_assert_double_eq(w.ahead, r);
}

FACT(the_first_step_of_bdf2_is_one_of_euler)
{
    const struct time_weights w = time_scheme_named("bdf2")->weights(0.0);
    const struct time_weights e = time_scheme_named("euler")->weights(0.0);
    ck_assert_int_eq(memcmp(&w, &e, sizeof w), 0);
    ck_assert_ptr_null(time_scheme_named("bdf3"));
}

/* Taylor and Green's vortices, carried along by a stream: u = (1, 0.5) + what
 * they are at rest. In a periodic box, no boundary in the way. */
struct vortex {
    int n;
    double dt, wobble, end; /* [s], [-] steps dt (1 +- wobble) in turn, [s] */
    const char *time, *convection, *slope;
    int repeats;
};

static const double nu = 0.1, stream[2] = {1.0, 0.5};

static void vortex_velocity(double x, double y, double t, double u[2])
{
    const double decay = exp(-2.0 * nu * t);
    const double a = x - stream[0] * t, b = y - stream[1] * t;
    u[0] = stream[0] + decay * sin(a) * cos(b);
    u[1] = stream[1] - decay * cos(a) * sin(b);
}

static struct fluid *vortex_create(const struct vortex *v)
{
    struct mesh *const m =
        periodic_box(2.0 * M_PI, 2.0 * M_PI, 1.0, v->n, v->n, 1);
    const struct fluid_options o = {
        .rho = 1.0,
        .mu = nu,
        .dt = v->dt,
        .time = time_scheme_named(v->time),
        .convection = convection_scheme_named(v->convection),
        .velocity_gradient = velocity_gradient_scheme_named(v->slope),
        .blend = 0.8,
        .correctors = 3,
        .outer_correctors = v->repeats,
        .tolerance = 1e-11};
    struct fluid *const fl = fluid_create(m, &o);

    for (int c = 0; c < m->n_cells; c++)
        vortex_velocity(m->centre[3 * c], m->centre[3 * c + 1], 0.0,
                        &fl->u[3 * c]);
    for (int f = 0; f < m->n_internal; f++) {
        const double *const x = &m->centre[3 * m->owner[f]];
        double u[2];
        vortex_velocity(x[0] + 0.5 * mesh_d(m, f)[0],
                        x[1] + 0.5 * mesh_d(m, f)[1], 0.0, u);
        fl->phi[f] = mesh_S(m, f)[0] * u[0] + mesh_S(m, f)[1] * u[1];
    }
    return fl;
}

static void discard(struct fluid *fl)
{
    struct mesh *const m = (struct mesh *)fl->mesh;
    owner_free(fl);
    mesh_free(m);
}

static struct fluid *vortex_run(const struct vortex *v)
{
    struct fluid *const fl = vortex_create(v);
    const int steps = (int)(v->end / v->dt + 0.5);

    for (int n = 0; n < steps; n++) {
        fl->options.dt = v->dt * (1.0 + (n % 2 ? v->wobble : -v->wobble));
        ck_assert_int_eq(fluid_step(fl), 0);
    }
    return fl;
}

/* Root mean square of u_x - exact. */
static double vortex_error(const struct vortex *v)
{
    struct fluid *const fl = vortex_run(v);
    const struct mesh *const m = fl->mesh;
    double sum = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        double u[2];
        vortex_velocity(m->centre[3 * c], m->centre[3 * c + 1], fl->t, u);
        sum += gsl_pow_2(fl->u[3 * c] - u[0]) / m->n_cells;
    }
    discard(fl);
    return sqrt(sum);
}

/* Order in time on one mesh, from steps dt, dt/2, dt/4: the mesh has its part
 * in all three alike. */
static double time_order(struct vortex v)
{
    struct fluid *fl[3];
    double first = 0.0, second = 0.0;

    for (int i = 0; i < 3; i++, v.dt *= 0.5)
        fl[i] = vortex_run(&v);
    for (int i = 0; i < 3 * fl[0]->mesh->n_cells; i++) {
        first += gsl_pow_2(fl[0]->u[i] - fl[1]->u[i]);
        second += gsl_pow_2(fl[1]->u[i] - fl[2]->u[i]);
    }
    for (int i = 0; i < 3; i++)
        discard(fl[i]);
    return 0.5 * log2(first / second);
}

static const struct vortex base = {16,      0.04,     0.0,     0.64,
                                   "euler", "linear", "gauss", 0};

FACT_FOR_EACH(euler_has_order_one_in_time, 2)
{
    struct vortex v = base;
    v.repeats = _i;
    ck_assert_double_eq_tol(time_order(v), 1.0, 0.15);
}

/* Also where the step changes by a factor 1.5 and back, and where the scheme
 * takes slopes from the velocities continued in time. */
FACT_FOR_EACH(sx15_bdf2_has_order_two_in_time, 4)
{
    static const struct vortex cases[] = {
        {16, 0.04, 0.0, 0.64, "bdf2", "linear", "gauss", 0},
        {16, 0.04, 0.0, 0.64, "bdf2", "linear", "gauss", 1},
        {16, 0.04, 0.2, 0.64, "bdf2", "linear", "gauss", 0},
        {16, 0.04, 0.0, 0.64, "bdf2", "second-upwind", "gauss", 0}};
    ck_assert_double_eq_tol(time_order(cases[_i]), 2.0, 0.2);
}

/* --- convection --------------------------------------------------------- */

/* Order in space. On these meshes the second order falls faster still, because
 * an error of order four has its part; blended lies between one and two. */
FACT_FOR_EACH(each_convection_scheme_has_its_order_in_space, 6)
{
    static const struct {
        const char *name, *slope;
        double least, most, error; /* [-], [-], [m/s] on 32 x 32 */
    } rows[] = {{"upwind", "gauss", 0.9, 1.1, 2e-2},
                {"linear", "gauss", 1.9, 3.0, 2e-3},
                {"blended", "gauss", 1.2, 1.8, 4e-3},
                {"second-upwind", "gauss", 1.9, 3.0, 1.5e-3},
                {"second-upwind", "least-squares", 1.9, 3.0, 1.5e-3},
                {"van-leer", "gauss", 1.9, 3.0, 2e-3}};
    struct vortex v = base;
    v.time = "bdf2";
    v.dt = 0.01;
    v.end = 0.2;
    v.convection = rows[_i].name;
    v.slope = rows[_i].slope;
    const double coarse = vortex_error(&v);
    v.n = 32;
    const double fine = vortex_error(&v), order = log2(coarse / fine);
    ck_assert_double_gt(order, rows[_i].least);
    ck_assert_double_lt(order, rows[_i].most);
    ck_assert_double_lt(fine, rows[_i].error);
}

/* A sharp band of sideways velocity 1 is carried along y; by how much does it
 * leave 0 .. 1, and how high is it afterwards? */
static void band(const char *convection, double *beyond, double *left)
{
    struct mesh *const m = periodic_box(0.1, 1.0, 0.1, 1, 64, 1);
    const struct fluid_options o = {.rho = 1.0,
                                    .dt = 1e-3,
                                    .convection =
                                        convection_scheme_named(convection),
                                    .blend = 0.5,
                                    .correctors = 1,
                                    .tolerance = 1e-10};
    struct fluid *const fl = fluid_create(m, &o);

    *beyond = *left = 0.0;
    for (int c = 0; c < 64; c++) {
        fl->u[3 * c] = c >= 16 && c < 32;
        fl->u[3 * c + 1] = 1.0;
    }
    for (int f = 0; f < m->n_faces; f++)
        fl->phi[f] = mesh_S(m, f)[1];
    for (int n = 0; n < 500; n++)
        ck_assert_int_eq(fluid_step(fl), 0);
    for (int c = 0; c < 64; c++) {
        *beyond = fmax(*beyond, fmax(fl->u[3 * c] - 1.0, -fl->u[3 * c]));
        *left = fmax(*left, fl->u[3 * c]);
    }
    discard(fl);
}

/* Upwind smears the band to a hill; van Leer keeps its height and its bounds
 * (1e-3: the slopes are those of the step before); the others leave them. */
FACT(upwind_and_van_leer_stay_within_bounds_and_others_do_not)
{
    double beyond[5], left[5];
    for (int i = 0; i < 5; i++)
        band(convection_schemes[i]->name, &beyond[i], &left[i]);
    ck_assert_double_lt(beyond[0], 1e-9); /* upwind */
    ck_assert_double_lt(left[0], 0.9);
    ck_assert_double_gt(beyond[1], 0.1);  /* linear */
    ck_assert_double_gt(beyond[3], 0.02); /* second upwind */
    ck_assert_double_lt(beyond[4], 1e-3); /* van Leer */
    ck_assert_double_gt(left[4], 0.98);
}

/* --- slopes ------------------------------------------------------------- */

/* A linear field on graded cells, its boundary values given: exact to
 * rounding, also along a direction of one cell. */
FACT_FOR_EACH(slopes_of_a_linear_field_are_exact_on_graded_cells, 4)
{
    static const double G[3][3] = {
        {1.0, -2.0, 0.5}, {0.3, 4.0, -1.0}, {-0.7, 0.1, 2.0}};
    const struct box_spec spec = {
        {1.0, 2.0, 0.5}, {4, 5, _i / 2 ? 3 : 1}, {2.0, 3.0, 1.5}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
    const int edges = m->n_faces - m->n_internal;
    double *const u = calloc(3 * (size_t)m->n_cells, sizeof *u);
    double *const u_b = calloc(3 * (size_t)edges, sizeof *u_b);
    double *const slope = calloc(9 * (size_t)m->n_cells, sizeof *slope);
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++) {
            for (int c = 0; c < m->n_cells; c++)
                u[3 * c + k] += G[k][j] * m->centre[3 * c + j];
            for (int b = 0; b < edges; b++) {
                const int f = m->n_internal + b;
                u_b[3 * b + k] += G[k][j] * (m->centre[3 * m->owner[f] + j] +
                                             mesh_d(m, f)[j]);
            }
        }
    velocity_gradient_schemes[_i % 2]->fill(m, NULL, u, u_b, slope);
    for (int i = 0; i < 9 * m->n_cells; i++)
        ck_assert_double_eq_tol(slope[i], G[i % 9 / 3][i % 3], 1e-12);
    free(u);
    free(u_b);
    free(slope);
    mesh_free(m);
}

/* u_y = x^2 in cells 1, 2 and 4 wide, around the middle one: by Gauss the slope
 * between the linear values at its faces, by least squares, with the inverse
 * square of the distances as weights, the mean of the slopes on both sides. */
FACT_FOR_EACH(slopes_of_a_parabola_are_those_of_the_formulas, 2)
{
    const struct box_spec spec = {
        {7.0, 1.0, 1.0}, {3, 1, 1}, {4.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
    double u[9] = {0.0}, slope[27];
    double *const u_b = calloc(3 * (size_t)m->n_faces, sizeof *u_b);
    for (int c = 0; c < 3; c++)
        u[3 * c + 1] = gsl_pow_2(m->centre[3 * c]);  /* at 0.5, 2, 5 */
    for (int f = m->n_internal; f < m->n_faces; f++) /* the sides' own */
        u_b[3 * (f - m->n_internal) + 1] = u[3 * m->owner[f] + 1];
    const double below = (2.0 * 0.25 + 1.0 * 4.0) / 3.0; /* at x = 1 */
    const double above = (2.0 * 4.0 + 1.0 * 25.0) / 3.0; /* at x = 3 */
    velocity_gradient_schemes[_i]->fill(m, NULL, u, u_b, slope);
    ck_assert_double_eq_tol(
        slope[9 + 3], _i ? 0.5 * (2.5 + 7.0) : 0.5 * (above - below), 1e-12);
    for (int i = 0; i < 9; i++)
        if (i != 3) ck_assert_double_eq_tol(slope[9 + i], 0.0, 1e-14);
    free(u_b);
    mesh_free(m);
}
