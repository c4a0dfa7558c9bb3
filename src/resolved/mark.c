/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/mark.h"

#include "base/alloc.h"
#include "base/vector.h"
#include "resolved/body_cells.h"
#include "resolved/body_motion.h"
#include "resolved/body_seal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const double mark_friction_inside = 1e3;

/* mu |S| / (|d| V) of face f [kg/(m^3 s)]. */
static double exchange(const struct fluid *fl, int f, int c)
{
    const double *const S = mesh_S(fl->mesh, f), *const d = mesh_d(fl->mesh, f);
    return fl->options.mu * vector_length(S) /
           (vector_length(d) * fl->mesh->V[c]);
}

/* Inside: C max(rho/dt, mu/h^2), the latter of the face with the most. */
static double friction_inside(const struct fluid *fl, int c)
{
    const struct mesh *const m = fl->mesh;
    double most = fl->options.rho / fl->options.dt;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
        most = fmax(most, exchange(fl, m->cell_face[a], c));
    return mark_friction_inside * most;
}

static int touches_boundary(const struct solid_bodies *b, const struct mesh *m,
                            int c)
{
    int touches = 0;

    if (b->amid[c]) return 0;
    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
        touches |= m->cell_face[a] >= m->n_internal;
    return touches;
}

/* The work of marking. All cells are equal, but for what touches a boundary. */
struct marking {
    struct solid_bodies *b;
    const struct fluid *fl;
    double width[3], widest; /* [m] of a cell */
    double exchange[3];      /* [kg/(m^3 s)] mu/width^2 */
    double inside; /* [kg/(m^3 s)] friction inside, of a cell amid others */
};

static struct marking marking_of(struct solid_bodies *b, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct marking by = {.b = b, .fl = fl};
    int c = 0;

    for (int k = 0; k < 3; k++) {
        const double h = m->box.edge[k][1] - m->box.edge[k][0];
        by.width[k] = h;
        by.widest = fmax(by.widest, h);
        by.exchange[k] = fl->options.mu / (h * h);
    }
    while (c < m->n_cells && touches_boundary(b, m, c))
        c++;
    by.inside = c < m->n_cells ? friction_inside(fl, c) : 0.0;
    return by;
}

static double marking_inside(const struct marking *by, int c)
{
    return touches_boundary(by->b, by->fl->mesh, c) ? friction_inside(by->fl, c)
                                                    : by->inside;
}

/* Outside at the distance s: the missing part of the neighbours inside; not
 * more than inside. */
static double friction_outside(const struct marking *by,
                               const struct body_shape *shape, int c,
                               const double r[3], double s)
{
    const struct solid_bodies *const b = by->b;
    const struct box *const box = &by->fl->mesh->box;
    const int way[] = {1, box->n[0], box->n[0] * box->n[1]};
    double sum = 0.0;

    for (int side = 0; side < 6; side++) {
        const int k = side / 2, on = side % 2 ? way[k] : -way[k];
        const int next = b->amid[c] ? c + on : box_beside(box, c, side);
        double beyond[3] = {r[0], r[1], r[2]};
        beyond[k] += side % 2 ? by->width[k] : -by->width[k];
        if (s > by->width[k] || next < 0 || b->body_of[next] == 0) continue;
        const double inside = -body_shape_distance(shape, beyond);
        if (inside > 0.0) sum += by->exchange[k] * inside;
    }
    return sum > 0.0 ? fmin(sum / s, marking_inside(by, c)) : 0.0;
}

/* Room for the links of each body, for as many as its `end` was counted to. */
static void mark_make_room(struct solid_bodies *b)
{
    int n = 0;

    for (int i = 0; i < b->ps->n; i++) {
        b->start[i] = n;
        n += b->end[i];
        b->end[i] = b->start[i];
    }
    if (n <= b->capacity) return;
    free(b->link);
    b->capacity = n + n / 8;
    b->link = alloc_zeroed((size_t)b->capacity, sizeof *b->link);
}

static struct hold_link *add_link(struct solid_bodies *b, int i, int cell,
                                  double hold, const double r[3])
{
    const struct particles *const ps = b->ps;
    const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};
    struct hold_link *const link = &b->link[b->end[i]++];
    double turn[3];

    vector_cross(w, r, turn);
    *link = (struct hold_link){
        .cell = cell,
        .hold = hold,
        .u = {ps->vx[i] + turn[0], ps->vy[i] + turn[1], ps->vz[i] + turn[2]},
        .r = {r[0], r[1], r[2]}};
    return link;
}

/* 1 if body i may come nearer to a wall across axis k. */
static int approaches(const struct solid_bodies *b, int i, int k)
{
    const struct particles *const ps = b->ps;
    const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};

    if (b->motion[i] == BODY_PRESCRIBED)
        return v[k] != 0.0 || w[(k + 1) % 3] != 0.0 || w[(k + 2) % 3] != 0.0;
    return body_motion_moves_along(b, i, k);
}

static int approaches_wall(const struct solid_bodies *b, int i,
                           const double S[3])
{
    int k = 0;

    while (k < 2 && S[k] == 0.0)
        k++;
    return approaches(b, i, k) && !body_exit_is_open(b->exit, S);
}

/* 1 if both are prescribed to move as one. */
static int move_as_one(const struct solid_bodies *b, int i, int j)
{
    const struct particles *const ps = b->ps;

    return b->motion[i] == BODY_PRESCRIBED && b->motion[j] == BODY_PRESCRIBED &&
           ps->vx[i] == ps->vx[j] && ps->vy[i] == ps->vy[j] &&
           ps->vz[i] == ps->vz[j] && ps->wx[i] == 0.0 && ps->wy[i] == 0.0 &&
           ps->wz[i] == 0.0 && ps->wx[j] == 0.0 && ps->wy[j] == 0.0 &&
           ps->wz[j] == 0.0;
}

int mark_gap_changes(const struct solid_bodies *b, int i, int j,
                     const double S[3])
{
    if (j < 0) return approaches_wall(b, i, S);
    return (b->motion[i] != BODY_FIXED || b->motion[j] != BODY_FIXED) &&
           !move_as_one(b, i, j);
}

/* 1 if body i squeezes the fluid out of the cell, which is its own, against a
 * wall or a body that moves otherwise. */
static int mark_is_gap(const struct solid_bodies *b, const struct mesh *m,
                       int c, int i)
{
    if (!box_meets_other(&m->box, b->amid[c], b->body_of, c)) return 0;
    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a];
        const int wall = f >= m->n_internal;
        const int next =
            wall || m->owner[f] != c ? m->owner[f] : m->neighbour[f];
        const int j = wall ? -1 : (abs(b->body_of[next]) - 1) % b->ps->n;
        if (wall || (b->body_of[next] != 0 && j != i))
            if (mark_gap_changes(b, i, j, mesh_S(m, f))) return 1;
    }
    return 0;
}

/* Bodies that have no balls have no contacts and may overlap, but not where a
 * spring moves one. */
static void look_for_spring(struct solid_bodies *b, int i, int j)
{
    if (j >= 0 && j != i &&
        (b->motion[i] == BODY_SPRING || b->motion[j] == BODY_SPRING))
        b->met |= body_shape_balls(&b->shape[i]) == 0 &&
                  body_shape_balls(&b->shape[j]) == 0;
}

/* While links are made, body_of is 1 + the body around a cell, else 0; negative
 * where that leaves the cell to the fluid; larger in gaps. Of several that are
 * around a cell it is the last: who takes the mark of a later one out gives it
 * back. */
static void assign_cell(void *by, int i, int c, const double r[3], double s)
{
    struct solid_bodies *const b = ((struct marking *)by)->b;

    (void)r;
    b->end[i]++;
    for (int mine = i + 1, other = 0; s <= 0.0; mine = other) {
#pragma omp atomic capture
        {
            other = b->body_of[c];
            b->body_of[c] = mine;
        }
        if (b->springs > 0) look_for_spring(b, i, other - 1);
        if (other <= mine) break;
    }
}

/* Several bodies at a time, but where a spring moves one. */
static void assign_cells(struct marking *by)
{
    struct solid_bodies *const b = by->b;

#pragma omp parallel for schedule(dynamic, 1) if (b->springs == 0)
    for (int i = 0; i < b->ps->n; i++)
        body_cells_each(b, by->fl->mesh, i, by->widest, assign_cell, by);
}

double mark_fraction(const struct mesh *m, int c, double s)
{
    return fmin(fmax(0.5 - s / cbrt(m->V[c]), 0.0), 1.0);
}

/* In place of `hold`, while links are made, of a cell that its body leaves to
 * the fluid, or in a gap has held [kg/(m^3 s)]. */
static const double mark_left = -1.0;

/* Of a gap that is closed, once: it may be between a body and its image. */
static void hold_gap(const struct marking *by, int i, int c, const double r[3],
                     double s)
{
    struct solid_bodies *const b = by->b;

    if (closed_gap_of(b, c) != i || b->hold[c] == mark_left) return;
    closed_gap_velocity(
        by->fl, c, s,
        add_link(b, i, c, b->by_fraction ? 1.0 : marking_inside(by, c), r)->u);
    b->hold[c] = mark_left;
}

static void hold_cell(void *marking, int i, int c, const double r[3], double s)
{
    const struct marking *const by = marking;
    struct solid_bodies *const b = by->b;

    if (closed_gap_of(b, c) >= 0)
        hold_gap(by, i, c, r, s);
    else if (b->by_fraction) {
        const double share = mark_fraction(by->fl->mesh, c, s);
        if (share > 0.0) add_link(b, i, c, share, r);
    } else if (s > 0.0) {
        const double hold = friction_outside(by, &b->shape[i], c, r, s);
        if (hold > 0.0) add_link(b, i, c, hold, r);
    } else if (!mark_is_gap(b, by->fl->mesh, c, i))
        add_link(b, i, c, marking_inside(by, c), r);
    else
        b->hold[c] = mark_left;
}

/* The links of all bodies, several at a time; cells of closed gaps may be
 * beyond those beside a body. What a body leaves to the fluid is marked when
 * all are done, because the others look at body_of. */
static void hold_cells(struct marking *by, int gaps)
{
    struct solid_bodies *const b = by->b;
    const double reach = gaps ? HUGE_VAL : by->widest;

#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < b->ps->n; i++)
        body_cells_each(b, by->fl->mesh, i, reach, hold_cell, by);
#pragma omp parallel for schedule(static)
    for (int c = 0; c < by->fl->mesh->n_cells; c++)
        if (b->hold[c] == mark_left) {
            b->hold[c] = 0.0;
            b->body_of[c] = -abs(b->body_of[c]);
        }
}

/* The sums over the links of each cell. */
static void sum_links(struct solid_bodies *b)
{
    for (int i = 0; i < b->ps->n; i++)
        for (int j = b->start[i]; j < b->end[i]; j++) {
            const struct hold_link *const l = &b->link[j];
            if (b->hold[l->cell] == 0.0) b->cell[b->n_cells++] = l->cell;
            b->hold[l->cell] += l->hold;
            for (int k = 0; k < 3 && !b->by_fraction; k++)
                b->hold_u[3 * l->cell + k] += l->hold * l->u[k];
        }
}

/* What of the fluid in the cell of link l moves with the body [-]. One outside
 * is slowed down, but flows: were it counted, a light sphere in a viscous fluid
 * would have less than no inertia. */
static double share_of(const struct solid_bodies *b, const struct fluid *fl,
                       const struct hold_link *l)
{
    const double least = 0.999 * mark_friction_inside; /* but for rounding */

    if (b->by_fraction) return l->hold;
    return l->hold * fl->options.dt >= least * fl->options.rho ? 1.0 : 0.0;
}

/* What body i turns with it of the fluid, about each axis: a cell that it
 * holds, whose centre is at r, has rho V (r^2 - r_k^2). Where cells at its
 * surface are left to the fluid that is less than of the whole sphere. */
static void sum_inertia(struct solid_bodies *b, const struct fluid *fl, int i)
{
    double *const I = &b->inertia[3 * i];

    I[0] = I[1] = I[2] = 0.0;
    for (int j = b->start[i]; j < b->end[i]; j++) {
        const struct hold_link *const l = &b->link[j];
        const double m =
            share_of(b, fl, l) * fl->options.rho * fl->mesh->V[l->cell];
        for (int k = 0; k < 3; k++)
            I[k] += m * (vector_dot(l->r, l->r) - l->r[k] * l->r[k]);
    }
}

static void clear_links(struct solid_bodies *b)
{
    for (int j = 0; j < b->n_cells; j++) {
        const int c = b->cell[j];
        b->hold[c] = 0.0;
        if (!b->by_fraction)
            memset(&b->hold_u[3 * c], 0, 3 * sizeof *b->hold_u);
    }
    b->n_cells = 0;
    memset(b->end, 0, (size_t)b->ps->n * sizeof *b->end);
}

void mark_bodies(struct solid_bodies *b, const struct fluid *fl)
{
    if (b->dt_marked == fl->options.dt) return;
    struct marking by = marking_of(b, fl);

    clear_links(b);
    assign_cells(&by);
    const int gaps = closed_gap_find(b, fl);
    mark_make_room(b);
    hold_cells(&by, gaps);
    body_seal_find(b, fl);
    memset(b->body_of, 0, (size_t)fl->mesh->n_cells * sizeof *b->body_of);
    sum_links(b);
    b->held = b->n_cells;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < b->ps->n; i++)
        sum_inertia(b, fl, i);
    b->dt_marked = fl->options.dt;
}

/* I += m (r^2 - r r), as xx, xy, xz, yy, yz, zz. */
static void add_moments(double I[6], double m, const double r[3])
{
    for (int k = 0, e = 0; k < 3; k++)
        for (int l = k; l < 3; l++, e++)
            I[e] += m * ((k == l ? vector_dot(r, r) : 0.0) - r[k] * r[l]);
}

/* Angular momentum over rho that body_motion.c takes to be inside. */
static void spin_inside(const struct solid_bodies *b, int i, double L[3])
{
    const double w[3] = {b->ps->wx[i], b->ps->wy[i], b->ps->wz[i]};
    double G[6];

    for (int k = 0; k < 3; k++)
        L[k] = b->inertia[3 * i + k] / b->rho * w[k];
    if (b->shape[i].kind != BODY_OUTLINE) return;
    body_turn_gyration(b, i, G);
    body_turn_times(G, w, L);
    for (int k = 0; k < 3; k++)
        L[k] *= b->volume[i];
}

/* The cells that body i holds have another volume, centre and moments than it
 * has. They move as one, with v + a x r, and have its momentum, V U and L:
 *
 *   held v + a x s = V U,   s x v + I a = L,   s = sum of V_c r */
static void start_inside(struct solid_bodies *b, struct fluid *fl, int i)
{
    const double U[3] = {b->ps->vx[i], b->ps->vy[i], b->ps->vz[i]};
    double held = 0.0, s[3] = {0.0}, I[6] = {0.0}, L[3], a[3], v[3], turn[3];

    for (int j = b->start[i]; j < b->end[i]; j++) {
        const struct hold_link *const l = &b->link[j];
        const double V = share_of(b, fl, l) * fl->mesh->V[l->cell];
        held += V;
        vector_along(s, V, l->r, s);
        add_moments(I, V, l->r);
    }
    if (held == 0.0) return;
    add_moments(I, -1.0 / held, s);
    spin_inside(b, i, L);
    vector_cross(s, U, turn);
    vector_along(L, -b->volume[i] / held, turn, L);
    vector_solve(I, L, a);
    vector_cross(s, a, v);
    vector_along(v, b->volume[i], U, v);
    for (int j = b->start[i]; j < b->end[i]; j++) {
        const struct hold_link *const l = &b->link[j];
        const double share = share_of(b, fl, l);
        double *const u = &fl->u[3 * l->cell];
        vector_cross(a, l->r, turn);
        vector_along(u, share / held, v, u);
        vector_along(u, share, turn, u);
    }
}

void mark_start(struct solid_bodies *b, struct fluid *fl)
{
    mark_bodies(b, fl);
    for (int i = 0; i < b->ps->n; i++)
        if (b->motion[i] == BODY_FREE || b->motion[i] == BODY_SPRING)
            start_inside(b, fl, i);
}
