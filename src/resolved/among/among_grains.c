/* SPDX-License-Identifier: GPL-3.0-or-later */
/* among_grains.c -- bodies in a bed of particles: their surfaces mirror what is
 * averaged, and push and are pushed. */
#include "resolved/among/among_grains.h"

#include "averaging/averaging.h"
#include "base/alloc.h"
#include "base/number.h"
#include "dem/box_domain.h"
#include "resolved/body_cells.h"
#include "resolved/mark.h"
#include "resolved/body_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- mirrors -------------------------------------------------------------- */

/* The surface of the bodies as a wall to the averaging.
 *
 * What a method of averaging puts into a cell of a body, at the depth s below
 * its surface, is moved out to the place as far before it, its mirror image: at
 * a plane wall nothing would then flow through the surface [SX15 5c]. Sums of
 * volume, momentum and force stay [SX15 A.1]. A field is continued into the
 * body by the same weights: an image has the value of what it mirrors. */

enum { CORNERS = 8 };

/* A cell in a body, and the open cells around its mirror image. */
struct mirror {
    int cell, n;
    int to[CORNERS];
    double w[CORNERS]; /* [-] sum 1 */
};

struct mirrors {
    struct averaging_wall wall; /* first, because the averaging gives it back */
    const struct mesh *mesh;    /* borrowed */
    const struct solid_bodies *b;
    struct mirror *list;
    int n, room, stuck;
    char *closed;     /* [-] of each cell: 1 in a body */
    double *extended; /* a field, continued; 8 a cell at most */
    int width;        /* [-] numbers a cell that there is room for */
};

static void move_out(const struct averaging_wall *self, int m, double *field)
{
    const struct mirrors *const all = (const struct mirrors *)self;
    const double *const V = all->mesh->V;

    for (int j = 0; j < all->n; j++) {
        const struct mirror *const one = &all->list[j];
        double *const from = &field[m * one->cell];
        for (int e = 0; e < one->n; e++) {
            const double share = one->w[e] * V[one->cell] / V[one->to[e]];
            for (int k = 0; k < m; k++)
                field[m * one->to[e] + k] += share * from[k];
        }
        for (int k = 0; k < m; k++)
            from[k] = 0.0;
    }
}

static const double *extend(struct averaging_wall *self, int m,
                            const double *field)
{
    struct mirrors *const all = (struct mirrors *)self;
    const int cells = all->mesh->n_cells;

    if (m > all->width) {
        free(all->extended);
        all->width = m;
        all->extended = alloc_doubles(m * cells);
    }
    memcpy(all->extended, field,
           (size_t)m * (size_t)cells * sizeof *all->extended);
    for (int j = 0; j < all->n; j++) {
        const struct mirror *const one = &all->list[j];
        for (int k = 0; k < m; k++) {
            double sum = 0.0;
            for (int e = 0; e < one->n; e++)
                sum += one->w[e] * field[m * one->to[e] + k];
            all->extended[m * one->cell + k] = sum;
        }
    }
    return all->extended;
}

static struct mirrors *mirrors_create(const struct solid_bodies *b,
                                      const struct mesh *mesh)
{
    struct mirrors *const m = owner_zeroed(b->among, 1, sizeof *m);

    m->wall = (struct averaging_wall){.move_out = move_out, .extend = extend};
    m->mesh = mesh;
    m->b = b;
    m->closed = owner_zeroed(b->among, (size_t)mesh->n_cells, 1);
    return m;
}

int mirrors_stuck(const struct mirrors *m)
{
    return m->stuck;
}

/* The eight cells whose centres lie around x, at weights that make linear
 * fields exact; those beyond a wall of the mesh count as the last before it.
 * Closed ones are left out. Returns the sum of the weights. */
static double weigh(const struct mirrors *all, const double x[3],
                    struct mirror *one)
{
    const struct box *const b = &all->mesh->box;
    int low[3];
    double share[3], sum = 0.0;

    for (int k = 0; k < 3; k++) {
        const double h = (b->edge[k][b->n[k]] - b->edge[k][0]) / b->n[k];
        const double at = (x[k] - b->edge[k][0]) / h - 0.5;
        low[k] = number_clamped(floor(at), -b->n[k], 2 * b->n[k]);
        share[k] = at - low[k];
    }
    one->n = 0;
    for (int corner = 0; corner < CORNERS; corner++) {
        int in[3];
        double w = 1.0;
        for (int k = 0; k < 3; k++) {
            const int up = corner >> k & 1, n = b->n[k];
            in[k] = low[k] + up;
            w *= up ? share[k] : 1.0 - share[k];
            if (b->periodic[k])
                in[k] = (in[k] % n + n) % n;
            else
                in[k] = in[k] < 0 ? 0 : in[k] >= n ? n - 1 : in[k];
        }
        const int c = in[0] + b->n[0] * (in[1] + b->n[1] * in[2]);
        if (w <= 0.0 || all->closed[c]) continue;
        one->to[one->n] = c;
        one->w[one->n++] = w;
        sum += w;
    }
    return sum;
}

/* Where no cell around the image is open, the next one farther out. */
static void add_mirror(struct mirrors *all, int c,
                       const struct body_shape *shape, const double centre[3],
                       const double r[3], double s)
{
    const double h = cbrt(all->mesh->V[c]), far = 4.0 * (h - s);
    struct mirror *const one = &all->list[all->n++];
    double n[3], x[3], sum = 0.0;

    body_shape_normal(shape, r, n);
    for (double way = -2.0 * s; sum <= 1e-3 && way < far; way += 0.5 * h) {
        for (int k = 0; k < 3; k++)
            x[k] = centre[k] + r[k] + way * n[k];
        sum = weigh(all, x, one);
    }
    one->cell = c;
    for (int e = 0; e < one->n; e++)
        one->w[e] /= sum;
    if (one->n > 0) return;
    all->n--;
    all->stuck++;
}

static void close_cell(void *by, int i, int c, const double r[3], double s)
{
    (void)i, (void)r;
    if (s <= 0.0) ((struct mirrors *)by)->closed[c] = 1;
}

/* A closed cell gets one mirror, of the first body around it. */
static void mirror_cell(void *by, int i, int c, const double r[3], double s)
{
    struct mirrors *const all = by;
    const struct solid_bodies *const b = all->b;
    const double x[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};

    if (s > 0.0 || all->closed[c] != 1) return;
    all->list = alloc_room(all->list, all->n, &all->room, sizeof *all->list);
    all->closed[c] = 2;
    add_mirror(all, c, &b->shape[i], x, r, s);
}

/* The bodies have moved. */
static void mirrors_update(struct mirrors *m)
{
    memset(m->closed, 0, (size_t)m->mesh->n_cells);
    m->n = m->stuck = 0;
    for (int i = 0; i < m->b->ps->n; i++)
        body_cells_each(m->b, m->mesh, i, 0.0, close_cell, m);
    for (int i = 0; i < m->b->ps->n; i++)
        body_cells_each(m->b, m->mesh, i, HUGE_VAL, mirror_cell, m);
}

/* --- among grains --------------------------------------------------------- */

/* Particle steps between two of a body: so few that the springs of all grains
 * around it do not throw it back and forth. */
enum { STEPS_TOGETHER = 5 };

static void take_pose(struct solid_bodies *b, int i, double t)
{
    const struct particles *const ps = b->ps;
    struct carrier *const c = &b->among->carrier[i];

    c->t = t;
    c->pose.centre[0] = ps->x[i], c->pose.centre[1] = ps->y[i];
    c->pose.centre[2] = ps->z[i];
    c->pose.velocity[0] = ps->vx[i], c->pose.velocity[1] = ps->vy[i];
    c->pose.velocity[2] = ps->vz[i];
    c->pose.spin[0] = ps->wx[i], c->pose.spin[1] = ps->wy[i];
    c->pose.spin[2] = ps->wz[i];
    if (b->shape[i].kind == BODY_OUTLINE)
        memcpy(c->pose.rotation, b->shape[i].turn, sizeof c->pose.rotation);
}

/* At rest until the run begins, though it may begin with a velocity: the bed
 * settles before. */
static void among_grains_place(struct solid_bodies *b, int i)
{
    struct pose *const p = &b->among->carrier[i].pose;

    take_pose(b, i, 0.0);
    memset(p->velocity, 0, sizeof p->velocity);
    memset(p->spin, 0, sizeof p->spin);
    memcpy(p->start, p->centre, sizeof p->start);
    for (int k = 0; k < 3; k++)
        p->rotation[k][k] = 1.0;
}

void among_grains_free(struct among_grains *g)
{
    if (g != NULL && g->mirrors != NULL) {
        free(g->mirrors->list);
        free(g->mirrors->extended);
    }
    owner_free(g);
}

void among_grains_state(struct solid_bodies *b, struct state *s)
{
    struct among_grains *const g = b->among;
    const int n = b->ps->n;

    state_reals(s, "impulse_of_grains", "N s", g->impulse[0], n, 3);
    state_reals(s, "angular_of_grains", "N m s", g->angular[0], n, 3);
    state_reals(s, "force_of_grains", "N", g->pushed[0], n, 3);
    state_reals_of(s, "time", "s", &g->carrier->t, sizeof *g->carrier, n, 1);
    if (!s->loading || s->failed) return;
    for (int i = 0; i < n; i++)
        take_pose(b, i, g->carrier[i].t);
    if (g->mirrors != NULL) mirrors_update(g->mirrors);
}

void among_grains_create(struct solid_bodies *b, int first)
{
    const size_t n = (size_t)b->ps->n;
    struct among_grains *const g = b->among = owner_create(sizeof *g);

    g->first = first;
    g->carrier = owner_zeroed(g, n, sizeof *g->carrier);
    g->surface = owner_zeroed(g, n, sizeof *g->surface);
    g->impulse = owner_zeroed(g, n, sizeof *g->impulse);
    g->angular = owner_zeroed(g, n, sizeof *g->angular);
    g->pushed = owner_zeroed(g, n, sizeof *g->pushed);
    g->held = owner_doubles(g, 3 * b->ps->n);
    for (int i = 0; i < b->ps->n; i++) {
        among_grains_place(b, i);
        g->surface[i] = body_surface(g, b, i);
        g->surface[i].motion.carrier = &g->carrier[i];
    }
}

void among_grains_begin(struct solid_bodies *b, struct simulation *sim)
{
    struct among_grains *const g = b->among;

    g->grains = sim->dem;
    for (int i = 0; i < b->ps->n; i++)
        take_pose(b, i, 0.0);
    if (sim->averaging == NULL) return;
    g->mirrors = mirrors_create(b, sim->mesh);
    averaging_set_wall(sim->averaging, &g->mirrors->wall);
    mirrors_update(g->mirrors);
}

void among_grains_set_forces(void *bodies, struct simulation *sim)
{
    struct solid_bodies *const b = bodies;
    struct particles *const ps = b->ps;
    struct among_grains *const g = b->among;

    body_motion_set_forces(b, sim->dt);
    for (int i = 0; i < ps->n; i++) {
        const double e[3] = {ps->ex[i], ps->ey[i], ps->ez[i]};
        memcpy(&g->held[3 * i], e, sizeof e);
        memset(g->pushed[i], 0, sizeof g->pushed[i]);
    }
}

/* What the grains gave body i in a time dt [s] of a step of the fluid that
 * takes `step` [s]: a force for its own motion, and a change of its spin. */
static void take_push(struct solid_bodies *b, int i, double dt, double step)
{
    struct among_grains *const g = b->among;
    struct particles *const ps = b->ps;
    const struct dem_surface now = dem_surface(g->grains, g->first + i);
    double *const e[3] = {&ps->ex[i], &ps->ey[i], &ps->ez[i]};
    double turn[3];

    for (int k = 0; k < 3; k++) {
        const double J = now.impulse[k] - g->impulse[i][k];
        turn[k] = now.angular[k] - g->angular[i][k];
        g->impulse[i][k] = now.impulse[k];
        g->angular[i][k] = now.angular[k];
        g->pushed[i][k] += J / step;
        if (body_motion_moves_along(b, i, k))
            *e[k] = g->held[3 * i + k] + J / dt;
    }
    body_motion_add_spin(b, i, turn);
}

/* 1 if a body has come back into the box at its other end. */
static int take_poses(struct solid_bodies *b, double t)
{
    const struct box_domain box =
        box_domain_of(b->contacts.lo, b->contacts.hi, b->contacts.periodic);
    int jumped = 0;

    for (int i = 0; i < b->ps->n; i++) {
        const double *const c = b->among->carrier[i].pose.centre;
        const double old[3] = {c[0], c[1], c[2]};
        take_pose(b, i, t);
        for (int k = 0; k < 3; k++)
            jumped |= box.periodic[k] &&
                      fabs(c[k] - old[k]) > 0.5 * (box.hi[k] - box.lo[k]);
    }
    return jumped;
}

/* Of several runs the deepest overlap and all rebuilds. */
static void add_report(struct dem_report *all, const struct dem_report *one)
{
    const struct dem_report before = *all;

    *all = *one;
    all->steps += before.steps;
    all->rebuilds += before.rebuilds;
    all->max_overlap = fmax(one->max_overlap, before.max_overlap);
}

int among_grains_run(void *bodies, struct simulation *sim, int steps)
{
    struct solid_bodies *const b = bodies;
    const double step = sim->dt / sim->dem_steps;
    struct dem_report all = {0};
    int failed = 0;

    for (int done = 0; done < steps && !failed;) {
        const int n =
            steps - done < STEPS_TOGETHER ? steps - done : STEPS_TOGETHER;
        struct dem_report one;
        failed = dem_run(sim->dem, n, &one);
        add_report(&all, &one);
        for (int i = 0; i < b->ps->n; i++)
            take_push(b, i, n * step, sim->dt);
        if (!failed && b->moves) failed = body_motion_run(b, n, step);
        const double t =
            b->ps->n > 0 ? dem_surface(sim->dem, b->among->first).t : 0.0;
        if (take_poses(b, t)) dem_changed(sim->dem);
        done += n;
    }
    sim->dem_report = all;
    return failed;
}

void among_grains_end(void *bodies, struct simulation *sim)
{
    struct solid_bodies *const b = bodies;

    (void)sim;
    if (b->moves) b->dt_marked = 0.0;
    if (b->moves && b->among->mirrors != NULL)
        mirrors_update(b->among->mirrors);
}

/* The last kick of a run gives the share `first` of it to the next run
 * (integrator.h). */
void among_grains_add_momentum(const struct solid_bodies *b, double total[3])
{
    const struct dem_options *const o = dem_created_with(b->among->grains);

    for (int i = 0; i < b->ps->n; i++) {
        if (b->motion[i] != BODY_FREE) continue;
        const struct dem_surface s =
            dem_surface(b->among->grains, b->among->first + i);
        for (int k = 0; k < 3; k++)
            total[k] -= o->integrator->first * o->step * s.force[k];
    }
}

int among_grains_has_room(const struct solid_bodies *b, const double x[3],
                          double R)
{
    const struct box_domain box =
        box_domain_of(b->contacts.lo, b->contacts.hi, b->contacts.periodic);

    for (int i = 0; i < b->ps->n; i++) {
        const double at[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};
        double r[3];
        for (int k = 0; k < 3; k++)
            r[k] = box_domain_nearest(&box, k, x[k] - at[k]);
        if (body_shape_distance(&b->shape[i], r) < R) return 0;
    }
    return 1;
}
