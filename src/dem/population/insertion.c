/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/insertion.h"

#include <gsl/gsl_math.h>

#include "base/alloc.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "base/statistics.h"
#include "base/vector.h"

/* Positions tried for one sphere in a step: beyond 30 % of solids hardly any is
 * free, and a sphere without one is tried again in the next step. */
enum { ATTEMPTS = 200, AT_ONCE = 4096 };

/* That of a sphere of the same volume; of a mixture that of its first shape. */
static double insertion_size(const struct insertion_options *o, long k)
{
    if (o->list != NULL) return o->list[k].d;
    if (o->sizes == NULL) return o->diameter;
    return sizes_quantile(o->sizes,
                          random_uniform((unsigned long)o->seed, k, 0, 3));
}

double insertion_diameter(const struct insertion_options *o, long k)
{
    const double d = insertion_size(o, k);
    return o->clump == NULL ? d
                            : d * clumps_shape_around(o->clump) *
                                  (clumps_drawn(o->clump, o->seed, k)->reach /
                                   o->clump->reach);
}

void insertion_place(const struct insertion_options *o, long k, long attempt,
                     double d, double x[3])
{
    for (int a = 0; a < 3; a++) {
        const double room = o->hi[a] - o->lo[a] - d;
        const double u = random_uniform((unsigned long)o->seed, k, attempt, a);
        x[a] = o->list != NULL ? o->list[k].x[a]
                               : o->lo[a] + 0.5 * d + u * fmax(room, 0.0);
    }
}

/* A sphere is due when the rate has brought the mass of all before it. */
static long insertion_count_by_mass(struct insertion *in, double t)
{
    const struct insertion_options *const o = &in->options;
    const double mass = (t - o->start) * o->mass_rate;

    while (in->n_due < o->count && in->mass_due <= mass) {
        const struct clump_shape *const clump =
            clumps_drawn(o->clump, o->seed, in->n_due);
        const double d = insertion_size(o, in->n_due++);
        in->mass_due +=
            o->density * M_PI / 6.0 * d * d * d *
            (clump == NULL ? 1.0 : clump->volume / o->clump->volume);
    }
    return in->n_due;
}

long insertion_count_due(struct insertion *in, double t)
{
    const struct insertion_options *const o = &in->options;

    if (t < o->start) return 0;
    if (insertion_at_once(o)) return o->count;
    if (o->mass_rate > 0.0) return insertion_count_by_mass(in, t);
    const double n = floor((t - o->start) * o->rate) + 1.0;
    long due;
    return number_long(n, &due) != 0 || due > o->count ? o->count : due;
}

/* Particles in cells over the region, or the period, which are as wide as the
 * largest diameter. */
struct near_particles {
    const struct particles *ps;
    const struct box_domain *box;
    struct link_cells *cells;
};

static void add_to_cell(struct near_particles *c, int i)
{
    const double x[3] = {c->ps->x[i], c->ps->y[i], c->ps->z[i]};
    link_cells_add(c->cells, i, x);
}

/* Empty cells for spheres of up to `widest` [m]. */
static struct near_particles
near_particles_create(const struct insertion_options *o,
                      const struct particles *ps, const struct box_domain *box,
                      double widest)
{
    struct box_domain region = *box;

    for (int k = 0; k < 3; k++) {
        if (box->periodic[k] || o->list != NULL) continue;
        region.lo[k] = o->lo[k];
        region.hi[k] = o->hi[k];
    }
    struct near_particles c = {ps, box,
                               link_cells_create(ps->capacity, &region)};
    link_cells_clear(c.cells, widest);
    return c;
}

/* x_i - x, nearest image. */
static void insertion_apart(const struct near_particles *c, int i,
                            const double x[3], double dx[3])
{
    const double at[3] = {c->ps->x[i], c->ps->y[i], c->ps->z[i]};

    for (int k = 0; k < 3; k++)
        dx[k] = box_domain_nearest(c->box, k, at[k] - x[k]);
}

/* A particle that overlaps the sphere by more than this fraction of the mean
 * diameter; -1: none. */
static int overlap_near(const struct near_particles *c, const double x[3],
                        double d, double share)
{
    int cell[LINK_CELLS_AROUND];
    const int n = link_cells_around(c->cells, x, cell);

    for (int q = 0; q < n; q++)
        for (int i = c->cells->head[cell[q]]; i >= 0; i = c->cells->next[i]) {
            const double reach = 0.5 * (d + c->ps->d[i]) * (1.0 - share);
            double dx[3];
            insertion_apart(c, i, x, dx);
            if (vector_dot(dx, dx) < reach * reach) return i;
        }
    return -1;
}

/* The particles that may touch a sphere in the region. */
static struct near_particles near_particles_of(const struct insertion *in,
                                               const struct particles *ps,
                                               const struct box_domain *box,
                                               long due)
{
    const struct insertion_options *const o = &in->options;
    double middle[3], widest = particles_widest(ps);

    for (long k = in->n_inserted; k < due; k++)
        widest = fmax(widest, insertion_diameter(o, k));
    struct near_particles c = near_particles_create(o, ps, box, widest);
    for (int k = 0; k < 3; k++)
        middle[k] = 0.5 * (o->lo[k] + o->hi[k]);
    for (int i = 0; i < ps->n; i++) {
        int near = 1;
        double dx[3];
        insertion_apart(&c, i, middle, dx);
        for (int k = 0; k < 3; k++)
            near &= fabs(dx[k]) <= 0.5 * (o->hi[k] - o->lo[k]) + 0.5 * ps->d[i];
        if (near || o->list != NULL) add_to_cell(&c, i);
    }
    return c;
}

/* Adds the next sphere, or the balls of the next clump. */
static void insertion_put(const struct insertion *in, struct near_particles *c,
                          struct particles *ps, double d, const double x[3])
{
    const struct insertion_options *const o = &in->options;
    int i = ps->n;

    clumps_add_drawn(ps, o->clump, o->seed, in->n_inserted, d, o->density, x,
                     o->velocity);
    for (; i < ps->n; i++) {
        if (ps->material != NULL) ps->material[i] = o->material;
        add_to_cell(c, i);
    }
}

/* Inserts the next sphere if there is a free position. */
static int place_next(struct insertion *in, struct near_particles *c,
                      struct particles *ps)
{
    const struct insertion_options *const o = &in->options;
    const double d = insertion_diameter(o, in->n_inserted);
    double x[3];

    for (int a = 0; a < (o->list != NULL ? 1 : ATTEMPTS); a++) {
        insertion_place(o, in->n_inserted, in->n_attempts++, d, x);
        if (overlap_near(c, x, d, o->overlap) >= 0) continue;
        if (o->region.has_room != NULL &&
            !o->region.has_room(o->region.state, x, 0.5 * d))
            continue;
        insertion_put(in, c, ps, d, x);
        in->n_inserted++;
        in->n_attempts = 0;
        return 1;
    }
    return 0;
}

/* The spheres are inserted AT_ONCE at a time, so that the diameters of all are
 * not drawn in a step that has no room for the first. */
int insertion_step(struct insertion *in, struct particles *ps,
                   const struct box_domain *box, double t)
{
    const long due = insertion_count_due(in, t);
    const int before = ps->n;
    long last = in->n_inserted;

    while (in->n_inserted == last && in->n_inserted < due &&
           ps->n < ps->capacity && !interrupt_arrived()) {
        last = due - in->n_inserted > AT_ONCE ? in->n_inserted + AT_ONCE : due;
        struct near_particles near = near_particles_of(in, ps, box, last);
        while (in->n_inserted < last && ps->n < ps->capacity &&
               place_next(in, &near, ps))
            continue;
        owner_free(near.cells);
    }
    return ps->n - before;
}

int insertion_overlap(const struct insertion_options *o,
                      const struct box_domain *box, double share, int who[2])
{
    struct particles *const ps = particles_create((int)o->count);
    double widest = 0.0;

    for (long k = 0; k < o->count; k++)
        widest = fmax(widest, o->list[k].d);
    struct near_particles c = near_particles_create(o, ps, box, widest);
    who[0] = -1;
    for (who[1] = 0; who[1] < o->count; who[1]++) {
        const struct insertion_sphere *const one = &o->list[who[1]];
        who[0] = overlap_near(&c, one->x, one->d, share);
        if (who[0] >= 0) break;
        add_to_cell(&c, particles_add(ps, one->x, one->d, 1.0));
    }
    owner_free(c.cells);
    particles_free(ps);
    return who[0] >= 0;
}

void insertion_move(struct insertion_sphere *list, long n, const double by[3],
                    const struct box_domain *box)
{
    for (long i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            list[i].x[k] = box_domain_inside(box, k, list[i].x[k] + by[k]);
}
