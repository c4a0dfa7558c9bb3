/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/particles/case_population.h"

#include <gsl/gsl_math.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "coupling/replacement.h"
#include "dem/population/insertion.h"
#include "dem/population/population.h"
#include "case/particles/case_clumps.h"
#include "case/particles/case_materials.h"
#include "case/particles/case_surfaces.h"
#include "case/case_mesh.h"
#include "base/text.h"
#include "case/build.h"

static const char sources[] = "particles.insert", sinks[] = "particles.sinks",
                  sizes[] = "particles.sizes";

/* --- sizes ---------------------------------------------------------------- */

/* The points are to be released with free(). */
static struct sizes_options sizes_options_of(const struct settings *s, int i)
{
    const struct sizes_setup *const one = &s->particles.sizes.item[i];
    struct sizes_options o = one->of;
    int n = 0;

    o.by_mass = strcmp(one->by, "mass") == 0;
    for (const struct key *k = o.law->own_keys; k != NULL && k->path != NULL;
         k++, n++) {
        const char *const key =
            SETTINGS_ITEM(sizes, i, strrchr(k->path, '.') + 1);
        if (settings_has(s, key)) o.own[n] = settings_real(s, key);
    }
    o.n = one->points.n;
    if (o.n == 0) return o;
    double(*const point)[2] = alloc_zeroed((size_t)o.n, sizeof *point);
    for (int k = 0; k < o.n; k++) {
        point[k][0] = one->points.at[k];
        point[k][1] = one->points.value[k];
    }
    o.point = (const double(*)[2])point;
    return o;
}

static int size_law_named(const struct settings *s, const char *name)
{
    int i = 0;

    while (i < s->particles.sizes.n &&
           strcmp(s->particles.sizes.item[i].name, name) != 0)
        i++;
    return i;
}

/* Are the distributions of the case possible, and their names its own? 0, or 2
 * after a message. */
static int check_size_laws(const struct settings *s)
{
    for (int i = 0; i < s->particles.sizes.n; i++) {
        const char *const name = s->particles.sizes.item[i].name;
        const struct sizes_options o = sizes_options_of(s, i);
        const char *const wrong = sizes_wrong(&o);

        free((void *)o.point);
        if (wrong != NULL)
            return settings_wrong(s, sizes, "%s, which is %s: %s", name,
                                  o.law->name, wrong);
        if (size_law_named(s, name) != i)
            return settings_wrong(s, sizes, "two are called %s", name);
    }
    return 0;
}

/* Is there one of the name that the key has? 0, or 2 after a message. */
static int check_size_name(const struct settings *s, const char *key,
                           const char *name)
{
    struct nearest n;

    if (size_law_named(s, name) < s->particles.sizes.n) return 0;
    nearest_init(&n, name);
    for (int i = 0; i < s->particles.sizes.n; i++)
        nearest_offer(&n, s->particles.sizes.item[i].name);
    const char *const best = nearest_best(&n);
    return settings_wrong(s, key, "no distribution in %s is called %s%s%s",
                          sizes, name, best != NULL ? "; did you mean " : "",
                          best != NULL ? best : "");
}

/* The distribution of that name, which is there, of a material's particles. */
static struct sizes *create_sizes(const struct settings *s, const char *name,
                                  int material)
{
    struct sizes_options o = sizes_options_of(s, size_law_named(s, name));
    case_parcels_sizes(&o, case_parcels_across(s, material));
    struct sizes *const made = sizes_create(&o);

    free((void *)o.point);
    return made;
}

/* --- sources -------------------------------------------------------------- */

/* The largest share of a region that random positions can fill quickly. */
static const double densest = 0.3;

/* A region that is not given is the whole box. */
static void region(const struct settings *s, int has_from, int has_to,
                   double lo[3], double hi[3])
{
    double end[2][3];

    case_mesh_ends(s, end[0], end[1]);
    if (!has_from) memcpy(lo, end[0], sizeof end[0]);
    if (!has_to) memcpy(hi, end[1], sizeof end[1]);
}

static struct box_domain box_of(const struct settings *s)
{
    double lo[3], hi[3];
    int periodic[3];

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    return box_domain_of(lo, hi, periodic);
}

/* Non-zero after a message if the file is wrong. */
static int read_list(const struct settings *s, struct insert_setup *in)
{
    const struct box_domain box = box_of(s);

    in->list = grain_table_parse(settings_input(s, in->file), &in->of.count);
    if (in->list == NULL) return 1;
    in->of.list = in->list;
    if (insertion_at_once(&in->of))
        in->of.overlap = build_particles_wall_overlap(s);
    insertion_move(in->list, in->of.count, in->offset, &box);
    return 0;
}

/* What the other members say, in the options. */
static int complete_source(const struct settings *s, struct insert_setup *in)
{
    region(s, in->has_from, in->has_to, in->of.lo, in->of.hi);
    in->of.count = in->count;
    in->of.material = case_materials_number(s, in->material);
    in->of.density = case_materials_setup(s, in->of.material)->density;
    if (in->sizes != NULL)
        in->of.sizes = in->distribution =
            create_sizes(s, in->sizes, in->of.material);
    return in->file != NULL ? read_list(s, in) : 0;
}

void case_population_release(struct settings *s)
{
    for (int i = 0; i < s->particles.insert.n; i++) {
        owner_free(s->particles.insert.item[i].distribution);
        free(s->particles.insert.item[i].list);
    }
}

/* --- checks --------------------------------------------------------------- */

static int case_population_check_names(const struct settings *s,
                                       const struct insert_setup *in)
{
    if (in->sizes != NULL && check_size_name(s, sources, in->sizes) != 0)
        return 2;
    return case_materials_check_name(s, sources, in->material);
}

static int case_population_check_given(const struct settings *s, int i,
                                       const struct insert_setup *in)
{
    const int sized = (in->of.diameter > 0.0) + (in->sizes != NULL);

    if (in->file != NULL && (sized > 0 || in->count > 0))
        return settings_wrong(s, sources,
                              "source %d: a file says how many there are and "
                              "how large; leave out count, diameter and sizes",
                              i);
    if (in->of.rate > 0.0 && in->of.mass_rate > 0.0)
        return settings_wrong(s, sources,
                              "source %d: give either rate [1/s] or mass_rate "
                              "[kg/s], not both",
                              i);
    if (in->file == NULL && in->count == 0)
        return settings_wrong(s, sources, "source %d needs count or file", i);
    if (in->file == NULL && sized != 1)
        return settings_wrong(s, sources,
                              "source %d: give either diameter or sizes%s", i,
                              sized > 1 ? ", not both" : "");
    return 0;
}

/* What will come: the smallest ball, the widest [m], and the volume [m^3]. */
struct source_sizes {
    double ball, max, volume;
};

static struct source_sizes sizes_of_source(const struct insertion_options *o)
{
    struct source_sizes c = {0.0, 0.0, 0.0};

    for (long k = 0; k < o->count; k++) {
        const double d = insertion_diameter(o, k);
        const double ball =
            clumps_least_ball(clumps_drawn(o->clump, o->seed, k), d);
        c.ball = k == 0 ? ball : fmin(c.ball, ball);
        c.max = fmax(c.max, d);
        c.volume += M_PI / 6.0 * d * d * d;
    }
    return c;
}

/* Spheres of a list that come at once do not overlap: the second would wait. */
static int case_population_check_no_contacts(const struct settings *s, int i,
                                             const struct insertion_options *o,
                                             const struct box_domain *box)
{
    int who[2];

    if (!insertion_at_once(o) || !insertion_overlap(o, box, o->overlap, who))
        return 0;
    return settings_wrong(
        s, sources,
        "source %d: spheres %d and %d of its file overlap by more than %g d; "
        "particles.overlaps = \"allow\" takes up to 0.5 d",
        i, who[0], who[1], o->overlap);
}

static int case_population_check_list(const struct settings *s, int i,
                                      const struct insertion_options *o)
{
    const struct box_domain box = box_of(s);

    for (long q = 0; q < o->count; q++)
        for (int k = 0; k < 3; k++) {
            const double *const x = o->list[q].x, d = o->list[q].d;
            const double margin =
                box.periodic[k] ? 0.0 : (0.5 - o->overlap) * d;
            if (x[k] < box.lo[k] + margin || x[k] > box.hi[k] - margin)
                return settings_wrong(
                    s, sources,
                    "source %d: sphere %ld at [%g, %g, %g] m with diameter %g "
                    "m is not inside the box; offset moves all of the file, "
                    "and particles.overlaps = \"allow\" takes a sphere whose "
                    "centre is inside",
                    i, q, x[0], x[1], x[2], d);
        }
    return case_population_check_no_contacts(s, i, o, &box);
}

static int check_region(const struct settings *s, int i,
                        const struct insertion_options *o)
{
    const struct source_sizes c = sizes_of_source(o);
    double lo[3], hi[3], volume = 1.0;

    if (o->list != NULL) return case_population_check_list(s, i, o);
    case_mesh_ends(s, lo, hi);
    for (int k = 0; k < 3; k++) {
        volume *= o->hi[k] - o->lo[k];
        if (o->lo[k] < lo[k] || o->hi[k] > hi[k] || o->hi[k] - o->lo[k] < c.max)
            return settings_wrong(
                s, sources,
                "source %d: its region, %g to %g m in direction %c, must be "
                "inside the box, %g to %g m, and have room for spheres of %g m",
                i, o->lo[k], o->hi[k], 'x' + k, lo[k], hi[k], c.max);
    }
    if (!insertion_at_once(o) || c.volume <= densest * volume) return 0;
    return settings_wrong(
        s, sources,
        "source %d: %ld spheres would fill %.0f %% of its region; at random no "
        "more than %.0f %% find room: give it a rate, or a larger region",
        i, o->count, 100.0 * c.volume / volume, 100.0 * densest);
}

static int check_source(const struct settings *s, int i,
                        struct insert_setup *in)
{
    int code = case_population_check_names(s, in);

    if (code == 0) code = case_population_check_given(s, i, in);
    if (code != 0) return code;
    return complete_source(s, in) != 0 ? 2 : check_region(s, i, &in->of);
}

static int check_sink(const struct settings *s, int i)
{
    const struct sink_setup *const k = &s->particles.sinks.item[i];

    if ((k->has_from || k->has_to) == (strcmp(k->side, "none") == 0)) return 0;
    return settings_wrong(s, sinks, "sink %d: give either side, or from and to",
                          i);
}

/* --- particles that come later -------------------------------------------- */

int case_population_count(const struct settings *s)
{
    double sum = 0.0;

    for (int i = 0; i < s->particles.insert.n; i++) {
        const struct insert_setup *const in = &s->particles.insert.item[i];
        sum += case_clumps_balls(s, in->clump, (double)in->of.count);
    }
    return number_clamped(sum, 0, INT_MAX);
}

struct case_diameters case_population_diameters(const struct settings *s,
                                                int material)
{
    struct case_diameters all = {0.0, 0.0};

    for (int i = 0; i < s->particles.insert.n; i++) {
        const struct insert_setup *const in = &s->particles.insert.item[i];
        if (material >= 0 && in->of.material != material) continue;
        const struct source_sizes c = sizes_of_source(&in->of);
        all.min = all.min > 0.0 ? fmin(all.min, c.ball) : c.ball;
        all.max = fmax(all.max, c.max);
    }
    return all;
}

/* The length of a period, which dem_create checks for those there at first. */
static int check_period(const struct settings *s)
{
    struct dem_options o = build_particles_dem(s, 1.0);
    const double most = case_population_diameters(s, -1).max;
    struct attraction *const pulls =
        case_materials_attractions(s, &o.n_attractions);

    o.attractions = pulls;
    const int wrong = most > 0.0 && dem_period_wrong(&o, most, most);
    free(pulls);
    return wrong ? 2 : 0;
}

/* A bed that is not there yet will be written, and no case writes beyond its
 * own folder. 0, or 2 after a message. */
static int check_bed_file(const struct settings *s)
{
    const char *const name = s->particles.bed_file;
    char path[SETTINGS_PATH];

    if (name == NULL) return 0;
    settings_beside(s, name, path, sizeof path);
    if (access(path, F_OK) == 0 || file_is_within(path, s->file)) return 0;
    return settings_wrong(s, KEY_OF(s, particles.bed_file),
                          "%s is not there, and a bed is written beside the "
                          "case alone, or in a folder that is there: expected "
                          "a name that does not lead elsewhere",
                          path);
}

/* The distributions, and the name that a bed gives. */
static int check_sizes(const struct settings *s)
{
    const char *const name = s->particles.bed_sizes;
    const int code = check_size_laws(s);

    if (code != 0 || name == NULL ||
        s->particles.bed.diameter > 0.0) /* said of both later */
        return code;
    return check_size_name(s, KEY_OF(s, particles.bed_sizes), name);
}

int case_population_check(struct settings *s)
{
    int code = check_sizes(s);

    if (code == 0) code = check_bed_file(s);
    for (int i = 0; i < s->particles.insert.n && code == 0; i++)
        code = check_source(s, i, &s->particles.insert.item[i]);
    for (int i = 0; i < s->particles.sinks.n && code == 0; i++)
        code = check_sink(s, i);
    return code != 0 ? code : check_period(s);
}

void case_population_bed_sizes(const struct settings *s, struct bed_options *b)
{
    if (s->particles.bed_sizes == NULL) return;
    b->sizes = create_sizes(s, s->particles.bed_sizes, 0);
    b->diameter = sizes_moment(b->sizes, 1) *
                  (b->clump == NULL ? 1.0 : clumps_shape_around(b->clump));
}

int case_population_place(const struct settings *s, struct particles *ps,
                          const struct dem_options *o)
{
    const char *const what = s->particles.overlaps;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    const struct overlap deep = overlaps_deepest(ps, &box);

    if (strcmp(what, "allow") == 0 || deep.depth <= OVERLAPS_MAX) return 0;
    if (strcmp(what, "refuse") == 0)
        return settings_wrong(
            s, KEY_OF(s, particles.place),
            "spheres of places %d and %d overlap by %.3g of their mean "
            "diameter; set particles.overlaps to %s\"allow\"",
            case_clumps_origin(s, deep.i), case_clumps_origin(s, deep.j),
            deep.depth, ps->clumps ? "" : "\"relax\" to move them apart or ");
    if (overlaps_relax(ps, &box, 1000) >= 0) return 0;
    return settings_wrong(s, KEY_OF(s, particles.place),
                          "there is no room to move the spheres apart");
}

static struct population_sink sink_of(const struct settings *s,
                                      const struct sink_setup *sink)
{
    struct population_sink k = sink->of;

    region(s, sink->has_from, sink->has_to, k.lo, k.hi);
    k.side = -1;
    for (int a = 0; a < 6; a++)
        if (strcmp(sink->side, mesh_sides[a]) == 0) k.side = a;
    return k;
}

void case_population_add(const struct settings *s, struct simulation *sim)
{
    const int n = s->particles.insert.n, m = s->particles.sinks.n;

    if (n + m == 0) return;
    const struct box_domain box = box_of(s);
    struct population *const l = sim->population =
        population_create(&box, n, m);
    for (int i = 0; i < n; i++) {
        struct insertion_options *const o = &l->sources[i].options;
        *o = s->particles.insert.item[i].of;
        o->region = sim->region;
        if (o->list == NULL) o->region.has_room = case_surfaces_are_apart;
    }
    for (int i = 0; i < m; i++)
        l->sinks[i] = sink_of(s, &s->particles.sinks.item[i]);
}

/* Prescribed particles that come now have their numbers if all find room. */
int case_population_start(const struct settings *s, struct simulation *sim)
{
    const int before = sim->particles != NULL ? sim->particles->n : 0;

    if (sim->population == NULL) return 0;
    population_insert(sim->population, sim->particles, sim->dem, sim->t);
    const long waiting = sim->population->totals.waiting;
    if (waiting == 0 || interrupt_arrived()) return 0;
    for (int k = 0; k < s->particles.prescribed.n; k++)
        if (prescribed_last(&s->particles.prescribed.item[k].of) >= before)
            return settings_wrong(
                s, sources,
                "%ld spheres find no room at the start, so that "
                "particles.prescribed would number others",
                waiting);
    return 0;
}

/* --- during a run, and after it ------------------------------------------- */

void case_population_report_waiting(const struct simulation *sim)
{
    const struct population *const l = sim->population;

    for (int i = 0; l != NULL && i < l->n_sources && sim->steps > 0; i++) {
        struct insertion *const in = &l->sources[i];
        const long due = insertion_count_due(in, sim->t - sim->dt);
        if (in->n_inserted < due)
            fprintf(
                stderr,
                "winnow: source %d of particles.insert: %ld of the %ld spheres "
                "that were due by t = %g s have found no room; make the region "
                "larger, the rate lower, or let particles leave it sooner\n",
                i, due - in->n_inserted, due, sim->t);
    }
}

int case_population_is_cut_short(const struct simulation *sim)
{
    return interrupt_arrived() && sim->population != NULL &&
           sim->population->totals.waiting > 0;
}
