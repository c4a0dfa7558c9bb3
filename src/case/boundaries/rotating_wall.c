/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rotating_wall.c -- no-slip walls that rotate within their own surface. */
#include "case/boundaries/rotating_wall.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/model.h"
#include "base/vector.h"
#include "case/build_boundaries.h"
#include "mesh/geometry/face_corners.h"

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
int rotating_wall_add(const struct settings *s, const struct mesh *m,
                      const struct patch *p, struct boundary *b)
{
    const double most = 0.05; /* [-] normal part over the speed of the patch */
    double *const u = alloc_doubles(3 * p->n);
    double omega[3], centre[3], fastest = 0.0, through = 0.0;
    char path[BUILD_BOUNDARIES_PATH];

    build_boundaries_has(s, p, "centre", path);
    settings_vector(s, path, centre);
    build_boundaries_has(s, p, "rotation", path);
    settings_vector(s, path, omega);
    for (int j = 0; j < p->n; j++) {
        const double *const S = &m->S[3 * (p->first + j)];
        double x[3], arm[3], off[3], less[3];
        face_corners_middle(m, p->first + j, x);
        vector_between(x, centre, arm);
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
    *b = (struct boundary){.kind = BOUNDARY_NO_SLIP, .walls = u, .memory = u};
    memcpy(b->rotation, omega, sizeof omega);
    if (through <= most * fastest) return 0;
    return settings_wrong(s, path,
                          "the wall would move through itself, at up to %g "
                          "m/s; a wall rotates within its own surface",
                          through);
}

static const struct key rotation_keys[] = {
    {"fluid.<patch>.rotation", KEY_VECTOR, "rad/s", "", KEY_OPTIONAL,
     "angular velocity of a no-slip wall that rotates within its own surface",
     "", ""},
    {"fluid.<patch>.centre", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "a point on the axis of the rotation", "", ""},
    KEY_END};

const struct model rotating_wall_kind = {
    .name = "rotating",
    .what = "a wall that rotates about an axis and takes the fluid with it",
    .equations = "",
    .function = "boundary_wall_velocity",
    .keys = {rotation_keys},
    .value = BOUNDARY_NO_SLIP,
};
