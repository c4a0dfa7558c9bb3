/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tell/check.h"

#include "case/case_mesh.h"
#include "case/checks/case_scales.h"
#include "base/text.h"
#include "fluid/time_scheme.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* In words: an error that is so many times as small, or as large if that is
 * below one. */
static void line_by(const char *name, double time, const char *of, double by)
{
    char remark[128];

    snprintf(remark, sizeof remark, "times the time; %s %s %.3g", of,
             by < 1.0 ? "times" : "over", by < 1.0 ? 1.0 / by : by);
    text_line(name, time, "-", remark);
}

/* A factor of two in a size, of that order. */
static void accuracy_line(const char *name, double time, const char *of,
                          double order, int finer)
{
    line_by(name, time, of, pow(2.0, finer ? order : -order));
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

static void print_fluid(const struct settings *s, const struct case_scales *k)
{
    const double order = s->fluid.time->time_levels;

    if (order == 1.0)
        text_line("fluid.time = bdf2", 1.0, "-",
                  "times the time; the error of the step of order 2, not 1");
    accuracy_line("fluid.step halved", time_with(k, 1, 2.0, 1.0, 1.0),
                  "the error of the step", order, 1);
    accuracy_line("fluid.step doubled", time_with(k, 1, 0.5, 1.0, 1.0),
                  "the error of the step", order, 0);
}

/* Two of the convection schemes are of first order. */
static double order_of_cells(const struct settings *s)
{
    const char *const name = s->fluid.convection->name;

    return strcmp(name, "upwind") == 0 || strcmp(name, "blended") == 0 ? 1.0
                                                                       : 2.0;
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

/* What a convection scheme takes and leaves: its error over that of
 * second-upwind, a share of upwind's and at least `least`, in a cavity (study
 * convection) and in a layer; and the time of the flow's equations over that of
 * upwind. */
static const struct scheme_cost {
    const char *name;
    double share, least[2], time;
} scheme_costs[] = {{"upwind", 1.0, {1.0, 1.0}, 1.0},
                    {"blended", 0.5, {1.0, 1.0}, 1.0},
                    {"linear", 0.0, {1.8, 1.2}, 1.0},
                    {"van-leer", 0.0, {1.7, 1.0}, 1.4},
                    {"second-upwind", 0.0, {1.0, 1.0}, 1.4}};
enum { SCHEME_COSTS = sizeof scheme_costs / sizeof scheme_costs[0] };

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

static double left_by(const struct scheme_cost *scheme, struct carried c)
{
    return fmax(scheme->share * c.upwind, scheme->least[c.layer]);
}

/* From one scheme to the other. */
static void print_scheme(const struct settings *s, const struct case_scales *k,
                         const struct scheme_cost *from,
                         const struct scheme_cost *to, struct carried c)
{
    char name[64];

    if (from == to) return;
    snprintf(name, sizeof name, "fluid.convection = %s", to->name);
    line_by(name, time_of_flow(s, k, to->time / from->time),
            "the error of convection", left_by(from, c) / left_by(to, c));
}

/* The only direction that has cells, of a flow without grains; else -1. */
static int only_direction(const struct settings *s)
{
    const int *const n = s->mesh.box.cells;
    double cells;

    if (accuracy_directions_of(s, &cells) != 1 || s->has.exchange) return -1;
    return n[0] > 1 ? 0 : n[1] > 1 ? 1 : 2;
}

static void print_convection(const struct settings *s,
                             const struct case_scales *k)
{
    const struct scheme_cost *from = scheme_costs;
    const char *const name = s->fluid.convection->name;
    const int only = only_direction(s);
    double cells;

    while (from < scheme_costs + SCHEME_COSTS && strcmp(from->name, name) != 0)
        from++;
    if (accuracy_directions_of(s, &cells) == 0 ||
        from == scheme_costs + SCHEME_COSTS ||
        (only >= 0 && carries_nothing(s, only)))
        return;
    const struct carried c = carried_in(s, k, only);
    print_scheme(s, k, from, &scheme_costs[SCHEME_COSTS - 1], c);
    if (order_of_cells(s) > 1.0) print_scheme(s, k, from, scheme_costs, c);
}

/* The number of iterations is proportional to the digits that are asked for,
 * and the rest of a step takes as long as four digits. The error of one digit
 * more is not a tenth, since iterations are whole, but that of four digits more
 * is about 1e-4 (study tolerance). */
static void print_tolerance(const struct settings *s,
                            const struct case_scales *k)
{
    const double digits = -log10(s->fluid.tolerance);

    line_by("fluid.tolerance over 10",
            time_of_flow(s, k, (digits + 5.0) / (digits + 4.0)),
            "the error of the equations, in the mean,", 10.0);
    if (digits > 1.0)
        line_by("fluid.tolerance times 10",
                time_of_flow(s, k, (digits + 3.0) / (digits + 4.0)),
                "the error of the equations, in the mean,", 0.1);
}

/* A corrector takes a quarter of the time of the rest, and leaves about a sixth
 * of the error of the one before at Courant numbers of one half (study
 * correctors). */
static void print_correctors(const struct settings *s,
                             const struct case_scales *k)
{
    const int n = s->fluid.correctors;
    const double rest = 4.4;

    line_by("fluid.correctors one more",
            time_of_flow(s, k, (rest + n + 1.0) / (rest + n)),
            "the error of splitting", 6.0);
    if (n > 1)
        line_by("fluid.correctors one less",
                time_of_flow(s, k, (rest + n - 1.0) / (rest + n)),
                "the error of splitting", 1.0 / 6.0);
}

/* All directions that have more than one cell, and the step with them, so that
 * the Courant number stays. */
static void print_cells(const struct settings *s, const struct case_scales *k)
{
    double n;
    const int directions = accuracy_directions_of(s, &n);
    const double cells = pow(2.0, directions);

    if (directions == 0) return;
    accuracy_line("mesh.cells doubled, fluid.step halved",
                  time_with(k, 1, 2.0, 1.0, cells), "that of the cells",
                  order_of_cells(s), 1);
    accuracy_line("mesh.cells halved, fluid.step doubled",
                  time_with(k, 1, 0.5, 1.0, 1.0 / cells), "that of the cells",
                  order_of_cells(s), 0);
}

/* Smoothing reduces a wave by a share proportional to the square of the
 * bandwidth. The diffusion takes the same time for any bandwidth. */
static void accuracy_print_bandwidth(const struct settings *s)
{
    if (s->averaging.method != &diffusion_method) return;
    accuracy_line("averaging.bandwidth halved", 1.0, "the damping of a wave",
                  2.0, 1);
    accuracy_line("averaging.bandwidth doubled", 1.0, "the damping of a wave",
                  2.0, 0);
}

/* A sub-step asks for the drag of each particle once, which was seen to cost as
 * much as a step of its motion. Where their number is left to the program it is
 * no choice. */
static void print_substeps(const struct settings *s,
                           const struct case_scales *k)
{
    const int n = s->exchange.substeps;
    struct case_scales one = *k;

    if (n == 0) return;
    one.dem_steps = n;
    one.cells = 0;
    const double more = case_scales_cost(&one, 0) / case_scales_cost(k, 1);
    accuracy_line("exchange.substeps doubled", 1.0 + more,
                  "the error of the drag", 1.0, 1);
    if (n > 1)
        accuracy_line("exchange.substeps halved", 1.0 - 0.5 * more,
                      "the error of the drag", 1.0, 0);
}

/* The force of a dashpot jumps when a contact begins and ends. Without one, e =
 * 1, the integrator has its own order; without contacts there is no impact. */
static void print_particles(const struct settings *s,
                            const struct case_scales *k, int flow)
{
    const double order = s->particles.grains.of.restitution == 1.0 ? 2.0 : 1.0;

    accuracy_line("particles.step halved", time_with(k, flow, 1.0, 2.0, 1.0),
                  "the error of an impact", order, 1);
    accuracy_line("particles.step doubled", time_with(k, flow, 1.0, 0.5, 1.0),
                  "the error of an impact", order, 0);
}

void check_accuracy(const struct settings *s, const struct case_scales *k)
{
    const int flow = s->has.fluid;

    puts("What accuracy costs");
    if (flow) print_fluid(s, k);
    if (flow) print_cells(s, k);
    if (flow) print_convection(s, k);
    if (flow) print_tolerance(s, k);
    if (flow) print_correctors(s, k);
    if (s->has.averaging) accuracy_print_bandwidth(s);
    if (s->has.exchange) print_substeps(s, k);
    if (k->particles > 0 && !s->particles.list->no_contacts)
        print_particles(s, k, flow);
}
