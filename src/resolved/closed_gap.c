/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/closed_gap.h"

#include <math.h>
#include <stdlib.h>

#include "base/vector.h"
#include "dem/box_domain.h"
#include "resolved/mark.h"

enum { NONE = -2, WALL = -1 }; /* in place of a body */

struct gap {
    int i, j;        /* [-] the body, and the other one or WALL */
    const double *S; /* [m^2] of the wall */
    double width;    /* [-] in cells */
};

int closed_gap_of(const struct solid_bodies *b, int c)
{
    return abs(b->body_of[c]) - 1 - b->ps->n;
}

static const struct patch *closed_gap_patch(const struct mesh *m, int f)
{
    const struct patch *p = m->patches;

    while (f >= p->first + p->n)
        p++;
    return p;
}

struct closing {
    struct solid_bodies *b;
    const struct fluid *fl;
    int corners; /* [-] 1: beside cells that are closed, too */
};

/* What is on the other side of face f of cell c: a body that holds the cell
 * there; a wall; or fluid. */
static int beyond(const struct closing *by, int c, int f)
{
    const struct solid_bodies *const b = by->b;
    const struct fluid *const fl = by->fl;
    const struct mesh *const m = fl->mesh;

    if (f >= m->n_internal) {
        const struct patch *const p = closed_gap_patch(m, f);
        return fl->options.boundaries[p - m->patches].kind < BOUNDARY_INLET
                   ? WALL
                   : NONE;
    }
    const int of = b->body_of[m->owner[f] == c ? m->neighbour[f] : m->owner[f]];
    if (of == 0 || (of > b->ps->n && !by->corners)) return NONE;
    return (of - 1) % b->ps->n;
}

/* Cell c from the centre of body i [m], which is around the cell beyond face a:
 * of its images that one. */
static void from_body(const struct closing *by, int i, int c, int a,
                      double r[3])
{
    const struct dem_options *const o = &by->b->contacts;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    const struct particles *const ps = by->b->ps;
    const struct mesh *const m = by->fl->mesh;
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
    const double *const d = &m->d[3 * m->cell_face[a]];

    for (int k = 0; k < 3; k++) {
        const double way = m->out[a] * d[k];
        r[k] = box_domain_nearest(&box, k, m->centre[3 * c + k] + way - x[k]) -
               way;
    }
}

/* 1 if c, between its faces a and e, is in a gap of less than a cell. */
static int is_narrow(const struct closing *by, int c, int a, int e,
                     struct gap *g)
{
    const struct solid_bodies *const b = by->b;
    const struct mesh *const m = by->fl->mesh;
    const double h = vector_length(&m->d[3 * m->cell_face[a]]);
    double r[3], q[3];

    from_body(by, g->i, c, a, r);
    g->width = body_shape_distance(&b->shape[g->i], r) / h + 0.5;
    if (g->j == WALL) return g->width < 1.0 - 1e-9;
    from_body(by, g->j, c, e, q);
    g->width += body_shape_distance(&b->shape[g->j], q) / h - 0.5;
    const int itself =
        g->i == g->j &&
        fabs(r[0] - q[0]) + fabs(r[1] - q[1]) + fabs(r[2] - q[2]) < h;
    return !itself && g->width < 1.0 - 1e-9;
}

static int is_opposite(const struct mesh *m, int a, int e)
{
    return m->out[a] * m->out[e] *
               vector_dot(&m->S[3 * m->cell_face[a]],
                          &m->S[3 * m->cell_face[e]]) <
           0.0;
}

/* The narrowest gap that cell c is in: of those along the axes, the number. */
static int gaps_at(const struct closing *by, int c, struct gap *g)
{
    const struct mesh *const m = by->fl->mesh;
    int n = 0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        struct gap one = {.i = beyond(by, c, m->cell_face[a])};
        if (one.i < 0) continue;
        for (int e = m->cell_start[c]; e < m->cell_start[c + 1]; e++) {
            one.j =
                is_opposite(m, a, e) ? beyond(by, c, m->cell_face[e]) : NONE;
            one.S = &m->S[3 * m->cell_face[e]];
            if (one.j == NONE || (one.j != WALL && e < a) ||
                (!is_narrow(by, c, a, e, &one) && !by->corners))
                continue;
            if (n++ == 0 || one.width < g->width) *g = one;
        }
    }
    return n;
}

/* Closes what is narrow, or in corners between cells that are closed has two
 * such gaps across; returns the number of cells. */
static int close_cells(const struct closing *by)
{
    struct solid_bodies *const b = by->b;
    struct gap g = {0};
    int closed = 0;

    for (int c = 0; c < by->fl->mesh->n_cells; c++) {
        if (b->body_of[c] != 0 || gaps_at(by, c, &g) < 1 + by->corners)
            continue;
        const int changes = mark_gap_changes(b, g.i, g.j, g.S);
        struct body_seal_gap *const widest =
            changes ? &b->seal.open : &b->seal.closed;
        if (g.width > widest->width && !by->corners)
            *widest = (struct body_seal_gap){g.i + 1, g.j + 1, g.width};
        if (changes) continue;
        b->body_of[c] = 1 + g.i + b->ps->n;
        closed++;
    }
    return closed;
}

void closed_gap_find(struct solid_bodies *b, const struct fluid *fl)
{
    struct closing by = {.b = b, .fl = fl};

    b->seal = (struct body_seal){0};
    do
        by.corners = close_cells(&by) > 0;
    while (by.corners);
}

void closed_gap_velocity(const struct fluid *fl, int c, double s, double u[3])
{
    const struct mesh *const m = fl->mesh;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a];
        if (f < m->n_internal) continue;
        const struct patch *const p = closed_gap_patch(m, f);
        const struct boundary *const at =
            &fl->options.boundaries[p - m->patches];
        const double *const wall =
            at->walls != NULL ? &at->walls[3 * (f - p->first)] : at->wall;
        const double half = vector_length(&m->d[3 * f]);
        for (int k = 0; k < 3 && at->kind == BOUNDARY_NO_SLIP; k++)
            u[k] = (s * wall[k] + half * u[k]) / (s + half);
    }
}
