/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resolved/case_bodies.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"
#include "case/case_mesh.h"
#include "case/case_file.h"
#include "coupling/effects.h"
#include "dem/contact_linear.h"
#include "case/particles/case_clumps.h"
#include "dem/reference.h"
#include "dem/surfaces/triangles.h"
#include "resolved/solid_bodies.h"
#include "resolved/among/among_grains.h"
#include "resolved/body_numbers.h"
#include "resolved/shapes/shapes.h"
#include "resolved/body_motion.h"

/* --- all bodies ----------------------------------------------------------- */

static struct body_shape plain_shape(enum body_list list,
                                     const struct body_setup *says)
{
    if (list == BODY_BOXES) return body_shape_box(says->size);
    if (list == BODY_CYLINDERS)
        return body_shape_cylinder(says->diameter, says->length, says->axis);
    return body_shape_sphere(says->diameter);
}

void case_bodies_keep(struct settings *s)
{
    struct case_bodies *const c = s->all_bodies = alloc_zeroed(1, sizeof *c);

    case_mesh_ends(s, c->lo, c->hi);
    case_mesh_periodic(s, c->periodic);
    for (int k = 0; k < 3 && s->poly == NULL; k++)
        c->h[k] = (c->hi[k] - c->lo[k]) / s->mesh.box.cells[k];
    for (int l = 0; l < BODY_LISTS; l++)
        c->n += s->bodies.list[l].n;
    c->item = alloc_zeroed((size_t)c->n, sizeof *c->item);
    struct case_body *b = c->item;
    for (enum body_list l = 0; l < BODY_LISTS; l++)
        for (int i = 0; i < s->bodies.list[l].n; i++, b++) {
            const struct body_setup *const says = &s->bodies.list[l].item[i];
            *b = (struct case_body){.says = says,
                                    .list = l,
                                    .path = KEY_OF(s, bodies.list[l]),
                                    .number = i,
                                    .plain = plain_shape(l, says)};
            c->touch |= says->motion == BODY_FREE && l != BODY_SPHERES &&
                        l != BODY_CLUMPS;
        }
}

/* The same file at the same scale is one outline. */
static const struct case_body *first_alike(const struct settings *s,
                                           const struct case_body *b)
{
    const struct case_body *a = s->all_bodies->item;

    while (a != b && (a->list != b->list || a->says->file == NULL ||
                      a->says->scale != b->says->scale ||
                      strcmp(a->says->file, b->says->file) != 0))
        a++;
    return a;
}

void case_bodies_release(struct settings *s)
{
    struct case_bodies *const c = s->all_bodies;

    for (int i = 0; c != NULL && i < c->n; i++) {
        struct case_body *const b = &c->item[i];
        if (b->outline == NULL || first_alike(s, b) != b) continue;
        b->outline->kept = 0;
        body_outline_free(b->outline);
    }
    if (c != NULL) free(c->item);
    free(c);
}

/* --- outlines ------------------------------------------------------------- */

/* NULL after a message. */
static struct body_outline *read_clump(const struct settings *s,
                                       const struct body_setup *says)
{
    int n;
    struct body_ball *const ball =
        case_clumps_file(s, says->file, says->scale, &n);

    if (ball == NULL) return NULL;
    struct body_outline *const o = clump_create(n, ball);
    free(ball);
    return o;
}

/* NULL after a message. */
static struct body_outline *read_surface(const struct settings *s,
                                         const struct case_body *b)
{
    const struct input *const in = settings_input(s, b->says->file);
    const char *trouble;
    struct stl stl;

    if (stl_parse(in, &stl) != 0) return NULL;
    for (int c = 0; c < 9 * stl.n; c++)
        stl.corner[c / 9][c / 3 % 3][c % 3] *= b->says->scale;
    struct body_outline *const o =
        closed_surface_create(stl.n, stl.corner, &trouble);
    stl_release(&stl);
    if (o == NULL)
        settings_wrong(s, b->path,
                       "%s holds no body, its surface is not closed: %s",
                       in->path, trouble);
    return o;
}

/* A block that never turns and touches nothing has none. A cylinder is turned
 * by its axis alone. */
static struct body_outline *turned_block(const struct settings *s,
                                         const struct case_body *b)
{
    return s->all_bodies->touch || vector_length(b->says->rotation) > 0.0 ||
                   vector_length(b->says->spin) > 0.0
               ? block_outline_create(&b->plain, b->says->rotation)
               : NULL;
}

/* The points of a closed outline that touch others, if any do. */
static void add_points(const struct case_bodies *c, struct body_outline *o)
{
    if (!c->touch) return;
    contact_points_add(o);
    for (int k = 0; k < 3; k++)
        if (!c->periodic[k] &&
            body_outline_spans(o, k, c->hi[k] - c->lo[k], c->h[k]))
            contact_points_between(o, k);
}

int case_bodies_outline(const struct settings *s, struct case_body *b)
{
    struct body_outline *o;

    if (b->outline != NULL || b->list == BODY_SPHERES) return 0;
    if (b->says->file != NULL && (o = first_alike(s, b)->outline) != NULL)
        b->outline = o;
    else {
        o = b->list == BODY_CLUMPS     ? read_clump(s, b->says)
            : b->list == BODY_SURFACES ? read_surface(s, b)
                                       : turned_block(s, b);
        if (o == NULL) return b->says->file != NULL ? 2 : 0;
        o->kept = 1;
        b->outline = o;
        if (b->list != BODY_CLUMPS) add_points(s->all_bodies, o);
    }
    b->R_min = HUGE_VAL;
    for (int k = 0; k < o->n_balls; k++) {
        b->R_min = fmin(b->R_min, o->ball[k].R);
        b->R_max = fmax(b->R_max, o->ball[k].R);
    }
    return 0;
}

/* --- masses and contacts -------------------------------------------------- */

/* Steps of the fluid that an impact lasts where the case gives no stiffness:
 * the fluid has to follow the rebound. */
static const double steps_an_impact = 8.0;

/* Volume [m^3] and smallest width [m]; of a block before it is turned. */
static void size_of(const struct case_body *b, double *V, double *width)
{
    const struct body_shape shape =
        b->list < BODY_CLUMPS ? b->plain : body_shape_outline(b->outline);

    *V = body_shape_volume(&shape);
    *width = body_shape_width(&shape);
}

double case_bodies_virtual_mass(const struct settings *s,
                                const struct case_body *b)
{
    const double rho = s->fluid.rho;
    double V, width;

    size_of(b, &V, &width);
    const double R = 0.5 * width, x = s->fluid.mu * s->fluid.dt / (rho * R * R);
    return body_numbers_virtual_mass(
        s->bodies.virtual_mass, x, b->says->density / rho,
        body_numbers_added_mass(V, width), s->all_bodies->n);
}

/* The volume whose mass one ball or contact point carries [m^3]: of a clump the
 * largest sphere, else its volume over the points that meet a plane together.
 */
static double contact_volume(const struct settings *s,
                             const struct case_body *b)
{
    const double d = b->says->diameter;

    if (b->list == BODY_SPHERES) return M_PI / 6.0 * d * d * d;
    if (b->list == BODY_CLUMPS)
        return 4.0 / 3.0 * M_PI * b->R_max * b->R_max * b->R_max;
    if (b->list != BODY_SURFACES && !s->all_bodies->touch)
        return body_shape_volume(&b->plain);
    return b->outline->volume / fmax(b->outline->flat, 1);
}

/* What a contact has to stop [kg]. */
static double contact_mass(const struct settings *s, const struct case_body *b)
{
    const double C_v = case_bodies_virtual_mass(s, b);

    return (b->says->density + body_numbers_contact_mass(C_v) * s->fluid.rho) *
           contact_volume(s, b);
}

/* The smallest mass in a contact of a body with this motion [kg]; HUGE_VAL:
 * there is none. */
static double lightest_of(const struct settings *s, enum body_motion motion)
{
    const struct case_bodies *const c = s->all_bodies;
    double least = HUGE_VAL;

    for (const struct case_body *b = c->item; b < c->item + c->n; b++)
        if (b->says->motion == motion) least = fmin(least, contact_mass(s, b));
    return least;
}

/* Of the free ones, or if there are none of those on springs; 0: all are held.
 */
static double lightest(const struct settings *s)
{
    double least = lightest_of(s, BODY_FREE);

    if (least == HUGE_VAL) least = lightest_of(s, BODY_SPRING);
    return least < HUGE_VAL ? least : 0.0;
}

/* k with which a mass bounces off a wall in so many steps [LS 4.4]. */
static double stiffness_of(const struct settings *s, double m)
{
    if (s->bodies.stiffness > 0.0) return s->bodies.stiffness;
    const double e = s->bodies.restitution, zeta = contact_damping_ratio(e);
    const double t = steps_an_impact * s->fluid.dt;

    return m > 0.0 ? m * M_PI * M_PI / (t * t * (1.0 - zeta * zeta)) : 1.0;
}

/* 25 in the impact of two of this mass. */
static int dem_steps(const struct settings *s, double k, double m)
{
    const double e = s->bodies.restitution;

    if (s->has.particles) return case_steps_within(s);
    if (m == 0.0) return 1;
    const double t = contact_linear_time(k, e, 0.5 * m);
    return number_clamped(ceil(25.0 * s->fluid.dt / t), 1, 1000000);
}

struct case_bodies_contact case_bodies_contact(const struct settings *s)
{
    const double m = lightest(s), k = stiffness_of(s, m);

    return (struct case_bodies_contact){k, dem_steps(s, k, m)};
}

/* With which a body hits something fixed, the largest at time 0 [m/s] or that
 * of a fall through its own width: v sqrt(m/k) and what bears its weight, in
 * widths. */
static double overlap_of(const struct settings *s, const struct case_body *b,
                         double k, double speed)
{
    const double rho = s->fluid.rho, weight = fabs(b->says->density - rho) *
                                              vector_length(s->effects.gravity);
    double V, width;

    size_of(b, &V, &width);
    const double v = fmax(speed, sqrt(weight / rho * width));
    return (v * sqrt(contact_mass(s, b) / k) +
            contact_volume(s, b) * weight / k) /
           width;
}

double case_bodies_expected_overlap(const struct settings *s)
{
    const struct case_bodies *const c = s->all_bodies;
    const double k = case_bodies_contact(s).stiffness;
    double most = 0.0, v = 0.0;

    for (const struct case_body *b = c->item; b < c->item + c->n; b++)
        v = fmax(v, vector_length(b->says->velocity));
    for (const struct case_body *b = c->item; b < c->item + c->n; b++)
        if (b->says->motion == BODY_FREE)
            most = fmax(most, overlap_of(s, b, k, v));
    return most;
}

int case_bodies_check_stiffness(const struct settings *s)
{
    const double e = s->bodies.restitution, m = lightest(s),
                 k = stiffness_of(s, m);
    const double t = contact_linear_time(k, e, 0.5 * m),
                 step = s->fluid.dt / dem_steps(s, k, m);

    if (m == 0.0 || t >= 5.0 * step) return 0;
    return settings_wrong(s, KEY_OF(s, bodies.stiffness),
                          "%g N/m: an impact lasts %.3g s and a particle step "
                          "%.3g s; expected at least five of them in it",
                          k, t, step);
}

/* --- the simulation ------------------------------------------------------- */

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

    memcpy(o.lo, s->all_bodies->lo, sizeof o.lo);
    memcpy(o.hi, s->all_bodies->hi, sizeof o.hi);
    memcpy(o.periodic, s->all_bodies->periodic, sizeof o.periodic);
    return o;
}

static void add_one(const struct case_body *from, struct solid_bodies *b)
{
    const struct body_setup *const says = from->says;
    const struct body_shape shape =
        from->outline != NULL ? body_shape_outline(from->outline) : from->plain;
    const int has_mass =
        says->motion == BODY_FREE || says->motion == BODY_SPRING;
    const double *const v = says->velocity, *const w = says->spin;
    double x[3];

    memcpy(x, says->position, sizeof x);
    for (int e = 0; e < 3 && shape.outline != NULL; e++)
        x[e] += shape.outline->centre[e];
    const int at = solid_bodies_add(
        b, &shape, x, has_mass ? says->density : 1.0, says->motion);
    b->ps->vx[at] = v[0], b->ps->vy[at] = v[1], b->ps->vz[at] = v[2];
    b->ps->wx[at] = w[0], b->ps->wy[at] = w[1], b->ps->wz[at] = w[2];
    if (says->motion == BODY_SPRING)
        solid_bodies_set_spring(b, at, says->spring);
}

static struct squeeze_film gaps(const struct settings *s)
{
    const struct case_bodies *const c = s->all_bodies;
    double R = HUGE_VAL;

    for (const struct case_body *b = c->item; b < c->item + c->n; b++)
        if (b->list == BODY_SPHERES || b->list == BODY_CLUMPS)
            R = fmin(R, b->list == BODY_CLUMPS ? b->R_min
                                               : 0.5 * b->says->diameter);
    return (struct squeeze_film){
        .mu = s->fluid.mu,
        .z_min = s->bodies.roughness * R,
        .reach =
            s->bodies.lubrication
                ? squeeze_film_cells * fmax(c->h[0], fmax(c->h[1], c->h[2]))
                : 0.0};
}

struct solid_bodies *case_bodies_create(const struct settings *s)
{
    for (int i = 0; i < s->all_bodies->n; i++)
        if (case_bodies_outline(s, &s->all_bodies->item[i]) != 0) return NULL;
    const struct case_bodies_contact contact = case_bodies_contact(s);
    const struct dem_options dem = case_bodies_contacts(s, &contact);
    struct solid_bodies_options o = {.method = s->bodies.method,
                                     .virtual_mass = s->bodies.virtual_mass,
                                     .dem_steps = contact.dem_steps,
                                     .max_overlap = s->bodies.max_overlap,
                                     .dem = &dem,
                                     .lubrication = gaps(s)};
    const int *const cells = s->mesh.box.cells;

    memcpy(o.gravity, s->effects.gravity, sizeof o.gravity);
    struct solid_bodies *const b = solid_bodies_create(
        s->all_bodies->n, cells[0] * cells[1] * cells[2], s->fluid.rho, &o);
    for (int i = 0; i < s->all_bodies->n; i++)
        add_one(&s->all_bodies->item[i], b);
    return b;
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
