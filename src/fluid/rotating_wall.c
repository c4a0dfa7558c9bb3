/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rotating_wall.c -- no-slip walls that rotate within their own surface. */
#include "fluid/boundary_condition.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "mesh/measures.h"

/* From the projection of the cell's centre onto boundary face f, where the
 * viscous force takes the velocity of a wall, to the middle of the face; 0 if
 * they differ by rounding alone. */
static void from_foot(const struct mesh *m, int f, double off[3])
{
    if (m->skewed && mesh_misses_middle(m, f, off)) return;
    off[0] = off[1] = off[2] = 0.0;
}

/* omega x (x - centre) at the projection of the centre of each face's cell onto
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
        const double *const S = &m->S[3 * (p->first + j)];
        double x[3], arm[3], off[3], less[3];
        mesh_face_middle(m, p->first + j, x);
        vector_between(x, r->says->centre, arm);
        vector_cross(omega, arm, &u[3 * j]);
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

static const struct key rotation_keys[] = {
    {"fluid.<patch>.rotation", KEY_VECTOR, "rad/s", "", KEY_OPTIONAL,
     "angular velocity of a no-slip wall that rotates within its own surface",
     "", "", .at = KEY_AT(boundary_options, rotation)},
    {"fluid.<patch>.centre", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "a point on the axis of the rotation", "", "",
     .at = KEY_AT(boundary_options, centre)},
    KEY_END};

const struct boundary_condition rotating_wall_condition = {
    .name = "rotating",
    .what = "a wall that rotates about an axis and takes the fluid with it",
    .equations = "",
    .function = "boundary_wall_velocity",
    .keys = {rotation_keys},
    .kind = BOUNDARY_NO_SLIP,
    .build = rotating_wall_build,
    .is_doubtful = rotating_wall_is_doubtful,
};
