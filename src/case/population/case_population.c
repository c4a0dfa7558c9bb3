/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/population/case_population.h"

#include <gsl/gsl_math.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "coupling/population/replacement.h"
#include "dem/population/overlaps.h"
#include "dem/population/grain_table.h"
#include "dem/population/population.h"
#include "case/cohesion/case_cohesion.h"
#include "case/case_materials.h"
#include "case/checks/materials_check.h"
#include "case/case_mesh.h"
#include "case/population/case_sizes.h"
#include "case/particle_options.h"

static const char sources[] = "particles.insert", sinks[] = "particles.sinks",
                  bed_key[] = "particles.bed.sizes";

/* The largest share of a region that random positions can fill in a short time.
 */
static const double densest = 0.3;

static int case_population_has(const struct settings *s, int i, const char *key)
{
    return settings_item_has(s, sources, i, key);
}

/* A region that is not given is the whole box. */
static void region(const struct settings *s, const char *list, int i,
                   double lo[3], double hi[3])
{
    case_mesh_ends(s, lo, hi);
    if (settings_item_has(s, list, i, "from"))
        settings_item_vector(s, list, i, "from", lo);
    if (settings_item_has(s, list, i, "to"))
        settings_item_vector(s, list, i, "to", hi);
}

static int case_population_material_of(const struct settings *s, int i)
{
    return case_population_has(s, i, "material")
               ? case_materials_number(
                     s, settings_item_text(s, sources, i, "material"))
               : 0;
}

/* Without a file; sizes and list come after. */
static struct insertion_options
case_population_options(const struct settings *s, int i)
{
    struct insertion_options o = {
        .diameter = settings_item_real_or(s, sources, i, "diameter", 0.0),
        .material = case_population_material_of(s, i),
        .count = case_population_has(s, i, "count")
                     ? settings_item_int(s, sources, i, "count")
                     : 0,
        .rate = settings_item_real_or(s, sources, i, "rate", 0.0),
        .start = settings_item_real(s, sources, i, "start"),
        .seed = (unsigned long)settings_item_int(s, sources, i, "seed")};

    region(s, sources, i, o.lo, o.hi);
    settings_item_vector(s, sources, i, "velocity", o.velocity);
    o.density = case_materials_density(s, o.material);
    return o;
}

static struct sizes *sizes_of(const struct settings *s, int i)
{
    return case_population_has(s, i, "sizes")
               ? case_sizes_create(s,
                                   settings_item_text(s, sources, i, "sizes"))
               : NULL;
}

static struct box_domain box_of(const struct settings *s)
{
    double lo[3], hi[3];
    int periodic[3];

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    return box_domain_of(lo, hi, periodic);
}

/* One source whole; non-zero after a message if its file is wrong. */
static int create_source(const struct settings *s, int i, struct insertion *in)
{
    *in = (struct insertion){.options = case_population_options(s, i),
                             .own_sizes = sizes_of(s, i)};
    in->options.sizes = in->own_sizes;
    char path[SETTINGS_PATH];
    double offset[3];

    if (!case_population_has(s, i, "file")) return 0;
    settings_beside(s, settings_item_text(s, sources, i, "file"), path,
                    sizeof path);
    in->own_list = grain_table_read(path, &in->options.count);
    in->options.list = in->own_list;
    if (in->options.rate == 0.0)
        in->options.overlap = particle_options_wall_overlap(s);
    const struct box_domain box = box_of(s);
    settings_item_vector(s, sources, i, "offset", offset);
    if (in->own_list != NULL)
        insertion_move(in->own_list, in->options.count, offset, &box);
    return in->own_list == NULL;
}

static void free_source(struct insertion *in)
{
    sizes_free(in->own_sizes);
    free(in->own_list);
}

/* --- checks -------------------------------------------------------------- */

static int case_population_check_names(const struct settings *s, int i)
{
    if (case_population_has(s, i, "sizes") &&
        case_sizes_check_name(s, sources,
                              settings_item_text(s, sources, i, "sizes")) != 0)
        return 2;
    if (case_population_has(s, i, "material"))
        return materials_check_name(
            s, sources, settings_item_text(s, sources, i, "material"));
    return 0;
}

static int case_population_check_given(const struct settings *s, int i)
{
    const int file = case_population_has(s, i, "file");
    const int sized = case_population_has(s, i, "diameter") +
                      case_population_has(s, i, "sizes");

    if (file && (sized > 0 || case_population_has(s, i, "count")))
        return settings_wrong(s, sources,
                              "source %d: a file says how many there are and "
                              "how large; leave out count, diameter and sizes",
                              i);
    if (!file && !case_population_has(s, i, "count"))
        return settings_wrong(s, sources, "source %d needs count or file", i);
    if (!file && sized != 1)
        return settings_wrong(s, sources,
                              "source %d: give either diameter or sizes%s", i,
                              sized > 1 ? ", not both" : "");
    return 0;
}

/* The diameters that will come: smallest, largest, and volume of all [m^3]. */
struct source_sizes {
    double min, max, volume;
};

static struct source_sizes sizes_of_source(const struct insertion_options *o)
{
    struct source_sizes c = {0.0, 0.0, 0.0};

    for (long k = 0; k < o->count; k++) {
        const double d = insertion_diameter(o, k);
        c.min = k == 0 ? d : fmin(c.min, d);
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

    if (o->rate > 0.0 || !insertion_overlap(o, box, o->overlap, who)) return 0;
    return settings_wrong(
        s, sources,
        "source %d: spheres %d and %d of its file overlap; move them apart, or "
        "set particles.overlaps to \"allow\"",
        i, who[0], who[1]);
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
                "inside the box, %g to %g m, and have room for spheres of %g "
                "m",
                i, o->lo[k], o->hi[k], 'x' + k, lo[k], hi[k], c.max);
    }
    if (o->rate > 0.0 || c.volume <= densest * volume) return 0;
    return settings_wrong(
        s, sources,
        "source %d: %ld spheres would fill %.0f %% of its region; at random no "
        "more than %.0f %% find room: give it a rate, or a larger region",
        i, o->count, 100.0 * c.volume / volume, 100.0 * densest);
}

static int check_source(const struct settings *s, int i)
{
    struct insertion in;
    int code = case_population_check_names(s, i);

    if (code == 0) code = case_population_check_given(s, i);
    if (code != 0) return code;
    code = create_source(s, i, &in) != 0 ? 2 : check_region(s, i, &in.options);
    free_source(&in);
    return code;
}

static int check_sink(const struct settings *s, int i)
{
    const int side =
        settings_item_has(s, sinks, i, "side") &&
        strcmp(settings_item_text(s, sinks, i, "side"), "none") != 0;
    const int box = settings_item_has(s, sinks, i, "from") +
                    settings_item_has(s, sinks, i, "to");

    if (box > 0 ? !side : side) return 0;
    return settings_wrong(s, sinks, "sink %d: give either side, or from and to",
                          i);
}

/* --- particles that come later ------------------------------------------- */

int case_population_count(const struct settings *s)
{
    long sum = 0;

    for (int i = 0; i < settings_length(s, sources); i++) {
        struct insertion in;
        if (create_source(s, i, &in) == 0) sum += in.options.count;
        free_source(&in);
    }
    return number_clamped((double)sum, 0, INT_MAX);
}

struct case_diameters case_population_diameters(const struct settings *s,
                                                int material)
{
    struct case_diameters all = {0.0, 0.0};

    for (int i = 0; i < settings_length(s, sources); i++) {
        struct insertion in;
        if (material >= 0 && case_population_material_of(s, i) != material)
            continue;
        if (create_source(s, i, &in) == 0) {
            const struct source_sizes c = sizes_of_source(&in.options);
            all.min = all.min > 0.0 ? fmin(all.min, c.min) : c.min;
            all.max = fmax(all.max, c.max);
        }
        free_source(&in);
    }
    return all;
}

/* The length of a period, which dem_create checks for those there at first. */
static int check_period(const struct settings *s)
{
    struct dem_options o = particle_options_dem(s, 1.0);
    const double most = case_population_diameters(s, -1).max;
    struct attraction *const pulls = case_cohesion_create(s, &o.n_attractions);

    o.attractions = pulls;
    const int wrong = most > 0.0 && dem_period_wrong(&o, most, most);
    free(pulls);
    return wrong ? 2 : 0;
}

/* The distributions, and the name that a bed gives. */
static int check_sizes(const struct settings *s)
{
    const int code = case_sizes_check(s);

    if (code != 0 || !settings_has(s, bed_key) ||
        settings_has(s, "particles.bed.diameter")) /* said of both later */
        return code;
    return case_sizes_check_name(s, bed_key, settings_text(s, bed_key));
}

int case_population_check(const struct settings *s)
{
    int code = check_sizes(s);

    if (code == 0) code = case_sizes_check_file(s);

    for (int i = 0; i < settings_length(s, sources) && code == 0; i++)
        code = check_source(s, i);
    for (int i = 0; i < settings_length(s, sinks) && code == 0; i++)
        code = check_sink(s, i);
    return code != 0 ? code : check_period(s);
}

void case_population_bed_sizes(const struct settings *s, struct bed_options *b)
{
    if (!settings_has(s, bed_key)) return;
    b->sizes = case_sizes_create(s, settings_text(s, bed_key));
    b->quantile = sizes_quantile;
    b->free_sizes = sizes_free;
    b->diameter = sizes_moment(b->sizes, 1);
}

int case_population_place(const struct settings *s, struct particles *ps,
                          const struct dem_options *o)
{
    const char *const what = settings_text(s, "particles.overlaps");
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    const struct overlap deep = overlaps_deepest(ps, &box);

    if (strcmp(what, "allow") == 0 || deep.depth <= OVERLAPS_MAX) return 0;
    if (strcmp(what, "refuse") == 0)
        return settings_wrong(
            s, "particles.place",
            "spheres %d and %d overlap by %.3g of their mean diameter; set "
            "particles.overlaps to \"relax\" to move them apart, or to "
            "\"allow\"",
            deep.i, deep.j, deep.depth);
    if (overlaps_relax(ps, &box, 1000) >= 0) return 0;
    return settings_wrong(s, "particles.place",
                          "the spheres overlap, and there is no room to move "
                          "them apart");
}

static struct population_sink sink_of(const struct settings *s, int i)
{
    struct population_sink k = {.side = -1};

    region(s, sinks, i, k.lo, k.hi);
    for (int a = 0; a < 6; a++)
        if (settings_item_has(s, sinks, i, "side") &&
            strcmp(settings_item_text(s, sinks, i, "side"), mesh_sides[a]) == 0)
            k.side = a;
    return k;
}

int case_population_add(const struct settings *s, struct simulation *sim)
{
    const int n = settings_length(s, sources), m = settings_length(s, sinks);
    int code = 0;

    if (n + m == 0) return 0;
    const struct box_domain box = box_of(s);
    struct population *const l = sim->population =
        population_create(&box, n, m);
    sim->insert_remove = &replacement_functions;
    for (int i = 0; i < n && code == 0; i++) {
        code = create_source(s, i, &l->sources[i]) != 0 ? 2 : 0;
        l->sources[i].options.region = sim->region;
    }
    for (int i = 0; i < m; i++)
        l->sinks[i] = sink_of(s, i);
    return code;
}
