/* SPDX-License-Identifier: GPL-3.0-or-later */
/* check_flow.c -- how far the fluid moves in a step, and what the averaging
 * keeps: the Courant number of a uniform flow, in the cell where it is
 * largest: U dt sum |S . e| / (2 V) with e the direction of the flow. An inlet
 * and a mean flow are taken to fill the mesh, a wall to move the cells that
 * touch it. */

#include "tell/check.h"

#include <math.h>
#include <stdio.h>

#include "averaging/averaging.h"
#include "averaging/kernel/weights.h"
#include "base/text.h"
#include "base/vector.h"
#include "case/build.h"
#include "case/case_mesh.h"
#include "mesh/measures.h"
#include "mesh/mesh.h"

/* The largest velocities [m/s], the largest Courant number over the step, and
 * the rate of viscous diffusion across a cell, nu / h^2 [1/s]. */
struct rates {
    double inlet, wall, mean, courant, viscous;
};

/* The narrowest cell of a box along k, as its inverse [1/m]. */
static double across_box(const struct mesh *m, int k)
{
    const double *const e = m->box.edge[k];
    double narrow = HUGE_VAL;

    for (int i = 0; i < m->box.n[k]; i++)
        narrow = fmin(narrow, e[i + 1] - e[i]);
    return 1.0 / narrow;
}

/* sum |S . e| / (2 V) of a cell [1/m]. */
static double across_cell(const struct mesh *m, int c, const double e[3])
{
    double sum = 0.0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
        sum += fabs(vector_dot(mesh_S(m, m->cell_face[a]), e));
    return 0.5 * sum / m->V[c];
}

/* The largest of all cells, for a velocity u: its part of each direction of a
 * box, or of any mesh [1/s]. */
static double fill_rate(const struct mesh *m, const double u[3])
{
    double rate = 0.0;

    if (m->face_centre == NULL) {
        for (int k = 0; k < 3; k++)
            rate += fabs(u[k]) * across_box(m, k);
        return rate;
    }
    for (int c = 0; c < m->n_cells; c++)
        rate = fmax(rate, across_cell(m, c, u));
    return rate;
}

static void add_inlet(const struct settings *s, const struct mesh *m,
                      const struct patch *p, const struct key_series *inlet,
                      struct rates *r)
{
    double U = 0.0, e[3], mean, peak;

    for (int i = 0; i < inlet->n; i++)
        U = fmax(U, inlet->value[i]);
    build_boundaries_shares(s, p->name, &mean, &peak);
    case_scales_inward(m, p, e);
    for (int k = 0; k < 3; k++)
        e[k] *= U * peak;
    r->inlet = fmax(r->inlet, U * mean);
    r->courant = fmax(r->courant, fill_rate(m, e));
}

/* A wall that moves takes the cells beside it with it. In a box the speed is
 * bounded by that of the fastest corner. */
static void add_wall(const struct boundary_options *o, const struct mesh *m,
                     const struct patch *p, struct rates *r)
{
    double u[3], fastest[3] = {0.0, 0.0, 0.0};

    for (int f = p->first; f < p->first + p->n && m->face_centre != NULL; f++) {
        o->condition->moves(o, &m->face_centre[3 * f], u);
        r->wall = fmax(r->wall, vector_length(u));
        r->courant = fmax(r->courant, across_cell(m, m->owner[f], u));
    }
    for (int i = 0; i < 8 && m->face_centre == NULL; i++) {
        const double x[3] = {i & 1 ? m->hi[0] : m->lo[0],
                             i & 2 ? m->hi[1] : m->lo[1],
                             i & 4 ? m->hi[2] : m->lo[2]};
        o->condition->moves(o, x, u);
        if (vector_length(u) > vector_length(fastest))
            memcpy(fastest, u, sizeof fastest);
    }
    r->wall = fmax(r->wall, vector_length(fastest));
    if (m->face_centre == NULL)
        r->courant = fmax(r->courant, fill_rate(m, fastest));
}

static void add_patch(const struct settings *s, const struct mesh *m,
                      const struct patch *p, struct rates *r)
{
    const struct boundary_options *const o = settings_side(s, p->name);

    if (o == NULL) return;
    if (o->inlet.n > 0) add_inlet(s, m, p, &o->inlet, r);
    if (o->condition->moves != NULL) add_wall(o, m, p, r);
}

static struct rates rates_of(const struct settings *s)
{
    struct mesh *const m = case_mesh_outline(s);
    struct rates r = {.inlet = 0.0};
    double u[3];

    for (int i = 0; i < m->n_patches; i++)
        add_patch(s, m, &m->patches[i], &r);
    if (s->fluid.has_mean_flow) {
        memcpy(u, s->fluid.mean_flow, sizeof u);
        r.mean = vector_length(u);
        r.courant = fmax(r.courant, fill_rate(m, u));
    }
    const int *const n = m->box.n; /* 0 of polyhedra */
    const int directions = (n[0] > 1) + (n[1] > 1) + (n[2] > 1);
    if (directions != 1) /* nothing is split in one */
        r.viscous = s->fluid.mu / s->fluid.rho * mesh_diffusion_rate(m) /
                    (directions > 0 ? 2.0 * directions : 6.0);
    mesh_free(m);
    return r;
}

/* The residual of the splitting enters the next step, so that the velocities
 * beside a wall alternate from step to step, by about fluid.piso_tolerance
 * times nu dt / h^2 of their difference, and the pressure from cell to cell.
 * Bodies have a line for it of their own. */
static void print_viscous(const struct settings *s, double number)
{
    const double part = s->fluid.piso_tolerance * number;
    char remark[96];

    if (part < 2e-3 || s->has.bodies) return;
    snprintf(
        remark, sizeof remark,
        "HIGH: pressure, forces on walls to %.1g; fluid.piso_tolerance = %.0e",
        part, pow(10.0, floor(log10(1e-3 / number))));
    text_line("nu dt / h^2", number, "-", remark);
}

double check_courant(const struct settings *s, const struct case_scales *k)
{
    const double eps_s = k->particles > 0 ? CHECK_PACKED : 0.0;

    return rates_of(s).courant / (1.0 - eps_s) * k->dt;
}

void check_flow(const struct settings *s, const struct case_scales *k)
{
    const double dt = k->dt, eps_s = k->particles > 0 ? CHECK_PACKED : 0.0;
    const struct rates r = rates_of(s);
    const double rate = r.courant / (1.0 - eps_s);
    char remark[64] = "of the flow as it enters, or as a wall moves it";

    puts("Flow");
    text_line("step", dt, "s", "");
    if (r.inlet > 0.0)
        text_line("inlet", r.inlet, "m/s", "superficial, largest");
    if (k->jet > 0.0)
        text_line("jet", k->jet, "m/s", "the fastest of the inlet, in a cell");
    if (r.wall > 0.0) text_line("moving walls", r.wall, "m/s", "the fastest");
    if (r.mean > 0.0) text_line("mean flow", r.mean, "m/s", "superficial");
    print_viscous(s, r.viscous * dt);
    if (rate <= 0.0) return;
    if (eps_s > 0.0)
        snprintf(remark, sizeof remark, "between grains at eps_s = %g", eps_s);
    text_line("CFL", rate * dt, "-", remark);
    text_line("step at CFL = 1", 1.0 / rate, "s",
              rate * dt <= 1.0 ? "the step is below: accurate in time"
                               : "the step is above: stable, not accurate");
}

static const double report_threshold = 10e6; /* [byte] */

/* Of the Gaussian, over the diameter: what chapter "Beds, compared with
 * measurements" found for Mueller's bed. With 4 d its bubbles are smeared;
 * below 1.5 d the fluid fraction follows single spheres. */
static const double narrow = 1.5, wide = 3.0;

/* Bandwidths in the height of a packed bed. With fewer of them the averaged
 * solids fraction at its ends is low, and so is the drag: more gas is needed to
 * fluidize the bed. */
static const double few = 6.0;

/* With weights at the centres of cells the bandwidth has to reach from one
 * large cell to the next; otherwise the small cells beside it receive its
 * share. */
static void print_bandwidth(const struct mesh *m, double b, double S_c,
                            double widths)
{
    double V, least, mean;

    mesh_volumes(m, &least, &V, &mean);
    text_line("bandwidth / S_c", b / S_c, "-", "");
    if (cbrt(V) > 1.01 * S_c)
        text_line("bandwidth / width of the largest cell", b / cbrt(V), "-",
                  b < widths * cbrt(V)
                      ? "LOW: smaller cells get too large a solid fraction"
                      : "");
}

/* How wide the Gaussian is for the spheres and for a bed of them. */
static void print_smearing(const struct settings *s, double b,
                           const struct case_scales *k)
{
    double lo[3], size[3];
    const int is_bed = s->effects.has_gravity && k->volume > 0.0;

    if (k->d_most <= 0.0) return;
    text_line("Gaussian's b / d", b / k->d_most, "-",
              is_bed && b > wide * k->d_most
                  ? "WIDE: bubbles are smeared; better 2 to 3"
              : is_bed && b < narrow * k->d_most
                  ? "NARROW: the fields show single spheres"
                  : "of the largest particle");
    if (s->poly != NULL || !is_bed) return;
    case_mesh_ends(s, lo, size);
    const int up = vector_axis(s->effects.gravity);
    const double base = size[(up + 1) % 3] * size[(up + 2) % 3];
    const double height = k->volume / (CHECK_PACKED * base);
    text_line("height of the packed bed / b", height / b, "-",
              height < few * b
                  ? "LOW: its ends are smeared, it fluidizes too late"
                  : "at eps_s = 0.6");
}

/* One cell in the depth averages over all of it, whatever the bandwidth. */
static void print_depth(const struct mesh *m, double b)
{
    const int n = m->box.n[2];
    const double depth = m->hi[2] - m->lo[2];

    if (m->face_centre != NULL || m->box.periodic[2]) return;
    if (n > 1 || depth > 2.0 * b)
        text_line("cells over the depth", n, "-",
                  n == 1 ? "FEW: the depth is several bandwidths"
                  : n * b < 0.5 * depth
                      ? "FEW: they are wider than two bandwidths"
                      : "");
}

/* Where the smallest cells are about as small as a grain, those of a packed bed
 * hold more by their centres than they have room for: in beds of 500 the lowest
 * fluid fraction was -0.7, -0.34, 0.07, 0.28 for cells of 1.05, 1.25, 1.57, 2
 * d. A cell that lies within a sphere has no fluid left. */
static void print_room(const struct settings *s, const struct mesh *m,
                       const struct case_scales *k)
{
    const struct averaging_method *const method = s->averaging.method;
    double least, most, mean;

    mesh_volumes(m, &least, &most, &mean);
    const double width = cbrt(least) / k->d_most;
    const double small = k->particles > 1 ? 1.5 : 0.81;
    if (method == &pcm_method && s->averaging.cap == 0.0 && width < 2.5)
        text_line("smallest cell / d", width, "-",
                  width < small
                      ? "TOO SMALL: a cell gets more than it has room for, and "
                        "the run ends; larger cells, or method = \"diffusion\""
                      : "SMALL: the fields show single grains");
    if ((method == &dpvm_method || method == &dpvm_cube_method) &&
        width < 1.0 / sqrt(3.0))
        text_line("smallest cell / d", width, "-",
                  "TOO SMALL: a cell within a sphere has no fluid left, and "
                  "the run ends; method = \"diffusion\"");
}

void check_averaging(const struct settings *s, const struct case_scales *k)
{
    struct mesh *const m = case_mesh_outline(s);
    const struct averaging_options o = build_averaging_options(s);
    const double b = o.method->gaussian * o.bandwidth;
    const int steps = averaging_check(o.method, m, &o); /* of Crank-Nicolson */
    const double bytes = weights_bytes(o.method, m, k->d_most, &o);

    puts(o.bandwidth > 0.0 ? "Averaging" : "Averaging over single cells");
    if (o.bandwidth > 0.0)
        print_bandwidth(m, o.bandwidth, k->S_c, o.method->uniform_widths);
    if (b > 0.0) {
        print_smearing(s, b, k);
        print_depth(m, b);
    }
    if (k->particles > 0 && s->exchange.two_way) print_room(s, m, k);
    if (steps > 0)
        text_line("averaging.steps", steps, "-",
                  "needed: with fewer the fields undershoot");
    if (bytes > report_threshold)
        text_line("memory for the cells near each", 1e-6 * bytes, "MB",
                  "about, besides that below");
    mesh_free(m);
}
