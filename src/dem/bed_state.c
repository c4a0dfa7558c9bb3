/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bed_state.c -- a settled bed as a state, to be kept in a file.
 * Chapter "Nothing is lost". */
#include "dem/bed.h"

#include <gsl/gsl_math.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "dem/population/sizes.h"

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
