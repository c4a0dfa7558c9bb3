/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resolved/case_bodies.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/build_boundaries.h"
#include "case/case_mesh.h"
#include "case/models.h"
#include "record/bodies_record.h"
#include "case/resolved/case_blocks.h"
#include "case/resolved/case_outlines.h"
#include "case/particle_options.h"
#include "coupling/effects.h"
#include "dem/contact_linear.h"
#include "dem/reference.h"
#include "resolved/among/among_effect.h"
#include "resolved/among/among_grains.h"
#include "resolved/bodies_effect.h"
#include "resolved/blocks/block_contacts.h"
#include "resolved/blocks/body_gaps.h"
#include "resolved/squeeze_film.h"

static const char *const list = case_bodies_spheres;

static enum body_motion case_bodies_motion_of(const struct settings *s,
                                              const char *of, int i)
{
    return case_bodies_is(s, of, i, "free")         ? BODY_FREE
           : case_bodies_is(s, of, i, "prescribed") ? BODY_PRESCRIBED
           : case_bodies_is(s, of, i, "spring")     ? BODY_SPRING
                                                    : BODY_FIXED;
}

static struct dem_options
case_bodies_contacts(const struct settings *s,
                     const struct case_bodies_contact *c)
{
    struct dem_options o = {.law = &contact_linear,
                            .material = {.stiffness = c->stiffness,
                                         .restitution = s->bodies.restitution,
                                         .friction = s->bodies.friction},
                            .method = &reference_link_cells,
                            .step = s->fluid.dt / c->dem_steps};

    case_mesh_ends(s, o.lo, o.hi);
    case_mesh_periodic(s, o.periodic);
    return o;
}

static void add_one(const struct settings *s, const char *of, int i,
                    const struct body_shape *shape, struct solid_bodies *b)
{
    const enum body_motion motion = case_bodies_motion_of(s, of, i);
    const int has_mass = motion == BODY_FREE || motion == BODY_SPRING;
    double x[3], v[3], w[3], k[3];

    settings_item_vector(s, of, i, "position", x);
    settings_item_vector(s, of, i, "velocity", v);
    settings_item_vector(s, of, i, "spin", w);
    for (int e = 0; e < 3 && shape->outline != NULL; e++)
        x[e] += shape->outline->centre[e];
    const int at = solid_bodies_add(
        b, shape, x, has_mass ? settings_item_real(s, of, i, "density") : 1.0,
        motion);
    b->ps->vx[at] = v[0], b->ps->vy[at] = v[1], b->ps->vz[at] = v[2];
    b->ps->wx[at] = w[0], b->ps->wy[at] = w[1], b->ps->wz[at] = w[2];
    if (motion != BODY_SPRING) return;
    settings_item_vector(s, of, i, "spring", k);
    solid_bodies_set_spring(b, at, k);
}

/* Of a list of boxes or cylinders. */
static void add_blocks(const struct settings *s, const char *of,
                       struct solid_bodies *b)
{
    for (int i = 0; i < settings_length(s, of); i++) {
        struct body_outline *const o = case_blocks_outline(s, of, i);
        const struct body_shape shape =
            o != NULL ? body_shape_outline(o) : case_blocks_shape(s, of, i);
        add_one(s, of, i, &shape, b);
    }
}

/* Of a list of clumps or surfaces. Non-zero after a message. */
static int add_outlines(const struct settings *s, const char *of,
                        struct solid_bodies *b)
{
    for (int i = 0; i < settings_length(s, of); i++) {
        struct body_outline *const o = case_outlines_read(s, of, i);
        if (o == NULL) return 1;
        const struct body_shape shape = body_shape_outline(o);
        add_one(s, of, i, &shape, b);
    }
    return 0;
}

static int case_bodies_add_all(const struct settings *s, struct solid_bodies *b)
{
    for (int i = 0; i < settings_length(s, list); i++) {
        const struct body_shape shape =
            body_shape_sphere(settings_item_real(s, list, i, "diameter"));
        add_one(s, list, i, &shape, b);
    }
    add_blocks(s, case_blocks_boxes, b);
    add_blocks(s, case_blocks_cylinders, b);
    return add_outlines(s, case_outlines_clumps, b) != 0 ||
           add_outlines(s, case_outlines_surfaces, b) != 0;
}

static struct squeeze_film gaps(const struct settings *s)
{
    double h[3], R = HUGE_VAL;

    case_bodies_cell_widths(s, h);
    for (int i = 0; i < settings_length(s, list); i++)
        R = fmin(R, 0.5 * settings_item_real(s, list, i, "diameter"));
    for (int i = 0; i < settings_length(s, case_outlines_clumps); i++) {
        double of_clump[2];
        case_outlines_radii(s, i, of_clump);
        R = fmin(R, of_clump[0]);
    }
    return (struct squeeze_film){.mu = s->fluid.mu,
                                 .z_min = s->bodies.roughness * R,
                                 .reach = s->bodies.lubrication
                                              ? squeeze_film_cells *
                                                    fmax(h[0], fmax(h[1], h[2]))
                                              : 0.0};
}

static struct solid_bodies *case_bodies_create(const struct settings *s)
{
    const struct case_bodies_contact contact = case_bodies_contact(s);
    const struct dem_options dem = case_bodies_contacts(s, &contact);
    struct solid_bodies_options o = {.method = s->bodies.method,
                                     .virtual_mass = s->bodies.virtual_mass,
                                     .dem_steps = contact.dem_steps,
                                     .max_overlap = s->bodies.max_overlap,
                                     .dem = &dem,
                                     .lubrication = gaps(s),
                                     .others = &block_contacts};
    const int n = case_bodies_count(s);
    const int *const cells = s->mesh.box.cells;

    memcpy(o.gravity, s->effects.gravity, sizeof o.gravity);
    struct solid_bodies *const b = solid_bodies_create(
        n, cells[0] * cells[1] * cells[2], s->fluid.rho, &o);
    if (case_bodies_add_all(s, b) == 0) return b;
    solid_bodies_free(b);
    return NULL;
}

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

int case_bodies_check_start(const struct settings *s)
{
    struct case_bodies_first first;
    const int code = case_bodies_check(s);

    if (code != 0 || !s->has.bodies) return code;
    return case_bodies_start(s, &first);
}

static int case_bodies_has_room(const void *state, const double x[3], double R)
{
    const struct simulation *const sim = state;
    return among_grains_has_room(effects_memory(sim, &among_effect), x, R);
}

/* The surfaces and their names in one list with those of the bodies, which the
 * part of the surfaces releases; sim->n_surfaces stays. */
static void join_surfaces(struct simulation *sim, const struct solid_bodies *b,
                          struct dem_options *o)
{
    const size_t before = (size_t)o->n_surfaces, n = (size_t)b->ps->n;
    struct surface *const all = alloc_zeroed(before + n, sizeof *all);
    const char **const names = alloc_zeroed(before + n, sizeof *names);

    for (size_t i = 0; i < before + n; i++) {
        all[i] = i < before ? sim->surfaces[i] : b->among->surface[i - before];
        names[i] = all[i].name;
    }
    free(sim->surfaces);
    free(sim->surface_names);
    o->surfaces = sim->surfaces = all;
    sim->surface_names = names;
    o->n_surfaces += (int)n;
}

/* Among particles, which touch the bodies: before there are any. */
int case_bodies_complete(const struct settings *s, struct simulation *sim,
                         struct dem_options *o)
{
    if (!s->has.bodies) return 0;
    struct solid_bodies *const b = case_bodies_create(s);

    if (b == NULL) return 2;
    effects_add(sim, &among_effect, b);
    among_grains_create(b, o->n_surfaces);
    join_surfaces(sim, b, o);
    sim->region.has_room = case_bodies_has_room;
    return 0;
}

int case_bodies_add(const struct settings *s, struct simulation *sim)
{
    if (!s->has.bodies) return 0;
    struct solid_bodies *b = effects_memory(sim, &among_effect);

    if (b == NULL) {
        b = case_bodies_create(s);
        if (b == NULL) return 2;
        effects_add(sim, &bodies_effect, b);
    } else
        among_grains_begin(b, sim);
    return solid_bodies_begin(b, sim->fluid) != 0 ? 2 : 0;
}

MODELS_KIND(case_bodies_method, body_methods, "body_method",
            "ways that bodies hold the fluid", "bodies.method", NULL)
