/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build_boundaries.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
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

/* Its numbers are put where *next points to. */
static void add_inlet(const struct settings *s, const struct patch *p,
                      struct boundary *b, double **next)
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

/* The boundary but for what a folder adds. */
static void plain_boundary(const struct settings *s, const struct patch *p,
                           struct boundary *b, double **next)
{
    char path[BUILD_BOUNDARIES_PATH];

    if (build_boundaries_has(s, p, "inlet", path))
        add_inlet(s, p, b, next);
    else if (build_boundaries_has(s, p, "outlet", path) ||
             build_boundaries_has(s, p, "pressure", path)) {
        b->kind = BOUNDARY_OUTLET;
        b->pressure = settings_real(s, path);
        b->enters = build_boundaries_has(s, p, "pressure", path);
    } else if (build_boundaries_has(s, p, "wall", path)) {
        b->kind = BOUNDARY_NO_SLIP;
        settings_vector(s, path, b->wall);
    } else if (settings_text(s, settings_side(s, p->name)) != NULL)
        b->kind = (enum boundary_kind)models_value(
            boundary_kinds, settings_text(s, settings_side(s, p->name)));
}

static int one_boundary(const struct settings *s, const struct mesh *m,
                        const struct patch *p, struct boundary *b,
                        double **next)
{
    char path[BUILD_BOUNDARIES_PATH];
    int code = 0;

    *b = (struct boundary){.kind = BOUNDARY_SLIP};
    if (settings_side(s, p->name) == NULL) return 0;
    plain_boundary(s, p, b, next);
    for (int i = 0; boundary_builders[i] != NULL && code == 0; i++)
        if (build_boundaries_has(s, p, boundary_builders[i]->key, path))
            code = boundary_builders[i]->build(s, m, p, b);
    return code;
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
