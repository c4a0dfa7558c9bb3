/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/boundaries/inlet_builder.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "fluid/inlet_profile.h"
#include "case/build_boundaries.h"
#include "case/case_mesh.h"
#include "case/models.h"

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

static const struct inlet_profile *profile_of(const struct settings *s,
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

/* The first value of a profile that is negative or not finite, over its faces
 * and the run. */
static int check_values(const struct settings *s, const struct boundary *b,
                        const struct inlet_request *r,
                        char wrong[INLET_PROFILE_TEXT])
{
    const int times = b->varying != NULL ? INLET_BUILDER_TIMES : 0;

    for (int i = 0; i <= times; i++)
        for (int j = 0; j < r->patch->n; j++) {
            const double t = times > 0 ? s->output.end * i / times : 0.0;
            const double u = boundary_inlet_profile(b, j, t);
            if (u >= 0.0 && u < HUGE_VAL) continue;
            snprintf(wrong, INLET_PROFILE_TEXT,
                     "it gives %g on face %d of %d at %g s; expected >= 0", u,
                     j, r->patch->n, t);
            return 1;
        }
    return 0;
}

/* Adds the profile to an inlet; non-zero after a message. */
int inlet_builder_add(const struct settings *s, const struct mesh *m,
                      const struct patch *p, struct boundary *b)
{
    const struct inlet_profile *const profile = profile_of(s, p);
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

/* Profiles that ask for no key cannot be wrong. */
int inlet_builder_is_checked(const struct settings *s, const struct patch *p)
{
    return profile_of(s, p)->asks != NULL;
}

/* --- the velocity over the patch ------------------------------------------ */

/* Of one boundary at one time. */
static void add_shares(const struct mesh *m, const struct patch *p,
                       const struct boundary *b, double t, double *mean,
                       double *peak)
{
    double sum = 0.0, surface = 0.0;

    for (int j = 0; j < p->n; j++) {
        const double area = vector_length(&m->S[3 * (p->first + j)]);
        const double share = boundary_inlet_profile(b, j, t);
        sum += share * area;
        surface += area;
        *peak = fmax(*peak, share);
    }
    *mean = fmax(*mean, sum / surface);
}

void inlet_builder_shares(const struct settings *s, const char *patch,
                          double *mean, double *peak)
{
    struct mesh *m = case_mesh_outline(s);
    const int is_uniform =
        profile_of(s, mesh_patch(m, patch)) == inlet_profiles[0];

    *mean = *peak = is_uniform ? 1.0 : 0.0;
    mesh_free(m);
    if (is_uniform) return;
    m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m);
    const struct patch *const p = mesh_patch(m, patch);
    for (int i = 0; i <= INLET_BUILDER_TIMES && all != NULL; i++)
        add_shares(m, p, &all[p - m->patches],
                   s->output.end * i / INLET_BUILDER_TIMES, mean, peak);
    if (all != NULL) build_boundaries_free(all, m->n_patches);
    mesh_free(m);
}
