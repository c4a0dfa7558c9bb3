/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_clumps.c -- grains that are rigid bodies of balls.
 * Chapter "Fewer or other particles". */
#include "case/particles/case_clumps.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/text.h"
#include "case/build.h"
#include "coupling/drag.h"
#include "dem/population/insertion.h"
#include "resolved/shapes/shapes.h"

static const char list[] = "particles.clumps";

/* So many balls in all clumps take seconds for their unions. */
enum { CLUMP_BALLS = 1000 };

/* --- shapes --------------------------------------------------------------- */

/* Balls on the long axis of an ellipsoid of revolution that touch it from
 * within, the last ones with the curvature of its ends. They lie closer there,
 * by a power that makes the largest gap small. */
static struct body_ball *ellipsoid_balls(const double half[3], int n)
{
    const double a = half[0], b = half[1];
    struct body_ball *const ball = alloc_zeroed((size_t)n, sizeof *ball);

    for (int k = 0; k < n; k++) {
        const double u = 2.0 * k / (n - 1.0) - 1.0;
        const double c = (a - b * b / a) * copysign(pow(fabs(u), 0.92), u);
        ball[k].at[0] = c;
        ball[k].R = b * sqrt(1.0 - c * c / (a * a - b * b));
    }
    return ball;
}

struct body_ball *case_clumps_file(const struct settings *s, const char *file,
                                   double scale, int *n)
{
    long rows;
    struct insertion_sphere *const read =
        grain_table_parse(settings_input(s, file), &rows);

    if (read == NULL) return NULL;
    struct body_ball *const ball = alloc_zeroed((size_t)rows, sizeof *ball);
    for (long k = 0; k < rows; k++) {
        for (int e = 0; e < 3; e++)
            ball[k].at[e] = scale * read[k].x[e];
        ball[k].R = 0.5 * scale * read[k].d;
    }
    free(read);
    *n = (int)rows;
    return ball;
}

/* Such a ball adds stiffness, and takes time, but is no part of the surface. 0,
 * or 2 after a message. */
static int refuse_inner_balls(const struct input *in, int n,
                              const struct body_ball *ball)
{
    double r[3];

    for (int i = 0; i < n * n; i++) {
        const struct body_ball *const a = &ball[i / n], *const b = &ball[i % n];
        vector_between(a->at, b->at, r);
        if (a == b || vector_length(r) + a->R > b->R * (1.0 + 1e-6)) continue;
        input_refuse(in, 0, "row %d is inside the ball of row %d", i / n + 1,
                     i % n + 1);
        return 2;
    }
    return 0;
}

/* dV/dR of balls of the volume V that shrink together: of a union of balls that
 * overlap in pairs V is a cubic in that, and the difference formula for the
 * beginning of four places exact. */
static double surface_of(int n, const struct body_ball *given, double V)
{
    static const double weight[4] = {11.0, -18.0, 9.0, -2.0};
    struct body_ball *const ball = alloc_zeroed((size_t)n, sizeof *ball);
    double R = HUGE_VAL, sum = weight[0] * V;

    for (int k = 0; k < n; k++)
        R = fmin(R, given[k].R);
    for (int step = 1; step < 4; step++) {
        for (int k = 0; k < n; k++) {
            ball[k] = given[k];
            ball[k].R -= 0.05 * step * R;
        }
        struct body_outline *const o = clump_create(n, ball);
        sum += weight[step] * o->volume;
        body_outline_free(o);
    }
    free(ball);
    return sum / (6.0 * 0.05 * R);
}

/* Mass and moments are those of the union (resolved/shapes/clump.c). 0, or 2
 * after a message. */
static int make_shape(const struct settings *s, const struct clump_setup *one,
                      int n, const struct body_ball *given,
                      struct clump_shape *to)
{
    struct body_outline *const o = clump_create(n, given);
    struct clump_ball *const ball = alloc_zeroed((size_t)n, sizeof *ball);

    for (int k = 0; k < n; k++) {
        memcpy(ball[k].at, o->ball[k].at, sizeof ball[k].at);
        ball[k].R = o->ball[k].R;
    }
    to->sauter = 6.0 * o->volume / surface_of(n, given, o->volume);
    const int wrong = clumps_shape_make(to, n, ball, o->volume, o->gyration);
    body_outline_free(o);
    if (!wrong) return 0;
    return settings_wrong(
        s, list,
        "%s: its mass cannot be shared by its balls; expected "
        "balls on all sides of its centre of mass",
        one->name);
}

static int clumps_check_one(const struct settings *s,
                            const struct clump_setup *one)
{
    const double *const h = one->half;

    if (one->name[0] == '\0')
        return settings_wrong(s, list, "expected a name for each");
    if (one->file != NULL && one->has_balls)
        return settings_wrong(
            s, list, "%s: balls is for half_axes, not for a file", one->name);
    if (one->has_half && one->scale != 1.0)
        return settings_wrong(s, list, "%s: scale is for a file", one->name);
    if ((one->file != NULL) == one->has_half)
        return settings_wrong(s, list, "%s: give either file or half_axes",
                              one->name);
    if (one->has_half && !(h[0] > h[1] && h[1] == h[2] && h[2] > 0.0))
        return settings_wrong(s, list,
                              "%s: half_axes are [%g, %g, %g] m; expected the "
                              "longer one first, and two that are equal",
                              one->name, h[0], h[1], h[2]);
    return 0;
}

static int make_one(const struct settings *s, const struct clump_setup *one,
                    struct clump_shape *to, int *total)
{
    int n = one->balls, code = clumps_check_one(s, one);

    if (code != 0) return code;
    struct body_ball *const ball =
        one->file != NULL ? case_clumps_file(s, one->file, one->scale, &n)
                          : ellipsoid_balls(one->half, n);
    if (ball == NULL) return 2;
    *total += n;
    if (*total > CLUMP_BALLS)
        code = settings_wrong(s, list,
                              "%s has %d balls; expected at most %d in all "
                              "clumps together",
                              one->name, n, CLUMP_BALLS);
    else if (one->file != NULL)
        code = refuse_inner_balls(settings_input(s, one->file), n, ball);
    if (code == 0) code = make_shape(s, one, n, ball, to);
    free(ball);
    return code;
}

const struct clump_shape *case_clumps_shape(const struct settings *s,
                                            const char *name)
{
    const struct clump_shape *found = NULL;

    for (int i = s->particles.clumps.n - 1; i >= 0 && name != NULL; i--)
        if (strcmp(s->particles.shapes[i].name, name) == 0)
            found = &s->particles.shapes[i];
    return found;
}

void case_clumps_release(struct settings *s)
{
    for (int i = 0; i < s->particles.clumps.n && s->particles.shapes != NULL;
         i++)
        free(s->particles.shapes[i].ball);
    free(s->particles.shapes);
}

/* --- sizes ---------------------------------------------------------------- */

/* The diameter [m] of clumps of one name, or of spheres; `around`: of the
 * sphere around one. 0, or 2 after a message. */
static int give_diameter(const struct settings *s, const char *key,
                         const char *name, const char *sizes, int around,
                         double *d)
{
    const struct clump_shape *const shape = case_clumps_shape(s, name);
    struct nearest n;
    char hint[NEAREST_HINT];

    if (name == NULL) return 0;
    nearest_init(&n, name);
    for (int i = 0; i < s->particles.clumps.n; i++)
        nearest_offer(&n, s->particles.shapes[i].name);
    if (shape == NULL)
        return settings_wrong(s, key, "no clump in %s is called %s%s", list,
                              name, nearest_hint(nearest_best(&n), "", hint));
    if (*d == 0.0 && sizes == NULL) *d = clumps_shape_diameter(shape);
    if (around) *d *= clumps_shape_around(shape);
    return 0;
}

static int give_place(const struct settings *s, struct place_setup *one)
{
    const struct clump_shape *const shape = case_clumps_shape(s, one->clump);
    const char *const key = KEY_OF(s, particles.place);

    if (shape != NULL && shape->next != NULL)
        return settings_wrong(s, key, "%s is a mixture; a place is for one",
                              one->clump);
    return give_diameter(s, key, one->clump, NULL, 1, &one->diameter);
}

static int give_diameters(struct settings *s)
{
    struct particles_setup *const p = &s->particles;
    int code = give_diameter(s, KEY_OF(s, particles.has_bed), p->bed_clump,
                             p->bed_sizes, 1, &p->bed.diameter);

    for (int i = 0; i < p->place.n && code == 0; i++)
        code = give_place(s, &p->place.item[i]);
    for (int i = 0; i < p->insert.n && code == 0; i++) {
        struct insert_setup *const in = &p->insert.item[i];
        if (in->clump != NULL && in->file != NULL)
            return settings_wrong(s, "particles.insert",
                                  "source %d: the rows of a file are spheres; "
                                  "leave clump or file out",
                                  i);
        code = give_diameter(s, "particles.insert", in->clump, in->sizes, 0,
                             &in->of.diameter);
        in->of.clump = case_clumps_shape(s, in->clump);
    }
    return code;
}

/* Shapes of one name are a mixture. 0, or 2 after a message. */
static int join_mixture(const struct settings *s, int i)
{
    const struct clump_setup *const item = s->particles.clumps.item;
    struct clump_shape *const shape = s->particles.shapes;

    shape[i].share = item[i].share;
    for (int j = s->particles.clumps.n - 1; j > i; j--) {
        if (strcmp(shape[i].name, shape[j].name) != 0) continue;
        shape[i].next = &shape[j];
        if (item[i].share == 0.0 || item[j].share == 0.0)
            return settings_wrong(s, list,
                                  "two are called %s; expected other names, or "
                                  "a share of each in a mixture",
                                  shape[i].name);
    }
    return 0;
}

int case_clumps_make(struct settings *s)
{
    struct particles_setup *const p = &s->particles;
    int code = 0, total = 0;

    for (int i = 0; i < p->place.n; i++) {
        const struct place_setup *const one = &p->place.item[i];
        if (one->clump == NULL && one->diameter == 0.0)
            return settings_wrong(s, KEY_OF(s, particles.place),
                                  "sphere %d needs a diameter", i);
        if (one->clump == NULL && vector_length(one->rotation) > 0.0)
            return settings_wrong(s, KEY_OF(s, particles.place),
                                  "sphere %d: rotation is for a clump", i);
    }
    if (p->clumps.n == 0)
        return s->has.particles && settings_has(s, list)
                   ? settings_wrong(s, list, "expected one clump or more")
                   : 0;
    p->shapes = alloc_zeroed((size_t)p->clumps.n, sizeof *p->shapes);
    for (int i = 0; i < p->clumps.n; i++)
        p->shapes[i].name = p->clumps.item[i].name;
    for (int i = 0; i < p->clumps.n && code == 0; i++)
        code = make_one(s, &p->clumps.item[i], &p->shapes[i], &total);
    for (int i = 0; i < p->clumps.n && code == 0; i++)
        code = join_mixture(s, i);
    return code != 0 ? code : give_diameters(s);
}

double case_clumps_balls(const struct settings *s, const char *name, double n)
{
    const struct clump_shape *shape = case_clumps_shape(s, name);
    int most = shape == NULL;

    for (; shape != NULL; shape = shape->next)
        most = shape->n > most ? shape->n : most;
    return n * most;
}

int case_clumps_origin(const struct settings *s, int i)
{
    int k = 0;

    for (double left = i;; k++) {
        left -= case_clumps_balls(s, s->particles.place.item[k].clump, 1.0);
        if (left < 0.0) return k;
    }
}

double case_clumps_filled(const struct settings *s)
{
    double least = 1.0;

    for (int i = 0; i < s->particles.clumps.n; i++)
        least = fmin(least, clumps_least_filled(&s->particles.shapes[i]));
    return least;
}

struct particles *case_clumps_particles(const struct settings *s, double n)
{
    struct particles *const ps =
        particles_create(number_clamped(n, 0, INT_MAX));

    if (s->particles.clumps.n > 0)
        clumps_add_to(ps, s->particles.clumps.n, s->particles.shapes);
    return ps;
}

int case_clumps_place(const struct settings *s, struct particles *ps,
                      const struct dem_options *o, const struct place_setup *p,
                      const double x[3], double density, int *at)
{
    const struct clump_shape *const shape = case_clumps_shape(s, p->clump);
    const double most = 0.5 - build_particles_wall_overlap(s);
    double q[4];

    clumps_turn(p->rotation, q);
    *at = clumps_add(ps, (int)(shape - s->particles.shapes),
                     0.5 * p->diameter / shape->reach, density, x, p->velocity,
                     q, p->spin);
    for (int i = *at; i < ps->n; i++) {
        const double ball[3] = {ps->x[i], ps->y[i], ps->z[i]};
        for (int k = 0; k < 3; k++)
            if (!o->periodic[k] && (ball[k] < o->lo[k] + most * ps->d[i] ||
                                    ball[k] > o->hi[k] - most * ps->d[i]))
                return settings_wrong(
                    s, KEY_OF(s, particles.place),
                    "the ball at [%g, %g, %g] m of a clump %s is not inside "
                    "the box",
                    ball[0], ball[1], ball[2], p->clump);
    }
    return 0;
}

/* --- what cannot be ------------------------------------------------------- */

static const char *const of_spheres[] = {
    "effects.virtual_mass",    "effects.basset",
    "effects.saffman",         "effects.fluid_torque",
    "effects.magnus",          "effects.whole_drag",
    "effects.stochastic_drag", "effects.lubrication",
    "effects.particle_stress", NULL};

int case_clumps_refuse(const struct settings *s, const char *key)
{
    int k = 0;

    while (of_spheres[k] != NULL && strcmp(of_spheres[k], key) != 0)
        k++;
    return s->particles.clumps.n > 0 && of_spheres[k] != NULL;
}

/* The key of what clumps cannot be together with, and why; NULL: nothing. */
static const char *clumps_cannot(const struct settings *s, const char **why)
{
    const struct particles_setup *const p = &s->particles;

    *why = "they are moved by velocity-verlet alone";
    if (strcmp(p->integrator->name, "velocity-verlet") != 0)
        return KEY_OF(s, particles.integrator);
    *why = "without contacts they would pass through each other and the walls";
    if (p->list->no_contacts) return KEY_OF(s, particles.list);
    *why = "their balls would be moved apart; expected \"refuse\" or \"allow\"";
    if (strcmp(p->overlaps, "relax") == 0) return KEY_OF(s, particles.overlaps);
    *why = "a ball is no parcel";
    if (p->parcel.grains > 0.0) return KEY_OF(s, particles.parcel.grains);
    *why = "the numbers of their balls would move with them";
    if (p->prescribed.n > 0) return "particles.prescribed";
    *why = "a bed of clumps is not kept in a file";
    if (p->bed_clump != NULL && p->bed_file != NULL)
        return KEY_OF(s, particles.bed_file);
    *why = "the wear by a clump is not known";
    for (int i = 0; i < p->surfaces.n; i++)
        if (p->surfaces.item[i].of.wear.hardness > 0.0)
            return "particles.surfaces";
    *why = "the force of a fluid on clumps is constant in a step; expected "
           "\"frozen\"";
    if (s->has.exchange &&
        s->exchange.slip_integration != SLIP_INTEGRATION_FROZEN)
        return KEY_OF(s, exchange.slip_integration);
    *why = "it divides spheres by the cells, and balls that overlap are none";
    if (s->has.averaging && (strcmp(s->averaging.method->name, "dpvm") == 0 ||
                             strcmp(s->averaging.method->name, "cube") == 0))
        return KEY_OF(s, averaging.method);
    *why = "that force is known for spheres alone";
    for (int k = 0; of_spheres[k] != NULL; k++)
        if (settings_has(s, of_spheres[k])) return of_spheres[k];
    *why = "bodies that the flow is resolved around have bodies.clumps";
    return s->has.bodies ? "bodies" : NULL;
}

int case_clumps_check(const struct settings *s)
{
    const char *why, *key;

    if (s->particles.clumps.n == 0) return 0;
    key = clumps_cannot(s, &why);
    return key == NULL ? 0
                       : settings_wrong(s, key, "particles.clumps: %s", why);
}

/* --- what is said --------------------------------------------------------- */

/* Marks the balls that those from number i on are joined to by contacts. */
static void mark_joined(const struct clump_shape *s, int i, int *mark)
{
    double r[3];

    mark[i] = 1;
    for (int j = 0; j < s->n; j++) {
        vector_between(s->ball[i].at, s->ball[j].at, r);
        if (!mark[j] &&
            vector_length(r) < (s->ball[i].R + s->ball[j].R) * (1.0 + 1e-6))
            mark_joined(s, j, mark);
    }
}

/* The pieces that a clump would fall into [-]. */
static int pieces_of(const struct clump_shape *s)
{
    int *const mark = alloc_ints(s->n), pieces = 0;

    for (int i = 0; i < s->n; i++) {
        pieces += !mark[i];
        if (!mark[i]) mark_joined(s, i, mark);
    }
    free(mark);
    return pieces;
}

/* The diameter of Sauter has 1/psi^2. */
static void print_lone_drag(const struct settings *s, double psi)
{
    const struct drag_shape *const by = s->exchange.shape;
    const int sauter = by->factor == NULL;

    text_line("drag of a lone one",
              sauter ? 1.0 / (psi * psi) : drag_shape_ratio(by, psi, 0.0), "-",
              sauter ? "slow, over that sphere's: too much; see exchange.shape"
                     : "slow, over that of the sphere of its volume");
}

void case_clumps_print(const struct settings *s)
{
    for (int i = 0; i < s->particles.clumps.n; i++) {
        const struct clump_shape *const one = &s->particles.shapes[i];
        const double d = clumps_shape_diameter(one), *const g = one->gyration;
        char about[200];

        if (i == 0) puts("Clumps");
        snprintf(about, sizeof about,
                 "of the sphere of its volume, %.6g m^3, by %d balls",
                 one->volume, one->n);
        text_line(one->name, d, "m", about);
        if (one->share > 0.0)
            text_line("share", one->share, "-",
                      "of the number, over the sum for this name");
        snprintf(about, sizeof about,
                 "over that; moments of inertia over m d^2: %.5f, %.5f, %.5f",
                 g[0] / (d * d), g[1] / (d * d), g[2] / (d * d));
        text_line("sphericity", one->sauter / d, "-",
                  "surface of that sphere over its own; the drag has that d");
        if (s->has.exchange) print_lone_drag(s, one->sauter / d);
        text_line("sphere around it", 2.0 * one->reach / d, "-", about);
        const int pieces = pieces_of(one);
        if (pieces > 1)
            text_line("pieces", pieces, "-",
                      "APART: not all its balls touch, yet they move as one");
    }
}
