/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Flow through beds whose fluid fraction jumps from cell to cell, without
 * damping by drag: in two and three directions, by all schemes. */
#include "fluid/fluid.h"
#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"

#include <math.h>
#include <stdlib.h>

enum bed { EACH_CELL_ANY, ALL_CELLS_FULL, FULL_OR_EMPTY };

/* The bed, the mesh and the schemes. */
struct blow {
    enum bed bed;
    const char *time, *convection;
    int shared;       /* gamma = eps */
    int mixture;      /* form of continuity */
    double cfl;       /* [-] at 2.5 times the superficial velocity */
    int depth;        /* cells in z */
    int walls, steps; /* no slip at the sides; [-] */
};

static const double zero = 0.0, through = 1.0; /* [s], [m/s] */

static double noise(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) / 16777216.0;
}

static double fraction(enum bed bed, double r)
{
    if (bed == ALL_CELLS_FULL) return 0.4;
    if (bed == FULL_OR_EMPTY) return r < 0.5 ? 0.4 : 1.0;
    return 0.4 + 0.6 * r;
}

static struct fluid *create(const struct blow *w, struct boundary b[6])
{
    const double h = 1e-3;
    const int n[3] = {8, 18, w->depth};
    const struct fluid_options o = {
        .rho = 1.2,
        .mu = 1.8e-5,
        .dt = w->cfl * h / 2.5,
        .time = time_scheme_named(w->time),
        .convection = convection_scheme_named(w->convection),
        .blend = 0.8,
        .continuity = w->mixture ? CONTINUITY_MIXTURE : CONTINUITY_VOID_RATE,
        .correctors = 2,
        .piso_tolerance = 1e-3,
        .tolerance = 1e-7,
        .coupled = 1,
        .pressure_shared = w->shared,
        .boundaries = b};

    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = w->walls && (i < 2 || w->depth > 1)
                                             ? BOUNDARY_NO_SLIP
                                             : BOUNDARY_SLIP};
    b[2] = (struct boundary){.kind = BOUNDARY_INLET,
                             .n_points = 1,
                             .time = &zero,
                             .velocity = &through};
    b[3] = (struct boundary){.kind = BOUNDARY_OUTLET};
    return fluid_create(
        closed_box(n[0] * h, n[1] * h, n[2] * h, n[0], n[1], n[2]), &o);
}

static void discard(struct fluid *fl)
{
    mesh_free((struct mesh *)fl->mesh);
    owner_free(fl);
}

/* The bed lies in the middle; all columns have the same flux at first, but for
 * a trace of noise. */
static void begin(struct fluid *fl, enum bed bed)
{
    const struct mesh *const m = fl->mesh;
    unsigned seed = 7;

    for (int c = 0; c < m->n_cells; c++) {
        const double y = m->centre[3 * c + 1], r = noise(&seed);
        fl->eps[c] = y > 3e-3 && y < 12e-3 ? fraction(bed, r) : 1.0;
        fl->u[3 * c + 1] = through / fl->eps[c] + 1e-6 * (r - 0.5);
    }
    for (int f = 0; f < m->n_faces; f++)
        fl->phi[f] = through * mesh_S(m, f)[1];
    fluid_reset_eps_history(fl);
}

/* The largest velocity of component k or of any (-1) [m/s]. */
static double fastest(const struct fluid *fl, int k)
{
    double most = 0.0;

    for (int i = 0; i < 3 * fl->mesh->n_cells; i++)
        if (k < 0 || i % 3 == k) most = fmax(most, fabs(fl->u[i]));
    return most;
}

static double blown(const struct blow *w, int component)
{
    struct boundary b[6];
    struct fluid *const fl = create(w, b);
    double most = 0.0;

    begin(fl, w->bed);
    for (int i = 0; i < w->steps; i++) {
        ck_assert_int_eq(fluid_step(fl), 0);
        ck_assert_double_le(fl->report.piso_residual, 1e-3);
        most = fastest(fl, component);
    }
    discard(fl);
    return most;
}

/* Any fluid fraction from 0.4 to 1 in each cell. At 0.4 the mean stream is 2.5
 * times the inlet's; nothing is much faster. */
FACT_FOR_EACH(a_bed_of_random_cells_stays_bounded_by_any_scheme, 5)
{
    struct blow w = {.bed = EACH_CELL_ANY, .depth = 1, .steps = 150};
    w.convection = convection_schemes[_i]->name;
    for (int i = 0; i < 8; i++) {
        w.shared = i & 1;
        w.mixture = i >> 1 & 1;
        w.cfl = i & 4 ? 2.0 : 0.5;
        w.time = i & 1 ? "bdf2" : "euler";
        ck_assert_double_lt(blown(&w, -1), 1.3 * 2.5);
    }
}

/* Three directions, walls, cells that are full or empty at random. */
FACT_FOR_EACH(so_does_one_of_full_and_empty_cells_between_walls, 5)
{
    struct blow w = {.bed = FULL_OR_EMPTY,
                     .time = "euler",
                     .shared = 1,
                     .mixture = 1,
                     .depth = 6,
                     .walls = 1,
                     .steps = 60};
    w.convection = convection_schemes[_i]->name;
    for (int i = 0; i < 2; i++) {
        w.cfl = i ? 2.0 : 0.5;
        ck_assert_double_lt(blown(&w, -1), 2.0 * 2.5);
    }
}

/* A bed with flat surfaces has the exact flow of one column, with u_x = 0. What
 * a trace of noise starts along them dies out. With central convection alone,
 * and no drag, it rings, but does not grow beyond the stream. */
FACT_FOR_EACH(waves_along_the_surface_of_a_bed_die_out_or_stay_bounded, 5)
{
    struct blow w = {.bed = ALL_CELLS_FULL,
                     .time = "bdf2",
                     .shared = 1,
                     .mixture = 1,
                     .depth = 1,
                     .steps = 300};
    w.convection = convection_schemes[_i]->name;
    for (int i = 0; i < 2; i++) {
        w.cfl = i ? 2.0 : 0.5;
        ck_assert_double_lt(blown(&w, 0), _i == 1 ? 5.0 * 2.5 : 5e-3);
    }
}

FACTS
{
    tcase_set_timeout(facts, 120.0);
}
