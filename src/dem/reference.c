/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/reference.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/dem_method.h"
#include "dem/contact.h"

/* The contact of sphere a with sphere b, or with a wall if b is NULL. A wall is
 * placed like a sphere of the same radius behind it that does not move; its 1/R
 * and 1/m are 0. */
struct contact {
    struct sphere *a, *b;
    const struct contact_constants *k;
    double n[3];           /* [-] from b to a */
    double delta;          /* [m] overlap */
    double arm;            /* [-] r / (R_a + R_b) */
    double R_star, m_star; /* [m], [kg] */
    double v_n, v_t[3];    /* [m/s] of the surface of a against that of b */
    double F_n, F_t[3];    /* [N] on a */
    int slides;            /* [-] 1: at Coulomb's limit */
};

/* Geometry and velocities; x points from the centre of b to that of a. */
static struct contact contact_between(struct sphere *a, struct sphere *b,
                                      const double x[3])
{
    static const struct sphere wall = {.R = HUGE_VAL, .m = HUGE_VAL};
    const struct sphere *const other = b != NULL ? b : &wall;
    const double r = vector_length(x), R_b = b != NULL ? b->R : a->R;
    struct contact c = {.a = a,
                        .b = b,
                        .delta = a->R + R_b - r,
                        .arm = r / (a->R + R_b),
                        .R_star = 1.0 / (1.0 / a->R + 1.0 / other->R),
                        .m_star = 1.0 / (1.0 / a->m + 1.0 / other->m)};
    double v[3], spin[3], roll[3];

    for (int k = 0; k < 3; k++) {
        c.n[k] = x[k] / r;
        v[k] = a->v[k] - other->v[k];
        spin[k] = a->R * a->w[k] + (b != NULL ? b->R * b->w[k] : 0.0);
    }
    /* v_t = v - v_n n + (l_a omega_a + l_b omega_b) x (-n) */
    c.v_n = vector_dot(v, c.n);
    vector_cross(spin, c.n, roll);
    for (int k = 0; k < 3; k++)
        c.v_t[k] = v[k] - c.v_n * c.n[k] - c.arm * roll[k];
    return c;
}

/* Friction [LS 4.8]: the displacement xi is projected into the plane of contact
 * and advanced by v_t dt. A force above Coulomb's limit is reduced to it, and
 * so is xi where its spring alone exceeds the limit. What slides off in dt is
 * the work of the mean of the spring's force before and F_t after, and what the
 * spring loses. */
static void tangential_force(struct contact *c,
                             const struct contact_response *law, double xi[3],
                             double dt, struct energy *e)
{
    const double limit = c->k->friction * fabs(c->F_n);
    const double normal = vector_dot(xi, c->n), k_t = law->k_t;
    double projected[3];

    vector_along(xi, -normal, c->n, projected);
    vector_along(projected, dt, c->v_t, xi);
    for (int k = 0; k < 3; k++)
        c->F_t[k] = -k_t * xi[k] - law->eta_t * c->v_t[k];
    const double size = vector_length(c->F_t);
    c->slides = size > limit;
    const int yields = c->slides && k_t * vector_length(xi) > limit;
    for (int k = 0; k < 3; k++) {
        if (c->slides) c->F_t[k] *= limit / size;
        if (yields) xi[k] = -c->F_t[k] / k_t;
    }
    const double before = 0.5 * k_t * vector_dot(projected, projected);
    const double after = 0.5 * k_t * vector_dot(xi, xi);
    e->tangential += after;
    e->released -= after;
    if (!c->slides) return;
    const double slid = before - after +
                        0.5 * dt * k_t * vector_dot(projected, c->v_t) -
                        0.5 * dt * vector_dot(c->F_t, c->v_t);
    e->slid += slid;
    e->released -= slid;
}

/* 1/(I + m R^2), I = (2/5) m R^2 [1/(kg m^2)]. */
static double inverse_rolling_inertia(const struct sphere *s)
{
    return 1.0 / (1.4 * s->m * s->R * s->R);
}

/* Rolling friction (contact.h): the moment M [N m] on a. */
static void rolling_friction(const struct contact *c, double k_t,
                             double angle[3], double dt, double M[3])
{
    const double k_r = k_t * c->R_star * c->R_star;
    const double inverse_I =
        inverse_rolling_inertia(c->a) +
        (c->b != NULL ? inverse_rolling_inertia(c->b) : 0.0);
    const double C_r = 2.0 * rolling_damping_ratio * sqrt(k_r / inverse_I);
    const double limit = c->k->rolling * c->R_star * fabs(c->F_n);
    double w[3];

    for (int k = 0; k < 3; k++)
        w[k] = c->a->w[k] - (c->b != NULL ? c->b->w[k] : 0.0);
    rolling_moment(M, angle, w, c->n, k_r, C_r, limit, dt);
}

/* Adds F_n n + F_t to the loads of a and its negative to those of b. The
 * torques are those of forces in the plane of contact, at arm R from the
 * centres, and the moment M. */
static void add_loads(const struct contact *c, double F_n, const double F_t[3],
                      const double M[3], struct loads *a, struct loads *b)
{
    double lever[3];

    vector_cross(c->n, F_t, lever);
    for (int k = 0; k < 3; k++) {
        const double F = F_n * c->n[k] + F_t[k];
        a->F[k] += F;
        a->T[k] += M[k] - c->arm * c->a->R * lever[k];
        if (b == NULL) continue;
        b->F[k] -= F;
        b->T[k] -= M[k] + c->arm * c->b->R * lever[k];
    }
}

/* Adds the parts of the loads that the budget counts. */
static void add_parts(const struct contact *c,
                      const struct contact_response *law, const double xi[3],
                      const double M[3])
{
    static const double none[3] = {0.0, 0.0, 0.0};
    struct loads *const a = c->a->part;
    struct loads *const b = c->b != NULL ? c->b->part : NULL;
    double dashpot[3], friction[3];

    for (int k = 0; k < 3; k++) {
        friction[k] = c->slides ? c->F_t[k] : -law->k_t * xi[k];
        dashpot[k] = c->F_t[k] - friction[k];
    }
    add_loads(c, -law->eta_n * c->v_n, none, M, &a[ENERGY_DASHPOTS],
              b != NULL ? &b[ENERGY_DASHPOTS] : NULL);
    add_loads(c, 0.0, dashpot, none, &a[ENERGY_DASHPOTS_T],
              b != NULL ? &b[ENERGY_DASHPOTS_T] : NULL);
    add_loads(c, 0.0, friction, none, &a[ENERGY_FRICTION],
              b != NULL ? &b[ENERGY_FRICTION] : NULL);
}

/* Returns the history of the contact of i with this partner: that of the step
 * before, or zero for a new contact. It becomes one of this step. */
static struct history *history_of(struct reference *r, int i, int partner)
{
    struct histories *const now = &r->now;
    const struct histories *const before = &r->before;

    now->list =
        alloc_room(now->list, now->n, &now->capacity, sizeof *now->list);
    struct history *const history = &now->list[now->n++];
    *history = (struct history){.partner = partner};
    for (int q = before->start[i]; q < before->start[i + 1]; q++)
        if (before->list[q].partner == partner) *history = before->list[q];
    return history;
}

/* A mass [kg] that two have of which neither can move (solid_bodies.h). */
static const double immovable = 1e50;

/* Keeps the deepest overlap over the diameter [-], with its pair. */
static void note_overlap(struct reference *r, const struct contact *c, int i,
                         int partner)
{
    struct dem_overlap *const deepest = r->deepest;
    const double overlap = 1.0 - c->arm;

    if (c->m_star > immovable) return;
    r->max_overlap = fmax(r->max_overlap, overlap);
    if (overlap <= fmax(deepest->depth, deepest->expected)) return;
    deepest->depth = overlap;
    deepest->id = r->id[i];
    deepest->other = partner < 0 ? partner : r->id[partner];
    for (int k = 0; k < 3; k++)
        deepest->at[k] = box_domain_inside(&r->box, k, c->a->x[k]);
}

/* By how much 1/m_eff of a ball, which moves as its clump does, is above its
 * own 1/m (clumps.h). */
static double clump_difference(const struct reference *r,
                               const struct sphere *s, const double n[3])
{
    double arm[3];

    if (s == NULL || s->clump < 0) return 0.0;
    const struct clump *const c = &r->clumps->item[s->clump];
    const struct clump_pose at = clumps_pose(c);
    reference_arm(r, c, s, arm);
    return 1.0 / c->m - 1.0 / s->m + clumps_turning(at.per_I, arm, n);
}

/* The contact of sphere i with a partner, which it touches. */
static void add_contact(struct reference *r, int i, int partner,
                        const double x[3], double dt)
{
    struct sphere *const a = &r->sphere[i];
    struct sphere *const b = partner < 0 ? NULL : &r->sphere[partner];
    struct contact c = contact_between(a, b, x);
    const struct materials *const all = r->options->materials;
    const int material_b = b != NULL     ? b->material
                           : all != NULL ? all->wall
                                         : 0;
    double M[3] = {0.0, 0.0, 0.0};

    if (r->clumps != NULL)
        c.m_star = 1.0 / (1.0 / c.m_star + clump_difference(r, a, c.n) +
                          clump_difference(r, b, c.n));
    c.k = &r->constants[a->material * materials_count(all) + material_b];
    const struct contact_response law =
        r->options->law->respond(c.k, c.delta, c.R_star, c.m_star);
    struct history *const history = history_of(r, i, partner);
    c.F_n = law.elastic - law.eta_n * c.v_n; /* [LS 4.4, 4.7] */
    tangential_force(&c, &law, history->xi, dt, r->energy);
    if (c.k->rolling > 0.0)
        rolling_friction(&c, law.k_t, history->roll_angle, dt, M);
    add_loads(&c, c.F_n, c.F_t, M, &a->all, b != NULL ? &b->all : NULL);
    if (r->budget) add_parts(&c, &law, history->xi, M);
    note_overlap(r, &c, i, partner);
    r->energy->normal += law.stored;
}

/* The attractions of two spheres, or of a sphere and a wall (b = NULL), along
 * the line of centres; gap [m]. */
static void reference_add_attractions(struct reference *r, struct sphere *a,
                                      struct sphere *b, const double x[3],
                                      double gap, double dt)
{
    const struct dem_options *const o = r->options;
    double F = 0.0, v[3];

    for (int k = 0; k < 3; k++)
        v[k] = a->v[k] - (b != NULL ? b->v[k] : 0.0);
    const double closing = -vector_dot(v, x) / vector_length(x);
    for (int q = 0; q < o->n_attractions; q++) {
        const struct attraction *const one = &o->attractions[q];
        F += b != NULL
                 ? attraction_of_pair(one, a->material, b->material, a->R, b->R,
                                      gap, closing, 1.0 / a->m + 1.0 / b->m, dt)
                 : attraction_of_wall(one, a->R, gap, closing, 1.0 / a->m, dt);
    }
    if (F == 0.0) return;
    for (int k = 0; k < 3; k++) {
        const double F_k = F * x[k] / vector_length(x);
        a->all.F[k] += F_k;
        a->part[ENERGY_ATTRACTIONS].F[k] += F_k;
        if (b == NULL) continue;
        b->all.F[k] -= F_k;
        b->part[ENERGY_ATTRACTIONS].F[k] -= F_k;
    }
}

static void reference_add_pair(struct reference *r, int i, int j, double dt)
{
    struct sphere *const a = &r->sphere[i], *const b = &r->sphere[j];
    double x[3];

    if (a->clump >= 0 && a->clump == b->clump) return;
    for (int k = 0; k < 3; k++)
        x[k] = box_domain_nearest(&r->box, k, a->x[k] - b->x[k]);
    const double gap = vector_length(x) - a->R - b->R;
    if (gap < 0.0) add_contact(r, i, j, x, dt);
    reference_add_attractions(r, a, b, x, gap, dt);
}

/* x points from the sphere behind the wall, which touches the wall, so that
 * even a particle whose centre has passed the wall is pushed back. */
static void reference_add_wall(struct reference *r, int i, int w, double dt)
{
    struct sphere *const a = &r->sphere[i];
    const double gap = box_domain_gap(&r->box, w, a->x) - a->R;
    double x[3] = {0.0, 0.0, 0.0};

    x[w / 2] = (w % 2 ? -1.0 : 1.0) * (gap + 2.0 * a->R);
    if (gap < 0.0) add_contact(r, i, -1 - w, x, dt);
    reference_add_attractions(r, a, NULL, x, gap, dt);
}

/* The partners of sphere i with a larger index. */
static void reference_add_partners(struct reference *r, int i, double dt)
{
    int cell[LINK_CELLS_AROUND];

    if (r->cells == NULL) {
        for (int j = i + 1; j < r->n; j++)
            reference_add_pair(r, i, j, dt);
        return;
    }
    const int n = link_cells_around(r->cells, r->sphere[i].x, cell);
    for (int c = 0; c < n; c++)
        for (int j = r->cells->head[cell[c]]; j >= 0; j = r->cells->next[j])
            if (j > i) reference_add_pair(r, i, j, dt);
}

/* Puts every sphere into its cell; cells are as wide as the widest one and
 * the range. */
static void sort_into_cells(struct reference *r)
{
    double widest = 0.0;

    for (int i = 0; i < r->n; i++)
        widest = fmax(widest, 2.0 * r->sphere[i].R);
    link_cells_clear(r->cells, widest + dem_range(r->options));
    for (int i = 0; i < r->n; i++)
        link_cells_add(r->cells, i, r->sphere[i].x);
    r->sorts++;
}

void reference_forces(struct reference *r, double dt)
{
    const struct histories swap = r->before;

    if (r->no_contacts) return;
    r->before = r->now;
    r->now = swap;
    r->now.n = 0;
    r->energy->normal = r->energy->tangential = 0.0;
    for (int i = 0; i < r->n; i++) {
        memset(&r->sphere[i].all, 0, sizeof r->sphere[i].all);
        memset(r->sphere[i].part, 0, sizeof r->sphere[i].part);
    }
    if (r->cells != NULL && r->n > 0) sort_into_cells(r);
    for (int i = 0; i < r->n; i++) {
        r->now.start[i] = r->now.n;
        for (int w = 0; w < 6; w++)
            if (!r->box.periodic[w / 2]) reference_add_wall(r, i, w, dt);
        reference_add_partners(r, i, dt);
    }
    for (int i = r->n; i <= r->capacity; i++)
        r->now.start[i] = r->now.n;
}

struct dem_crossing reference_crossing(const struct reference *r, double dt)
{
    double least = HUGE_VAL;

    for (int i = 0; i < r->n && !r->no_contacts; i++)
        least = fmin(least, r->sphere[i].R);
    for (int i = 0; i < r->n; i++) {
        const struct sphere *const a = &r->sphere[i];
        if (vector_length(a->v) * dt <= least) continue;
        for (int j = 0; j < r->n; j++) {
            const struct sphere *const b = &r->sphere[j];
            if (j != i &&
                crossing(&r->box, a->x, b->x, a->v, b->v, dt, a->R + b->R))
                return (struct dem_crossing){1, {r->id[i], r->id[j]}};
        }
    }
    return (struct dem_crossing){0};
}

/* --- clumps --------------------------------------------------------------- */

void reference_put_balls(struct reference *r)
{
    const struct clumps *const l = r->clumps;

    for (int c = 0; l != NULL && c < l->n; c++) {
        const struct clump *const one = &l->item[c];
        const struct clump_pose at = clumps_pose(one);
        for (int k = 0; k < l->shape[one->shape].n; k++) {
            struct sphere *const s = &r->sphere[l->index[one->first + k]];
            double arm[3];
            clumps_ball(l, one, &at, k, arm, s->v);
            vector_along(one->x, 1.0, arm, s->x);
            memcpy(s->w, at.w, sizeof s->w);
        }
    }
}

void reference_kick_clumps(struct reference *r, double dt)
{
    for (int c = 0; r->clumps != NULL && c < r->clumps->n; c++) {
        struct clump *const one = &r->clumps->item[c];
        double F[3] = {0.0}, T[3] = {0.0};

        for (int k = 0; k < r->clumps->shape[one->shape].n; k++) {
            const struct sphere *const s =
                &r->sphere[r->clumps->index[one->first + k]];
            double all[3], arm[3], turn[3];
            vector_along(s->all.F, 1.0, s->external, all);
            reference_arm(r, one, s, arm);
            vector_cross(arm, all, turn);
            vector_along(F, 1.0, all, F);
            vector_along(T, 1.0, turn, T);
            vector_along(T, 1.0, s->all.T, T);
        }
        clumps_kick(one, F, T, dt);
    }
}

/* --- lost ----------------------------------------------------------------- */

/* A particle is lost when it is wholly outside or not finite; a comparison with
 * NaN is false. What cannot move is where it was placed. */
static int reference_is_lost(const struct reference *r, const struct sphere *s)
{
    for (int w = 0; w < 6; w++) {
        const double gap = box_domain_gap(&r->box, w, s->x);
        const int may = r->box.periodic[w / 2] || s->m > immovable;
        if (!(may ? fabs(gap) < HUGE_VAL : gap >= -s->R)) return 1;
    }
    return !(vector_length(s->v) + vector_length(s->w) < HUGE_VAL);
}

/* Returns the number of lost particles, and reports the first. */
int reference_check_lost(const struct reference *r, struct dem_report *report)
{
    report->lost = 0;
    report->lost_id = report->lost_through = -1;
    for (int i = 0; i < r->n; i++) {
        if (!reference_is_lost(r, &r->sphere[i]) || report->lost++ > 0)
            continue;
        report->lost_id = r->id[i];
        memcpy(report->lost_at, r->sphere[i].x, sizeof report->lost_at);
    }
    return report->lost;
}
