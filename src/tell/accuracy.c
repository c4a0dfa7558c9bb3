/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tell/check.h"

#include "case/case_mesh.h"
#include "case/checks/checks.h"
#include "case/particles/case_materials.h"
#include "fluid/schemes.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* One choice that could be finer. */
struct choice {
    char name[48];
    double error; /* [-] that it makes now, of a structure of ten cells; nan:
                     not known */
    double over;  /* [-] then the error is over that */
    double time;  /* [-] and the time times that */
    const char *of;
};

struct choices {
    int n;
    struct choice all[16];
    double k_h;     /* [-] wave number of ten cells, times the cell */
    double courant; /* [-] */
};

static void add_choice(struct choices *c, const char *name, double error,
                       double over, double time, const char *of)
{
    struct choice *const one = &c->all[c->n++];

    *one =
        (struct choice){.error = error, .over = over, .time = time, .of = of};
    snprintf(one->name, sizeof one->name, "%s", name);
}

/* The largest first, those that are not known last. */
static int compare_choices(const void *p, const void *q)
{
    const double a = ((const struct choice *)p)->error,
                 b = ((const struct choice *)q)->error;

    if (isnan(a) || isnan(b)) return isnan(a) - isnan(b);
    return (a < b) - (a > b);
}

/* The time with steps of the fluid and of the particles, and cells, that are so
 * many times as many. */
static double time_with(const struct case_scales *k, int flow, double steps,
                        double particle_steps, double cells)
{
    struct case_scales other = *k;

    other.dt = k->dt / steps;
    other.dem_steps = 1;
    const double one = case_scales_cost(k, flow);
    const double grains =
        case_scales_cost(k, 0) * particle_steps; /* without the flow */
    other.particles = 0;
    return (grains + cells * case_scales_cost(&other, flow)) / one;
}

/* Implicit Euler damps a wave that goes by with C cells a step by k h C / 2 in
 * the time of one radian, two steps by (k h C)^2 / 3. */
static double error_of_step(const struct settings *s, const struct choices *c)
{
    const double x = c->k_h * c->courant;

    if (!(x > 0.0)) return NAN;
    return s->fluid.time->time_levels == 1 ? x / 2.0 : x * x / 3.0;
}

static void add_step(const struct settings *s, const struct case_scales *k,
                     struct choices *c)
{
    const double order = s->fluid.time->time_levels;
    const double error = error_of_step(s, c);

    if (order == 1.0 && error > 0.0)
        add_choice(c, "fluid.time = bdf2", error, 0.75 / error, 1.0,
                   "of the step");
    add_choice(c, "fluid.step halved", error, pow(2.0, order),
               time_with(k, 1, 2.0, 1.0, 1.0), "of the step");
}

/* Directions that have more than one cell, and the product of their numbers. */
static int accuracy_directions_of(const struct settings *s, double *cells)
{
    const int *const n = s->mesh.box.cells;
    int directions = 0;

    *cells = 1.0;
    if (s->mesh.polymesh != NULL) return 0;
    for (int i = 0; i < 3; i++) {
        directions += n[i] > 1;
        *cells *= n[i];
    }
    return directions;
}

/* The time if that of the equations of the flow becomes `by` as long. With
 * grains half of what a cell takes is the coupling. */
static double time_of_flow(const struct settings *s,
                           const struct case_scales *k, double by)
{
    const double share = s->has.exchange ? 0.5 : 1.0;

    return time_with(k, 1, 1.0, 1.0, 1.0 + share * (by - 1.0));
}

/* The flow that convection carries. */
struct carried {
    int layer;     /* [-] 1: across one layer; 0: as in a cavity */
    double upwind; /* [-] error of upwind over that of second-upwind */
};

/* 1 if an end of the direction is of that kind. */
static int has_end(const struct settings *s, int direction,
                   enum boundary_kind kind)
{
    for (int i = 2 * direction; i < 2 * direction + 2; i++) {
        const struct boundary_options *const o =
            settings_side(s, mesh_sides[i]);
        if (o != NULL && o->condition->kind == kind) return 1;
    }
    return 0;
}

/* 1 if the flow goes along all faces between cells, so that convection carries
 * nothing: between two walls in the only direction that has cells. */
static int carries_nothing(const struct settings *s, int direction)
{
    int periodic[3];

    case_mesh_periodic(s, periodic);
    return !periodic[direction] && !has_end(s, direction, BOUNDARY_INLET) &&
           !has_end(s, direction, BOUNDARY_OUTLET);
}

/* The first terms of the two errors, h/2 u'' and h^2/12 u''', have the ratio
 * 6 l/h, where l = u''/u'''. In a cavity of N cells a side it is N/4. Where one
 * direction alone has cells and the flow goes through it, l is the width nu/V
 * of the layer at its end, or a fifth of the side if that is less. */
static struct carried carried_in(const struct settings *s,
                                 const struct case_scales *k, int only)
{
    double cells;
    const int directions = accuracy_directions_of(s, &cells);

    if (only < 0 || !has_end(s, only, BOUNDARY_INLET) || k->inlet == 0.0)
        return (struct carried){0, pow(cells, 1.0 / directions) / 4.0};
    const double nu = s->fluid.mu / s->fluid.rho;
    return (struct carried){
        1, 6.0 * cells * fmin(nu / k->inlet / s->mesh.box.size[only], 0.2)};
}

static double left_by(const struct convection_scheme *scheme, struct carried c)
{
    return fmax(scheme->share * c.upwind, scheme->least[c.layer]);
}

/* The first terms of the errors of a wave, in one radian: k h / 2 and more. */
static double error_of_cells(const struct settings *s, const struct choices *c,
                             int carries)
{
    const struct convection_scheme *const scheme = s->fluid.convection;

    if (!carries) return c->k_h * c->k_h / 12.0; /* of the viscous stress */
    return scheme->error * pow(c->k_h, scheme->order);
}

/* From one scheme to the other. */
static void add_scheme(const struct settings *s, const struct case_scales *k,
                       const struct convection_scheme *from,
                       const struct convection_scheme *to, struct carried flow,
                       struct choices *c)
{
    char name[64];

    if (from == to) return;
    snprintf(name, sizeof name, "fluid.convection = %s", to->name);
    add_choice(c, name, error_of_cells(s, c, 1),
               left_by(from, flow) / left_by(to, flow),
               time_of_flow(s, k, to->time / from->time), "of convection");
}

/* The only direction that has cells, of a flow without grains; else -1. */
static int only_direction(const struct settings *s)
{
    const int *const n = s->mesh.box.cells;
    double cells;

    if (accuracy_directions_of(s, &cells) != 1 || s->has.exchange) return -1;
    return n[0] > 1 ? 0 : n[1] > 1 ? 1 : 2;
}

static void add_cells(const struct settings *s, const struct case_scales *k,
                      struct choices *c)
{
    const struct convection_scheme *const from = s->fluid.convection;
    const int only = only_direction(s);
    double n;

    const int directions = accuracy_directions_of(s, &n);
    const int carries = only < 0 || !carries_nothing(s, only);
    if (directions > 0)
        add_choice(
            c, "mesh.cells doubled, fluid.step halved",
            error_of_cells(s, c, carries), pow(2.0, s->fluid.convection->order),
            time_with(k, 1, 2.0, 1.0, pow(2.0, directions)), "of the cells");
    if (directions == 0 || !carries) return;
    const struct carried flow = carried_in(s, k, only);
    add_scheme(s, k, from, &convection_second_upwind, flow, c);
    if (s->fluid.convection->order > 1.0)
        add_scheme(s, k, from, &convection_upwind, flow, c);
}

/* The number of iterations is proportional to the digits that are asked for,
 * and the rest of a step takes as long as four digits. The error of one digit
 * more is not a tenth, since iterations are whole, but that of four digits more
 * is about 1e-4 (study tolerance). A corrector takes a quarter of the time of
 * the rest, and leaves about a sixth of the error of the one before at Courant
 * numbers of one half (study correctors). */
static void add_solvers(const struct settings *s, const struct case_scales *k,
                        struct choices *c)
{
    const double digits = -log10(s->fluid.tolerance), rest = 4.4;
    const int n = s->fluid.correctors;

    add_choice(c, "fluid.tolerance over 10", s->fluid.tolerance, 10.0,
               time_of_flow(s, k, (digits + 5.0) / (digits + 4.0)),
               "of the equations, in the mean");
    add_choice(
        c, "fluid.correctors one more", error_of_step(s, c) * pow(6.0, 1.0 - n),
        6.0, time_of_flow(s, k, (rest + n + 1.0) / (rest + n)), "of splitting");
}

/* Smoothing reduces a wave by a share proportional to the square of the
 * bandwidth. The diffusion takes the same time for any bandwidth. */
static void add_bandwidth(const struct settings *s, const struct case_scales *k,
                          struct choices *c)
{
    const struct averaging_method *const method = s->averaging.method;
    const double kb =
        method->gaussian * s->averaging.bandwidth * c->k_h / k->S_c;

    if (method == &diffusion_method)
        add_choice(c, "averaging.bandwidth halved", -expm1(-0.25 * kb * kb),
                   4.0, 1.0, "the damping of a wave");
}

/* A sub-step asks for the drag of each particle once, which was seen to cost as
 * much as a step of its motion. Where their number is left to the program it is
 * no choice. */
static void add_substeps(const struct settings *s, const struct case_scales *k,
                         struct choices *c)
{
    const int n = s->exchange.substeps;
    const double tau = check_scales(s, k).tau;
    struct case_scales one = *k;

    if (n == 0) return;
    one.dem_steps = n;
    one.cells = 0;
    const double more = case_scales_cost(&one, 0) / case_scales_cost(k, 1);
    add_choice(c, "exchange.substeps doubled",
               tau > 0.0 ? fmin(1.0, 0.5 * k->dt / n / tau) : NAN, 2.0,
               1.0 + more, "of the drag");
}

/* The force of a dashpot jumps when a contact begins and ends. Without one, e =
 * 1, the integrator has its own order; without contacts there is no impact. One
 * that adapts is told its error. */
static void add_impacts(const struct settings *s, const struct case_scales *k,
                        int flow, struct choices *c)
{
    if (s->particles.integrator->adapts) return;
    const double e = case_materials_one(s, 0).restitution;
    const double x = k->dem_dt / case_scales_tightest(s, k->impact).contact;
    const double error = e == 1.0 ? M_PI * M_PI * x * x / 24.0 : (1.0 - e) * x;

    add_choice(c, "particles.step halved", isfinite(error) ? error : NAN,
               e == 1.0 ? 4.0 : 2.0, time_with(k, flow, 1.0, 2.0, 1.0),
               "of an impact");
}

void check_accuracy(const struct settings *s, const struct case_scales *k)
{
    const int flow = s->has.fluid;
    struct choices c = {.k_h = 2.0 * M_PI / 10.0};

    if (flow) {
        c.courant = check_courant(s, k);
        add_step(s, k, &c);
        add_cells(s, k, &c);
        add_solvers(s, k, &c);
    }
    if (s->has.averaging) add_bandwidth(s, k, &c);
    if (s->has.exchange) add_substeps(s, k, &c);
    if (k->particles > 0 && !s->particles.list->no_contacts)
        add_impacts(s, k, flow, &c);
    qsort(c.all, (size_t)c.n, sizeof *c.all, compare_choices);
    printf("What accuracy costs, the largest error first, of a structure of "
           "ten cells\n  %-38s %9s %9s %9s\n  %-38s %9s %9s %9s\n",
           "", "error", "then", "time", "", "%", "over", "times");
    for (int i = 0; i < c.n; i++) {
        const struct choice *const one = &c.all[i];
        char error[32] = "-";
        if (!isnan(one->error))
            snprintf(error, sizeof error, "%.2g", 100.0 * one->error);
        printf("  %-38s %9s %9.3g %9.4g  %s\n", one->name, error, one->over,
               one->time, one->of);
    }
}
