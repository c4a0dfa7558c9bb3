/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fast_clumps.c -- the motion of clumps (clumps.h).
 *
 * When all loads of a step are known, those of the balls of a clump are added
 * in the order of its balls, the clump moves, and the rows of its balls are
 * written anew. The clumps are divided into slices; which thread moves one
 * changes no bit. */
#include "dem/fast/neighbours.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

static struct chunk_range fast_clumps_in(const struct clumps *l, int slice)
{
    return (struct chunk_range){
        (int)((long)l->n * slice / FAST_CLUMPS_SLICES),
        (int)((long)l->n * (slice + 1) / FAST_CLUMPS_SLICES)};
}

void fast_clumps_locate(struct neighbours *nb)
{
    const struct particles *const ps = nb->ps;
    struct rows *const b = nb->rows;

    if (ps->clumps == NULL) return;
    if (b->ball == NULL) {
        b->ball = owner_zeroed(b, (size_t)ps->capacity, sizeof *b->ball);
        b->clump =
            owner_zeroed(b, (size_t)ps->clumps->capacity, sizeof *b->clump);
        nb->clump_speed =
            owner_zeroed(nb, FAST_CLUMPS_SLICES, sizeof *nb->clump_speed);
    }
    clumps_locate(ps);
    for (int i = 0; i < ps->n; i++)
        b->ball[i].of = ps->clumps->of[ps->id[i]];
}

/* So many clumps side by side, with numbers in columns: loops over them become
 * vectors, with the bits of clumps_drift and clumps_pose. */
enum { TOGETHER = 8 };

struct clumps_together {
    double q[4][TOGETHER], L[3][TOGETHER], own[3][TOGETHER];
    double Q[9][TOGETHER], w[3][TOGETHER], per_I[6][TOGETHER];
};

static void together_gather(struct clumps_together *t, const struct clump *c,
                            int n)
{
    for (int i = 0; i < TOGETHER; i++) {
        const struct clump *const one = &c[i < n ? i : 0];
        for (int k = 0; k < 4; k++)
            t->q[k][i] = one->q[k];
        for (int k = 0; k < 3; k++) {
            t->L[k][i] = one->L[k];
            t->own[k][i] = one->per_I[k];
        }
    }
}

static void together_turn(struct clumps_together *t, double dt)
{
    for (int i = 0; i < TOGETHER; i++) {
        const double L[3] = {t->L[0][i], t->L[1][i], t->L[2][i]};
        const double own[3] = {t->own[0][i], t->own[1][i], t->own[2][i]};
        double q[4] = {t->q[0][i], t->q[1][i], t->q[2][i], t->q[3][i]};
        rotation_advance(q, L, own, dt);
        for (int k = 0; k < 4; k++)
            t->q[k][i] = q[k];
    }
}

static void together_pose(struct clumps_together *t)
{
    for (int i = 0; i < TOGETHER; i++) {
        const double q[4] = {t->q[0][i], t->q[1][i], t->q[2][i], t->q[3][i]};
        const double L[3] = {t->L[0][i], t->L[1][i], t->L[2][i]};
        const double own[3] = {t->own[0][i], t->own[1][i], t->own[2][i]};
        struct clump_pose at;
        clumps_pose_of(q, L, own, &at);
        for (int k = 0; k < 9; k++)
            t->Q[k][i] = at.Q[k / 3][k % 3];
        for (int k = 0; k < 3; k++)
            t->w[k][i] = at.w[k];
        for (int k = 0; k < 6; k++)
            t->per_I[k][i] = at.per_I[k];
    }
}

/* The rows of the balls of a clump, number i of those together; raises the
 * largest |v_x|, |v_y|, |v_z|. */
static void fast_clumps_write_one(struct neighbours *nb,
                                  const struct clumps_together *t, int i,
                                  int number, double top[3])
{
    const struct clumps *const l = nb->ps->clumps;
    const struct clump *const c = &l->item[number];
    struct rows *const b = nb->rows;
    struct clump_pose at;

    for (int k = 0; k < 9; k++)
        at.Q[k / 3][k % 3] = t->Q[k][i];
    for (int k = 0; k < 3; k++)
        at.w[k] = t->w[k][i];
    b->clump[number].per_m = 1.0 / c->m;
    for (int k = 0; k < 6; k++)
        b->clump[number].per_I[k] = t->per_I[k][i];
    for (int k = 0; k < l->shape[c->shape].n; k++) {
        const int row = l->index[c->first + k];
        struct row_motion *const m = &b->motion[row];
        struct row_place *const place = &b->place[row];
        double r[3], v[3];
        clumps_ball(l, c, &at, k, r, v);
        for (int e = 0; e < 3; e++) {
            const double speed = fabs(v[e]);
            b->ball[row].arm[e] = r[e];
            place->x[e] = box_domain_inside(&b->box, e, c->x[e] + r[e]);
            m->v[e] = v[e];
            m->s[e] = place->R * at.w[e];
            if (speed > top[e]) top[e] = speed;
        }
    }
}

/* Clumps first to last - 1 move freely for `drift` [s]; their balls follow. */
static void fast_clumps_move(struct neighbours *nb, int first, int last,
                             double drift, double top[3])
{
    struct clump *const c = nb->ps->clumps->item;
    struct clumps_together t;

    together_gather(&t, &c[first], last - first);
    if (drift > 0.0) together_turn(&t, drift);
    together_pose(&t);
    for (int i = 0; i < last - first; i++) {
        for (int k = 0; k < 4; k++)
            c[first + i].q[k] = t.q[k][i];
        if (drift > 0.0) clumps_move(&c[first + i], &nb->rows->box, drift);
        fast_clumps_write_one(nb, &t, i, first + i, top);
    }
}

void fast_clumps_drift(struct neighbours *nb, double drift)
{
    const struct chunk_range mine = neighbours_part(FAST_CLUMPS_SLICES);

    for (int s = mine.first; s < mine.last; s++) {
        const struct chunk_range in = fast_clumps_in(nb->ps->clumps, s);
        memset(nb->clump_speed[s], 0, sizeof nb->clump_speed[s]);
        for (int c = in.first; c < in.last; c += TOGETHER)
            fast_clumps_move(nb, c,
                             c + TOGETHER < in.last ? c + TOGETHER : in.last,
                             drift, nb->clump_speed[s]);
    }
    neighbours_barrier(nb);
}

void fast_clumps_write(struct neighbours *nb)
{
    if (nb->ps->clumps == NULL) return;
    neighbours_barrier(nb);
    fast_clumps_drift(nb, 0.0);
}

/* The load of a clump, and that of all that is not a contact. */
static void fast_clumps_load(const struct neighbours *nb, const struct clump *c,
                             double F[3], double T[3])
{
    const struct particles *const ps = nb->ps;
    const struct rows *const b = nb->rows;

    for (int k = 0; k < 3; k++)
        F[k] = T[k] = 0.0;
    for (int k = 0; k < ps->clumps->shape[c->shape].n; k++) {
        const int i = ps->clumps->index[c->first + k];
        const struct chunk *const s = neighbours_chunk_of(nb, i);
        const struct row_load *const load = &s->load[i - s->begin];
        const double all[3] = {load->F[0] + ps->ex[i], load->F[1] + ps->ey[i],
                               load->F[2] + ps->ez[i]};
        double turn[3];
        vector_cross(b->ball[i].arm, all, turn);
        for (int e = 0; e < 3; e++) {
            F[e] += all[e];
            T[e] += turn[e] - b->place[i].R * load->turn[e];
        }
    }
}

void fast_clumps_kick(struct neighbours *nb, double kick, int budget)
{
    const struct chunk_range mine = neighbours_part(FAST_CLUMPS_SLICES);
    const struct clumps *const l = nb->ps->clumps;

    for (int s = mine.first; s < mine.last; s++) {
        const struct chunk_range in = fast_clumps_in(l, s);
        for (int c = in.first; c < in.last; c++) {
            double F[3], T[3];
            fast_clumps_load(nb, &l->item[c], F, T);
            clumps_kick(&l->item[c], F, T, kick);
        }
    }
    if (budget) fast_clumps_drift(nb, 0.0);
}
