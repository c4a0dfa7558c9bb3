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

enum { PATH = 128 };

/* 1 if the case gives a key of one side, whose path this makes. A symmetry of
 * the mesh may be left out. */
static int has(const struct settings *s, const struct patch *p, const char *key,
               char path[PATH])
{
    const char *const side = settings_side(s, p->name);

    if (side == NULL) return 0;
    snprintf(path, PATH, "%s.%s", side, key);
    return settings_has(s, path);
}

/* --- inlets --------------------------------------------------------------- */

/* 1 if both ends of direction k are walls that hold the fluid. */
static int between_walls(const struct settings *s, int k)
{
    for (int i = 0; i < 2; i++) {
        const char *const side = settings_side(s, mesh_sides[2 * k + i]);
        char wall[PATH], rotation[PATH];
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

static const struct inlet_profile *profile_of(const struct settings *s,
                                              const struct patch *p)
{
    char path[PATH];

    return has(s, p, "profile", path)
               ? inlet_profile_named(settings_text(s, path))
               : inlet_profiles[0];
}

/* What the case says about a profile, for its creator. */
static void describe(const struct settings *s, struct inlet_request *r,
                     char file[SETTINGS_PATH], double **table)
{
    char path[PATH];

    *table = NULL;
    for (int k = 0; k < 3; k++)
        r->between_walls[k] = settings_mesh(s) == NULL && between_walls(s, k);
    if (has(s, r->patch, "formula", path)) r->formula = settings_text(s, path);
    if (has(s, r->patch, "file", path)) {
        settings_beside(s, settings_text(s, path), file, SETTINGS_PATH);
        r->file = file;
    }
    if (!has(s, r->patch, "table", path)) return;
    const int n = r->n_points = settings_points(s, path);
    *table = alloc_doubles(2 * n);
    for (int i = 0; i < n; i++)
        settings_point(s, path, i, &(*table)[i], &(*table)[n + i]);
    r->s = *table;
    r->u = *table + n;
    snprintf(path, sizeof path, "%s.along", settings_side(s, r->patch->name));
    settings_vector(s, path, r->along);
}

/* Times of a run at which a profile that varies is looked at, beside 0. */
enum { TIMES = 64 };

/* The first value of a profile that is none, over its faces and the run. */
static int check_values(const struct settings *s, const struct boundary *b,
                        const struct inlet_request *r,
                        char wrong[INLET_PROFILE_TEXT])
{
    const int times = b->varying != NULL ? TIMES : 0;

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
    const struct inlet_profile *const profile = profile_of(s, p);
    struct inlet_request r = {.mesh = m, .patch = p};
    char file[SETTINGS_PATH], path[PATH], wrong[INLET_PROFILE_TEXT];
    double *table;

    has(s, p, "profile", path);
    if (profile->asks != NULL && !has(s, p, profile->asks, path))
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
    char path[PATH];

    has(s, p, "inlet", path);
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
    char path[PATH];
    int n = 0;

    for (int i = 0; i < m->n_patches; i++)
        if (has(s, &m->patches[i], "inlet", path))
            n += 2 * settings_points(s, path);
    return n;
}

/* --- walls that rotate ------------------------------------------------------
 */

/* omega x (x - centre) at the middle of each face, without what rounding or the
 * flat faces of a round wall leave of a normal part; that of a wall which would
 * move through itself is an error. */
static int add_rotation(const struct settings *s, const struct mesh *m,
                        const struct patch *p, struct boundary *b)
{
    const double most = 0.05; /* [-] normal part over the speed of the patch */
    double *const u = alloc_doubles(3 * p->n);
    double omega[3], centre[3], fastest = 0.0, through = 0.0;
    char path[PATH];

    has(s, p, "centre", path);
    settings_vector(s, path, centre);
    has(s, p, "rotation", path);
    settings_vector(s, path, omega);
    for (int j = 0; j < p->n; j++) {
        const double *const S = &m->S[3 * (p->first + j)];
        double x[3], arm[3];
        face_corners_middle(m, p->first + j, x);
        vector_between(x, centre, arm);
        vector_cross(omega, arm, &u[3 * j]);
        fastest = fmax(fastest, vector_length(&u[3 * j]));
        const double out = vector_dot(&u[3 * j], S) / vector_dot(S, S);
        through = fmax(through, fabs(out) * vector_length(S));
        vector_along(&u[3 * j], -out, S, &u[3 * j]);
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
    char path[PATH];

    *b = (struct boundary){.kind = BOUNDARY_SLIP};
    if (settings_side(s, p->name) == NULL) return 0;
    if (has(s, p, "inlet", path)) return add_inlet(s, m, p, b, next);
    if (has(s, p, "rotation", path)) return add_rotation(s, m, p, b);
    if (has(s, p, "outlet", path) || has(s, p, "pressure", path)) {
        b->kind = BOUNDARY_OUTLET;
        b->pressure = settings_real(s, path);
        b->enters = has(s, p, "pressure", path);
    } else if (has(s, p, "wall", path)) {
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

/* The parabola of a box needs no arrays to be known as right. */
static int needs_arrays(const struct settings *s, const struct mesh *m)
{
    char path[PATH];
    int needs = 0;

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        needs |= has(s, p, "inlet", path) && profile_of(s, p)->asks != NULL;
        needs |= has(s, p, "rotation", path);
    }
    return needs;
}

int build_boundaries_check(const struct settings *s)
{
    struct mesh *m = case_mesh_outline(s);
    const int needs = needs_arrays(s, m);
    double *series;
    int failed = 0;

    mesh_free(m);
    if (!needs) return 0;
    m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m, &series);
    failed = all == NULL;
    if (!failed) build_boundaries_free(all, m->n_patches, series);
    mesh_free(m);
    return failed ? 2 : 0;
}

/* Of one boundary at one time. */
static void add_shares(const struct mesh *m, const struct patch *p,
                       const struct boundary *b, double t, double *mean,
                       double *peak)
{
    double sum = 0.0, surface = 0.0;

    for (int j = 0; j < p->n; j++) {
        const double area = vector_length(&m->S[3 * (p->first + j)]);
        const double share = boundary_inlet_share(b, j, t);
        sum += share * area;
        surface += area;
        *peak = fmax(*peak, share);
    }
    *mean = fmax(*mean, sum / surface);
}

void build_boundaries_shares(const struct settings *s, const char *patch,
                             double *mean, double *peak)
{
    double *series;
    struct mesh *m = case_mesh_outline(s);
    const int is_uniform =
        profile_of(s, mesh_patch(m, patch)) == inlet_profiles[0];

    *mean = *peak = is_uniform ? 1.0 : 0.0;
    mesh_free(m);
    if (is_uniform) return;
    m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m, &series);
    const struct patch *const p = mesh_patch(m, patch);
    for (int i = 0; i <= TIMES && all != NULL; i++)
        add_shares(m, p, &all[p - m->patches],
                   settings_real(s, "output.end") * i / TIMES, mean, peak);
    if (all != NULL) build_boundaries_free(all, m->n_patches, series);
    mesh_free(m);
}
