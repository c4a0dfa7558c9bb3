/* SPDX-License-Identifier: GPL-3.0-or-later */
/* clumps.c -- what is written of clumps (dem/clumps.h).
 *
 * bodies.pvd: one point a clump, to place glyphs at. In particles.pvd, where
 * their balls are, the array body: the number of its clump, or -1. */
#include "record/recorder_part.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "dem/clumps.h"
#include "output/series.h"

struct clump_record {
    const struct particles *ps;
    struct series *pictures;
    double *x[3], *d, *number, *shape, *v, *w, *q, *L; /* of each clump */
};

static void take_body(void *memory, const struct simulation *sim, double *to)
{
    const struct particles *const ps = sim->particles;

    (void)memory;
    for (int i = 0; i < ps->n; i++) {
        const int of = ps->clumps->of[ps->id[i]];
        to[i] = of < 0 ? -1.0 : ps->clumps->item[of].first;
    }
}

static void clump_record_release(void *record)
{
    struct clump_record *const r = record;

    series_free(r->pictures);
    free(r->x[0]);
    free(r);
}

static void *clump_record_create(const struct recorder_view *v, int *failed)
{
    static const struct snapshot_field body = {"body", "-", 1, take_body};

    if (v->sim->particles == NULL || v->sim->particles->clumps == NULL)
        return NULL;
    struct clump_record *const r = alloc_zeroed(1, sizeof *r);
    const int n = v->sim->particles->clumps->capacity;

    r->ps = v->sim->particles;
    r->pictures = recorder_series(v, "bodies");
    r->x[0] = alloc_doubles(19 * n);
    r->x[1] = r->x[0] + n, r->x[2] = r->x[1] + n, r->d = r->x[2] + n;
    r->number = r->d + n, r->shape = r->number + n, r->v = r->shape + n;
    r->w = r->v + 3 * n, r->q = r->w + 3 * n, r->L = r->q + 4 * n;
    snapshot_add(v->snapshot, &body, NULL);
    *failed = r->pictures == NULL;
    return r;
}

static void clump_record_take(struct clump_record *r)
{
    const struct clumps *const l = r->ps->clumps;

    for (int c = 0; c < l->n; c++) {
        const struct clump *const one = &l->item[c];
        const struct clump_shape *const s = &l->shape[one->shape];
        r->number[c] = one->first;
        r->shape[c] = one->shape;
        r->d[c] = one->scale * clumps_shape_diameter(s);
        rotation_spin(one->q, one->L, one->per_I, &r->w[3 * c]);
        for (int k = 0; k < 4; k++)
            r->q[4 * c + k] = one->q[k];
        for (int k = 0; k < 3; k++) {
            r->x[k][c] = one->x[k];
            r->v[3 * c + k] = one->v[k];
            r->L[3 * c + k] = one->L[k];
        }
    }
}

static int clump_record_add(void *record, double t)
{
    struct clump_record *const r = record;
    const double *const x[3] = {r->x[0], r->x[1], r->x[2]};
    const struct vtk_array arrays[] = {
        vtk_single("diameter", 1, r->d),
        vtk_single("velocity", 3, r->v),
        vtk_single("angular_velocity", 3, r->w),
        {.name = "quaternion", .components = 4, .values = r->q},
        {.name = "angular_momentum", .components = 3, .values = r->L},
        vtk_single("body", 1, r->number),
        vtk_single("shape", 1, r->shape)};

    clump_record_take(r);
    return series_add_particles(r->pictures, r->ps->clumps->n, x, t, 7, arrays);
}

static void clump_record_state(void *record, struct state *s)
{
    struct clump_record *const r = record;

    state_begin(s, "clump_record");
    series_state(r->pictures, s);
    state_end(s);
}

const struct recorder_part recorder_clumps = {.create = clump_record_create,
                                              .free = clump_record_release,
                                              .fields = clump_record_add,
                                              .state = clump_record_state};
