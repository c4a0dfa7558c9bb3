/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fast_clumps.c -- the motion of clumps (clumps.h).
 *
 * When all loads of a step are known, those of the balls of a clump are added
 * in the order of its balls, the clump moves, and the rows of its balls are
 * written anew. The clumps are divided into slices; which thread moves one
 * changes no bit. */
#include "dem/fast/neighbours.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

/* The clumps of this thread. */
static struct chunk_range fast_clumps_slices(void)
{
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();

    return (struct chunk_range){FAST_CLUMPS_SLICES * thread / threads,
                                FAST_CLUMPS_SLICES * (thread + 1) / threads};
}

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
        b->ball = alloc_zeroed((size_t)ps->capacity, sizeof *b->ball);
        b->clump = alloc_zeroed((size_t)ps->clumps->capacity, sizeof *b->clump);
        nb->clump_speed =
            alloc_zeroed(FAST_CLUMPS_SLICES, sizeof *nb->clump_speed);
    }
    clumps_locate(ps);
    for (int i = 0; i < ps->n; i++)
        b->ball[i].of = ps->clumps->of[ps->id[i]];
}

/* The rows of the balls of one clump; raises the largest |v_x|, |v_y|, |v_z|.
 */
static void fast_clumps_write_one(struct neighbours *nb, int number,
                                  double top[3])
{
    const struct clumps *const l = nb->ps->clumps;
    const struct clump *const c = &l->item[number];
    const struct clump_pose at = clumps_pose(c);
    struct rows *const b = nb->rows;

    b->clump[number].per_m = 1.0 / c->m;
    memcpy(b->clump[number].per_I, at.per_I, sizeof at.per_I);
    for (int k = 0; k < l->shape[c->shape].n; k++) {
        const int i = l->index[c->first + k];
        struct row_motion *const m = &b->motion[i];
        double *const r = b->ball[i].arm;
        clumps_ball(l, c, &at, k, r, m->v);
        for (int e = 0; e < 3; e++) {
            b->place[i].x[e] = box_domain_inside(&b->box, e, c->x[e] + r[e]);
            m->s[e] = b->place[i].R * at.w[e];
            top[e] = fmax(top[e], fabs(m->v[e]));
        }
    }
}

static void fast_clumps_put(struct neighbours *nb)
{
    const struct chunk_range mine = fast_clumps_slices();

    for (int s = mine.first; s < mine.last; s++) {
        const struct chunk_range in = fast_clumps_in(nb->ps->clumps, s);
        memset(nb->clump_speed[s], 0, sizeof nb->clump_speed[s]);
        for (int c = in.first; c < in.last; c++)
            fast_clumps_write_one(nb, c, nb->clump_speed[s]);
    }
    neighbours_barrier(nb);
}

void fast_clumps_write(struct neighbours *nb)
{
    if (nb->ps->clumps == NULL) return;
    neighbours_barrier(nb);
    fast_clumps_put(nb);
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
    const struct chunk_range mine = fast_clumps_slices();
    const struct clumps *const l = nb->ps->clumps;

    for (int s = mine.first; s < mine.last; s++) {
        const struct chunk_range in = fast_clumps_in(l, s);
        for (int c = in.first; c < in.last; c++) {
            double F[3], T[3];
            fast_clumps_load(nb, &l->item[c], F, T);
            clumps_kick(&l->item[c], F, T, kick);
        }
    }
    if (budget) fast_clumps_put(nb);
}

void fast_clumps_drift(struct neighbours *nb, double drift)
{
    const struct chunk_range mine = fast_clumps_slices();
    const struct clumps *const l = nb->ps->clumps;

    for (int s = mine.first; s < mine.last && drift > 0.0; s++) {
        const struct chunk_range in = fast_clumps_in(l, s);
        for (int c = in.first; c < in.last; c++)
            clumps_drift(&l->item[c], &nb->rows->box, drift);
    }
    fast_clumps_put(nb);
}
