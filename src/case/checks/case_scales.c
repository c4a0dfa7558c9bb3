/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/checks.h"

#include <libconfig.h>
#include <limits.h>
#include <math.h>

#include "averaging/averaging.h"
#include "averaging/kernel/weights.h"
#include "base/number.h"
#include "base/vector.h"
#include "case/build.h"
#include "case/particles/case_clumps.h"
#include "case/particles/case_materials.h"
#include "case/case_mesh.h"
#include "case/case_file.h"
#include "case/particles/case_population.h"
#include "dem/contact.h"

/* Particles that are inserted later count as if they were there. */
static void add_inserted(const struct settings *s, struct case_scales *k)
{
    k->particles += case_population_count(s);
    k->d_most = fmax(k->d_most, case_population_diameters(s, -1).max);
    for (int m = 0; m <= s->particles.materials.n; m++) {
        const double d = case_population_diameters(s, m).min;
        if (d > 0.0) k->d = k->d > 0.0 ? fmin(k->d, d) : d;
    }
}

static void particle_scales(const struct settings *s, struct case_scales *k)
{
    k->density = s->particles.grains.density;
    k->across = case_parcels_across(s, 0);
    if (s->particles.has_bed) {
        struct bed_options b = build_particles_bed(s);
        const struct bed_range range = bed_range(&b);
        k->particles = number_clamped(range.balls, 0, INT_MAX);
        k->d = range.ball;
        k->d_most = range.max;
        k->volume = range.volume;
        build_particles_free_bed(&b);
        return;
    }
    for (int i = 0; i < s->particles.place.n; i++) {
        const struct place_setup *const p = &s->particles.place.item[i];
        const double d =
            clumps_least_ball(case_clumps_shape(s, p->clump), p->diameter);

        k->particles +=
            number_clamped(case_clumps_balls(s, p->clump, 1.0), 1, INT_MAX);
        k->d = i == 0 ? d : fmin(k->d, d);
        k->d_most = fmax(k->d_most, p->diameter);
    }
}

/* Of the outline of a box the patches come in the order left, right, bottom,
 * ... */
void case_scales_inward(const struct mesh *m, const struct patch *p,
                        double e[3])
{
    e[0] = e[1] = e[2] = 0.0;
    for (int i = 0; i < 6 && m->face_centre == NULL; i++)
        if (mesh_patch(m, mesh_sides[i]) == p) e[i / 2] = i % 2 ? -1.0 : 1.0;
    for (int f = p->first; f < p->first + p->n && m->face_centre != NULL; f++)
        vector_along(e, -1.0, mesh_S(m, f), e);
    vector_unit(e, e);
}

/* The section of the mesh across gravity, in the mean [m^2]. */
static double mean_section(const struct settings *s, const struct mesh *m)
{
    const double *const g = s->effects.gravity;
    int up = 0;

    for (int i = 1; i < 3; i++)
        if (fabs(g[i]) > fabs(g[up])) up = i;
    return case_mesh_volume(s) / (m->hi[up] - m->lo[up]);
}

/* The area of a patch over that section, where it is not that of a box: a
 * vessel may widen [-]. */
static double share_of_section(const struct settings *s, const struct mesh *m,
                               const struct patch *p)
{
    if (m->face_centre == NULL) return 1.0;
    return case_mesh_area(m, p) / mean_section(s, m);
}

/* A stream of U [m/s] along e, with length 1: its part against the fall of the
 * particles, which rise if they are lighter; in the mean over the section. */
static void add_stream(const struct settings *s, double U, double share,
                       const double e[3], struct case_scales *k)
{
    const double g = vector_length(s->effects.gravity);
    const double falls =
        s->particles.grains.density < s->fluid.rho ? -1.0 : 1.0;

    k->inlet = fmax(k->inlet, U);
    if (g > 0.0)
        k->up = fmax(k->up, -falls * U * share *
                                vector_dot(e, s->effects.gravity) / g);
}

/* The sum of the changes of a series up to its end [m/s], from rest. */
static double changes_of(const struct key_series *x, double end)
{
    double sum = fabs(x->value[0]);

    for (int j = 1; j < x->n && x->at[j - 1] < end; j++)
        sum += fabs(x->value[j] - x->value[j - 1]) *
               fmin(1.0, (end - x->at[j - 1]) / (x->at[j] - x->at[j - 1]));
    return sum;
}

/* The mean square of a series up to its end over that of its largest [-]. */
static double inlet_square(const struct key_series *x, double end)
{
    double most = fabs(x->value[0]), sum = 0.0, v = x->value[0];
    double rest = end;

    for (int j = 1; j < x->n; j++) {
        const double T = x->at[j] - x->at[j - 1], lasts = fmin(T, rest);
        const double to = v + lasts / T * (x->value[j] - v);
        sum += lasts * (v * v + v * to + to * to) / 3.0;
        rest -= lasts;
        v = x->value[j];
        most = fmax(most, fabs(v));
    }
    sum += rest * v * v;
    return most > 0.0 ? sum / (end * most * most) : 1.0;
}

/* The largest in time, in the mean over its side: where a jet comes through a
 * slot, the grains beside it are not struck at the speed of the jet. */
static void stream_scales(const struct settings *s, const struct mesh *m,
                          struct case_scales *k)
{
    double mean, peak, e[3];

    for (int i = 0; i < m->n_patches; i++) {
        const struct boundary_options *const o =
            settings_side(s, m->patches[i].name);

        if (o == NULL || o->inlet.n == 0) continue;
        build_boundaries_shares(s, m->patches[i].name, &mean, &peak);
        case_scales_inward(m, &m->patches[i], e);
        k->way = 0.0;
        for (int a = 0; a < 3; a++)
            k->way += fabs(e[a]) * (m->hi[a] - m->lo[a]);
        k->changes = fmax(k->changes, mean * changes_of(&o->inlet, k->end));
        k->square = fmax(k->square, inlet_square(&o->inlet, k->end));
        for (int j = 0; j < o->inlet.n; j++) {
            add_stream(s, o->inlet.value[j] * mean,
                       share_of_section(s, m, &m->patches[i]), e, k);
            if (peak > 1.5 * mean) /* more than a parabola between walls has */
                k->jet = fmax(k->jet, o->inlet.value[j] * peak);
        }
    }
    const double U = vector_length(s->fluid.mean_flow);
    vector_unit(s->fluid.mean_flow, e);
    if (U > 0.0) add_stream(s, U, 1.0, e, k);
    if (U > 0.0) k->square = 1.0;
    k->changes = fmax(k->changes, U); /* it is there from the first step on */
}

/* The speed [m/s] at which a sphere meets a wall or another one that starts
 * with v [m/s] within lo ... hi [m]: what it gains on the longest way down to
 * the walls, in the time of the run; in a fluid at most that of a free fall
 * with the smallest drag coefficient of a sphere, 0.44. A periodic direction
 * has no end; a bed, also one from a file, is at rest. */
static double fall_speed(const struct settings *s, double v, double d,
                         const double lo[3], const double hi[3])
{
    const double *const g = s->effects.gravity;
    double end[2][3], gained = 0.0;
    int periodic[3];

    case_mesh_ends(s, end[0], end[1]);
    case_mesh_periodic(s, periodic);
    for (int k = 0; k < 3; k++) {
        const double way = g[k] > 0.0 ? end[1][k] - lo[k] : hi[k] - end[0][k];
        if (!periodic[k]) gained += fabs(g[k]) * fmax(way - 0.5 * d, 0.0);
    }
    const double G = vector_length(g);
    double dv = fmin(sqrt(v * v + 2.0 * gained) - v, G * s->output.end);
    if (s->has.fluid) {
        const double ratio = s->particles.grains.density / s->fluid.rho;
        dv = fmin(dv, sqrt(4.0 / 3.0 * G * d * fabs(ratio - 1.0) / 0.44));
    }
    return v + dv;
}

/* [m/s] of the spheres that are placed, and of those that are inserted. */
static double fastest_sphere(const struct settings *s, double d_most)
{
    double fastest = 0.0;

    for (int i = 0; i < s->particles.place.n; i++) {
        const struct place_setup *const p = &s->particles.place.item[i];
        fastest =
            fmax(fastest, fall_speed(s, vector_length(p->velocity), p->diameter,
                                     p->position, p->position));
    }
    for (int i = 0; i < s->particles.insert.n; i++) {
        const struct insert_setup *const in = &s->particles.insert.item[i];
        const double v = vector_length(in->of.velocity);
        fastest = fmax(fastest, v);
        if (in->file != NULL && insertion_at_once(&in->of))
            continue; /* a bed */
        fastest = fmax(fastest, fall_speed(s, v, d_most, in->of.lo, in->of.hi));
    }
    return fastest;
}

/* [m/s] of a wall or a particle that moves as prescribed (motion.h); one that
 * turns about its centre reaches to the end of the mesh. */
static double motion_highest(const struct settings *s, const struct motion *m,
                             int has_centre)
{
    double reach = 0.0, lo[3], hi[3];

    case_mesh_ends(s, lo, hi);
    for (int k = 0; k < 3 && has_centre; k++)
        reach = hypot(reach, fmax(m->centre[k] - lo[k], hi[k] - m->centre[k]));
    return motion_speed(m, reach);
}

static double fastest_motion(const struct settings *s)
{
    const struct particles_setup *const p = &s->particles;
    double most = 0.0;

    for (int i = 0; i < p->surfaces.n; i++)
        most = fmax(most, motion_highest(s, &p->surfaces.item[i].of.motion, 1));
    for (int i = 0; i < p->prescribed.n; i++) {
        const struct prescribed_setup *const one = &p->prescribed.item[i];
        most = fmax(most, motion_highest(s, &one->of.motion, one->has_centre));
    }
    return most;
}

/* The scales of a case that are known before its run: cells, steps, speeds,
 * times. */
struct case_scales case_scales_of(const struct settings *s)
{
    struct mesh *const m = case_mesh_outline(s);
    struct case_scales k = {.cells = m->n_cells};

    k.S_c = cbrt(case_mesh_volume(s) / k.cells); /* [SX15 10] */
    k.end = s->output.end;
    k.dt = case_steps_length(s);
    k.dem_steps = case_steps_within(s);
    if (s->has.fluid) stream_scales(s, m, &k);
    if (s->has.particles) {
        particle_scales(s, &k);
        add_inserted(s, &k);
        k.dem_dt = k.dt / k.dem_steps;
    }
    k.impact =
        fmax(k.inlet, sqrt(2.0 * vector_length(s->effects.gravity) * k.d_most));
    k.impact = fmax(k.impact, fastest_sphere(s, k.d_most));
    k.impact = fmax(k.impact, fastest_motion(s));
    if (k.impact == 0.0) k.impact = 1.0; /* nothing flows, falls or flies */
    mesh_free(m);
    return k;
}

int case_scales_is_auto(const struct settings *s)
{
    const config_setting_t *at =
        config_setting_get_member(settings_root(s), "particles");

    if (at != NULL) at = config_setting_get_member(at, "step");
    return at != NULL && config_setting_get_string(at) != NULL;
}

int case_scales_auto_step(struct settings *s)
{
    double least = HUGE_VAL;

    if (!case_scales_is_auto(s)) return 0;
    s->particles.step = s->output.end; /* the speeds do not depend on it */
    const struct case_scales k = case_scales_of(s);
    for (int m = 0; m <= s->particles.materials.n; m++) {
        const struct case_limits one = case_scales_limits(s, m, k.impact);
        if (one.d > 0.0) least = fmin(least, one.suggested);
    }
    if (least == HUGE_VAL || s->particles.list->no_contacts)
        return settings_wrong(s, KEY_OF(s, particles.step),
                              "\"auto\": there are no contacts that a step "
                              "would have to resolve; expected a number of s");
    s->particles.step = least;
    return 0;
}

/* The weights that an averaging method stores for each cell can take more than
 * all else. */
int case_scales_check_memory(const struct settings *s,
                             const struct case_scales *k)
{
    if (!s->has.averaging) return 0;
    struct mesh *const m = case_mesh_outline(s);
    const struct averaging_options o = build_averaging_options(s);
    const double bytes = weights_bytes(o.method, m, k->d_most, &o);

    mesh_free(m);
    return case_memory_check(s, bytes);
}

/* Without contacts a bed does not come to rest. */
static int case_scales_check_no_contacts(const struct settings *s)
{
    const struct bed_options *const bed = &s->particles.bed;

    if (bed->count == 0 || bed->settle == 0.0) return 0;
    return settings_wrong(s, KEY_OF(s, particles.list),
                          "\"none\": no bed comes to rest without contacts; "
                          "give particles.bed.settle = 0.0, or place the "
                          "spheres");
}

int case_scales_check(const struct settings *s)
{
    if (!s->has.particles) return 0;
    const struct case_scales k = case_scales_of(s);
    if (case_scales_check_memory(s, &k) != 0) return 2;
    if (s->particles.list->no_contacts) return case_scales_check_no_contacts(s);
    if (s->particles.unsafe_step) return 0;
    const struct case_limits m = case_scales_tightest(s, k.impact);
    const int adapts = s->particles.integrator->adapts;
    const double dt = adapts ? s->particles.shortest_step : k.dem_dt;
    if (m.d <= 0.0 || dt <= m.longest) return 0;
    if (adapts)
        return settings_wrong(s, KEY_OF(s, particles.shortest_step),
                              "%.3g s does not resolve the impacts, which last "
                              "%.3g s: at most %.3g s",
                              dt, m.contact, m.longest);
    if (0.5 * m.d < k.impact * m.longest * (1.0 + 1e-9))
        return settings_wrong(
            s, KEY_OF(s, particles.step),
            "at %.3g m/s a sphere of %.3g m moves by more than half of its "
            "diameter in %.3g s, and could pass through another one: at most "
            "%.3g s, better %.3g s; to run all the same set "
            "particles.unsafe_step = true",
            k.impact, m.d, k.dem_dt, m.longest, m.suggested);
    return settings_wrong(
        s, KEY_OF(s, particles.step),
        "%.3g s does not resolve the impacts of %s of %.3g m, which last %.3g "
        "s: at most %.3g s, better %.3g s; to run all the same set "
        "particles.unsafe_step = true",
        k.dem_dt,
        s->particles.clumps.n > 0 ? "balls" : case_scales_name(s, m.material),
        m.d, m.contact, m.longest, m.suggested);
}

const char *case_scales_name(const struct settings *s, int m)
{
    return m == 0 ? "grains" : s->particles.materials.item[m - 1].name;
}

/* The smaller of two diameters, of which 0 is none. */
static double smaller(double a, double b)
{
    return a > 0.0 && b > 0.0 ? fmin(a, b) : fmax(a, b);
}

static double smallest_placed(const struct settings *s, int m)
{
    double least = 0.0;

    for (int i = 0; i < s->particles.place.n; i++) {
        const struct place_setup *const p = &s->particles.place.item[i];
        if (case_materials_number(s, p->material) == m)
            least =
                smaller(least, clumps_least_ball(case_clumps_shape(s, p->clump),
                                                 p->diameter));
    }
    return least;
}

/* A bed is of material 0. */
static double smallest_of_bed(const struct settings *s, int m)
{
    if (m != 0 || !s->particles.has_bed) return 0.0;
    struct bed_options b = build_particles_bed(s);
    const struct bed_range range = bed_range(&b);
    build_particles_free_bed(&b);
    return b.count > 0 ? range.ball : 0.0;
}

struct case_limits case_scales_limits(const struct settings *s, int m, double v)
{
    const struct contact_law *const law = s->particles.contact;
    const struct material of = case_materials_one(s, m);
    struct case_limits k = {.material = m};

    k.density = case_clumps_filled(s) * case_materials_setup(s, m)->density;
    k.d = smaller(smallest_of_bed(s, m), smallest_placed(s, m));
    k.d = smaller(k.d, case_population_diameters(s, m).min);
    if (k.d <= 0.0) return k;
    k.rayleigh = law->wave_time(&of, 0.5 * k.d, k.density);
    k.contact = limits_contact_time(law, &of, k.d, k.density, v);
    k.suggested = limits_step(law, &of, k.d, k.density, v);
    k.longest = limits_longest_step(law, &of, k.d, k.density, v);
    return k;
}

double case_scales_initial_speed(const struct settings *s)
{
    const struct particles_setup *const p = &s->particles;
    double fastest = 0.0;

    for (int i = 0; i < p->place.n; i++)
        fastest = fmax(fastest, vector_length(p->place.item[i].velocity));
    for (int i = 0; i < p->insert.n; i++)
        fastest = fmax(fastest, vector_length(p->insert.item[i].of.velocity));
    return fastest;
}

struct case_limits case_scales_tightest(const struct settings *s, double v)
{
    struct case_limits tightest = case_scales_limits(s, 0, v);

    for (int m = 1; m <= s->particles.materials.n; m++) {
        const struct case_limits k = case_scales_limits(s, m, v);
        if (k.d > 0.0 && (tightest.d <= 0.0 || k.longest < tightest.longest))
            tightest = k;
    }
    return tightest;
}

/* What one core was seen to do in the Mueller bed, busy with other work beside
 * it: 9.0e6 particle steps a second with Hertz's law, 7.7e6 with the linear
 * one, and 5.1e5 cell steps with all that the coupling needs. */
static const double particle_steps_per_second = 8e6;
static const double cell_steps_per_second = 5e5;

double case_scales_cost(const struct case_scales *k, int flow)
{
    const double steps = k->end / k->dt;

    return steps * k->dem_steps * k->particles / particle_steps_per_second +
           steps * k->cells * flow / cell_steps_per_second;
}

double case_scales_seconds(const struct settings *s)
{
    const struct case_scales k = case_scales_of(s);

    return case_scales_cost(&k, s->has.fluid);
}
