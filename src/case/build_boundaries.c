/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build_boundaries.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "case/boundaries/inlet_builder.h"
#include "case/boundaries/rotating_wall.h"
#include "case/models.h"

/* A case may leave out a symmetry plane of the mesh. */
int build_boundaries_has(const struct settings *s, const struct patch *p,
                         const char *key, char path[BUILD_BOUNDARIES_PATH])
{
    const char *const side = settings_side(s, p->name);

    if (side == NULL) return 0;
    snprintf(path, BUILD_BOUNDARIES_PATH, "%s.%s", side, key);
    return settings_has(s, path);
}

static struct boundary inlet(const struct settings *s, const char *path)
{
    const int n = settings_points(s, path);
    double *const time = alloc_doubles(2 * n), *const velocity = time + n;

    for (int i = 0; i < n; i++)
        settings_point(s, path, i, &time[i], &velocity[i]);
    return (struct boundary){.kind = BOUNDARY_INLET,
                             .n_points = n,
                             .time = time,
                             .velocity = velocity,
                             .series = time};
}

/* The boundary without the changes of folders. */
static void plain_boundary(const struct settings *s, const struct patch *p,
                           struct boundary *b)
{
    char path[BUILD_BOUNDARIES_PATH];

    if (build_boundaries_has(s, p, "inlet", path))
        *b = inlet(s, path);
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
                        const struct patch *p, struct boundary *b)
{
    char path[BUILD_BOUNDARIES_PATH];
    int code = 0;

    *b = (struct boundary){.kind = BOUNDARY_SLIP};
    if (settings_side(s, p->name) == NULL) return 0;
    plain_boundary(s, p, b);
    if (build_boundaries_has(s, p, "profile", path))
        code = inlet_builder_add(s, m, p, b);
    if (code == 0 && build_boundaries_has(s, p, "rotation", path))
        code = rotating_wall_add(s, m, p, b);
    return code;
}

struct boundary *build_boundaries(const struct settings *s,
                                  const struct mesh *m)
{
    struct boundary *const all =
        alloc_zeroed((size_t)m->n_patches, sizeof *all);
    int failed = 0;

    for (int i = 0; i < m->n_patches && !failed; i++)
        failed = one_boundary(s, m, &m->patches[i], &all[i]);
    if (!failed) return all;
    build_boundaries_free(all, m->n_patches);
    return NULL;
}

void build_boundaries_free(struct boundary *all, int n)
{
    for (int i = 0; i < n && all != NULL; i++)
        boundary_release(&all[i]);
    free(all);
}
