/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_bodies_check.c -- what a case may not ask of its bodies. */
#include "case/resolved/case_bodies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/build.h"
#include "case/case_mesh.h"
#include "case/particles/case_materials.h"
#include "resolved/shapes/block_contacts.h"

/* Less than 3 cells across by rounding is 3. A sphere of fewer is a few cells
 * and has no shape. */
static const double least_cells = 3.0 * (1.0 - 1e-9);

#define BODY_WRONG(s, b, ...) settings_wrong(s, (b)->path, __VA_ARGS__)

static int check_mesh(const struct settings *s)
{
    const double *const grading = s->mesh.box.grading;

    if (s->poly != NULL)
        return settings_wrong(s, "bodies",
                              "bodies are held in the cells of a plain box; "
                              "leave out mesh.polymesh and mesh.shear");
    for (int k = 0; k < 3; k++)
        if (fabs(grading[k] - 1.0) > 0.01)
            return settings_wrong(s, KEY_OF(s, mesh.box.grading),
                                  "%g: bodies ask for equal cells", grading[k]);
    return 0;
}

/* Bodies among particles: a body in the way of a method that sets velocities by
 * solid fractions, a cell that a body enters, and what knows no surfaces. */
static int case_bodies_check_particles(const struct settings *s)
{
    const char *const pull = case_materials_attraction_of_box(s);
    const struct case_bodies *const c = s->all_bodies;
    int moves = 0;

    for (int i = 0; i < c->n; i++)
        moves |= c->item[i].says->motion != BODY_FIXED;
    if (strcmp(s->bodies.method->name, "hold") != 0)
        return settings_wrong(s, KEY_OF(s, bodies.method),
                              "among particles bodies hold the fluid by "
                              "\"hold\" only");
    if (s->bodies.list[BODY_CLUMPS].n > 0)
        return settings_wrong(s, KEY_OF(s, bodies.list[BODY_CLUMPS]),
                              "clumps do not touch particles; give the body as "
                              "a closed surface, in bodies.surfaces");
    if (s->has.exchange && moves && s->fluid.continuity != CONTINUITY_MIXTURE)
        return settings_wrong(s, KEY_OF(s, fluid.continuity),
                              "among particles a body that moves asks for "
                              "\"mixture\": where it comes, the fluid fraction "
                              "jumps");
    if (pull != NULL)
        return settings_wrong(s, "bodies",
                              "%s acts between particles and the box, not on "
                              "bodies: leave one of them out",
                              pull);
    if (s->particles.bed_file != NULL)
        return settings_wrong(s, "bodies",
                              "a bed that settles around bodies is not kept in "
                              "a file: leave particles.bed.file out");
    return 0;
}

static int check_sphere(const struct settings *s, const struct case_body *b)
{
    const struct case_bodies *const c = s->all_bodies;
    const double d = b->says->diameter, *const x = b->says->position;
    const int fixed = b->says->motion == BODY_FIXED;

    if (b->says->motion == BODY_FREE && b->says->density == 0.0)
        return BODY_WRONG(s, b, "sphere %d is free and asks for its density",
                          b->number);
    for (int k = 0; k < 3; k++) {
        const double L = c->hi[k] - c->lo[k];
        const double margin = c->periodic[k] || fixed ? 0.0 : 0.5 * d;
        if (x[k] < c->lo[k] + margin || x[k] > c->hi[k] - margin)
            return BODY_WRONG(s, b,
                              "sphere %d at [%g, %g, %g] m with diameter %g m "
                              "is not inside the box",
                              b->number, x[0], x[1], x[2], d);
        if (d < least_cells * c->h[k])
            return BODY_WRONG(s, b,
                              "sphere %d has a diameter of %.3g cells; "
                              "expected at least %g, better 12",
                              b->number, d / c->h[k], least_cells);
        if (c->periodic[k] && d >= (fixed ? 1.0 : 0.5) * L)
            return BODY_WRONG(s, b,
                              "sphere %d with diameter %g m meets itself "
                              "across the period, %g m; %s",
                              b->number, d, L,
                              fixed ? "expected less"
                                    : "expected less than half of it");
    }
    return 0;
}

/* What moves by its mass against a spring, along the axes that have one. */
static int check_spring(const struct settings *s, const struct case_body *b)
{
    const double *const k = b->says->spring, *const v = b->says->velocity;

    if (b->says->motion == BODY_FREE && vector_length(k) > 0.0)
        return BODY_WRONG(s, b,
                          "number %d is free and has a spring; motion = "
                          "\"spring\" holds it by that",
                          b->number);
    if (b->says->motion != BODY_SPRING) return 0;
    if (!(vector_length(k) > 0.0))
        return BODY_WRONG(s, b,
                          "number %d is on a spring and asks for its "
                          "stiffness, spring = [kx, ky, kz] in N/m",
                          b->number);
    for (int e = 0; e < 3; e++)
        if (k[e] == 0.0 && v[e] != 0.0)
            return BODY_WRONG(s, b,
                              "number %d has a velocity along %c, where it "
                              "cannot move without a spring",
                              b->number, 'x' + e);
    if (b->says->density > 0.0) return 0;
    return BODY_WRONG(s, b, "number %d is on a spring and asks for its density",
                      b->number);
}

/* What is fixed has no velocity; it has no spin, nor has what is on a spring.
 */
static int check_velocity(const struct settings *s, const struct case_body *b)
{
    const int fixed = b->says->motion == BODY_FIXED;

    if (fixed && vector_length(b->says->velocity) > 0.0)
        return BODY_WRONG(s, b,
                          "number %d is fixed and has a velocity; motion = "
                          "\"prescribed\" keeps it",
                          b->number);
    if (vector_length(b->says->spin) > 0.0 &&
        (fixed || b->says->motion == BODY_SPRING))
        return BODY_WRONG(s, b,
                          "number %d does not turn and has a spin; motion = "
                          "\"prescribed\" keeps it",
                          b->number);
    return 0;
}

/* --- places --------------------------------------------------------------- */

/* The width across axis k [m]. One along an axis of the box has its length
 * there. */
static double block_width(const struct body_shape *shape, int k)
{
    const double d = 2.0 * shape->half[0], length = 2.0 * shape->half[1];

    return shape->kind == BODY_BOX      ? 2.0 * shape->half[k]
           : body_shape_along(shape, k) ? length
           : shape->axis[k] == 0.0      ? d
                                        : fmin(d, length);
}

/* What reaches through the box has no ends there. One that is narrower than a
 * cell may hold none. */
static int check_block(const struct settings *s, const struct case_body *b)
{
    const struct case_bodies *const c = s->all_bodies;
    const double *const x = b->says->position;
    double extent[3];

    body_shape_extent(&b->plain, extent);
    for (int k = 0; k < 3; k++) {
        const double reach = b->says->motion == BODY_FIXED ? extent[k] : 0.0;
        const double width = block_width(&b->plain, k);
        if (x[k] + reach < c->lo[k] || x[k] - reach > c->hi[k])
            return BODY_WRONG(
                s, b, "number %d at [%g, %g, %g] m is not inside the box",
                b->number, x[0], x[1], x[2]);
        if (2.0 * extent[k] < c->hi[k] - c->lo[k] && width < c->h[k])
            return BODY_WRONG(s, b,
                              "number %d is %.3g cells wide; expected at least "
                              "1, better 12",
                              b->number, width / c->h[k]);
    }
    return 0;
}

/* The box around the shape as it was given [m]. */
static void ends_of(const struct body_outline *o, double lo[3], double hi[3])
{
    for (int k = 0; k < 3; k++) {
        lo[k] = HUGE_VAL;
        hi[k] = -HUGE_VAL;
        for (int i = 0; i < o->n_balls && o->n_triangles == 0; i++) {
            lo[k] = fmin(lo[k], o->ball[i].at[k] - o->ball[i].R);
            hi[k] = fmax(hi[k], o->ball[i].at[k] + o->ball[i].R);
        }
        for (int c = 0; c < 3 * o->n_triangles; c++) {
            lo[k] = fmin(lo[k], o->corner[c / 3][c % 3][k]);
            hi[k] = fmax(hi[k], o->corner[c / 3][c % 3][k]);
        }
        lo[k] += o->centre[k];
        hi[k] += o->centre[k];
    }
}

/* The narrowest part that is known of a shape: a ball, its box, or of a block
 * what it knows of itself [m]. */
static double thinnest(const struct case_body *b, const double lo[3],
                       const double hi[3])
{
    const double least =
        fmin(hi[0] - lo[0], fmin(hi[1] - lo[1], hi[2] - lo[2]));

    if (b->list == BODY_SURFACES) return least; /* see its thickness */
    return fmin(least,
                b->list == BODY_CLUMPS ? 2.0 * b->R_min : b->outline->width);
}

/* The farthest point from the centroid [m]. */
static double reach_of(const struct body_outline *o)
{
    double most = 0.0;

    for (int i = 0; i < o->n_balls; i++)
        most = fmax(most, vector_length(o->ball[i].at) + o->ball[i].R);
    for (int c = 0; c < 3 * o->n_triangles; c++)
        most = fmax(most, vector_length(o->corner[c / 3][c % 3]));
    return most;
}

static int check_place(const struct settings *s, const struct case_body *b)
{
    const struct case_bodies *const c = s->all_bodies;
    const int fixed = b->says->motion == BODY_FIXED;
    const double *const x = b->says->position;
    double from[3], to[3];

    ends_of(b->outline, from, to);
    const double thin = thinnest(b, from, to);
    for (int k = 0; k < 3; k++) {
        const double L = c->hi[k] - c->lo[k];
        const double wide =
            fixed ? to[k] - from[k] : 4.0 * reach_of(b->outline);
        if (thin < least_cells * c->h[k])
            return BODY_WRONG(s, b,
                              "number %d has a part of %.3g cells; expected at "
                              "least %g, better 12",
                              b->number, thin / c->h[k], least_cells);
        if (c->periodic[k] && wide >= L)
            return BODY_WRONG(s, b,
                              "number %d meets itself across the period, %g m",
                              b->number, L);
        if (!c->periodic[k] && !fixed &&
            (x[k] + from[k] < c->lo[k] || x[k] + to[k] > c->hi[k]))
            return BODY_WRONG(s, b,
                              "number %d, from %g to %g m in direction %d, is "
                              "not inside the box",
                              b->number, x[k] + from[k], x[k] + to[k], k);
    }
    return 0;
}

/* A closed surface may be thinner than its box, but not so thin that it may
 * have no cell inside. */
static int check_thickness(const struct settings *s, const struct case_body *b)
{
    const double *const h = s->all_bodies->h;
    const double most = fmax(h[0], fmax(h[1], h[2]));

    if (b->list != BODY_SURFACES || b->outline->width >= most) return 0;
    return BODY_WRONG(s, b,
                      "number %d is only %.3g cells thick; expected at least "
                      "1, better 12",
                      b->number, b->outline->width / most);
}

/* A free one from wall to wall across axis k. */
static int check_upright(const struct settings *s, const struct case_body *b,
                         int k)
{
    const struct case_bodies *const c = s->all_bodies;
    const double *const v = b->says->velocity, *const w = b->says->spin;

    if (c->periodic[k] ||
        !body_outline_spans(b->outline, k, c->hi[k] - c->lo[k], c->h[k]) ||
        (v[k] == 0.0 && w[(k + 1) % 3] == 0.0 && w[(k + 2) % 3] == 0.0))
        return 0;
    return BODY_WRONG(s, b,
                      "number %d reaches from wall to wall along %c: it has no "
                      "velocity there and no spin about another axis",
                      b->number, "xyz"[k]);
}

static int check_outline(const struct settings *s, struct case_body *b)
{
    const enum body_motion motion = b->says->motion;

    if (b->says->density == 0.0 &&
        (motion == BODY_FREE || motion == BODY_SPRING))
        return BODY_WRONG(s, b, "number %d is moved and asks for its density",
                          b->number);
    int code = case_bodies_outline(s, b);
    if (code == 0) code = check_place(s, b);
    if (code == 0) code = check_thickness(s, b);
    for (int k = 0; k < 3 && code == 0 && motion == BODY_FREE; k++)
        code = check_upright(s, b, k);
    return code;
}

static int check_body(const struct settings *s, struct case_body *b)
{
    if (b->list == BODY_CYLINDERS && vector_length(b->says->axis) == 0.0)
        return BODY_WRONG(s, b, "the axis of cylinder %d has no direction",
                          b->number);
    return b->list >= BODY_CLUMPS || b->says->motion == BODY_FREE
               ? check_outline(s, b)
               : check_block(s, b);
}

/* --- all ------------------------------------------------------------------ */

/* A cube that is narrower than a cell may have none in it. */
static int check_filter(const struct settings *s)
{
    const double width = s->bodies.filter, *const h = s->all_bodies->h,
                 widest = fmax(h[0], fmax(h[1], h[2]));

    if (width == 0.0 || width >= widest) return 0;
    return settings_wrong(s, KEY_OF(s, bodies.filter),
                          "%g m is narrower than a cell, %g m; expected more "
                          "than a body, two diameters or so",
                          width, widest);
}

static int check_all(const struct settings *s)
{
    struct case_body *const first = s->all_bodies->item, *const end =
                                                             first +
                                                             s->all_bodies->n;
    int code = check_mesh(s);

    if (code == 0 && first == end)
        return settings_wrong(s, "bodies",
                              "there is no body; give spheres, boxes, "
                              "cylinders, clumps or surfaces");
    if (s->has.particles && code == 0) code = case_bodies_check_particles(s);
    for (struct case_body *b = first; b < end && code == 0; b++)
        if (b->list == BODY_SPHERES) code = check_sphere(s, b);
    for (struct case_body *b = first; b < end && code == 0; b++) {
        code = check_spring(s, b);
        if (code == 0) code = check_velocity(s, b);
    }
    if (code == 0) code = check_filter(s);
    for (struct case_body *b = first; b < end && code == 0; b++)
        if (b->list >= BODY_CLUMPS) code = check_body(s, b);
    for (struct case_body *b = first; b < end && code == 0; b++)
        if (b->list == BODY_BOXES || b->list == BODY_CYLINDERS)
            code = check_body(s, b);
    for (struct case_body *b = first; b < end && code == 0; b++)
        code = case_bodies_outline(s, b);
    return code != 0 ? code : case_bodies_check_stiffness(s);
}

/* --- where they start ----------------------------------------------------- */

/* Non-zero after a message. */
static int case_bodies_overlap(const struct settings *s,
                               const struct solid_bodies *b)
{
    int pair[2];
    const double depth = body_gaps_deepest(b, pair);

    if (depth == 0.0) return 0;
    return settings_wrong(s, "bodies",
                          "body %d begins %g m deep in body %d (counted as in "
                          "bodies.csv: spheres, boxes, cylinders, clumps, "
                          "surfaces)",
                          pair[0], depth, pair[1]);
}

/* Non-zero after a message. */
static int sealed(const struct settings *s, const struct solid_bodies *b)
{
    static const char way[] =
        "the flow would go through bodies; leave a gap of a cell or more";

    if (b->seal.outside == 0)
        return settings_wrong(s, "bodies",
                              "they cover all of the mesh, and no fluid is "
                              "left; sizes are in m");
    if (case_bodies_overlap(s, b) != 0) return 2;
    if (b->seal.inlet)
        return settings_wrong(
            s, "bodies", "they cut an inlet off from every outlet: %s", way);
    if (b->seal.pushes == 0) return 0;
    return settings_wrong(s, "bodies",
                          "body %d (counted as in bodies.csv) pushes the fluid "
                          "into a part of the box without an outlet: %s",
                          b->seal.pushes - 1, way);
}

/* What body i leaves of its way to the walls after a time [m]. */
static double way_left(const struct solid_bodies *b, int i, double t)
{
    const struct particles *const ps = b->ps;
    const struct dem_options *const o = &b->contacts;
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]},
                 v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    double extent[3], least = HUGE_VAL;

    body_shape_extent(&b->shape[i], extent);
    for (int k = 0; k < 3; k++) {
        const double gap = v[k] > 0.0 ? o->hi[k] - x[k] : x[k] - o->lo[k];
        if (v[k] != 0.0 && !o->periodic[k])
            least = fmin(least, gap - extent[k] - t * fabs(v[k]));
    }
    return least;
}

int case_bodies_start(const struct settings *s, struct case_bodies_first *first)
{
    struct solid_bodies *const b = case_bodies_create(s);

    if (b == NULL) return 2;
    struct mesh *const m = case_mesh_create(s);
    struct boundary *const boundaries = build_boundaries(s, m);
    struct fluid fl = {.mesh = m,
                       .u = alloc_doubles(3 * m->n_cells),
                       .options = {.rho = s->fluid.rho,
                                   .mu = s->fluid.mu,
                                   .dt = s->fluid.dt,
                                   .boundaries = boundaries}};
    int code = boundaries == NULL || solid_bodies_begin(b, &fl) != 0 ? 2 : 0;

    if (code == 0) code = sealed(s, b);
    first->seal = b->seal;
    first->left = HUGE_VAL;
    for (int i = 0; i < b->ps->n; i++)
        if (b->motion[i] == BODY_PRESCRIBED)
            first->left = fmin(first->left, way_left(b, i, s->output.end));
    free(fl.u);
    build_boundaries_free(boundaries, m->n_patches);
    mesh_free(m);
    solid_bodies_free(b);
    return code;
}

int case_bodies_check(const struct settings *s)
{
    struct case_bodies_first first;

    if (!s->has.bodies) return 0;
    const int code = check_all(s);
    return code != 0 ? code : case_bodies_start(s, &first);
}
