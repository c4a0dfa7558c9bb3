/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build_boundaries.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "fluid/inlet_profile.h"
#include "mesh/face_corners.h"
#include "case/case_mesh.h"
#include "case/models.h"

/* A symmetry of the mesh may be left out. */
int build_boundaries_has(const struct settings *s, const struct patch *p,
                         const char *key, char path[BUILD_BOUNDARIES_PATH])
{
    const char *const side = settings_side(s, p->name);

    if (side == NULL) return 0;
    snprintf(path, BUILD_BOUNDARIES_PATH, "%s.%s", side, key);
    return settings_has(s, path);
}

/* --- inlets --------------------------------------------------------------- */

/* 1 if both ends of direction k are walls that hold the fluid. */
static int between_walls(const struct settings *s, int k)
{
    for (int i = 0; i < 2; i++) {
        const char *const side = settings_side(s, mesh_sides[2 * k + i]);
        char wall[BUILD_BOUNDARIES_PATH], rotation[BUILD_BOUNDARIES_PATH];
        if (side == NULL) return 0; /* periodic */
        snprintf(wall, sizeof wall, "%s.wall", side);
        snprintf(rotation, sizeof rotation, "%s.rotation", side);
        const char *const word = settings_text(s, side);
        if (!settings_has(s, wall) && !settings_has(s, rotation) &&
            (word == NULL ||
             models_value(boundary_kinds, word) != BOUNDARY_NO_SLIP))
            return 0;
    }
    return 1;
}

const struct inlet_profile *build_boundaries_profile(const struct settings *s,
                                                     const struct patch *p)
{
    char path[BUILD_BOUNDARIES_PATH];

    return build_boundaries_has(s, p, "profile", path)
               ? inlet_profile_named(settings_text(s, path))
               : inlet_profiles[0];
}

/* What the case says about a profile, for its creator. */
static void describe(const struct settings *s, struct inlet_request *r,
                     char file[SETTINGS_PATH], double **table)
{
    char path[BUILD_BOUNDARIES_PATH];

    *table = NULL;
    for (int k = 0; k < 3; k++)
        r->between_walls[k] = settings_mesh(s) == NULL && between_walls(s, k);
    if (build_boundaries_has(s, r->patch, "formula", path))
        r->formula = settings_text(s, path);
    if (build_boundaries_has(s, r->patch, "file", path)) {
        settings_beside(s, settings_text(s, path), file, SETTINGS_PATH);
        r->file = file;
    }
    if (!build_boundaries_has(s, r->patch, "table", path)) return;
    const int n = r->n_points = settings_points(s, path);
    *table = alloc_doubles(2 * n);
    for (int i = 0; i < n; i++)
        settings_point(s, path, i, &(*table)[i], &(*table)[n + i]);
    r->s = *table;
    r->u = *table + n;
    snprintf(path, sizeof path, "%s.along", settings_side(s, r->patch->name));
    settings_vector(s, path, r->along);
}

/* The first value of a profile that is none, over its faces and the run. */
static int check_values(const struct settings *s, const struct boundary *b,
                        const struct inlet_request *r,
                        char wrong[INLET_PROFILE_TEXT])
{
    const int times = b->varying != NULL ? BUILD_BOUNDARIES_TIMES : 0;

    for (int i = 0; i <= times; i++)
        for (int j = 0; j < r->patch->n; j++) {
            const double t =
                times > 0 ? settings_real(s, "output.end") * i / times : 0.0;
            const double u = boundary_inlet_share(b, j, t);
            if (u >= 0.0 && u < HUGE_VAL) continue;
            snprintf(wrong, INLET_PROFILE_TEXT,
                     "it gives %g on face %d of %d at %g s; expected >= 0", u,
                     j, r->patch->n, t);
            return 1;
        }
    return 0;
}

/* Adds the profile to an inlet; non-zero after a message. */
static int add_profile(const struct settings *s, const struct mesh *m,
                       const struct patch *p, struct boundary *b)
{
    const struct inlet_profile *const profile = build_boundaries_profile(s, p);
    struct inlet_request r = {.mesh = m, .patch = p};
    char file[SETTINGS_PATH], path[BUILD_BOUNDARIES_PATH],
        wrong[INLET_PROFILE_TEXT];
    double *table;

    build_boundaries_has(s, p, "profile", path);
    if (profile->asks != NULL &&
        !build_boundaries_has(s, p, profile->asks, path))
        return settings_wrong(s, settings_side(s, p->name),
                              "the profile %s needs %s", profile->name,
                              profile->asks);
    describe(s, &r, file, &table);
    const int failed = profile->create(&r, b, wrong) != 0 ||
                       check_values(s, b, &r, wrong) != 0;
    free(table);
    return failed ? settings_wrong(s, path, "%s", wrong) : 0;
}

/* Its numbers are put where *next points to. */
static int add_inlet(const struct settings *s, const struct mesh *m,
                     const struct patch *p, struct boundary *b, double **next)
{
    char path[BUILD_BOUNDARIES_PATH];

    build_boundaries_has(s, p, "inlet", path);
    const int n = settings_points(s, path);
    double *const time = *next, *const velocity = time + n;
    for (int i = 0; i < n; i++)
        settings_point(s, path, i, &time[i], &velocity[i]);
    *next += 2 * n;
    *b = (struct boundary){.kind = BOUNDARY_INLET,
                           .n_points = n,
                           .time = time,
                           .velocity = velocity};
    return add_profile(s, m, p, b);
}

/* A time and a velocity for each point of each inlet. */
static int count_numbers(const struct settings *s, const struct mesh *m)
{
    char path[BUILD_BOUNDARIES_PATH];
    int n = 0;

    for (int i = 0; i < m->n_patches; i++)
        if (build_boundaries_has(s, &m->patches[i], "inlet", path))
            n += 2 * settings_points(s, path);
    return n;
}

/* --- walls that rotate ------------------------------------------------------
 */

/* From the point of boundary face f where its viscous force takes the velocity
 * of a wall, below the centre of the cell, back to the middle of the face; 0
 * where there is nothing between them but rounding. */
static void from_foot(const struct mesh *m, int f, double off[3])
{
    if (m->skewed && mesh_misses_middle(m, f, off)) return;
    off[0] = off[1] = off[2] = 0.0;
}

/* omega x (x - centre) at the foot of the centre of each face's cell, without
 * what rounding or the flat faces of a round wall leave of a normal part; that
 * of a wall which would move through itself is an error. */
static int add_rotation(const struct settings *s, const struct mesh *m,
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

/* --- all of them ------------------------------------------------------------
 */

static int one_boundary(const struct settings *s, const struct mesh *m,
                        const struct patch *p, struct boundary *b,
                        double **next)
{
    char path[BUILD_BOUNDARIES_PATH];

    *b = (struct boundary){.kind = BOUNDARY_SLIP};
    if (settings_side(s, p->name) == NULL) return 0;
    if (build_boundaries_has(s, p, "inlet", path))
        return add_inlet(s, m, p, b, next);
    if (build_boundaries_has(s, p, "rotation", path))
        return add_rotation(s, m, p, b);
    if (build_boundaries_has(s, p, "outlet", path) ||
        build_boundaries_has(s, p, "pressure", path)) {
        b->kind = BOUNDARY_OUTLET;
        b->pressure = settings_real(s, path);
        b->enters = build_boundaries_has(s, p, "pressure", path);
    } else if (build_boundaries_has(s, p, "wall", path)) {
        b->kind = BOUNDARY_NO_SLIP;
        settings_vector(s, path, b->wall);
    } else
        b->kind = (enum boundary_kind)models_value(
            boundary_kinds, settings_text(s, settings_side(s, p->name)));
    return 0;
}

struct boundary *build_boundaries(const struct settings *s,
                                  const struct mesh *m, double **series)
{
    struct boundary *const all =
        alloc_zeroed((size_t)m->n_patches, sizeof *all);
    double *next = *series = alloc_doubles(count_numbers(s, m));
    int failed = 0;

    for (int i = 0; i < m->n_patches && !failed; i++)
        failed = one_boundary(s, m, &m->patches[i], &all[i], &next);
    if (!failed) return all;
    build_boundaries_free(all, m->n_patches, *series);
    return NULL;
}

void build_boundaries_free(struct boundary *all, int n, double *series)
{
    for (int i = 0; i < n && all != NULL; i++)
        boundary_release(&all[i]);
    free(all);
    free(series);
}
