/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/bed.h"

#include <assert.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_rng.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

static const double lattice_spacing = 1.02; /* [-] over d */

struct lattice {
    int up;          /* direction that gravity points along */
    int down;        /* 1: gravity points to lo */
    int n[3];        /* sites a direction; as many layers as needed */
    double space[3]; /* [m] between sites */
};

/* The direction that g mostly points along; without gravity the longest. */
static int upward(const struct bed_options *bed, const struct dem_options *dem)
{
    int up = 0;

    for (int k = 1; k < 3; k++) {
        const double own = fabs(bed->gravity[k]), best = fabs(bed->gravity[up]);
        const double L = dem->hi[k] - dem->lo[k];
        const double most = dem->hi[up] - dem->lo[up];
        if (own > best || (own == best && L > most)) up = k;
    }
    return up;
}

static int lattice_wrong(const struct lattice *l, const struct bed_options *bed,
                         const struct dem_options *dem)
{
    const double available = dem->hi[l->up] - dem->lo[l->up];
    const double height = l->n[l->up] * l->space[l->up];

    for (int k = 0; k < 3; k++)
        if (l->n[k] == 0 && bed->count > 0) {
            fprintf(stderr,
                    "winnow: %sthe bed does not fit: spheres of %g m in a box "
                    "%g m wide\n",
                    bed->where, bed->diameter, dem->hi[k] - dem->lo[k]);
            return 1;
        }
    if (height <= available) return 0;
    fprintf(stderr,
            "winnow: %sthe bed does not fit: %d spheres of %g m on a lattice "
            "need %g m of height, the box has %g m\n",
            bed->where, bed->count, bed->diameter, height, available);
    return 1;
}

static struct lattice lattice_of(const struct bed_options *bed,
                                 const struct dem_options *dem)
{
    const double least = lattice_spacing * bed->diameter;
    struct lattice l = {.up = upward(bed, dem)};
    long layer = 1;

    l.down = bed->gravity[l.up] <= 0.0;
    for (int k = 0; k < 3; k++) {
        const double L = dem->hi[k] - dem->lo[k];
        l.n[k] = L >= least ? number_clamped(L / least, 1, INT_MAX)
                            : L >= bed->diameter;
        l.space[k] = k == l.up ? least : L / fmax(1.0, l.n[k]);
        if (k != l.up) layer *= l.n[k];
    }
    if (layer > 0) l.n[l.up] = (int)((bed->count + layer - 1) / layer);
    return l;
}

/* The next diameter. Sizes and jitter are drawn from two generators, so that
 * one does not depend on the other. */
static double next_size(const struct bed_options *bed, gsl_rng *random)
{
    return bed->sizes == NULL
               ? bed->diameter
               : bed->quantile(bed->sizes, gsl_rng_uniform(random));
}

struct bed_range bed_range(const struct bed_options *bed)
{
    gsl_rng *const random = gsl_rng_alloc(gsl_rng_ranlxd1);
    struct bed_range r = {bed->diameter, bed->diameter, 0.0};

    gsl_rng_set(random, (unsigned long)bed->seed);
    for (int i = 0; i < bed->count; i++) {
        const double d = next_size(bed, random);
        r.min = i == 0 ? d : fmin(r.min, d);
        r.max = i == 0 ? d : fmax(r.max, d);
        r.volume += M_PI / 6.0 * gsl_pow_3(d);
    }
    gsl_rng_free(random);
    return r;
}

/* Calls put for the spheres of the bed, one after the other on the sites of the
 * lattice; with a region only on sites where a sphere has room, as far as they
 * reach. Returns the number of spheres. */
static int fill_lattice(const struct lattice *l, const struct bed_options *bed,
                        const struct dem_options *dem, bed_put *put, void *to)
{
    const struct placement_region *const region = &bed->region;
    const int a = (l->up + 1) % 3, c = (l->up + 2) % 3;
    const long layer = (long)l->n[a] * l->n[c];
    const double height = dem->hi[l->up] - dem->lo[l->up];
    const double sites = (double)layer * floor(height / l->space[l->up]);
    gsl_rng *const random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng *const sizes = gsl_rng_alloc(gsl_rng_ranlxd1);
    int i = 0;

    gsl_rng_set(random, (unsigned long)bed->seed);
    gsl_rng_set(sizes, (unsigned long)bed->seed);
    double d = next_size(bed, sizes);
    for (long q = 0; i < bed->count; q++) {
        long site[3];
        double x[3];

        if (region->has_room != NULL && (double)q >= sites) break;
        site[a] = q % l->n[a];
        site[c] = q / l->n[a] % l->n[c];
        site[l->up] = q / layer;
        for (int k = 0; k < 3; k++) {
            const double gap = bed->jitter * (l->space[k] - d);
            const double shift = gap * (gsl_rng_uniform(random) - 0.5);
            const double at = ((double)site[k] + 0.5) * l->space[k] + shift;
            x[k] = k == l->up && !l->down ? dem->hi[k] - at : dem->lo[k] + at;
        }
        if (region->has_room != NULL &&
            !region->has_room(region->state, x, 0.5 * d))
            continue;
        put(to, i++, x, d);
        d = next_size(bed, sizes);
    }
    gsl_rng_free(random);
    gsl_rng_free(sizes);
    return i;
}

/* The bed as if all its spheres were as wide as the widest. */
static struct bed_options widest_of(const struct bed_options *bed)
{
    struct bed_options widest = *bed;

    widest.diameter = bed_range(bed).max;
    return widest;
}

/* The lattice ends at the top of the box, or where the region does. */
int bed_each(const struct bed_options *bed, const struct dem_options *dem,
             bed_put *put, void *to)
{
    const struct bed_options widest = widest_of(bed);
    const struct lattice l = lattice_of(&widest, dem);

    if (bed->region.has_room == NULL && lattice_wrong(&l, &widest, dem))
        return 1;
    const int n = fill_lattice(&l, bed, dem, put, to);
    if (n == bed->count) return 0;
    fprintf(
        stderr,
        "winnow: %sthe bed does not fit: the mesh has room for %d of its %d "
        "spheres on a lattice\n",
        bed->where, n, bed->count);
    return 1;
}

/* The particles that a bed is added to. */
struct filling {
    struct particles *ps;
    double density; /* [kg/m^3] */
};

static void put_one(void *to, int i, const double x[3], double d)
{
    const struct filling *const f = to;

    (void)i; /* particles_add counts them itself */
    particles_add(f->ps, x, d, f->density);
}

int bed_fill(struct particles *ps, const struct bed_options *bed,
             const struct dem_options *dem)
{
    struct filling f = {ps, bed->density};
    const int wrong = bed_each(bed, dem, put_one, &f);

    if (wrong || bed->region.start_wrong == NULL) return wrong;
    return bed->region.start_wrong(bed->region.state, ps);
}

int bed_settle(struct particles *ps, const struct bed_options *bed,
               const struct dem_options *dem, struct bed_report *r,
               struct bed_histories *histories)
{
    int lost = 0;

    *histories = (struct bed_histories){0, NULL};
    *r = (struct bed_report){.settled = 1};
    if (ps->n > 0 && bed->settle > 0.0 && vector_length(bed->gravity) > 0.0)
        lost = bed_settling_run(ps, bed, dem, r, histories);
    bed_measure(ps, bed, dem, r);
    return lost;
}

void bed_measure(const struct particles *ps, const struct bed_options *bed,
                 const struct dem_options *dem, struct bed_report *r)
{
    const struct lattice l = lattice_of(bed, dem);
    const double *const x = l.up == 0 ? ps->x : l.up == 1 ? ps->y : ps->z;
    const int a = (l.up + 1) % 3, c = (l.up + 2) % 3;
    const double base = (dem->hi[a] - dem->lo[a]) * (dem->hi[c] - dem->lo[c]);
    double volume = 0.0, sum = 0.0;

    r->top = 0.0;
    for (int i = 0; i < ps->n; i++) {
        const double h = l.down ? x[i] - dem->lo[l.up] : dem->hi[l.up] - x[i];
        sum += h;
        volume += particles_volume(ps, i);
        r->top = fmax(r->top, h + 0.5 * ps->d[i]);
    }
    r->height = ps->n > 0 ? 2.0 * sum / ps->n : 0.0;
    r->packing = ps->n > 0 ? volume / (base * r->height) : 0.0;
}

int bed_create(struct particles *ps, const struct bed_options *bed,
               const struct dem_options *dem, struct bed_report *r,
               struct bed_histories *histories)
{
    *r = (struct bed_report){.settled = 1};
    if (bed_fill(ps, bed, dem) != 0) return BED_REFUSED;
    const int wrong = bed_settle(ps, bed, dem, r, histories);
    return r->stopped  ? BED_STOPPED
           : wrong < 0 ? BED_REFUSED
           : wrong > 0 ? BED_LOST
                       : BED_CREATED;
}
