/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fluid solver against manufactured solutions, a published table, and hard
 * cases.
 */
#include "fluid/fluid.h"
#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double zero = 0.0;

static void discard(struct fluid *fl)
{
    struct mesh *const m = (struct mesh *)fl->mesh;
    owner_free(fl);
    mesh_free(m);
}

/* --- a manufactured solution --------------------------------------------- */

/* u = T (-2 sin^2 pi x sin pi y cos pi y, 2 sin pi x cos pi x sin^2 pi y),
 * p = T sin pi x sin pi y, eps = 0.5 + 0.25 sin pi x sin pi y on [-1, 1]^2: eps
 * u has no divergence. T = 1, or 1 + 0.5 sin 5 t. rho = mu = 1. */
static double amplitude(int unsteady, double t)
{
    return unsteady ? 1.0 + 0.5 * sin(5.0 * t) : 1.0;
}

static double made_u(int k, double x, double y)
{
    const double sx = sin(M_PI * x), cx = cos(M_PI * x);
    const double sy = sin(M_PI * y), cy = cos(M_PI * y);
    return k == 0 ? -2.0 * sx * sx * sy * cy : 2.0 * sx * cx * sy * sy;
}

static double made_p(double x, double y)
{
    return sin(M_PI * x) * sin(M_PI * y);
}

static double made_eps(double x, double y)
{
    return 0.5 + 0.25 * sin(M_PI * x) * sin(M_PI * y);
}

/* The force for which it is a solution: eps (du/dt + u . grad u) + gamma grad p
 * - lap u, with differences over 1e-4 (their error is 1e-7). */
static double made_force(int k, int shared, int unsteady, double x, double y,
                         double t)
{
    const double h = 1e-4, T = amplitude(unsteady, t);
    const double dT = unsteady ? 2.5 * cos(5.0 * t) : 0.0;
    const double e = made_u(k, x + h, y), w = made_u(k, x - h, y);
    const double n = made_u(k, x, y + h), s = made_u(k, x, y - h);
    const double u = made_u(k, x, y), eps = made_eps(x, y);
    const double carried = made_u(0, x, y) * (e - w) / (2.0 * h) +
                           made_u(1, x, y) * (n - s) / (2.0 * h);
    const double grad = k == 0 ? made_p(x + h, y) - made_p(x - h, y)
                               : made_p(x, y + h) - made_p(x, y - h);

    return eps * (dT * u + T * T * carried) +
           (shared ? eps : 1.0) * T * grad / (2.0 * h) -
           T * (e + w + n + s - 4.0 * u) / (h * h);
}

/* Root mean square errors of u and p (less its mean) after a while. */
struct made_error {
    double u, p;
};

static struct fluid *made_create(int n, int shared, double dt, const char *time)
{
    struct mesh *const m = periodic_box(2.0, 2.0, 1.0, n, n, 1);
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 1.0,
                                    .dt = dt,
                                    .time = time_scheme_named(time),
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .continuity = CONTINUITY_VOID_RATE,
                                    .correctors = 3,
                                    .piso_tolerance = 1e-5,
                                    .tolerance = 1e-10,
                                    .coupled = 1,
                                    .pressure_shared = shared};
    struct fluid *const fl = fluid_create(m, &o);

    for (int c = 0; c < m->n_cells; c++) {
        const double x = m->centre[3 * c] - 1.0, y = m->centre[3 * c + 1] - 1.0;
        fl->eps[c] = made_eps(x, y);
        fl->p[c] = made_p(x, y);
        for (int k = 0; k < 2; k++)
            fl->u[3 * c + k] = made_u(k, x, y);
    }
    for (int f = 0; f < m->n_internal; f++) {
        const double *const P = &m->centre[3 * m->owner[f]];
        const double x = P[0] - 1.0 + 0.5 * mesh_d(m, f)[0];
        const double y = P[1] - 1.0 + 0.5 * mesh_d(m, f)[1];
        fl->phi[f] = made_eps(x, y) * (made_u(0, x, y) * mesh_S(m, f)[0] +
                                       made_u(1, x, y) * mesh_S(m, f)[1]);
    }
    fluid_reset_eps_history(fl);
    return fl;
}

static struct made_error made_run(int n, int shared, int unsteady, double dt,
                                  int steps, const char *time)
{
    struct fluid *const fl = made_create(n, shared, dt, time);
    const struct mesh *const m = fl->mesh;
    struct made_error error = {0.0, 0.0};
    double mean = 0.0;

    for (int i = 0; i < steps; i++) {
        const double t = fl->t + dt;
        for (int c = 0; c < m->n_cells; c++)
            for (int k = 0; k < 2; k++)
                fl->F[3 * c + k] =
                    made_force(k, shared, unsteady, m->centre[3 * c] - 1.0,
                               m->centre[3 * c + 1] - 1.0, t);
        ck_assert_int_eq(fluid_step(fl), 0);
    }
    const double T = amplitude(unsteady, fl->t);
    for (int c = 0; c < m->n_cells; c++)
        mean += fl->p[c] / m->n_cells;
    for (int c = 0; c < m->n_cells; c++) {
        const double x = m->centre[3 * c] - 1.0, y = m->centre[3 * c + 1] - 1.0;
        for (int k = 0; k < 2; k++)
            error.u += gsl_pow_2(fl->u[3 * c + k] - T * made_u(k, x, y));
        error.p += gsl_pow_2(fl->p[c] - mean - T * made_p(x, y));
    }
    discard(fl);
    return (struct made_error){sqrt(error.u / (n * n)),
                               sqrt(error.p / (n * n))};
}

/* Both forms of the pressure term, steady. */
FACT_FOR_EACH(a_manufactured_solution_with_eps_has_order_two_in_u_and_p, 2)
{
    const struct made_error a = made_run(16, _i, 0, 0.02, 40, "euler");
    const struct made_error b = made_run(32, _i, 0, 0.02, 40, "euler");
    ck_assert_double_gt(log2(a.u / b.u), 1.85);
    ck_assert_double_gt(log2(a.p / b.p), 1.5);
    ck_assert_double_lt(b.u, 0.015);
}

/* Unsteady, on one mesh: what a step of dt adds to the error of the mesh falls
 * by 2 with Euler and by 4 with BDF2 (order 1 and 2). */
FACT_FOR_EACH(a_manufactured_solution_has_the_order_of_the_scheme_in_time, 2)
{
    const char *const time = _i ? "bdf2" : "euler";
    double u[3];
    for (int i = 0; i < 3; i++)
        u[i] = made_run(12, 1, 1, 0.04 / (1 << i), 12 << i, time).u;
    const double order = log2(fabs(u[0] - u[1]) / fabs(u[1] - u[2]));
    ck_assert_double_gt(order, _i ? 1.6 : 0.7);
    if (_i) ck_assert_double_lt(fabs(u[1] - u[2]), 1e-3);
}

/* A void fraction that travels through a periodic box, eps = 0.5 + 0.2 sin(x -
 * c t), with u = c + q / eps: which satisfies void-rate continuity exactly. */
static double wave_error(const char *time, int n, double dt)
{
    const double L = 2.0 * M_PI, speed = 1.0, q = 0.3, mu = 0.05;
    struct mesh *const m = periodic_box(L, 1.0, 1.0, n, 1, 1);
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = mu,
                                    .dt = dt,
                                    .time = time_scheme_named(time),
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .continuity = CONTINUITY_VOID_RATE,
                                    .correctors = 3,
                                    .piso_tolerance = 1e-6,
                                    .tolerance = 1e-11,
                                    .coupled = 1};
    struct fluid *const fl = fluid_create(m, &o);
    double sum = 0.0;

    for (int f = 0; f < m->n_internal; f++) {
        const double x = m->centre[3 * m->owner[f]] + 0.5 * mesh_d(m, f)[0];
        fl->phi[f] = mesh_S(m, f)[0] * (speed * (0.5 + 0.2 * sin(x)) + q);
    }
    for (int c = 0; c < n; c++) {
        fl->eps[c] = 0.5 + 0.2 * sin(m->centre[3 * c]);
        fl->u[3 * c] = speed + q / fl->eps[c];
    }
    fluid_reset_eps_history(fl);
    for (int i = 0; i * dt < 0.8 - 1e-9; i++) {
        for (int c = 0; c < n; c++) {
            const double a = m->centre[3 * c] - speed * (fl->t + dt);
            const double eps = 0.5 + 0.2 * sin(a), d = 0.2 * cos(a);
            const double dd = -0.2 * sin(a), u_x = -q * d / (eps * eps);
            const double u_xx =
                -q * (dd / (eps * eps) - 2.0 * d * d / (eps * eps * eps));
            fl->eps[c] = eps;
            /* eps (du/dt + u du/dx) = eps (u - c) du/dx = q du/dx */
            fl->F[3 * c] = q * u_x - mu * u_xx + cos(a);
        }
        ck_assert_int_eq(fluid_step(fl), 0);
    }
    for (int c = 0; c < n; c++)
        sum += gsl_pow_2(fl->u[3 * c] - speed - q / fl->eps[c]) / n;
    discard(fl);
    return sqrt(sum);
}

FACT(a_travelling_void_has_order_two_in_space_and_time)
{
    const double coarse = wave_error("bdf2", 24, 0.04);
    const double fine = wave_error("bdf2", 48, 0.02);
    ck_assert_double_gt(log2(coarse / fine), 1.8);
    ck_assert_double_lt(fine, 0.5 * wave_error("euler", 48, 0.02));
}

/* --- the cavity of Ghia --------------------------------------------------- */

static struct fluid *cavity(int n, double Re, const struct boundary b[4])
{
    const struct box_spec spec = {
        {1.0, 1.0, 0.1}, {n, n, 1}, {1.0, 1.0, 1.0}, {0, 0, 1}};
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 1.0 / Re,
                                    .dt = 0.5 / n,
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .correctors = 2,
                                    .piso_tolerance = 1e-3,
                                    .tolerance = 1e-7,
                                    .boundaries = b};
    return fluid_create(mesh_create_box(&spec), &o);
}

/* u on x = 0.5 at height y, linear between the cells beside (n even), the wall
 * at 0 and the lid at 1. */
static double on_centreline(const struct fluid *fl, int n, double y)
{
    const double at = y * n - 0.5;
    const int j = (int)floor(at);
    double value[2];

    for (int i = 0; i < 2; i++) {
        const int row = j + i, c = n / 2 + n * row;
        value[i] = row < 0    ? -fl->u[3 * (n / 2)]
                   : row >= n ? 2.0 - fl->u[3 * (n / 2 + n * (n - 1))]
                              : 0.5 * (fl->u[3 * c] + fl->u[3 * (c - 1)]);
    }
    return value[0] + (at - j) * (value[1] - value[0]);
}

/* Root mean square of u - u_Ghia over the 15 inner points of Table I [m/s]. */
static double ghia_error(int n)
{
    static const double y[] = {0.9766, 0.9688, 0.9609, 0.9531, 0.8516,
                               0.7344, 0.6172, 0.5000, 0.4531, 0.2813,
                               0.1719, 0.1016, 0.0703, 0.0625, 0.0547};
    static const double u[] = {0.84123,  0.78871,  0.73722,  0.68717,
                               0.23151,  0.00332,  -0.13641, -0.20581,
                               -0.21090, -0.15662, -0.10150, -0.06434,
                               -0.04775, -0.04192, -0.03717};
    struct boundary b[4];
    for (int i = 0; i < 4; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_NO_SLIP};
    b[3].wall[0] = 1.0;
    struct fluid *const fl = cavity(n, 100.0, b);
    double sum = 0.0;
    for (int i = 0; i < 24 * n; i++)
        ck_assert_int_eq(fluid_step(fl), 0);
    for (int i = 0; i < 15; i++)
        sum += gsl_pow_2(on_centreline(fl, n, y[i]) - u[i]) / 15.0;
    discard(fl);
    return sqrt(sum);
}

/* [Ghia82, Table I], Re = 100, on 32 x 32 cells: 1 % of the lid's velocity. */
FACT(the_cavity_has_the_profile_of_ghia_at_re_100)
{
    const double coarse = ghia_error(16), fine = ghia_error(32);
    ck_assert_double_lt(fine, 0.01);
    ck_assert_double_gt(coarse / fine, 2.0);
}

/* Half of a cube whose other half is its image, Re 1000, n^3 cells. Root mean
 * square of u - u_AK on the vertical centreline over 15 points [m/s]. */
static double cube_error(int n)
{
    static const double y[] = {0.0547, 0.0625, 0.0703, 0.1016, 0.1719,
                               0.2813, 0.4531, 0.5000, 0.6172, 0.7344,
                               0.8516, 0.9531, 0.9609, 0.9688, 0.9766};
    static const double u[] = {-0.20623, -0.22283, -0.23696, -0.27293, -0.25160,
                               -0.10999, -0.00612, 0.00802,  0.03905,  0.07334,
                               0.12183,  0.33171,  0.39821,  0.48443,  0.58964};
    struct boundary b[6];
    double sum = 0.0;

    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind =
                                     i == 5 ? BOUNDARY_SLIP : BOUNDARY_NO_SLIP};
    b[3].wall[0] = 1.0;
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 1e-3,
                                    .dt = 1.0 / n,
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .correctors = 2,
                                    .piso_tolerance = 1e-3,
                                    .tolerance = 1e-4,
                                    .boundaries = b};
    struct fluid *const fl =
        fluid_create(closed_box(1.0, 1.0, 0.5, n, n, n / 2), &o);
    for (int i = 0; i < 25 * n; i++)
        ck_assert_int_eq(fluid_step(fl), 0);
    for (int i = 0; i < 15; i++) {
        fl->u += 3 * n * n * (n / 2 - 1); /* the layer at the middle */
        sum += gsl_pow_2(on_centreline(fl, n, y[i]) - u[i]) / 15.0;
        fl->u -= 3 * n * n * (n / 2 - 1);
    }
    discard(fl);
    return sqrt(sum);
}

/* [Albensoeder05, Table 5]: coarse, and nearer with each cell; Chapter "The
 * flow, verified" has finer meshes. */
FACT(the_cubic_cavity_nears_albensoeder_and_kuhlmann_at_re_1000)
{
    const double fine = cube_error(16);
    ck_assert_double_lt(fine, 0.08);
    ck_assert_double_gt(cube_error(8), 1.2 * fine);
}

/* --- hard cases ----------------------------------------------------------- */

static void stream_boundaries(struct boundary b[6], const double *U)
{
    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    b[2] = (struct boundary){
        .kind = BOUNDARY_INLET, .n_points = 1, .time = &zero, .velocity = U};
    b[3] = (struct boundary){.kind = BOUNDARY_OUTLET};
}

static struct fluid *column(const struct boundary b[6], double dt,
                            const double size[3], const int cells[3])
{
    const struct fluid_options o = {.rho = 1.2,
                                    .mu = 1.8e-5,
                                    .dt = dt,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .continuity = CONTINUITY_VOID_RATE,
                                    .correctors = 2,
                                    .piso_tolerance = 1e-3,
                                    .tolerance = 1e-9,
                                    .coupled = 1,
                                    .boundaries = b};
    return fluid_create(
        closed_box(size[0], size[1], size[2], cells[0], cells[1], cells[2]),
        &o);
}

/* From rest, the inlet switched on at once: eps jumping 0.4/1 across one face,
 * drag coefficients up to 1e8, Courant numbers up to 12, cells 100 times as
 * wide as high, one cell across. The stream must be there; viscosity smooths
 * the jump of its velocity by 3e-3. */
FACT_FOR_EACH(a_stream_switched_on_at_once_comes_to_its_steady_state, 6)
{
    static const struct {
        double dt, K, size[3];
        int cells[3];
    } rows[] = {
        {1e-3, 1e3, {0.02, 0.1, 0.01}, {4, 20, 1}},
        {1e-2, 1e3, {0.02, 0.1, 0.01}, {4, 20, 1}}, /* Courant number 5 */
        {1e-3, 1e8, {0.02, 0.1, 0.01}, {4, 20, 1}},
        {1e-3, 1e3, {2.0, 0.1, 2.0}, {4, 20, 4}}, /* flat: 100 to 1 */
        {1e-2, 1e3, {0.01, 0.1, 0.01}, {1, 20, 1}},
        {1e-2, 0.0, {0.01, 0.01, 0.01}, {1, 1, 1}}};
    const double U = 1.0;
    struct boundary b[6];
    stream_boundaries(b, &U);
    struct fluid *const fl =
        column(b, rows[_i].dt, rows[_i].size, rows[_i].cells);
    const struct mesh *const m = fl->mesh;
    for (int c = 0; c < m->n_cells; c++) {
        const int bed = m->centre[3 * c + 1] < 0.5 * rows[_i].size[1];
        if (rows[_i].K == 0.0 || !bed) continue;
        fl->eps[c] = 0.4;
        fl->K[c] = rows[_i].K;
    }
    fluid_reset_eps_history(fl);
    for (int n = 0; n < 400; n++)
        ck_assert_int_eq(fluid_step(fl), 0);
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq_tol(fl->u[3 * c + 1] * fl->eps[c] / U, 1.0, 5e-3);
    discard(fl);
}

/* A cavity at ten times its stable explicit step, Courant number 5: Euler and
 * upwind stay bounded by the lid. */
FACT(a_cavity_at_courant_number_5_stays_below_its_lid)
{
    struct boundary b[4];
    for (int i = 0; i < 4; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_NO_SLIP};
    b[3].wall[0] = 1.0;
    struct fluid *const fl = cavity(16, 1000.0, b);
    fl->options.convection = convection_scheme_named("upwind");
    fl->options.dt = 5.0 / 16.0;
    for (int n = 0; n < 100; n++)
        ck_assert_int_eq(fluid_step(fl), 0);
    for (int i = 0; i < 3 * 256; i++)
        ck_assert_double_lt(fabs(fl->u[i]), 1.0);
    ck_assert_double_lt(fl->report.piso_residual, 1e-3);
    discard(fl);
}

/* Viscosity that crosses many cells within a step: two corrections are not
 * enough and would diverge; further ones are added automatically. */
FACT(corrections_go_on_where_viscosity_is_fast)
{
    struct boundary b[4];
    for (int i = 0; i < 4; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_NO_SLIP};
    b[3].wall[0] = 1.0;
    struct fluid *const fl = cavity(16, 0.1, b); /* nu dt / dx^2 = 80 */
    int most = 0;
    for (int n = 0; n < 60; n++) {
        ck_assert_int_eq(fluid_step(fl), 0);
        ck_assert_double_lt(fl->report.piso_residual, 1e-3);
        most = fl->report.correctors > most ? fl->report.correctors : most;
    }
    ck_assert_int_gt(most, 2);
    for (int i = 0; i < 3 * 256; i++)
        ck_assert_double_lt(fabs(fl->u[i]), 1.0);
    discard(fl);
}

FACTS
{
    tcase_set_timeout(facts, 120.0);
}
