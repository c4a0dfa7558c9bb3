/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_bodies_report.c -- what `check` says of the bodies. */
#include <math.h>
#include <stdio.h>

#include "base/text.h"
#include "base/vector.h"
#include "case/resolved/case_bodies.h"
#include "resolved/body_numbers.h"

/* [EW18 6, 8, 9] of the first free sphere, with the velocity of a fall through
 * its own diameter without drag, V = sqrt(|rho_r - 1| g d). */
static void report_numbers(const struct settings *s)
{
    const int n = s->bodies.list[BODY_SPHERES].n;
    const struct body_setup *b = s->bodies.list[BODY_SPHERES].item, *const end =
                                                                        b + n;
    const double rho = s->fluid.rho;

    while (b < end && b->motion != BODY_FREE)
        b++;
    if (b == end || !s->effects.has_gravity) return;
    const double d = b->diameter,
                 ratio = body_numbers_density_ratio(b->density, rho),
                 V = sqrt(fabs(ratio - 1.0) *
                          vector_length(s->effects.gravity) * d),
                 Re = body_numbers_reynolds(rho, V, d, s->fluid.mu);

    text_line("Re by sqrt(|rho_r - 1| g d)", Re, "-", "Galilei's number");
    text_line("Stokes number by it", body_numbers_stokes(ratio, Re), "-",
              "an impact rebounds from about 10 on");
}

/* The smallest width of spheres, clumps and cylinders, and of others that are
 * free; the largest speed at the start; and how many are free, with the
 * smallest density ratio and the largest virtual mass of these. */
struct extremes {
    double d, cells;     /* [m], [-] that in cells */
    double speed, ratio; /* [m/s], [-] */
    double C_v;          /* [-] */
    int free;
};

static double width_of(const struct case_body *b) /* [m] */
{
    if (b->list == BODY_SPHERES ||
        (b->list == BODY_CYLINDERS && b->says->motion != BODY_FREE))
        return b->says->diameter;
    return b->list == BODY_CLUMPS ? 2.0 * b->R_min : b->outline->width;
}

/* Of the cells around a body, the largest width [m]. A cylinder along an axis
 * has the same shape in each layer of them. */
static double cell_width(const struct settings *s, const struct case_body *b)
{
    double widest = 0.0;

    for (int k = 0; k < 3; k++)
        if (b->list != BODY_CYLINDERS || !body_shape_along(&b->plain, k))
            widest = fmax(widest, s->all_bodies->h[k]);
    return widest;
}

static struct extremes extremes_of(const struct settings *s)
{
    const struct case_bodies *const c = s->all_bodies;
    struct extremes e = {.d = HUGE_VAL, .cells = HUGE_VAL, .ratio = HUGE_VAL};

    for (const struct case_body *b = c->item; b < c->item + c->n; b++) {
        const int free = b->says->motion == BODY_FREE;
        e.speed = fmax(e.speed, vector_length(b->says->velocity));
        if (!free && (b->list == BODY_BOXES || b->list == BODY_SURFACES))
            continue; /* parts of walls, often */
        e.d = fmin(e.d, width_of(b));
        e.cells = fmin(e.cells, width_of(b) / cell_width(s, b));
        if (!free) continue;
        e.free++;
        e.ratio = fmin(e.ratio, b->says->density / s->fluid.rho);
        e.C_v = fmax(e.C_v, case_bodies_virtual_mass(s, b));
    }
    return e;
}

static int count_of(const struct settings *s, enum body_list a,
                    enum body_list b)
{
    return s->bodies.list[a].n + s->bodies.list[b].n;
}

static void report_counts(const struct settings *s)
{
    const int outlines = count_of(s, BODY_CLUMPS, BODY_SURFACES);

    text_line("spheres", s->bodies.list[BODY_SPHERES].n, "-", "");
    text_line("boxes and cylinders", count_of(s, BODY_BOXES, BODY_CYLINDERS),
              "-", "");
    if (outlines > 0)
        text_line("clumps and closed surfaces", outlines, "-", "");
}

static void report_free(const struct settings *s, const struct extremes *e)
{
    const int raised = e->C_v > s->bodies.virtual_mass;
    const struct case_bodies_contact c = case_bodies_contact(s);

    report_numbers(s);
    text_line("smallest density ratio", e->ratio, "-",
              e->ratio < 1.0 && e->cells < 7.5
                  ? "LOW: in contact such a body needs eight cells, or moves on"
              : e->ratio < 0.5 ? "LOW: stable; halve fluid.step and compare"
                               : "");
    text_line("largest virtual mass", e->C_v, "-",
              raised ? "as a light, thin or small body needs, or one of many"
                     : "as bodies.virtual_mass says");
    text_line("stiffness", c.stiffness, "N/m", "");
    text_line("particle steps in one step", c.dem_steps, "-",
              "of their contacts");
    const double overlap = case_bodies_expected_overlap(s);
    text_line("expected overlap / d", overlap, "-",
              overlap > s->bodies.max_overlap
                  ? "HIGH: above bodies.max_overlap the run stops"
                  : "of an impact, by the speeds that are known");
}

/* Where what an average spreads is moved out of a body [SX15 5c]. */
static void report_bandwidth(const struct settings *s, double d)
{
    const double b = s->averaging.bandwidth;

    if (!s->has.particles || b == 0.0 || d == HUGE_VAL) return;
    text_line("bandwidth / d", b / d, "-",
              b > 0.5 * d ? "HIGH: grains beside a body count too far from it"
                          : "");
}

/* The gaps of less than a cell whose cells are held; and what is left for free
 * bodies, the smallest of which has the width d [m]. */
static void report_gaps(const struct settings *s, double d, int free)
{
    struct case_bodies_first first;
    char where[BODY_SEAL_TEXT];

    if (case_bodies_start(s, &first) != 0) return;
    for (int open = 0; open < 2; open++) {
        const struct body_seal_gap *const g =
            open ? &first.seal.open : &first.seal.closed;
        body_seal_describe(g, open, where);
        if (g->beside > 0)
            text_line(open ? "widest narrow gap / h" : "widest closed gap / h",
                      g->width, "-", where);
    }
    if (first.seal.covered > 0.0)
        text_line("share of an inlet in bodies", first.seal.covered, "-",
                  "what comes in there flows through them");
    if (free && first.left < d)
        text_line("way of a prescribed body to a wall", first.left, "m",
                  "LOW: at the end; a free body between stops the run");
}

/* The residual of the splitting enters the next step. Where viscosity crosses
 * more than a cell in a step, a free body answers it with its acceleration. */
static void report_viscous(const struct settings *s, double number, int free)
{
    const double tolerance = s->fluid.piso_tolerance;

    text_line("nu dt / h^2", number, "-",
              free && number > 1.0 && !(tolerance > 0.0 && tolerance < 1.1e-4)
                  ? "HIGH: free bodies jitter; fluid.piso_tolerance = 1e-4"
              : tolerance * number > 2e-3
                  ? "HIGH: pressure, forces on walls; lower "
                    "fluid.piso_tolerance"
                  : "the drag does not depend on it");
}

void case_bodies_report(const struct settings *s)
{
    if (!s->has.bodies) return;
    const struct extremes e = extremes_of(s);
    const double *const h = s->all_bodies->h;
    const double dt = s->fluid.dt, nu = s->fluid.mu / s->fluid.rho,
                 narrowest = fmin(h[0], fmin(h[1], h[2]));
    puts("Bodies");
    report_counts(s);
    if (e.cells < HUGE_VAL)
        text_line("d / h", e.cells, "-",
                  e.cells < 7.0 ? "LOW: good to look at; 12 to measure"
                  : e.cells < 11.5
                      ? "about 5 % of the drag where they are apart"
                      : "2 to 3 % of the drag where they are apart");
    report_gaps(s, e.d, e.free > 0);
    report_bandwidth(s, e.d);
    report_viscous(s, nu * dt / (narrowest * narrowest), e.free > 0);
    text_line("CFL of the bodies", e.speed * dt / narrowest, "-",
              e.speed * dt / narrowest > 0.5
                  ? "HIGH: more than half a cell in a step"
                  : "by their speed at time 0");
    if (e.free > 0) report_free(s, &e);
}
