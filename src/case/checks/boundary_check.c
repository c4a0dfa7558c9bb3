/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/boundary_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/vector.h"
#include "case/build_boundaries.h"
#include "case/case_mesh.h"

/* The parabola of a box needs no arrays to be known as right. */
static int needs_arrays(const struct settings *s, const struct mesh *m)
{
    char path[BUILD_BOUNDARIES_PATH];
    int needs = 0;

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        needs |= build_boundaries_has(s, p, "inlet", path) &&
                 build_boundaries_profile(s, p)->asks != NULL;
        needs |= build_boundaries_has(s, p, "rotation", path);
    }
    return needs;
}

int boundary_check(const struct settings *s)
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

void boundary_check_shares(const struct settings *s, const char *patch,
                           double *mean, double *peak)
{
    double *series;
    struct mesh *m = case_mesh_outline(s);
    const int is_uniform =
        build_boundaries_profile(s, mesh_patch(m, patch)) == inlet_profiles[0];

    *mean = *peak = is_uniform ? 1.0 : 0.0;
    mesh_free(m);
    if (is_uniform) return;
    m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m, &series);
    const struct patch *const p = mesh_patch(m, patch);
    for (int i = 0; i <= BUILD_BOUNDARIES_TIMES && all != NULL; i++)
        add_shares(m, p, &all[p - m->patches],
                   settings_real(s, "output.end") * i / BUILD_BOUNDARIES_TIMES,
                   mean, peak);
    if (all != NULL) build_boundaries_free(all, m->n_patches, series);
    mesh_free(m);
}
