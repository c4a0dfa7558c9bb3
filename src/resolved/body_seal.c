/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_seal.h"

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "base/vector.h"
#include "dem/box_domain.h"
#include "resolved/body_cells.h"
#include "resolved/fluid_parts.h"
#include "resolved/mark.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- closed gap ----------------------------------------------------------- */

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

/* The patch of a boundary face. */
static int body_seal_patch(const struct mesh *m, int f)
{
    int p = 0;

    while (f >= m->patches[p].first + m->patches[p].n)
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

    if (f >= m->n_internal)
        return fl->options.boundaries[body_seal_patch(m, f)].kind <
                       BOUNDARY_INLET
                   ? WALL
                   : NONE;
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
    const double *const d = mesh_d(m, m->cell_face[a]);

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
    const double h = vector_length(mesh_d(m, m->cell_face[a]));
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
               vector_dot(mesh_S(m, m->cell_face[a]),
                          mesh_S(m, m->cell_face[e])) <
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
            one.j = beyond(by, c, m->cell_face[e]);
            one.S = mesh_S(m, m->cell_face[e]);
            if (one.j == NONE || (one.j != WALL && e < a) ||
                !is_opposite(m, a, e) ||
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
        if (b->body_of[c] != 0 ||
            !box_is_between(&by->fl->mesh->box, b->amid[c], b->body_of, c) ||
            gaps_at(by, c, &g) < 1 + by->corners)
            continue;
        const int changes = mark_gap_changes(b, g.i, g.j, g.S);
        struct body_seal_gap *const widest =
            changes ? &b->seal.open : &b->seal.closed;
        if (g.width > widest->width && !by->corners)
            *widest = (struct body_seal_gap){g.i + 1, g.j + 1, g.width};
        if (changes) continue;
        b->body_of[c] = 1 + g.i + b->ps->n;
        b->end[g.i]++;
        closed++;
    }
    return closed;
}

int closed_gap_find(struct solid_bodies *b, const struct fluid *fl)
{
    struct closing by = {.b = b, .fl = fl};
    int closed = 0, more;

    b->seal = (struct body_seal){0};
    do {
        more = close_cells(&by);
        by.corners = more > 0;
        closed += more;
    } while (more > 0);
    return closed;
}

void closed_gap_velocity(const struct fluid *fl, int c, double s, double u[3])
{
    const struct mesh *const m = fl->mesh;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a];
        if (f < m->n_internal) continue;
        const int p = body_seal_patch(m, f);
        const struct boundary *const at = &fl->options.boundaries[p];
        const double *const wall =
            boundary_wall_velocity(at, f - m->patches[p].first);
        const double half = vector_length(mesh_d(m, f));
        for (int k = 0; k < 3 && at->kind == BOUNDARY_NO_SLIP; k++)
            u[k] = (s * wall[k] + half * u[k]) / (s + half);
    }
}

/* --- body seal ------------------------------------------------------------ */

/* A body pushes into a part if that takes so much of what it displaces [-]: a
 * piston all of it, a sphere less than this between three others. */
static const double share = 0.5;

struct search {
    struct solid_bodies *b;
    const struct fluid *fl;
    struct box_domain box;
    double *here; /* [m^3/s] that each body displaces into this part */
    int any_outlet;
    struct body_seal *found;
};

/* From the centre of body i to the middle of face f [m], seen from cell c. */
static void from_centre(const struct search *s, int i, int c, int f, double out,
                        double r[3])
{
    const struct particles *const ps = s->b->ps;
    const struct mesh *const m = s->fl->mesh;
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
    const double part = f < m->n_internal ? 0.5 : 1.0;

    for (int k = 0; k < 3; k++)
        r[k] = box_domain_nearest(&s->box, k, m->centre[3 * c + k] - x[k]) +
               part * out * mesh_d(m, f)[k];
}

/* What body i sweeps through the face of a cell of its own, outward [m^3/s].
 * Contacts move one that is fixed by what rounding leaves. */
static double swept(const struct search *s, int i, int c, int f, double out)
{
    const struct particles *const ps = s->b->ps;
    const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};
    double r[3], v[3];

    if (s->b->motion[i] == BODY_FIXED) return 0.0;
    from_centre(s, i, c, f, out, r);
    vector_cross(w, r, v);
    v[0] += ps->vx[i], v[1] += ps->vy[i], v[2] += ps->vz[i];
    return out * vector_dot(v, mesh_S(s->fl->mesh, f));
}

static double height_at(const struct search *s, int i, int c, int f, double out)
{
    double r[3];

    from_centre(s, i, c, f, out, r);
    return body_shape_distance(&s->b->shape[i], r);
}

/* The gap between a cell in body i, and the other side of a face. */
static void look_into_gap(const struct search *s, int i, int c, int f,
                          double out, struct body_seal *found)
{
    const struct mesh *const m = s->fl->mesh;
    const int wall = f >= m->n_internal;
    const int next = wall || m->owner[f] != c ? m->owner[f] : m->neighbour[f];
    const int j = wall ? -1 : abs(s->b->body_of[next]) - 1;

    if (wall ? s->fl->options.boundaries[body_seal_patch(m, f)].kind >=
                   BOUNDARY_INLET
             : j < 0 || j == i || j >= s->b->ps->n)
        return;
    struct body_seal_gap *const widest =
        mark_gap_changes(s->b, i, j, mesh_S(m, f)) ? &found->open
                                                   : &found->closed;
    const double h = vector_length(mesh_d(m, f)) * (wall ? 2.0 : 1.0);
    const double gap = height_at(s, i, c, f, out) +
                       (wall ? 0.0 : height_at(s, j, next, f, -out));
    if (gap > fmax(widest->width, 1e-9) * h)
        *widest = (struct body_seal_gap){i + 1, j + 1, gap / h};
}

static void look_at_body(const struct search *s, int c, struct body_seal *found)
{
    const struct mesh *const m = s->fl->mesh;
    const int i = (abs(s->b->body_of[c]) - 1) % s->b->ps->n;

    if (closed_gap_of(s->b, c) >= 0 ||
        !box_meets_other(&m->box, s->b->amid[c], s->b->body_of, c))
        return;
    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
        look_into_gap(s, i, c, m->cell_face[a], m->out[a], found);
}

static void take_wider(struct body_seal_gap *widest,
                       const struct body_seal_gap *g)
{
    if (g->width > widest->width) *widest = *g;
}

/* Each range of cells finds its own, whatever the number of threads. */
static void look_at_bodies(struct search *s)
{
    struct body_seal part[PARALLEL_RANGES_COUNT] = {{0}};
    const int n = s->fl->mesh->n_cells, *const of = s->b->body_of;

#pragma omp parallel for schedule(static)
    for (int k = 0; k < PARALLEL_RANGES_COUNT; k++)
        for (int c = parallel_ranges_first(n, k);
             c < parallel_ranges_first(n, k + 1); c++)
            if (of[c] == 0)
                part[k].outside++;
            else
                look_at_body(s, c, &part[k]);
    for (int k = 0; k < PARALLEL_RANGES_COUNT; k++) {
        s->found->outside += part[k].outside;
        take_wider(&s->found->open, &part[k].open);
        take_wider(&s->found->closed, &part[k].closed);
    }
}

static int flows_in(const struct boundary *p)
{
    int flows = 0;

    for (int i = 0; i < p->n_points && p->kind == BOUNDARY_INLET; i++)
        flows |= p->velocity[i] > 0.0;
    return flows;
}

static void find_openings(const struct search *s, const struct fluid_parts *p)
{
    const struct mesh *const m = s->fl->mesh;

    for (int k = 0; k < m->n_patches; k++) {
        const struct patch *const at = &m->patches[k];
        const int outlet = s->fl->options.boundaries[k].kind == BOUNDARY_OUTLET;
        const int inlet = flows_in(&s->fl->options.boundaries[k]);
        for (int f = at->first; f < at->first + at->n && (inlet || outlet);
             f++) {
            if (s->b->body_of[m->owner[f]] > 0) continue;
            const int e = p->run[fluid_parts_run(p, m->owner[f])].root;
            p->run[e].inlet |= inlet;
            p->run[e].outlet |= outlet;
        }
    }
}

/* What the cells of body i displace [m^3/s]. */
static double displaced_by_cells(const struct search *s, int i)
{
    const struct solid_bodies *const b = s->b;
    const struct mesh *const m = s->fl->mesh;
    double sum = 0.0;

    for (int j = b->start[i]; j < b->end[i]; j++) {
        const int c = b->link[j].cell;
        for (int a = m->cell_start[c];
             a < m->cell_start[c + 1] && b->body_of[c] == i + 1; a++) {
            const int f = m->cell_face[a];
            if (f >= m->n_internal) continue;
            const int next = m->owner[f] == c ? m->neighbour[f] : m->owner[f];
            if (b->body_of[next] <= 0)
                sum += 0.5 * fabs(swept(s, i, c, f, m->out[a]));
        }
    }
    return sum;
}

/* What the bodies displace into a part of n cells, in s->here; the sum. */
static double sum_swept(const struct search *s, const int *part, int n)
{
    const struct mesh *const m = s->fl->mesh;
    double sum = 0.0;

    memset(s->here, 0, (size_t)s->b->ps->n * sizeof *s->here);
    for (int e = 0; e < n; e++) {
        const int c = part[e];
        if (!box_meets_other(&m->box, s->b->amid[c], s->b->body_of, c))
            continue;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            if (f >= m->n_internal) continue;
            const int next = m->owner[f] == c ? m->neighbour[f] : m->owner[f];
            const int i = s->b->body_of[next] - 1;
            if (i >= 0) s->here[i] += swept(s, i, next, f, -m->out[a]);
        }
    }
    for (int i = 0; i < s->b->ps->n; i++)
        sum += s->here[i];
    return sum;
}

/* Whether what is pushed into the part with this root gets out of it. */
static void judge(const struct search *s, const struct fluid_parts *p, int root)
{
    int *const part = s->b->cell;

    s->found->inlet |=
        p->run[root].inlet && !p->run[root].outlet && s->any_outlet;
    if (p->run[root].outlet) return;
    const int n = fluid_parts_cells(p, root, part);
    const double sum = sum_swept(s, part, n);
    for (int i = 0; i < s->b->ps->n; i++) {
        if (s->here[i] == 0.0) continue;
        const double most = share * displaced_by_cells(s, i);
        if (most > 0.0 && fabs(s->here[i]) > most && fabs(sum) > most)
            s->found->pushes = i + 1;
    }
}

/* What of an inlet is covered by bodies [-]. */
static double covered(const struct search *s, int p)
{
    const struct patch *const at = &s->fl->mesh->patches[p];
    double all = 0.0, held = 0.0;

    for (int f = at->first; f < at->first + at->n; f++) {
        const double area = vector_length(mesh_S(s->fl->mesh, f));
        all += area;
        if (s->b->body_of[s->fl->mesh->owner[f]] > 0) held += area;
    }
    return flows_in(&s->fl->options.boundaries[p]) ? held / all : 0.0;
}

static void look_at_patches(struct search *s)
{
    for (int p = 0; p < s->fl->mesh->n_patches; p++) {
        s->any_outlet |= s->fl->options.boundaries[p].kind == BOUNDARY_OUTLET;
        s->found->covered = fmax(s->found->covered, covered(s, p));
    }
}

void body_seal_find(struct solid_bodies *b, const struct fluid *fl)
{
    const struct dem_options *const o = &b->contacts;
    struct search s = {.b = b,
                       .fl = fl,
                       .box = box_domain_of(o->lo, o->hi, o->periodic),
                       .here = alloc_doubles(b->ps->n),
                       .found = &b->seal};
    const int n = b->ps->n;
    int *const of = b->body_of;

#pragma omp parallel for schedule(static)
    for (int c = 0; c < fl->mesh->n_cells; c++)
        of[c] = of[c] < -n ? -of[c] : of[c];
    look_at_patches(&s);
    look_at_bodies(&s);
#pragma omp parallel for schedule(static)
    for (int c = 0; c < fl->mesh->n_cells; c++)
        of[c] = of[c] > n ? of[c] - n : of[c] > 0 ? of[c] : 0;
    struct fluid_parts *const p = fluid_parts_find(&fl->mesh->box, of);
    find_openings(&s, p);
    for (int e = 0; e < p->runs; e++)
        if (p->run[e].root == e) judge(&s, p, e);
    owner_free(p);
    b->seal.inlet |= b->seal.covered == 1.0;
    free(s.here);
}

void body_seal_describe(const struct body_seal_gap *g, int open,
                        char text[BODY_SEAL_TEXT])
{
    char other[32] = "a wall";

    if (g->across > 0) snprintf(other, sizeof other, "body %d", g->across - 1);
    snprintf(text, BODY_SEAL_TEXT, "body %d to %s, %s", g->beside - 1, other,
             open ? "three times too much or more flows along it"
                  : "no fluid flows between them");
}
