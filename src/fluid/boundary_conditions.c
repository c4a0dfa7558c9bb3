/* SPDX-License-Identifier: GPL-3.0-or-later */
/* boundary_conditions.c -- the conditions that a case can choose for a side or
 * a patch, each with its keys, what is wrong with them, and what it makes of
 * them. */
#include "fluid/boundary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "fluid/inlet_profile.h"
#include "mesh/measures.h"

#define AT(member) KEY_AT(boundary_options, member)

/* --- inlets --------------------------------------------------------------- */

static const struct key inlet_keys[] = {
    {"fluid.<patch>.inlet", KEY_SERIES, "m/s", ">= 0", KEY_OPTIONAL,
     "superficial velocity into the box, constant or ((time, velocity), ...)",
     "SX15 Table 1", "", AT(inlet)},
    {"fluid.<patch>.profile", KEY_NAME, "", "", "uniform",
     "how the velocity varies over an inlet", "", "", AT(profile),
     .models = inlet_profiles, KEY_GIVEN(boundary_options, has_profile)},
    KEY_END};

/* The first value of a profile that is negative or not finite, over its faces
 * and the run. */
static int boundary_check_values(const struct boundary_request *r,
                                 const struct boundary *b,
                                 char wrong[BOUNDARY_TEXT])
{
    const int times = b->varying != NULL ? BOUNDARY_TIMES : 0;

    for (int i = 0; i <= times; i++)
        for (int j = 0; j < r->patch->n; j++) {
            const double t = times > 0 ? r->end * i / times : 0.0;
            const double u = boundary_inlet_profile(b, j, t);
            if (u >= 0.0 && u < HUGE_VAL) continue;
            snprintf(wrong, BOUNDARY_TEXT,
                     "it gives %g on face %d of %d at %g s; expected >= 0", u,
                     j, r->patch->n, t);
            return 1;
        }
    return 0;
}

static const char *build_inlet(const struct boundary_request *r,
                               struct boundary *b, char wrong[BOUNDARY_TEXT])
{
    const struct key_series *const u = &r->says->inlet;
    const struct inlet_profile *const profile = r->says->profile;

    b->n_points = u->n;
    b->time = b->series = alloc_doubles(2 * u->n);
    b->velocity = b->series + u->n;
    memcpy(b->series, u->at, 2 * (size_t)u->n * sizeof *u->at);
    if (!inlet_profile_is_given(profile, r->says)) {
        snprintf(wrong, BOUNDARY_TEXT, "the profile %s needs %s", profile->name,
                 profile->asks);
        return "";
    }
    return profile->create(r, b, wrong) != 0 ||
                   boundary_check_values(r, b, wrong) != 0
               ? profile->asks != NULL ? profile->asks : "profile"
               : NULL;
}

/* Profiles that ask for no key cannot be wrong. */
static int is_doubtful_inlet(const struct boundary_options *o)
{
    return o->profile->asks != NULL;
}

static const char *inlet_whole(const struct boundary_options *o)
{
    return o->profile != &inlet_profile_uniform ? "profile" : NULL;
}

static const struct boundary_condition inlet_condition = {
    .name = "inlet",
    .what = "a superficial velocity, constant or varying in time",
    .equations = "",
    .function = "boundary_inlet_velocity",
    .keys = {inlet_keys},
    .kind = BOUNDARY_INLET,
    .build = build_inlet,
    .is_doubtful = is_doubtful_inlet,
    .whole = inlet_whole,
};

/* --- walls ---------------------------------------------------------------- */

static const struct boundary_condition no_slip_condition = {
    .name = "no-slip",
    .what = "the fluid stands still at the wall",
    .equations = "",
    .function = "add_wall_face",
    .kind = BOUNDARY_NO_SLIP,
};

static const struct boundary_condition slip_condition = {
    .name = "slip",
    .what = "no flow through, no friction along",
    .equations = "",
    .function = "add_slip_face",
    .kind = BOUNDARY_SLIP,
};

static const struct key wall_keys[] = {
    {"fluid.<patch>.wall", KEY_VECTOR, "m/s", "", KEY_OPTIONAL,
     "velocity of a no-slip wall that moves along itself", "", "", AT(wall)},
    KEY_END};

/* On a side of a box. */
static const char *check_side(const double u[3], const struct patch *p,
                              char wrong[BOUNDARY_TEXT])
{
    int i = 0;

    while (strcmp(mesh_sides[i], p->name) != 0)
        i++;
    if (u[i / 2] == 0.0) return NULL;
    snprintf(wrong, BOUNDARY_TEXT,
             "the wall would move through itself: its %c is %g m/s, expected 0",
             "xyz"[i / 2], u[i / 2]);
    return "wall";
}

/* A wall may move along itself only, every face of it: it holds the fluid back,
 * or there would be a flow through it. */
static const char *boundary_check_wall(const struct boundary_options *o,
                                       const struct mesh *m,
                                       const struct patch *p,
                                       char wrong[BOUNDARY_TEXT])
{
    const double *const u = o->wall;

    if (m->face_centre == NULL) return check_side(u, p, wrong);
    for (int f = p->first; f < p->first + p->n; f++) {
        const double *const S = mesh_S(m, f), *const x = &m->face_centre[3 * f];
        const double out = vector_dot(u, S) / vector_length(S);
        if (fabs(out) <= 1e-6 * vector_length(u)) continue;
        snprintf(wrong, BOUNDARY_TEXT,
                 "the wall would move through itself, at %g m/s at [%g, %g, "
                 "%g] m; expected 0",
                 out, x[0], x[1], x[2]);
        return "wall";
    }
    return NULL;
}

static void wall_moves(const struct boundary_options *o, const double x[3],
                       double u[3])
{
    (void)x;
    memcpy(u, o->wall, sizeof o->wall);
}

static const char *boundary_build_wall(const struct boundary_request *r,
                                       struct boundary *b,
                                       char wrong[BOUNDARY_TEXT])
{
    (void)wrong;
    memcpy(b->wall, r->says->wall, sizeof b->wall);
    return NULL;
}

static const struct boundary_condition moving_wall_condition = {
    .name = "wall",
    .what = "a wall that moves along itself and takes the fluid with it",
    .equations = "",
    .function = "add_wall_face",
    .keys = {wall_keys},
    .kind = BOUNDARY_NO_SLIP,
    .check = boundary_check_wall,
    .moves = wall_moves,
    .build = boundary_build_wall,
};

static const struct key rotation_keys[] = {
    {"fluid.<patch>.rotation", KEY_VECTOR, "rad/s", "", KEY_OPTIONAL,
     "angular velocity of a no-slip wall that rotates within its own surface",
     "", "", AT(rotation)},
    {"fluid.<patch>.centre", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "a point on the axis of the rotation", "", "", AT(centre)},
    KEY_END};

/* From the projection of the cell's centre onto boundary face f, where the
 * viscous force takes the velocity of a wall, to the middle of the face; 0 if
 * they differ by rounding alone. */
static void from_foot(const struct mesh *m, int f, double off[3])
{
    if (m->skewed && mesh_misses_middle(m, f, off)) return;
    off[0] = off[1] = off[2] = 0.0;
}

static void rotating_wall_moves(const struct boundary_options *o,
                                const double x[3], double u[3])
{
    double arm[3];

    vector_between(x, o->centre, arm);
    vector_cross(o->rotation, arm, u);
}

/* The same at the projection of the centre of each face's cell onto
 * the face, with the normal component removed. A wall with a large normal
 * component would move through itself: an error. */
static const char *rotating_wall_build(const struct boundary_request *r,
                                       struct boundary *b,
                                       char wrong[BOUNDARY_TEXT])
{
    const struct mesh *const m = r->mesh;
    const struct patch *const p = r->patch;
    const double *const omega = r->says->rotation;
    const double most = 0.05; /* [-] normal part over the speed of the patch */
    double *const u = alloc_doubles(3 * p->n);
    double fastest = 0.0, through = 0.0;

    for (int j = 0; j < p->n; j++) {
        const double *const S = mesh_S(m, p->first + j);
        double x[3], off[3], less[3];
        mesh_face_middle(m, p->first + j, x);
        rotating_wall_moves(r->says, x, &u[3 * j]);
        fastest = fmax(fastest, vector_length(&u[3 * j]));
        const double out = vector_dot(&u[3 * j], S) / vector_dot(S, S);
        through = fmax(through, fabs(out) * vector_length(S));
        from_foot(m, p->first + j, off);
        vector_cross(omega, off, less);
        vector_along(&u[3 * j], -1.0, less, &u[3 * j]);
        vector_along(&u[3 * j], -vector_dot(&u[3 * j], S) / vector_dot(S, S), S,
                     &u[3 * j]);
    }
    b->walls = b->memory = u;
    memcpy(b->rotation, omega, sizeof b->rotation);
    if (through <= most * fastest) return NULL;
    snprintf(wrong, BOUNDARY_TEXT,
             "the wall would move through itself, at up to %g m/s; a wall "
             "rotates within its own surface",
             through);
    return "rotation";
}

static int rotating_wall_is_doubtful(const struct boundary_options *o)
{
    (void)o;
    return 1;
}

static const char *rotating_wall_whole(const struct boundary_options *o)
{
    (void)o;
    return "rotation";
}

static const struct boundary_condition rotating_wall_condition = {
    .name = "rotating",
    .what = "a wall that rotates about an axis and takes the fluid with it",
    .equations = "",
    .function = "boundary_wall_velocity",
    .keys = {rotation_keys},
    .kind = BOUNDARY_NO_SLIP,
    .build = rotating_wall_build,
    .is_doubtful = rotating_wall_is_doubtful,
    .whole = rotating_wall_whole,
    .moves = rotating_wall_moves,
};

/* --- pressures ------------------------------------------------------------ */

static const struct key outlet_keys[] = {
    {"fluid.<patch>.outlet", KEY_REAL, "Pa", "", KEY_OPTIONAL,
     "pressure outside, without the weight of the fluid", "", "", AT(pressure)},
    KEY_END};

static const char *build_outlet(const struct boundary_request *r,
                                struct boundary *b, char wrong[BOUNDARY_TEXT])
{
    (void)wrong;
    b->pressure = r->says->pressure;
    return NULL;
}

static const struct boundary_condition outlet_condition = {
    .name = "outlet",
    .what = "a pressure outside",
    .equations = "",
    .function = "pressure_correct",
    .keys = {outlet_keys},
    .kind = BOUNDARY_OUTLET,
    .build = build_outlet,
};

static const struct key pressure_keys[] = {
    {"fluid.<patch>.pressure", KEY_REAL, "Pa", "", KEY_OPTIONAL,
     "pressure of an inlet, without the weight of the fluid: what enters has "
     "the velocity of its flux",
     "", "", AT(pressure)},
    KEY_END};

static const char *build_pressure(const struct boundary_request *r,
                                  struct boundary *b, char wrong[BOUNDARY_TEXT])
{
    b->enters = 1;
    return build_outlet(r, b, wrong);
}

static const struct boundary_condition pressure_condition = {
    .name = "pressure",
    .what = "a pressure that the fluid enters with, or leaves against",
    .equations = "",
    .function = "boundary_face_velocity",
    .keys = {pressure_keys},
    .kind = BOUNDARY_OUTLET,
    .build = build_pressure,
};

/* --- all ------------------------------------------------------------------ */

const struct boundary_condition *const boundary_conditions[] = {
    &no_slip_condition,  &slip_condition,
    &inlet_condition,    &moving_wall_condition,
    &outlet_condition,   &rotating_wall_condition,
    &pressure_condition, NULL};
