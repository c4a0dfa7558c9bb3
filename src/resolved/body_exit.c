/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

static int is_outlet(const struct fluid *fl, const char *side)
{
    const struct mesh *const m = fl->mesh;

    for (int p = 0; p < m->n_patches; p++)
        if (strcmp(m->patches[p].name, side) == 0)
            return fl->options.boundaries[p].kind == BOUNDARY_OUTLET;
    return 0;
}

/* The largest extent of a body [m]. */
static double body_exit_widest(const struct solid_bodies *b)
{
    double most = 0.0;

    for (int i = 0; i < b->ps->n; i++) {
        double extent[3];
        body_shape_extent(&b->shape[i], extent);
        for (int k = 0; k < 3 && b->motion[i] != BODY_FIXED; k++)
            most = fmax(most, 2.0 * extent[k]);
    }
    return most;
}

/* Beyond an outlet there is room for one that is just outside and, four times
 * as far, for those that have left. */
struct body_exit *body_exit_create(struct solid_bodies *b,
                                   const struct fluid *fl)
{
    struct body_exit *const e = owner_create(sizeof *e);
    int any = 0;

    memcpy(e->lo, b->contacts.lo, sizeof e->lo);
    memcpy(e->hi, b->contacts.hi, sizeof e->hi);
    e->way = 4.0 * body_exit_widest(b);
    for (int w = 0; w < 6 && b->moves; w++) {
        e->open[w] = is_outlet(fl, mesh_sides[w]);
        any |= e->open[w];
        if (!e->open[w]) continue;
        if (w % 2)
            b->contacts.hi[w / 2] += 1.25 * e->way;
        else
            b->contacts.lo[w / 2] -= 1.25 * e->way;
    }
    e->gone = owner_ints(e, b->ps->n);
    if (any) return e;
    owner_free(e);
    return NULL;
}

/* How far the whole body is beyond side w [m]. */
static double body_exit_beyond(const struct solid_bodies *b, int i, int w)
{
    const double x[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};
    double extent[3];
    const int k = w / 2;

    body_shape_extent(&b->shape[i], extent);
    return (w % 2 ? x[k] - b->exit->hi[k] : b->exit->lo[k] - x[k]) - extent[k];
}

/* From now on no force changes its motion. */
static void keep_velocity(struct solid_bodies *b, int i)
{
    struct particles *const ps = b->ps;

    b->exit->gone[i] = 1;
    b->motion[i] = BODY_PRESCRIBED;
    ps->m[i] = solid_bodies_immovable;
    ps->ex[i] = ps->ey[i] = ps->ez[i] = ps->added_mass[i] = 0.0;
}

/* At rest where no other one comes, and as small as a block is to spheres. */
static void take_out(struct solid_bodies *b, int i, int w)
{
    struct particles *const ps = b->ps;
    struct body_exit *const e = b->exit;
    double *const x[3] = {&ps->x[i], &ps->y[i], &ps->z[i]};
    const int k = w / 2;

    e->gone[i] = 2;
    e->n_gone++;
    b->motion[i] = BODY_FIXED;
    *x[k] = w % 2 ? e->hi[k] + e->way : e->lo[k] - e->way;
    ps->vx[i] = ps->vy[i] = ps->vz[i] = 0.0;
    ps->wx[i] = ps->wy[i] = ps->wz[i] = 0.0;
    memset(&b->u_old[3 * i], 0, 3 * sizeof *b->u_old);
    memset(&b->w_old[3 * i], 0, 3 * sizeof *b->w_old);
    if (b->shape[i].kind == BODY_SPHERE) ps->d[i] *= 1e-3;
    if (b->dem != NULL) dem_changed(b->dem);
}

/* One that reaches out without moving out is free still: it may have turned. */
static void body_exit_look_at(struct solid_bodies *b, int i, int w)
{
    const double v[3] = {b->ps->vx[i], b->ps->vy[i], b->ps->vz[i]};
    const double out = body_exit_beyond(b, i, w);
    double extent[3];

    body_shape_extent(&b->shape[i], extent);
    if (b->motion[i] == BODY_FREE && out + 2.0 * extent[w / 2] > 0.0 &&
        (w % 2 ? v[w / 2] : -v[w / 2]) > 0.0)
        keep_velocity(b, i);
    if (b->motion[i] == BODY_PRESCRIBED && out > 0.0) take_out(b, i, w);
}

void body_exit_look(struct solid_bodies *b)
{
    for (int i = 0; i < b->ps->n; i++)
        for (int w = 0; w < 6; w++)
            if (b->exit->open[w]) body_exit_look_at(b, i, w);
}

void body_exit_state(struct solid_bodies *b, struct state *s)
{
    struct body_exit *const e = b->exit;

    state_wholes(s, "gone", "-", e->gone, b->ps->n, 1);
    if (!s->loading || s->failed) return;
    e->n_gone = 0;
    for (int i = 0; i < b->ps->n; i++) {
        if (e->gone[i] > 0)
            b->motion[i] = e->gone[i] == 1 ? BODY_PRESCRIBED : BODY_FIXED;
        e->n_gone += e->gone[i] == 2;
    }
}

int body_exit_is_open(const struct body_exit *e, const double S[3])
{
    for (int k = 0; k < 3 && e != NULL; k++)
        if (S[k] != 0.0 && e->open[2 * k + (S[k] > 0.0)]) return 1;
    return 0;
}
