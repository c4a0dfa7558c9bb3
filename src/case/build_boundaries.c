/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build_boundaries.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/case_mesh.h"
#include "case/schema.h"
#include "fluid/inlet_profile.h"

/* 1 if both ends of direction k are walls that hold the fluid. */
static int between_walls(const struct settings *s, int k)
{
    for (int i = 0; i < 2; i++) {
        const struct boundary_options *const o =
            settings_side(s, mesh_sides[2 * k + i]);
        if (o == NULL || o->condition->kind != BOUNDARY_NO_SLIP) return 0;
    }
    return 1;
}

/* A message about a key of a side; 0 if there is none. */
static int build_boundaries_wrong(const struct settings *s,
                                  const struct boundary_options *o,
                                  const char *key, const char *why)
{
    char path[SCHEMA_TEXT];

    if (key == NULL) return 0;
    snprintf(path, sizeof path, "%s%s%s", o->key, key[0] != '\0' ? "." : "",
             key);
    return settings_wrong(s, path, "%s", why);
}

/* A case may leave out a symmetry plane of the mesh. */
static int one_boundary(const struct settings *s, const struct mesh *m,
                        const struct patch *p, struct boundary *b)
{
    struct boundary_request r = {.says = settings_side(s, p->name),
                                 .mesh = m,
                                 .patch = p,
                                 .end = s->output.end};
    char file[SETTINGS_PATH], wrong[BOUNDARY_TEXT];

    b->kind = r.says != NULL ? r.says->condition->kind : BOUNDARY_SLIP;
    if (r.says == NULL || r.says->condition->build == NULL) return 0;
    for (int k = 0; k < 3; k++)
        r.between_walls[k] = settings_mesh(s) == NULL && between_walls(s, k);
    if (r.says->file != NULL) {
        settings_beside(s, r.says->file, file, sizeof file);
        r.file = file;
    }
    return build_boundaries_wrong(
        s, r.says, r.says->condition->build(&r, b, wrong), wrong);
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

/* --- before there is a fluid ---------------------------------------------- */

static int check_condition(const struct settings *s, const struct mesh *m,
                           const struct patch *p, int *doubtful)
{
    const struct boundary_options *const o = settings_side(s, p->name);
    const struct boundary_condition *const c = o != NULL ? o->condition : NULL;
    char wrong[BOUNDARY_TEXT];

    if (o == NULL) return 0;
    if (c->is_doubtful != NULL) *doubtful |= c->is_doubtful(o);
    return c->check == NULL
               ? 0
               : build_boundaries_wrong(s, o, c->check(o, m, p, wrong), wrong);
}

int build_boundaries_check(const struct settings *s)
{
    struct mesh *m = case_mesh_outline(s);
    int code = 0, doubtful = 0;

    for (int i = 0; i < m->n_patches && code == 0; i++)
        code = check_condition(s, m, &m->patches[i], &doubtful);
    mesh_free(m);
    if (code != 0 || !doubtful) return code;
    m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m);
    code = all == NULL ? 2 : 0;
    build_boundaries_free(all, m->n_patches);
    mesh_free(m);
    return code;
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

void build_boundaries_shares(const struct settings *s, const char *patch,
                             double *mean, double *peak)
{
    const int is_uniform =
        settings_side(s, patch)->profile == &inlet_profile_uniform;
    const double end = s->output.end;

    *mean = *peak = is_uniform ? 1.0 : 0.0;
    if (is_uniform) return;
    struct mesh *const m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m);
    const struct patch *const p = mesh_patch(m, patch);
    for (int i = 0; i <= BOUNDARY_TIMES && all != NULL; i++)
        add_shares(m, p, &all[p - m->patches], end * i / BOUNDARY_TIMES, mean,
                   peak);
    build_boundaries_free(all, m->n_patches);
    mesh_free(m);
}
