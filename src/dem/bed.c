/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/bed.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_rng.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"
#include "dem/clumps.h"
#include "dem/population/sizes.h"

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

/* The diameter of number i, the next one. Sizes and jitter are drawn from two
 * generators, so that one does not depend on the other. */
static double next_size(const struct bed_options *bed, gsl_rng *random, int i)
{
    const struct clump_shape *const clump = bed->clump;
    double d = bed->diameter;

    if (bed->sizes != NULL)
        d = sizes_quantile(bed->sizes, gsl_rng_uniform(random));
    if (clump == NULL) return d;
    if (bed->sizes != NULL) d *= clumps_shape_around(clump);
    return d * (clumps_drawn(clump, bed->seed, i)->reach / clump->reach);
}

struct bed_range bed_range(const struct bed_options *bed)
{
    gsl_rng *const random = gsl_rng_alloc(gsl_rng_ranlxd1);
    struct bed_range r = {bed->diameter, bed->diameter, bed->diameter, 0.0,
                          0.0};

    gsl_rng_set(random, (unsigned long)bed->seed);
    for (int i = 0; i < bed->count; i++) {
        const double d = next_size(bed, random, i);
        const struct clump_shape *const clump =
            clumps_drawn(bed->clump, bed->seed, i);
        const double ball = clumps_least_ball(clump, d);
        r.min = i == 0 ? d : fmin(r.min, d);
        r.max = i == 0 ? d : fmax(r.max, d);
        r.ball = i == 0 ? ball : fmin(r.ball, ball);
        r.balls += clump == NULL ? 1 : clump->n;
        r.volume +=
            M_PI / 6.0 *
            gsl_pow_3(clump == NULL ? d : d / clumps_shape_around(clump));
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
    double d = next_size(bed, sizes, 0);
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
        d = next_size(bed, sizes, i);
    }
    gsl_rng_free(random);
    gsl_rng_free(sizes);
    return i;
}

/* The lattice is that of the widest sphere, and ends at the top of the box, or
 * where the region does. */
int bed_each(const struct bed_options *bed, const struct dem_options *dem,
             bed_put *put, void *to)
{
    struct bed_options widest = *bed;

    widest.diameter = bed_range(bed).max;
    const struct lattice l = lattice_of(&widest, dem);
    if (bed->region.has_room == NULL && lattice_wrong(&l, &widest, dem))
        return 1;
    const int n = fill_lattice(&l, bed, dem, put, to);
    if (n == bed->count) return 0;
    fprintf(stderr,
            "winnow: %sthe bed does not fit: the mesh has room for %d of its "
            "%d spheres on a lattice\n",
            bed->where, n, bed->count);
    return 1;
}

/* The particles that a bed is added to. */
struct filling {
    struct particles *ps;
    const struct bed_options *bed;
};

static void put_one(void *to, int i, const double x[3], double d)
{
    static const double rest[3] = {0.0, 0.0, 0.0};
    const struct filling *const f = to;
    const struct bed_options *const bed = f->bed;

    clumps_add_drawn(f->ps, bed->clump, bed->seed, i, d, bed->density, x, rest);
}

int bed_fill(struct particles *ps, const struct bed_options *bed,
             const struct dem_options *dem)
{
    struct filling f = {ps, bed};
    const int wrong = bed_each(bed, dem, put_one, &f);

    if (wrong || bed->region.start_wrong == NULL) return wrong;
    return bed->region.start_wrong(bed->region.state, ps);
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

/* --- bed state: a settled bed as a state, to be kept in a file. Chapter
 * "Nothing is lost". */

/* "name a b c" with numbers that read back exactly. */
static void fact(FILE *out, const char *name, int n, const double *value)
{
    char number[NUMBER_LENGTH];

    fputs(name, out);
    for (int k = 0; k < n; k++)
        fprintf(out, " %s", number_text(value[k], number));
    fputc('\n', out);
}

/* Of several sizes, what tells one distribution from another. */
static void size_fact(FILE *out, const struct bed_options *bed)
{
    const struct sizes *const s = bed->sizes;

    if (s == NULL)
        fact(out, "diameter", 1, &bed->diameter);
    else
        fact(out, "sizes", 5,
             (const double[5]){sizes_min(s), sizes_max(s), sizes_moment(s, 1),
                               sizes_moment(s, 2), sizes_moment(s, 3)});
}

/* Beds in files are of material 0; this is its pair with the wall. */
static void wall_fact(FILE *out, const struct dem_options *o)
{
    const struct material_pair p =
        materials_pair(&o->material, o->materials, 0, o->materials->wall);
    double known[7 + MODEL_NUMBERS] = {
        p.of[1]->young, p.of[1]->poisson, p.stiffness, p.tangential,
        p.restitution,  p.friction,       p.rolling};

    memcpy(&known[7], p.of[1]->own, sizeof p.of[1]->own);
    fact(out, "wall", o->law->own_keys != NULL ? 7 + MODEL_NUMBERS : 7, known);
}

static void attraction_fact(FILE *out, const struct attraction *a)
{
    const double known[] = {a->range, a->strength, a->closest,
                            a->harmonic ? 1.0 : 0.0,
                            a->charge != NULL ? a->charge[0] : 0.0};

    fact(out, a->law->name, 5, known);
}

static void material_facts(FILE *out, const struct dem_options *o)
{
    const struct material *const m = &o->material;

    fact(out, "young", 1, &m->young);
    fact(out, "poisson", 1, &m->poisson);
    fact(out, "stiffness", 1, &m->stiffness);
    fact(out, "tangential", 1, &m->tangential);
    fact(out, "restitution", 1, &m->restitution);
    fact(out, "friction", 1, &m->friction);
    if (m->rolling > 0.0) fact(out, "rolling", 1, &m->rolling);
    if (o->law->own_keys != NULL) fact(out, "own", MODEL_NUMBERS, m->own);
    if (o->materials != NULL) wall_fact(out, o);
}

char *bed_made_with(const struct bed_options *bed, const struct dem_options *o)
{
    char *text;
    size_t length;
    FILE *const out = open_memstream(&text, &length);

    fprintf(out, "winnow bed, contact %s\n", o->law->name);
    fprintf(out, "count %d\n", bed->count);
    fprintf(out, "seed %d\n", bed->seed);
    fprintf(out, "periodic %d %d %d\n", o->periodic[0], o->periodic[1],
            o->periodic[2]);
    size_fact(out, bed);
    fact(out, "density", 1, &bed->density);
    fact(out, "jitter", 1, &bed->jitter);
    fact(out, "settle", 1, &bed->settle);
    fact(out, "gravity", 3, bed->gravity);
    fact(out, "box from", 3, o->lo);
    fact(out, "box to", 3, o->hi);
    material_facts(out, o);
    if (o->n_surfaces > 0)
        fprintf(out, "surfaces %d crc32 %08lx\n", o->n_surfaces,
                o->surfaces_checksum);
    for (int k = 0; k < o->n_attractions; k++)
        attraction_fact(out, &o->attractions[k]);
    fclose(out);
    return text;
}

/* What is wrong with particle i, or NULL. */
static const char *misfit(const struct particles *ps, int i,
                          const struct bed_options *bed,
                          const struct dem_options *dem)
{
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]}, d = ps->d[i];
    const double least = bed->sizes ? sizes_min(bed->sizes) : bed->diameter;
    const double most = bed->sizes ? sizes_max(bed->sizes) : bed->diameter;

    for (int k = 0; k < 3; k++)
        if (!(x[k] >= dem->lo[k] && x[k] <= dem->hi[k]))
            return "a particle that is not in the box";
    if (!(d >= least && d <= most))
        return "a diameter that is not one of the bed's";
    /* The mass is the product in another order: rounded differently. */
    if (!(fabs(ps->m[i] / (bed->density * particles_volume(ps, i)) - 1.0) <
          1e-12))
        return "a mass that does not belong to its diameter";
    return NULL;
}

/* What is wrong with a bed that was loaded, or NULL. */
static const char *bed_misfit(const struct particles *ps,
                              const struct bed_options *bed,
                              const struct dem_options *dem)
{
    char *const known = alloc_zeroed((size_t)ps->n, 1);
    const char *wrong = NULL;

    for (int i = 0; i < ps->n && wrong == NULL; i++) {
        wrong = misfit(ps, i, bed, dem);
        if (known[ps->id[i]]++) wrong = "an id that is given twice";
    }
    free(known);
    return wrong;
}

/* The histories against surfaces, -7 (surface_history.c), come last. */
static int surfaces_come_last(const struct bed_histories *h)
{
    for (int q = 1; q < h->n; q++)
        if (h->list[q - 1].other == -7 && h->list[q].other != -7) return 0;
    return 1;
}

/* Sixty contacts a sphere, and some with walls, are more than any bed has. */
static void histories_state(struct bed_histories *h, int count, int least,
                            struct state *s)
{
    const size_t size = sizeof *h->list;

    state_begin(s, "contacts");
    state_count(s, "count", &h->n,
                number_clamped(100.0 * count + 100.0, 0, INT_MAX));
    if (s->loading && !s->failed) {
        free(h->list);
        h->list = alloc_zeroed((size_t)h->n, size);
    }
    if (h->n > 0) {
        state_indices_of(s, "id", &h->list->id, size, h->n, 0, count - 1);
        state_indices_of(s, "other", &h->list->other, size, h->n, least,
                         count - 1);
        state_reals_of(s, "xi", "m", h->list->xi, size, h->n, 3);
        state_reals_of(s, "roll_angle", "rad", h->list->roll_angle, size, h->n,
                       3);
        state_reals_of(s, "n", "-", h->list->n, size, h->n, 3);
    }
    state_demand(s, surfaces_come_last(h), "surfaces before spheres");
    state_end(s);
}

void bed_state(struct particles *ps, struct bed_histories *h,
               const struct bed_options *bed, const struct dem_options *dem,
               struct state *s)
{
    static const char *const names[] = {"x",  "y",  "z",  "vx", "vy", "vz",
                                        "wx", "wy", "wz", "d",  "m"};
    static const char *const units[] = {"m",     "m",   "m",     "m/s",
                                        "m/s",   "m/s", "rad/s", "rad/s",
                                        "rad/s", "m",   "kg"};
    double *const columns[] = {ps->x,  ps->y,  ps->z,  ps->vx, ps->vy, ps->vz,
                               ps->wx, ps->wy, ps->wz, ps->d,  ps->m};
    const char *wrong = NULL;

    state_begin(s, "bed");
    if (s->loading) ps->n = ps->next_id = bed->count;
    state_indices(s, "id", ps->id, bed->count, 0, bed->count - 1);
    for (int k = 0; k < 11; k++)
        state_reals(s, names[k], units[k], columns[k], bed->count, 1);
    histories_state(h, bed->count, dem->n_surfaces > 0 ? -7 : -6, s);
    if (s->loading && !s->failed) wrong = bed_misfit(ps, bed, dem);
    state_demand(s, wrong == NULL, wrong);
    state_end(s);
}
