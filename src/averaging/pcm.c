/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pcm.c -- the particle-centroid method: a particle counts wholly in the cell
 * of its centre.
 * Chapter "Averaging".
 *
 *     eps_s,c = (1 / V_c) sum of the V_p of the particles whose centre is in c
 *                                                   [XS11 3.1, SX15 4, 7, 8]
 *
 * With a cap only the fraction s_c = min(1, cap / eps_s,c) of the volume of
 * every particle in c is used. Spreading and gathering are unchanged: the
 * caller reduces the volumes (averaging_apply_cap) and all amounts proportional
 * to volume, but not the drag, whose reaction must act on the fluid completely.
 * Thus eps_s <= cap, and the mean velocity of a cell (momentum over volume) is
 * unchanged. The volume above the cap is missing in eps_s: the report gives the
 * number of cells and the volume.
 */
#include <stdio.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"
#include "base/alloc.h"

struct pcm {
    const struct cell_of_particle *h; /* borrowed */
    double cap;                       /* [-] on eps_s, 0: none */
    double *capped_fraction; /* [-] fraction of the solids within the cap; NULL
                                without a cap */
};

static void *pcm_create(const struct cell_of_particle *h,
                        const struct averaging_options *o)
{
    if (!(o->cap >= 0.0 && o->cap <= 1.0)) {
        fprintf(stderr,
                "winnow: the cap on eps_s is %g; expected 0 (none) to 1 [-]\n",
                o->cap);
        return NULL;
    }
    struct pcm *const p = owner_create(sizeof *p);

    p->h = h;
    p->cap = o->cap;
    if (p->cap > 0.0) p->capped_fraction = owner_doubles(p, h->mesh->n_cells);
    return p;
}

/* [m^3] of solids in cell c. */
static double solids(const struct cell_of_particle *h, int c)
{
    double sum = 0.0;

    for (int a = h->start[c]; a < h->start[c + 1]; a++)
        sum += particles_volume(h->ps, h->particle[a]);
    return sum;
}

static void pcm_bind(void *state, struct averaging_report *r)
{
    struct pcm *const p = state;

    if (p->capped_fraction == NULL) return;
    for (int c = 0; c < p->h->mesh->n_cells; c++) {
        const double V_s = solids(p->h, c);
        const double limit = p->cap * p->h->mesh->V[c];
        p->capped_fraction[c] = V_s > limit ? limit / V_s : 1.0;
        if (!(V_s > limit)) continue;
        r->capped++;
        r->lost_volume += V_s - limit;
    }
}

static void pcm_spread(void *state, int m, const double *q, double *field,
                       struct averaging_report *r)
{
    const struct pcm *const p = state;

    (void)r;
    cell_of_particle_sum(p->h, m, q, field);
}

static void pcm_gather(void *state, int m, const double *field, double *q,
                       struct averaging_report *r)
{
    const struct pcm *const p = state;

    (void)r;
    cell_of_particle_value(p->h, m, field, q);
}

static double pcm_capped_fraction(const void *state, int i)
{
    const struct pcm *const p = state;
    return p->capped_fraction == NULL ? 1.0 : p->capped_fraction[p->h->cell[i]];
}

static const struct key cap_keys[] = {
    {"averaging.cap", KEY_REAL, "-", "> 0, <= 1", KEY_OPTIONAL,
     "largest solid fraction of a cell with "
     "pcm; the volume above it is counted",
     "SX15 4", "", KEY_AT(averaging_options, cap)},
    KEY_END};

const struct averaging_method pcm_method = {
    .name = "pcm",
    .what = "each particle belongs to the cell of its centre",
    .equations = "XS11 3.1, SX15 4, 7, 8",
    .function = "pcm_spread",
    .keys = {cap_keys},
    .create = pcm_create,
    .free = owner_free,
    .bind = pcm_bind,
    .spread = pcm_spread,
    .gather = pcm_gather,
    .capped_fraction = pcm_capped_fraction,
};
