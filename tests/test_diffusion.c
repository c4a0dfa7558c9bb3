/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/diffusion.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"
#include "cloud.h"

/* A box with one particle in the middle of every cell: to spread the amounts
 * V f is to smooth the field f. */
struct scene {
    struct mesh *mesh;
    struct particles *ps;
    struct averaging *a;
    double *q, *field;
};

static struct scene scene_of(const struct box_spec *spec,
                             const struct averaging_options *o)
{
    struct scene s = {.mesh = mesh_create_box(spec)};
    const int n = s.mesh->n_cells;

    s.ps = particles_create(n);
    for (int c = 0; c < n; c++)
        cloud_place(s.ps, s.mesh->centre[3 * c], s.mesh->centre[3 * c + 1],
                    s.mesh->centre[3 * c + 2], 0.001);
    s.a =
        averaging_create(averaging_method_named("diffusion"), s.mesh, s.ps, o);
    s.q = alloc_doubles(n);
    s.field = alloc_doubles(n);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    return s;
}

static void scene_free(struct scene *s)
{
    averaging_free(s->a);
    particles_free(s->ps);
    mesh_free(s->mesh);
    free(s->q);
    free(s->field);
}

/* The field after one m^3 in the middle of cell c. */
static void smooth_one(struct scene *s, int c)
{
    for (int i = 0; i < s->ps->n; i++)
        s->q[i] = i == c;
    averaging_spread(s->a, 1, s->q, s->field);
}

/* h(0, 1) = pi^(-3/2), and e^-1 less at r = b; 8 times as much for b / 2. */
FACT(sx15_6_values)
{
    ck_assert_double_eq_tol(diffusion_kernel(0.0, 1.0), 0.17958712212516656,
                            1e-16);
    ck_assert_double_eq_tol(diffusion_kernel(1.0, 1.0), 0.06606641012899384,
                            1e-16);
    ck_assert_double_eq_tol(diffusion_kernel(0.5, 0.5), 0.52853128103195070,
                            1e-15);
}

/* Trapezoids of a Gaussian are exact to rounding if they are fine. */
FACT(sx15_6_encloses_one)
{
    const double b = 0.3, dr = 0.01;
    double sum = 0.0;

    for (int i = 1; i < 1000; i++)
        sum +=
            4.0 * M_PI * gsl_pow_2(i * dr) * diffusion_kernel(i * dr, b) * dr;
    ck_assert_double_eq_tol(sum, 1.0, 1e-14);
}

FACT(sx15_b_is_the_root_of_4_T)
{
    ck_assert_double_eq_tol(diffusion_time(4.8e-3), 5.76e-6, 1e-20);
}

/* Largest error against [SX15 6], over its largest value, of one particle in
 * the middle of a cube of n cells a side; the walls are 4 b away, where the
 * kernel is 1e-7 of its middle. */
static double gaussian_error(int n)
{
    const struct box_spec spec = {
        {1.0, 1.0, 1.0}, {n, n, n}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct averaging_options o = {
        .bandwidth = 0.125, .tolerance = 1e-9, .fields = 1};
    struct scene s = scene_of(&spec, &o);
    const double *const x = s.mesh->centre;
    double worst = 0.0;

    smooth_one(&s, s.mesh->n_cells / 2);
    for (int c = 0; c < s.mesh->n_cells; c++) {
        const double r =
            gsl_hypot3(x[3 * c] - 0.5, x[3 * c + 1] - 0.5, x[3 * c + 2] - 0.5);
        worst = fmax(worst, fabs(s.field[c] - diffusion_kernel(r, 0.125)));
    }
    scene_free(&s);
    return worst / diffusion_kernel(0.0, 0.125);
}

/* Cells of b/4 and b/6 or so. The mesh damps a wave k by too little, by
 * T k^4 dx^2 / 12 in each direction; over the spectrum of the Gaussian that
 * makes the middle too high by the share 3/4 (dx/b)^2. The next term is 4 % of
 * it at b/6, and 0.13 of the order. */
FACT(sx15_6_diffusion_is_the_gaussian_kernel_to_second_order)
{
    const double e1 = gaussian_error(33), e2 = gaussian_error(49);
    const double leading = 0.75 * gsl_pow_2(8.0 / 49.0);

    ck_assert_double_eq_tol(log(e1 / e2) / log(49.0 / 33.0), 2.0, 0.15);
    ck_assert_double_eq_tol(e2 / leading, 1.0, 0.05);
}

/* Two dimensions, one particle 0.1 b from one wall and b from another: the
 * field is that of a box twice (and twice) as large, unfolded. The cells are
 * the same, so only rounding is between them. */
FACT(sx15_5c_a_wall_is_a_mirror)
{
    enum { H = 20 };
    const struct box_spec half = {
        {1.0, 1.0, 0.1}, {H, H, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct box_spec whole = {
        {2.0, 2.0, 0.1}, {2 * H, 2 * H, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct averaging_options o = {.bandwidth = 0.3, .tolerance = 1e-13};
    struct scene s = scene_of(&half, &o), big = scene_of(&whole, &o);
    const int i = 0, j = 5;

    smooth_one(&s, i + H * j);
    for (int image = 0; image < 4; image++) {
        const int x = image % 2 ? H + i : H - 1 - i;
        const int y = image / 2 ? H + j : H - 1 - j;
        big.q[x + 2 * H * y] = 1.0;
    }
    averaging_spread(big.a, 1, big.q, big.field);
    for (int c = 0; c < H * H; c++) {
        const int x = H + c % H, y = H + c / H;
        ck_assert_double_eq_tol(s.field[c], big.field[x + 2 * H * y],
                                1e-11 * averaging_report(s.a)->highest);
    }
    scene_free(&s);
    scene_free(&big);
}

/* And in numbers: near a wall twice [SX15 6] in one dimension. dx = b/30. */
FACT(sx15_5c_at_a_wall_the_gaussian_is_doubled)
{
    const struct box_spec spec = {
        {1.0, 0.1, 0.1}, {300, 1, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct averaging_options o = {.bandwidth = 0.1, .tolerance = 1e-9};
    struct scene s = scene_of(&spec, &o);
    const double b = 0.1, *const x = s.mesh->centre;

    smooth_one(&s, 0);
    for (int c = 0; c < 300; c++) {
        const double r = x[3 * c] - x[0], image = x[3 * c] + x[0];
        const double line =
            (exp(-r * r / (b * b)) + exp(-image * image / (b * b))) /
            (b * sqrt(M_PI));
        ck_assert_double_eq_tol(s.field[c] * 0.01, line, 0.01); /* of 11 */
    }
    scene_free(&s);
}

/* A cosine is an eigenvector of the mesh Laplacian between walls,
 * lambda = 4/dx^2 sin^2(pi k / 2n): each scheme damps it by its own factor, to
 * the tolerance. z = lambda T is 0.54, 4.7 and 46: slow, middling, stiff. */
static void check_factor(const struct averaging_options *o, int k,
                         double (*factor)(double z, int steps))
{
    enum { M = 40 };
    const struct box_spec spec = {
        {1.0, 0.1, 0.1}, {M, 1, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct scene s = scene_of(&spec, o);
    const double lambda = 4.0 * M * M * gsl_pow_2(sin(0.5 * M_PI * k / M));
    const double expected =
        factor(lambda * diffusion_time(o->bandwidth), o->steps);

    for (int c = 0; c < M; c++)
        s.q[c] = s.mesh->V[c] * cos(M_PI * k * (c + 0.5) / M);
    averaging_spread(s.a, 1, s.q, s.field);
    for (int c = 0; c < M; c++)
        ck_assert_double_eq_tol(s.field[c],
                                expected * cos(M_PI * k * (c + 0.5) / M), 1e-9);
    scene_free(&s);
}

static double exact(double z, int steps)
{
    (void)steps;
    return exp(-z);
}

static double crank_nicolson(double z, int steps)
{
    return pow((1.0 - 0.5 * z / steps) / (1.0 + 0.5 * z / steps), steps);
}

static double implicit_euler(double z, int steps)
{
    return pow(1.0 + z / steps, -steps);
}

/* (1 - (1 - 2 g) z) / (1 + g z)^2 with g = 1 - 1/sqrt 2, step by step. */
static double sdirk2(double z, int steps)
{
    const double g = 1.0 - M_SQRT1_2, w = z / steps;
    return pow((1.0 - (1.0 - 2.0 * g) * w) / gsl_pow_2(1.0 + g * w), steps);
}

static const int waves[] = {1, 3, 10};

FACT_FOR_EACH(sx15_5_the_exponential_damps_a_wave_exactly, 6)
{
    const struct averaging_options o = {.bandwidth = 0.47,
                                        .scheme =
                                            diffusion_schemes[_i / 3]->name,
                                        .tolerance = 1e-10};
    check_factor(&o, waves[_i % 3], exact);
}

FACT_FOR_EACH(sx15_5_crank_nicolson_damps_a_wave_as_it_should, 3)
{
    const struct averaging_options o = {.bandwidth = 0.47,
                                        .scheme = "crank-nicolson",
                                        .steps = 3,
                                        .tolerance = 1e-12};
    check_factor(&o, waves[_i], crank_nicolson);
}

FACT_FOR_EACH(sx15_5_implicit_euler_damps_a_wave_as_it_should, 3)
{
    const struct averaging_options o = {.bandwidth = 0.47,
                                        .scheme = "implicit-euler",
                                        .steps = 3,
                                        .tolerance = 1e-12};
    check_factor(&o, waves[_i], implicit_euler);
}

FACT_FOR_EACH(sx15_5_sdirk2_damps_a_wave_as_it_should, 3)
{
    const struct averaging_options o = {
        .bandwidth = 0.47, .scheme = "sdirk2", .steps = 3, .tolerance = 1e-12};
    check_factor(&o, waves[_i], sdirk2);
}

/* z = 48, cells of one diameter and b of four, three steps: sdirk2 leaves a
 * hundredth of the shortest wave, Crank-Nicolson half of it. */
FACT(a_stiff_wave_is_gone_after_a_step_of_sdirk2)
{
    ck_assert_double_lt(fabs(sdirk2(48.0, 3)), 0.02);
    ck_assert_double_gt(fabs(crank_nicolson(48.0, 3)), 0.45);
    ck_assert_double_lt(fabs(sdirk2(1e6, 1)), 1e-5); /* Like 4.8 / z. */
}

/* Graded mesh in two dimensions, a blob: the distance (V-weighted, L1) of a
 * scheme with so many steps from the exponential. */
static double time_error(const char *scheme, int steps)
{
    const struct box_spec spec = {
        {1.0, 0.8, 0.1}, {16, 12, 1}, {2.0, 0.6, 1.0}, {1, 0, 0}};
    const struct averaging_options exact_o = {.bandwidth = 0.2,
                                              .tolerance = 1e-12};
    const struct averaging_options o = {
        .bandwidth = 0.2, .scheme = scheme, .steps = steps, .tolerance = 1e-12};
    struct scene s = scene_of(&spec, &o), sure = scene_of(&spec, &exact_o);
    double sum = 0.0;

    for (int c = 0; c < s.mesh->n_cells; c++) {
        const double x = s.mesh->centre[3 * c] - 0.4;
        const double y = s.mesh->centre[3 * c + 1] - 0.3;
        s.q[c] = s.mesh->V[c] * exp(-20.0 * (x * x + y * y));
        sure.q[c] = s.q[c];
    }
    averaging_spread(s.a, 1, s.q, s.field);
    averaging_spread(sure.a, 1, sure.q, sure.field);
    for (int c = 0; c < s.mesh->n_cells; c++)
        sum += s.mesh->V[c] * fabs(s.field[c] - sure.field[c]);
    scene_free(&s);
    scene_free(&sure);
    return sum;
}

/* The order shows once the steps are short: 0.1 and less of the order is left
 * to the next term. */
FACT(crank_nicolson_is_of_second_order_in_pseudo_time)
{
    const double e1 = time_error("crank-nicolson", 8);
    const double e2 = time_error("crank-nicolson", 16);
    ck_assert_double_eq_tol(log2(e1 / e2), 2.0, 0.1);
}

FACT(sdirk2_is_of_second_order_in_pseudo_time)
{
    const double e1 = time_error("sdirk2", 8);
    const double e2 = time_error("sdirk2", 16);
    ck_assert_double_eq_tol(log2(e1 / e2), 2.0, 0.1);
}

FACT(implicit_euler_is_of_first_order_in_pseudo_time)
{
    const double e1 = time_error("implicit-euler", 16);
    const double e2 = time_error("implicit-euler", 32);
    ck_assert_double_eq_tol(log2(e1 / e2), 1.0, 0.1);
}

/* One full cell in the middle of a cube of 15 cells, dx = 1, b = 2 dx r with
 * r^2 = T / dx^2. */
static struct averaging_report one_full_cell(const char *scheme, int steps,
                                             double T)
{
    const struct box_spec spec = {
        {15.0, 15.0, 15.0}, {15, 15, 15}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct averaging_options o = {.bandwidth = sqrt(4.0 * T),
                                        .scheme = scheme,
                                        .steps = steps,
                                        .tolerance = 1e-9,
                                        .fields = 1};
    struct scene s = scene_of(&spec, &o);
    smooth_one(&s, s.mesh->n_cells / 2);
    const struct averaging_report r = *averaging_report(s.a);
    scene_free(&s);
    return r;
}

/* By measurement Crank-Nicolson undershoots here from T / dx^2 = 0.37 with one
 * step, 1.37 with three, 3.9 with six; m >= 3 T / dx^2 is sure not to. */
FACT_FOR_EACH(crank_nicolson_undershoots_beyond_its_limit_and_says_so, 3)
{
    static const int steps[] = {1, 3, 6};
    static const double limit[] = {0.37, 1.37, 3.9};

    const struct averaging_report above =
        one_full_cell("crank-nicolson", steps[_i], 1.02 * limit[_i]);
    const struct averaging_report below =
        one_full_cell("crank-nicolson", steps[_i], 0.98 * limit[_i]);
    const struct averaging_report safe =
        one_full_cell("crank-nicolson", steps[_i], steps[_i] / 3.0);
    ck_assert_double_lt(above.lowest, -1e-4 * above.highest);
    ck_assert_double_gt(above.negative, 1e-4);
    ck_assert_double_gt(below.lowest, -1e-8 * below.highest);
    ck_assert_double_gt(safe.lowest, -1e-8 * safe.highest);
}

/* By measurement too: from 0.48 with one step, from 2.6 with three; with two
 * and four not at all, the signs of two steps cancelling. */
FACT_FOR_EACH(sdirk2_undershoots_with_few_odd_steps_and_says_so, 2)
{
    static const int steps[] = {1, 3};
    static const double limit[] = {0.48, 2.6};
    const struct averaging_report above =
        one_full_cell("sdirk2", steps[_i], 1.1 * limit[_i]);
    const struct averaging_report below =
        one_full_cell("sdirk2", steps[_i], 0.9 * limit[_i]);
    const struct averaging_report even =
        one_full_cell("sdirk2", steps[_i] + 1, 16.0);

    ck_assert_double_lt(above.lowest, -1e-5 * above.highest);
    ck_assert_double_gt(below.lowest, -1e-8 * below.highest);
    ck_assert_double_gt(even.lowest, -1e-8 * even.highest);
}

/* The prototype's figure: 22 % of the total, as a share of what is left. */
FACT(crank_nicolson_with_three_steps_at_dx_of_d_is_a_fifth_negative)
{
    const struct averaging_report r = one_full_cell("crank-nicolson", 3, 4.0);
    ck_assert_double_eq_tol(r.negative / (1.0 - 2.0 * r.negative), 0.22, 0.02);
}

/* In a box not at all; to the tolerance of the series or of the solver, 1e-9,
 * with a margin. */
FACT_FOR_EACH(exponential_and_implicit_euler_never_undershoot, 4)
{
    static const double T[] = {0.1, 1.0, 4.0, 16.0};
    const struct averaging_report box = one_full_cell("exponential", 0, T[_i]);
    const struct averaging_report series = one_full_cell("series", 0, T[_i]);
    const struct averaging_report euler =
        one_full_cell("implicit-euler", 1, T[_i]);

    ck_assert_double_ge(box.lowest, 0.0);
    ck_assert_int_eq(box.products, 0);
    ck_assert_double_gt(series.lowest, -2e-9);
    ck_assert_int_gt(series.products, 0);
    ck_assert_double_gt(euler.lowest, -2e-9);
}

/* 3 T / dx^2 in cubes, 2 T / dx^2 in squares, T / dx^2 in a row; a graded mesh
 * goes by its worst cell. */
FACT(the_safe_number_of_steps_is_3_T_over_dx_squared_in_cubes)
{
    static const int cells[3][3] = {{5, 5, 5}, {5, 5, 1}, {1, 5, 1}};
    for (int i = 0; i < 3; i++) {
        struct mesh *const m =
            closed_box(cells[i][0] * 0.1, cells[i][1] * 0.1, cells[i][2] * 0.1,
                       cells[i][0], cells[i][1], cells[i][2]);
        const double b = 0.2; /* T = dx^2 */
        ck_assert_double_eq_tol(diffusion_safe_steps(m, b), 3.0 - i, 1e-12);
        mesh_free(m);
    }
}

FACT(a_check_warns_of_too_few_steps_of_crank_nicolson_only)
{
    const struct averaging_method *const diffusion =
        averaging_method_named("diffusion");
    struct mesh *const m = mesh_create_box(&cloud_shapes[5]);
    struct averaging_options o = {
        .bandwidth = 0.4, .steps = 11, .scheme = "crank-nicolson"};

    ck_assert_int_eq(averaging_check(diffusion, m, &o), 12);
    o.steps = 0; /* 3 */
    ck_assert_int_eq(averaging_check(diffusion, m, &o), 12);
    o.steps = 12;
    ck_assert_int_eq(averaging_check(diffusion, m, &o), 0);
    o.steps = 1;
    o.scheme = "implicit-euler";
    ck_assert_int_eq(averaging_check(diffusion, m, &o), 0);
    o.scheme = NULL;
    ck_assert_int_eq(averaging_check(diffusion, m, &o), 0);
    o.scheme = "crank-nicolson";
    ck_assert_int_eq(averaging_check(averaging_method_named("pcm"), m, &o), 0);
    mesh_free(m);
}

/* Diffused for long, everything is everywhere: the mean, V-weighted. */
FACT_FOR_EACH(sx15_a_5_what_is_left_after_a_long_time_is_the_mean, CLOUD_SHAPES)
{
    const struct averaging_options o = {.bandwidth = 12.0, .tolerance = 1e-9};
    struct scene s = scene_of(&cloud_shapes[_i], &o);
    double volume = 0.0;

    for (int c = 0; c < s.mesh->n_cells; c++)
        volume += s.mesh->V[c];
    smooth_one(&s, s.mesh->n_cells / 3);
    for (int c = 0; c < s.mesh->n_cells; c++)
        ck_assert_double_eq_tol(s.field[c] * volume, 1.0, 1e-6);
    scene_free(&s);
}

/* A row of four cells: a full one that moves, one a quarter full and at rest
 * beside it. Momentum per volume, diffused, keeps its sum; velocity, diffused
 * by itself and then multiplied by the diffused eps_s, does not. */
FACT(sx15_9_momentum_is_to_be_diffused_and_not_velocity)
{
    const struct box_spec spec = {
        {4.0, 1.0, 1.0}, {4, 1, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct averaging_options o = {.bandwidth = 1.5, .tolerance = 1e-12};
    const double solids[4] = {0.0, 0.6, 0.15, 0.0};
    const double u[4] = {0.0, 1.0, 0.0, 0.0};
    struct scene s = scene_of(&spec, &o);
    double q[12], field[12], kept = 0.0, changed = 0.0;

    for (int c = 0; c < 4; c++) {
        q[3 * c] = solids[c];
        q[3 * c + 1] = solids[c] * u[c];
        q[3 * c + 2] = u[c];
    }
    averaging_spread(s.a, 3, q, field);
    for (int c = 0; c < 4; c++) {
        kept += field[3 * c + 1];
        changed += field[3 * c] * field[3 * c + 2];
    }
    ck_assert_double_eq_tol(kept, 0.6, 1e-15);
    ck_assert_double_lt(changed, 0.4);
    scene_free(&s);
}
