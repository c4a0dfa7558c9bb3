/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bodies.c -- what is written of the bodies.
 *
 * bodies.csv: with each row of history.csv a row for each body, its place,
 * velocity, spin, and the force and torque of the fluid in the last step; and
 * the quaternion of its orientation, if one of them is a clump or a surface.
 * bodies.pvd: the same, to look at; each ball of a clump as a point in
 * body_clumps.pvd, triangles of closed surfaces, boxes and cylinders in
 * body_surfaces.pvd, once if no body moves. Sums in history.csv.
 */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "coupling/effects.h"
#include "output/series.h"
#include "resolved/solid_bodies.h"
#include "resolved/among/among_grains.h"
#include "resolved/shapes/shapes.h"
#include "resolved/body_motion.h"

struct record {
    const struct simulation *sim;
    const struct solid_bodies *bodies;
    const char *folder; /* its name, borrowed */
    struct table *table;
    struct series *pictures;
    double *d;                          /* [m] as it is shown */
    struct surroundings_filter *filter; /* NULL: no such columns */
};

static struct solid_bodies *among(const struct simulation *sim)
{
    return effects_memory(sim, &among_effect);
}

static const struct solid_bodies *bodies_of_run(const struct simulation *sim)
{
    const struct solid_bodies *const b = effects_memory(sim, &bodies_effect);
    return b != NULL ? b : among(sim);
}

/* --- columns of the history ----------------------------------------------- */

static double bodies_force(const struct simulation *sim, int k)
{
    const struct solid_bodies *const b = bodies_of_run(sim);
    double sum = 0.0;

    for (int i = 0; i < b->ps->n; i++)
        sum += b->force[3 * i + k];
    return sum;
}

static double bodies_flow(const struct simulation *sim, int k)
{
    double flow[3];
    fluid_mean_flow(sim->fluid, flow);
    return flow[k];
}

HISTORY_VECTOR(force, bodies_force(sim, k))
HISTORY_VECTOR(mean_flow, bodies_flow(sim, k))
HISTORY_VALUE(held_cells, bodies_of_run(sim)->held)
HISTORY_VALUE(bodies_contacts, bodies_of_run(sim)->dem_report.contacts)
HISTORY_VALUE(bodies_overlap, bodies_of_run(sim)->dem_report.max_overlap)

static const struct history_column columns[] = {
    {"force_on_bodies_x [N]", force_x, 0, "of the fluid, on all of them"},
    {"force_on_bodies_y [N]", force_y, 0, "of the fluid, on all of them"},
    {"force_on_bodies_z [N]", force_z, 0, "of the fluid, on all of them"},
    {"mean_flow_x [m/s]", mean_flow_x, 0, "mean velocity of all of the box"},
    {"mean_flow_y [m/s]", mean_flow_y, 0, "mean velocity of all of the box"},
    {"mean_flow_z [m/s]", mean_flow_z, 0, "mean velocity of all of the box"},
    {"held_cells [-]", held_cells, 0, "cells whose velocity is that of a body"},
    {"contacts_of_bodies [-]", bodies_contacts, 0, "that touch"},
    {"max_overlap_of_bodies [-]", bodies_overlap, 0, "largest of the step"},
    {NULL, NULL, 0, NULL}};

/* Of the particles on the bodies, mean of the last step. */
static double pushed(const struct simulation *sim, int k)
{
    const struct solid_bodies *const b = among(sim);
    double sum = 0.0;

    for (int i = 0; i < b->ps->n; i++)
        sum += b->among->pushed[i][k];
    return sum;
}

HISTORY_VECTOR(push, pushed(sim, k))

/* Cells whose solids found no open cell (mirrors.h). */
static double stuck(const struct simulation *sim)
{
    const struct mirrors *const m = among(sim)->among->mirrors;
    return m != NULL ? mirrors_stuck(m) : 0.0;
}

static const struct history_column columns_among[] = {
    {"force_of_grains_x [N]", push_x, 0,
     "of the grains on the bodies, mean of the step"},
    {"force_of_grains_y [N]", push_y, 0,
     "of the grains on the bodies, mean of the step"},
    {"force_of_grains_z [N]", push_z, 0,
     "of the grains on the bodies, mean of the step"},
    {"closed_cells_with_solids [-]", stuck, 0,
     "cells within a body whose solids found no open cell"},
    {NULL, NULL, 0, NULL}};

HISTORY_VALUE(left, bodies_of_run(sim)->exit->n_gone)

static const struct history_column columns_left[] = {
    {"bodies_left [-]", left, 0, "that left the box"}, {NULL, NULL, 0, NULL}};

/* --- files ---------------------------------------------------------------- */

/* Then the orientation, if there are outlines; then the means around it. */
enum { COLUMNS = 17, TURN = 4, AROUND = 6 };

static struct table *bodies_create_table(const struct record *r,
                                         struct folder *folder)
{
    static const char *const names[COLUMNS + TURN + AROUND] = {
        "time [s]",       "body [-]",    "x [m]",          "y [m]",
        "z [m]",          "vx [m/s]",    "vy [m/s]",       "vz [m/s]",
        "wx [rad/s]",     "wy [rad/s]",  "wz [rad/s]",     "force_x [N]",
        "force_y [N]",    "force_z [N]", "torque_x [N m]", "torque_y [N m]",
        "torque_z [N m]", "q_0 [-]",     "q_x [-]",        "q_y [-]",
        "q_z [-]",        "eps_f [-]",   "ux [m/s]",       "uy [m/s]",
        "uz [m/s]",       "Re_p [-]",    "C_d [-]"};
    struct table_head head = {0};

    for (int k = 0; k < COLUMNS + TURN + AROUND; k++)
        if (k < COLUMNS ||
            (k < COLUMNS + TURN ? r->bodies->turn != NULL : r->filter != NULL))
            table_head_add(&head, "%s", names[k]);
    return folder_table(folder, "bodies.csv", &head);
}

static void bodies_release(void *record)
{
    struct record *const r = record;

    table_free(r->table);
    series_free(r->pictures);
    owner_free(r->filter);
    owner_free(r);
}

static void *create_bodies(const struct recorder_view *v, int *failed)
{
    const double width = v->of->filter;

    if (bodies_of_run(v->sim) == NULL) return NULL;
    struct record *const r = owner_create(sizeof *r);

    r->sim = v->sim;
    r->bodies = bodies_of_run(v->sim);
    r->folder = folder_name(v->folder);
    if (width > 0.0)
        r->filter = surroundings_create(r->bodies, v->sim->fluid, width);
    r->table = bodies_create_table(r, v->folder);
    r->pictures = r->table != NULL ? recorder_series(v, "bodies") : NULL;
    r->d = owner_doubles(r, r->bodies->ps->n);
    *failed = r->pictures == NULL;
    return r;
}

static void add_surroundings(const struct record *r, int i, double *row)
{
    const struct surroundings around = surroundings_of(r->filter, i);
    const double values[AROUND] = {around.eps,  around.u[0], around.u[1],
                                   around.u[2], around.Re,   around.Cd};

    memcpy(row, values, sizeof values);
}

static int bodies_add_row(void *record)
{
    const struct record *const r = record;
    const struct solid_bodies *const b = r->bodies;
    const struct particles *const ps = b->ps;
    int failed = 0;

    if (r->filter != NULL) surroundings_bind(r->filter);
    for (int i = 0; i < ps->n && !failed; i++) {
        const double *const F = &b->force[3 * i], *const T = &b->torque[3 * i];
        double row[COLUMNS + TURN + AROUND] = {
            r->sim->t, i,         ps->x[i],  ps->y[i],  ps->z[i],  ps->vx[i],
            ps->vy[i], ps->vz[i], ps->wx[i], ps->wy[i], ps->wz[i], F[0],
            F[1],      F[2],      T[0],      T[1],      T[2]};
        int n = COLUMNS;
        for (int k = 0; k < TURN && b->turn != NULL; k++)
            row[n++] = b->turn[4 * i + k];
        if (r->filter != NULL) add_surroundings(r, i, &row[n]);
        failed = table_add(r->table, row);
    }
    return failed;
}

static int add_picture(void *record, double t)
{
    struct record *const r = record;
    const struct solid_bodies *const b = r->bodies;
    const struct particles *const ps = b->ps;
    const double *const x[3] = {ps->x, ps->y, ps->z};

    for (int i = 0; i < ps->n; i++)
        r->d[i] =
            solid_bodies_hung(b, i) ? 2.0 * b->shape[i].half[0] : ps->d[i];
    const struct vtk_array arrays[] = {
        vtk_single("diameter", 1, r->d),
        vtk_vector("velocity", ps->vx, ps->vy, ps->vz),
        vtk_vector("angular_velocity", ps->wx, ps->wy, ps->wz),
        vtk_single("force", 3, b->force),
        vtk_single("torque", 3, b->torque),
        {.name = "id", .components = 1, .ints = ps->id}};
    return series_add_particles(r->pictures, ps->n, x, t, 6, arrays);
}

/* Of the first body, and the sum over all. */
static void bodies_summarize(const void *record, struct summary *f)
{
    const struct record *const r = record;
    static const char *const names[3] = {"force_x", "force_y", "force_z"};

    summary_begin(f, "bodies");
    summary_count(f, "number", r->bodies->ps->n);
    summary_count(f, "held_cells", r->bodies->held);
    summary_number(f, "largest_overlap", r->bodies->deepest);
    for (int k = 0; k < 3; k++)
        summary_number(f, names[k], bodies_force(r->sim, k));
    summary_end(f);
}

static void bodies_print(const void *record)
{
    const struct record *const r = record;
    const double F[3] = {bodies_force(r->sim, 0), bodies_force(r->sim, 1),
                         bodies_force(r->sim, 2)};
    char gap[BODY_SEAL_TEXT];
    double flow[3];

    fluid_mean_flow(r->sim->fluid, flow);
    for (int open = 0; open < 2; open++) {
        const struct body_seal *const s = &r->bodies->seal;
        const struct body_seal_gap *const g = open ? &s->open : &s->closed;
        body_seal_describe(g, open, gap);
        if (g->beside > 0)
            printf("gaps below a cell %s, the widest of %.2g cells: %s\n",
                   open ? "that may change are open" : "are closed", g->width,
                   gap);
    }
    if (r->bodies->deepest > 0.0)
        printf("largest overlap of the bodies %.3g of a diameter or width\n",
               r->bodies->deepest);
    printf("force of the fluid on the bodies [%.6g, %.6g, %.6g] N, mean flow "
           "[%.6g, %.6g, %.6g] m/s; each body in %s/bodies.csv\n",
           F[0], F[1], F[2], flow[0], flow[1], flow[2], r->folder);
}

static void bodies_visit(void *record, struct state *s)
{
    struct record *const r = record;

    state_begin(s, "bodies_record");
    table_state(r->table, s);
    series_state(r->pictures, s);
    state_end(s);
}

const struct recorder_part recorder_bodies = {.create = create_bodies,
                                              .free = bodies_release,
                                              .row = bodies_add_row,
                                              .last_row = bodies_add_row,
                                              .fields = add_picture,
                                              .columns = columns,
                                              .summarize = bodies_summarize,
                                              .print = bodies_print,
                                              .state = bodies_visit};

/* These two have only columns: where there are bodies among particles, and
 * where bodies can leave. */
static void *bodies_create_among(const struct recorder_view *v, int *failed)
{
    (void)failed;
    return among(v->sim);
}

static void *bodies_create_left(const struct recorder_view *v, int *failed)
{
    const struct solid_bodies *const b = bodies_of_run(v->sim);
    (void)failed;
    return b != NULL ? b->exit : NULL;
}

const struct recorder_part recorder_bodies_among = {
    .create = bodies_create_among, .columns = columns_among};
const struct recorder_part recorder_bodies_left = {.create = bodies_create_left,
                                                   .columns = columns_left};

/* --- their outlines ------------------------------------------------------- */

struct outlines {
    const struct solid_bodies *bodies;
    struct series *clumps, *surfaces; /* NULL: there are none */
    int n_balls, n_triangles;
    double *x[3], *d;           /* [m] of the balls */
    double *corner;             /* [m] of the triangles, 9 each */
    int *of_ball, *of_triangle; /* [-] the body of each */
    int *number, *end;          /* [-] points of the triangles */
};

static void outlines_release(void *record)
{
    struct outlines *const r = record;

    series_free(r->clumps);
    series_free(r->surfaces);
    owner_free(r);
}

/* Balls are shown of what consists of them, not the points of a surface. */
static int balls_of(const struct body_shape *shape)
{
    const struct body_outline *const o = shape->outline;
    return o != NULL && o->n_triangles == 0 ? o->n_balls : 0;
}

static int body_triangles(const struct body_shape *shape)
{
    return shape->outline != NULL ? shape->outline->n_triangles
                                  : block_triangles_count(shape);
}

static void outlines_make_room(struct outlines *r)
{
    for (int k = 0; k < 3; k++)
        r->x[k] = owner_doubles(r, r->n_balls);
    r->d = owner_doubles(r, r->n_balls);
    r->of_ball = owner_ints(r, r->n_balls);
    r->corner = owner_doubles(r, 9 * r->n_triangles);
    r->of_triangle = owner_ints(r, r->n_triangles);
    r->number = owner_ints(r, 3 * r->n_triangles);
    r->end = owner_ints(r, r->n_triangles);
    for (int c = 0; c < 3 * r->n_triangles; c++)
        r->number[c] = c;
    for (int t = 0; t < r->n_triangles; t++)
        r->end[t] = 3 * (t + 1);
}

static void *outlines_create(const struct recorder_view *v, int *failed)
{
    const struct solid_bodies *const b = bodies_of_run(v->sim);
    if (b == NULL) return NULL;
    struct outlines *const r = owner_create(sizeof *r);
    r->bodies = b;
    for (int i = 0; i < b->ps->n; i++) {
        r->n_balls += balls_of(&b->shape[i]);
        r->n_triangles += body_triangles(&b->shape[i]);
    }
    outlines_make_room(r);
    if (r->n_balls > 0) r->clumps = recorder_series(v, "body_clumps");
    if (r->n_triangles > 0) r->surfaces = recorder_series(v, "body_surfaces");
    *failed = (r->n_balls > 0 && r->clumps == NULL) ||
              (r->n_triangles > 0 && r->surfaces == NULL);
    return r;
}

/* The triangles of a body where it is, nine numbers each. */
static void outlines_put_triangles(const struct body_shape *shape,
                                   const double at[3], double *x)
{
    const struct body_outline *const o = shape->outline;

    if (o == NULL) {
        block_triangles_put(shape, at, (double(*)[3][3])x);
        return;
    }
    for (int c = 0; c < 9 * o->n_triangles; c++)
        x[c] = at[c % 3] +
               vector_dot(shape->turn[c % 3], o->corner[c / 9][c / 3 % 3]);
}

/* Where the balls and the triangles are now. */
static void outlines_place(struct outlines *r)
{
    const struct particles *const ps = r->bodies->ps;
    int ball = 0, triangle = 0;

    for (int i = 0; i < ps->n; i++) {
        const struct body_shape *const shape = &r->bodies->shape[i];
        const double at[3] = {ps->x[i], ps->y[i], ps->z[i]};
        for (int k = 0; k < balls_of(shape); k++, ball++) {
            const struct body_ball b = body_shape_ball(shape, k);
            for (int e = 0; e < 3; e++)
                r->x[e][ball] = at[e] + b.at[e];
            r->d[ball] = 2.0 * b.R;
            r->of_ball[ball] = i;
        }
        const int n = body_triangles(shape);
        if (n > 0) outlines_put_triangles(shape, at, &r->corner[9 * triangle]);
        for (int t = 0; t < n; t++)
            r->of_triangle[triangle++] = i;
    }
}

static int add_clumps(struct outlines *r, double t)
{
    const struct vtk_array arrays[] = {
        vtk_single("diameter", 1, r->d),
        {.name = "body", .components = 1, .ints = r->of_ball}};
    const double *const x[3] = {r->x[0], r->x[1], r->x[2]};
    return series_add_particles(r->clumps, r->n_balls, x, t, 2, arrays);
}

static int outlines_add_surfaces(struct outlines *r, double t)
{
    const struct vtk_polygons shape = {
        3 * r->n_triangles, r->n_triangles, r->corner, r->number, r->end, 0};
    const struct vtk_array of = {
        .name = "body", .components = 1, .ints = r->of_triangle};

    return series_add_polygons(r->surfaces, &shape, t, 1, &of);
}

static int outlines_add(void *record, double t)
{
    struct outlines *const r = record;
    const struct series *const any =
        r->clumps != NULL ? r->clumps : r->surfaces;

    if (any == NULL || (!r->bodies->moves && series_count(any) > 0)) return 0;
    outlines_place(r);
    return (r->clumps != NULL && add_clumps(r, t) != 0) ||
           (r->surfaces != NULL && outlines_add_surfaces(r, t) != 0);
}

static void outlines_visit(void *record, struct state *s)
{
    struct outlines *const r = record;

    state_begin(s, "outlines_record");
    if (r->clumps != NULL) series_state(r->clumps, s);
    if (r->surfaces != NULL) series_state(r->surfaces, s);
    state_end(s);
}

const struct recorder_part recorder_outlines = {.create = outlines_create,
                                                .free = outlines_release,
                                                .fields = outlines_add,
                                                .state = outlines_visit};
