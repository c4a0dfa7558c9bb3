/* SPDX-License-Identifier: GPL-3.0-or-later */
/* dpvm.c -- a particle divided among the cells that it overlaps.
 * Chapter "Further averaging methods".
 *
 *     w_ic = |body_i and cell c| / sum_m |body_i and cell m|
 *
 * dpvm  the body is the sphere itself: the divided particle volume method
 *       [SX15 section 1, LS section 5.4]. The solid fraction of a cell never
 *       exceeds 1 unless particles overlap.
 * cube  the body is the cube around the sphere [EW18 section 2.4]: cheaper,
 *       and a little smoother.
 *
 * Exact for cells of any shape, also where they are smaller than the particle:
 * overlap.h for boxes, graded or periodic, facets.h for all others. The weights
 * are normalised, so the part of a body beyond a wall is distributed in the
 * same proportions.
 */
#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/kernel/weights.h"
#include "averaging/more/overlap.h"
#include "averaging/poly/facets.h"
#include "base/alloc.h"

/* --- weights that are computed once and stored
 *
 * The weights of a particle are few and take long to compute: they are computed
 * once after the particles have moved, and those that are not 0 are stored,
 * particle after particle in the order of their cells. */

struct stored_weights {
    int *start;        /* [-] the weights of particle h->particle[a] are */
    int *index_offset; /* [-] start[a] .. start[a + 1] - 1 of the cells */
    double *w;         /* [-] and of the weights */
    int capacity;      /* [-] of these two */
};

/* Makes room for n more weights after the first `used`. */
static void stored_weights_make_room(struct stored_weights *k, int used, int n)
{
    if (used + n <= k->capacity) return;
    k->capacity = 2 * (used + n);
    k->index_offset =
        alloc_grown(k->index_offset, used, k->capacity, sizeof(int));
    k->w = alloc_grown(k->w, used, k->capacity, sizeof(double));
}

/* Appends the weights that are not 0 after the first `used`, and returns how
 * many there are then. */
static int stored_weights_append(struct stored_weights *k, int used, int n,
                                 const int *index_offset, const double *w)
{
    stored_weights_make_room(k, used, n);
    for (int e = 0; e < n; e++) {
        if (w[e] == 0.0) continue;
        k->index_offset[used] = index_offset[e];
        k->w[used++] = w[e];
    }
    return used;
}

/* Computes the weights of all particles in the cells near theirs by a function
 * as weigh of the rule. Returns the number of those that were assigned to their
 * own cell alone. */
static int
stored_weights_fill(struct stored_weights *k, const struct cell_of_particle *h,
                    const struct weights *weights,
                    int (*weigh)(const void *state, int i,
                                 const struct neighbourhood *near, double *w))
{
    double *const w = alloc_doubles(weights_stencil(weights)->largest);
    int used = 0, unsupported = 0;

    for (int c = 0; c < h->mesh->n_cells; c++) {
        const struct neighbourhood near = weights_around(weights, c);
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            int n = near.n;
            if (!weigh(weights_state(weights), h->particle[a], &near, w)) {
                w[0] = n = 1;
                unsupported++;
            }
            k->start[a] = used;
            used = stored_weights_append(k, used, n, near.index_offset, w);
        }
    }
    k->start[h->n] = used;
    free(w);
    return unsupported;
}

/* --- the volumes that cells have of a body --- */

struct dpvm;

/* The body that is divided: how in cells that are boxes, and its kind for
 * others. */
struct body {
    void (*divide)(const struct dpvm *d, const struct neighbourhood *near,
                   const double o[3], double R, double *w);
    enum facets_body kind;
    double corner; /* [-] distance of its farthest point, over R */
};

struct dpvm {
    const struct cell_of_particle *h; /* borrowed */
    double reach;                     /* [m] to which cells are near */
    struct stored_weights stored;
    struct body body;
    double *half; /* [m] of a box: half extents of the cells, 3; infinite where
                     a period is one cell wide, because this cell contains the
                     whole body */
    struct facets *facets; /* of another mesh */
};

/* 1 if the body is wholly within its cell, as most are where cells are large. A
 * sphere and its cube have the same extent in each direction. */
static int dpvm_is_within(const double o[3], double R, const double half[3])
{
    return fabs(o[0]) + R <= half[0] && fabs(o[1]) + R <= half[1] &&
           fabs(o[2]) + R <= half[2];
}

/* The ends of entry e relative to the centre of particle i. */
static void dpvm_ends_of(const struct dpvm *d, const struct neighbourhood *near,
                         int e, const double o[3], double lo[3], double hi[3])
{
    const double *const half =
        &d->half[3 * (near->cell + near->index_offset[e])];
    const double at[3] = {near->dx[e] - o[0], near->dy[e] - o[1],
                          near->dz[e] - o[2]};

    for (int k = 0; k < 3; k++) {
        lo[k] = at[k] - half[k];
        hi[k] = at[k] + half[k];
    }
}

static int reaches(double R, const double lo[3], const double hi[3])
{
    return lo[0] < R && hi[0] > -R && lo[1] < R && hi[1] > -R && lo[2] < R &&
           hi[2] > -R;
}

/* The volumes that the entries have of the sphere; in very small cells each for
 * itself. */
static void divide_sphere(const struct dpvm *d,
                          const struct neighbourhood *near, const double o[3],
                          double R, double *w)
{
    struct overlap_grid g;
    double lo[3], hi[3];
    int few = 1;

    overlap_grid_start(&g, R);
    for (int e = 0; e < near->n && few; e++) {
        dpvm_ends_of(d, near, e, o, lo, hi);
        if (reaches(R, lo, hi)) few = overlap_grid_add(&g, lo, hi);
    }
    if (few) overlap_grid_prepare(&g);
    for (int e = 0; e < near->n; e++) {
        dpvm_ends_of(d, near, e, o, lo, hi);
        w[e] = !reaches(R, lo, hi) ? 0.0
               : few               ? overlap_grid_cell(&g, lo, hi)
                                   : overlap_sphere(R, lo, hi);
    }
}

static void divide_cube(const struct dpvm *d, const struct neighbourhood *near,
                        const double o[3], double R, double *w)
{
    for (int e = 0; e < near->n; e++) {
        double lo[3], hi[3];
        dpvm_ends_of(d, near, e, o, lo, hi);
        w[e] = overlap_cube(R, lo, hi);
    }
}

/* For cells of any shape. */
static void divide_anywhere(const struct dpvm *d,
                            const struct neighbourhood *near, const double o[3],
                            double R, double *w)
{
    for (int e = 0; e < near->n; e++) {
        const double from[3] = {o[0] - near->dx[e], o[1] - near->dy[e],
                                o[2] - near->dz[e]};
        w[e] = facets_overlap(d->facets, d->body.kind,
                              near->cell + near->index_offset[e], from, R);
    }
}

/* The rule. If the centre lies outside a curved wall (by less than the facets
 * differ from it), the whole body may be outside; it is then assigned to its
 * cell. */
static int dpvm_weights(const void *state, int i,
                        const struct neighbourhood *near, double *w)
{
    const struct dpvm *const d = state;
    const double R = 0.5 * d->h->ps->d[i], *const o = &d->h->offset[3 * i];
    double sum = 0.0;

    if (d->facets != NULL
            ? facets_contain(d->facets, d->body.kind, near->cell, o, R)
            : dpvm_is_within(o, R, &d->half[3 * near->cell]))
        return 0;
    (d->facets != NULL ? divide_anywhere : d->body.divide)(d, near, o, R, w);
    for (int e = 0; e < near->n; e++)
        sum += w[e];
    if (!(sum > 0.0)) return 0;
    for (int e = 0; e < near->n; e++)
        w[e] /= sum;
    return 1;
}

static const struct body sphere = {divide_sphere, FACETS_SPHERE, 1.0};
static const struct body cube = {divide_cube, FACETS_CUBE, M_SQRT3};

/* Distance [m] of the farthest point of the largest body from its centre. */
static double dpvm_reach(const struct dpvm *d)
{
    return d->body.corner * (0.5 * particles_widest(d->h->ps));
}

static void find_halves(struct dpvm *d)
{
    const struct mesh *const m = d->h->mesh;

    d->half = stencil_extents(m);
    for (int c = 0; c < m->n_cells; c++)
        for (int k = 0; k < 3; k++)
            if (m->box.periodic[k] && m->box.n[k] == 1)
                d->half[3 * c + k] = INFINITY;
}

/* Those of particle h->particle[a]. */
static struct weight_list dpvm_list(const void *state, int a)
{
    const struct stored_weights *const k =
        &((const struct dpvm *)state)->stored;
    const int first = k->start[a];

    return (struct weight_list){k->start[a + 1] - first,
                                &k->index_offset[first], &k->w[first]};
}

static void dpvm_free(void *state)
{
    struct dpvm *const d = state;

    free(d->stored.start);
    free(d->stored.index_offset);
    free(d->stored.w);
    owner_free(d->facets);
    free(d->half);
    free(d);
}

static void *dpvm_create(const struct cell_of_particle *h,
                         const struct averaging_options *o)
{
    const struct body *const body = o->method->variety;
    struct dpvm *const d = alloc_zeroed(1, sizeof *d);

    d->h = h;
    d->body = *body;
    d->stored.start = alloc_ints(h->ps->capacity + 1);
    if (h->mesh->shape == NULL)
        find_halves(d);
    else
        d->facets = facets_create(h->mesh);
    d->reach = dpvm_reach(d);
    return weights_create(
        h, d->reach, STENCIL_TO_CELL, o->fields,
        (struct weights_rule){dpvm_weights, d, dpvm_free, dpvm_list});
}

/* The cells that the largest body can reach are found anew where a particle
 * larger than all before has been inserted. */
static void dpvm_bind(void *weights, struct averaging_report *r)
{
    struct dpvm *const d = weights_state(weights);
    const double now = dpvm_reach(d);

    if (now > d->reach) weights_set_reach(weights, d->reach = now);
    r->unsupported =
        stored_weights_fill(&d->stored, d->h, weights, dpvm_weights);
}

const struct averaging_method dpvm_method = {
    .name = "dpvm",
    .what = "each particle is divided among the cells that it overlaps",
    .equations = "SX15 section 1, LS section 5.4",
    .function = "dpvm_weights",
    .reach_d = 0.5,
    .variety = &sphere,
    .create = dpvm_create,
    .free = weights_free,
    .bind = dpvm_bind,
    .spread = weights_spread,
    .gather = weights_gather,
};

const struct averaging_method dpvm_cube_method = {
    .name = "cube",
    .what =
        "each particle, as a cube, is divided among the cells that it overlaps",
    .equations = "EW18 section 2.4",
    .function = "dpvm_weights",
    .reach_d = 0.5 * M_SQRT3,
    .variety = &cube,
    .create = dpvm_create,
    .free = weights_free,
    .bind = dpvm_bind,
    .spread = weights_spread,
    .gather = weights_gather,
};
