/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/report_accuracy.h"

#include "case/case_cost.h"
#include "case/check_line.h"
#include "fluid/time_scheme.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A factor of two, in words: the error that is left, or that it becomes. */
static void line(const char *name, double time, const char *of, double order,
                 int finer)
{
    char remark[128];

    snprintf(remark, sizeof remark, "times the time; %s %s %g", of,
             finer ? "over" : "times", pow(2.0, order));
    check_line(name, time, "-", remark);
}

/* The time with steps of the fluid and of the particles, and cells, that are so
 * many times as many. */
static double time_with(const struct case_scales *k, int flow, double steps,
                        double particle_steps, double cells)
{
    struct case_scales other = *k;

    other.dt = k->dt / steps;
    other.dem_steps = 1;
    const double one = case_cost_of(k, flow);
    const double grains =
        case_cost_of(k, 0) * particle_steps; /* without the flow */
    other.particles = 0;
    return (grains + cells * case_cost_of(&other, flow)) / one;
}

static void print_fluid(const struct settings *s, const struct case_scales *k)
{
    const double order =
        time_scheme_named(settings_text(s, "fluid.time"))->time_levels;

    if (order == 1.0)
        check_line("fluid.time = bdf2", 1.0, "-",
                   "times the time; the error of the step of order 2, not 1");
    line("fluid.step halved", time_with(k, 1, 2.0, 1.0, 1.0),
         "the error of the step", order, 1);
    line("fluid.step doubled", time_with(k, 1, 0.5, 1.0, 1.0),
         "the error of the step", order, 0);
}

/* Two of the convection schemes are of first order. */
static double order_of_cells(const struct settings *s)
{
    const char *const name = settings_text(s, "fluid.convection");

    return strcmp(name, "upwind") == 0 || strcmp(name, "blended") == 0 ? 1.0
                                                                       : 2.0;
}

/* All directions that have more than one cell, and the step with them, so that
 * the Courant number stays. */
static void print_cells(const struct settings *s, const struct case_scales *k)
{
    int n[3], directions = 0;

    if (!settings_has(s, "mesh.cells")) return;
    settings_counts(s, "mesh.cells", n);
    for (int i = 0; i < 3; i++)
        directions += n[i] > 1;
    if (directions == 0) return;
    const double cells = pow(2.0, directions);
    line("mesh.cells doubled, fluid.step halved",
         time_with(k, 1, 2.0, 1.0, cells), "that of the cells",
         order_of_cells(s), 1);
    line("mesh.cells halved, fluid.step doubled",
         time_with(k, 1, 0.5, 1.0, 1.0 / cells), "that of the cells",
         order_of_cells(s), 0);
}

/* Smearing takes a share of a wave that goes with the square of the bandwidth.
 * The diffusion costs the same for any. */
static void print_bandwidth(const struct settings *s)
{
    if (strcmp(settings_text(s, "averaging.method"), "diffusion") != 0) return;
    line("averaging.bandwidth halved", 1.0, "what it takes off a wave", 2.0, 1);
    line("averaging.bandwidth doubled", 1.0, "what it takes off a wave", 2.0,
         0);
}

/* A sub-step asks for the drag of each particle once, which was seen to cost as
 * much as a step of its motion. Where their number is left to the program it is
 * no choice. */
static void print_substeps(const struct settings *s,
                           const struct case_scales *k)
{
    const int n = settings_int(s, "exchange.substeps");
    struct case_scales one = *k;

    if (n == 0) return;
    one.dem_steps = n;
    one.cells = 0;
    const double more = case_cost_of(&one, 0) / case_cost_of(k, 1);
    line("exchange.substeps doubled", 1.0 + more, "the error of the drag", 1.0,
         1);
    if (n > 1)
        line("exchange.substeps halved", 1.0 - 0.5 * more,
             "the error of the drag", 1.0, 0);
}

void report_accuracy(const struct settings *s, const struct case_scales *k)
{
    const int flow = settings_has(s, "fluid");

    puts("What accuracy costs");
    if (flow) print_fluid(s, k);
    if (flow) print_cells(s, k);
    if (settings_has(s, "averaging")) print_bandwidth(s);
    if (settings_has(s, "exchange")) print_substeps(s, k);
    if (k->particles == 0) return;
    /* The force of a dashpot jumps when a contact begins and ends. */
    line("particles.step halved", time_with(k, flow, 1.0, 2.0, 1.0),
         "the error of an impact", 1.0, 1);
    line("particles.step doubled", time_with(k, flow, 1.0, 0.5, 1.0),
         "the error of an impact", 1.0, 0);
}
