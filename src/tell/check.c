/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tell/check.h"

#include "base/clock.h"
#include "coupling/coupling.h"
#include "coupling/effects.h"
#include "mesh/measures.h"
#include "case/build.h"
#include "case/checks/checks.h"
#include "case/particles/case_clumps.h"
#include "case/particles/case_population.h"
#include "coupling/processes.h"
#include "case/resolved/case_bodies.h"
#include "case/particles/case_surfaces.h"
#include "base/text.h"
#include "case/case_mesh.h"
#include "case/case_file.h"
#include "case/command.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <unistd.h>

/* A line with the place of the cell in question. */
static void line_at(const char *name, double value, const char *unit,
                    const struct mesh *m, int c, const char *advice)
{
    const double *const x = &m->centre[3 * c];
    char remark[256];

    snprintf(remark, sizeof remark, "at [%.3g, %.3g, %.3g] m%s%s", x[0], x[1],
             x[2], advice[0] != '\0' ? ": " : "", advice);
    text_line(name, value, unit, remark);
}

/* Of links that are not normal to their faces the part along the face is taken
 * from the step before, so that outer iterations are needed. */
static void print_bad_cells(const struct mesh *m, const struct mesh_quality *q)
{
    const double angle = q->non_orthogonal;

    line_at(
        "largest non-orthogonality", angle, "deg", m, q->n_non_orthogonal,
        angle > 80.0 ? "TOO LARGE: improve the mesh if the flow breaks down"
        : angle > 63.0
            ? "HIGH: the non-orthogonal correction of the pressure is limited"
        : angle > 45.0 ? "high: give fluid.outer_correctors 1 or 2"
                       : "good");
    line_at("largest skewness", q->skewness, "-", m, q->n_skewed,
            q->skewness > 0.8   ? "HIGH: corrected in part, by gradients"
            : q->skewness > 0.1 ? "corrected by gradients"
                                : "good");
    line_at("largest aspect ratio", q->aspect, "-", m, q->n_flat,
            q->aspect > 20.0 ? "high: solvers are slower on flat cells" : "");
    text_line("openness", q->openness, "-", "of the worst cell: closed");
    line_at("smallest cell", q->V_min, "m^3", m, q->n_small, "");
}

/* Beyond sqrt(7) widths the pressure can alternate from cell to cell (19.8). */
static void print_longest(const struct mesh *m)
{
    int c;
    const double longest = mesh_longest_cell(m, &c);
    static const char *const name = "longest cell over its width";
    static const char *const advice =
        "LONG: 2.6 at most where the flow changes within one";

    if (longest <= sqrt(7.0)) return;
    if (c < 0)
        text_line(name, longest, "-", advice);
    else
        line_at(name, longest, "-", m, c, advice);
}

/* The quality of the mesh: a box has no oblique links and no skewness. */
static void print_quality(const struct settings *s)
{
    struct mesh *const m = case_mesh_outline(s);
    const int crooked = m->face_centre != NULL;
    const struct mesh_quality q =
        crooked ? mesh_quality(m) : (struct mesh_quality){.growth = 1.0};
    double least, most, mean;

    mesh_volumes(m, &least, &most, &mean);
    if (crooked) print_bad_cells(m, &q);
    if (s->has.fluid) print_longest(m);
    if (most > least * (1.0 + 1e-9))
        text_line(
            "largest over smallest cell", most / least, "-",
            "volumes; what the schemes assume is near 1 between neighbours");
    if (q.growth > 1.0 + 1e-9)
        text_line("largest between neighbours", q.growth, "-",
                  q.growth > 2.1 ? "HIGH: second order is lost there" : "good");
    mesh_free(m);
}

static void print_resolution(const struct settings *s,
                             const struct case_scales *k)
{
    puts("Resolution");
    text_line("cells", k->cells, "-", "");
    text_line("S_c", k->S_c, "m", "cube root of the mean cell volume");
    if (k->particles == 0) return;
    text_line("particles", k->particles, "-",
              s->particles.clumps.n > 0 ? "each ball of a clump is one" : "");
    text_line("S_c / d", k->S_c / k->d_most, "-", "of the largest particle");
    text_line("N_p / N_c", (double)k->particles / k->cells, "-",
              k->cells > 1 && k->volume > 0.0 &&
                      k->volume < CHECK_PACKED * gsl_pow_3(k->S_c)
                  ? "ALL fit into one cell: are the lengths in m?"
                  : "particles a cell, in the mean");
}

static void print_one(const struct case_scales *k, const struct case_limits *m)
{
    if (m->rayleigh < HUGE_VAL) {
        text_line("T_R", m->rayleigh, "s",
                  "Rayleigh time of the smallest particle");
        text_line("particles.step / T_R", k->dem_dt / m->rayleigh, "-", "");
    }
    text_line("contact time", m->contact, "s",
              m->contact < HUGE_VAL ? "of two of the smallest particles"
                                    : "critical damping: no rebound");
    text_line("suggested step", m->suggested, "s", "");
    text_line("safe step", m->longest, "s", "");
}

static void print_contacts(const struct settings *s,
                           const struct case_scales *k)
{
    const double safe = case_scales_tightest(s, k->impact).longest;

    puts("Contacts");
    if (s->particles.list->no_contacts) {
        text_line("particle step", k->dem_dt, "s",
                  s->effects.particle_stress
                      ? "no contacts: the way in a step decides"
                      : "safe: particles.list = \"none\", no contacts");
        return;
    }
    text_line("impact speed", k->impact, "m/s", "assumed for what follows");
    for (int m = 0; m <= s->particles.materials.n; m++) {
        const struct case_limits one = case_scales_limits(s, m, k->impact);
        if (one.d <= 0.0) continue;
        if (s->particles.materials.n > 0)
            text_line(case_scales_name(s, m), one.d, "m", "smallest of it");
        print_one(k, &one);
    }
    text_line("particle step", k->dem_dt, "s",
              s->particles.integrator->adapts
                  ? "split in parts as short as particles.shortest_step"
              : case_scales_is_auto(s) ? "auto: the suggested one or less"
              : k->dem_dt <= safe      ? "safe"
                                  : "NOT SAFE: collisions are not resolved");
    text_line("particle steps in one step", k->dem_steps, "-", "");
}

/* The weight of the bed over its area [Pa], in a fluid of rho_f [kg/m^3]; 0 of
 * none, and in a mesh that has no one section. */
static double weight_over_area(const struct settings *s,
                               const struct case_scales *k, double rho_f)
{
    const double *const g = s->effects.gravity;
    double lo[3], size[3], area = 1.0;
    int up = 0;

    if (s->poly != NULL) return 0.0;
    if (!s->effects.has_gravity || !s->particles.has_bed) return 0.0;
    case_mesh_ends(s, lo, size);
    for (int i = 0; i < 3; i++)
        if (fabs(g[i]) > fabs(g[up])) up = i;
    for (int i = 0; i < 3; i++)
        if (i != up) area *= size[i] - lo[i];
    return k->volume * (s->particles.grains.density - rho_f) * fabs(g[up]) /
           area;
}

/* The pressure drop of a bed that a stream carries is its weight less its
 * buoyancy, for pressures are without the weight of the fluid. */
static void print_weight(const struct settings *s, const struct case_scales *k)
{
    const double rho_f = s->has.fluid ? s->fluid.rho : 0.0;
    const double weight = weight_over_area(s, k, rho_f);

    if (weight == 0.0) return;
    text_line(rho_f > 0.0 ? "buoyant weight of the bed over its area"
                          : "weight of the bed over its area",
              weight, "Pa",
              rho_f > 0.0 ? "the pressure drop of a fluidized bed" : "");
}

/* What a stress in the place of contacts has to go on. */
static void print_stress(const struct settings *s, const struct case_scales *k)
{
    double n[EFFECT_NUMBERS];
    const double eps_s = check_scales(s, k).eps_s;
    const double each = M_PI / 6.0 * gsl_pow_3(k->d);
    const double in_a_cell = eps_s * gsl_pow_3(k->S_c) / each;
    const double weight = weight_over_area(s, k, 0.0);
    const double way = k->impact * k->dt / k->S_c;

    if (!fill_effect_numbers(s, &particle_stress_effect, n)) return;
    puts("Particle stress");
    text_line("particles in a cell", in_a_cell, "-",
              in_a_cell < 5.0 ? "FEW: their noise decides"
                              : "where the particles are");
    text_line("way in a step / S_c", way, "-",
              way > 0.2 ? "LONG: cells are filled above the packing"
                        : "at the speed that is assumed");
    if (weight > 0.0)
        text_line("P_s / weight of the bed", n[1] / weight, "-",
                  n[1] > 1e-4 * weight
                      ? "SOFT: the bed packs slowly, and its floor bears "
                        "weight that the drop lacks"
                      : "stiff");
}

/* Where whole steps do not give the time between two rows or pictures. */
static void print_interval(const struct settings *s, const char *name,
                           const char *key, double asked, double dt)
{
    char remark[64];

    const double given = (double)case_steps_between(s, asked) * dt;

    if (fabs(given - asked) <= 0.01 * asked) return;
    snprintf(remark, sizeof remark, "in whole steps; %s is %.4g s", key, asked);
    text_line(name, given, "s", remark);
}

/* 1 if the bed is in the file that the case names. */
static int is_kept(const struct settings *s)
{
    char path[SETTINGS_PATH];

    if (s->particles.bed_file == NULL) return 0;
    settings_beside(s, s->particles.bed_file, path, sizeof path);
    return access(path, R_OK) == 0;
}

/* The first steps of a case, for at most `enough` of one core; nothing is
 * written. A bed that is not kept does not settle for that, so that its grains
 * do not touch. */
static const double enough = 0.3; /* [s] */

static long first_steps(const struct settings *s, double *seconds, int *code,
                        char why[BREAKDOWN_TEXT])
{
    const int threads = omp_get_max_threads();
    const long most = GSL_MIN(20, case_steps_until_end(s));
    struct settings now = *s;
    long n = 0;

    if (!is_kept(s)) {
        now.particles.bed.settle = 0.0;
        now.particles.bed_file = NULL;
    }
    now.quiet = 1;
    omp_set_num_threads(1);
    struct simulation *const sim = build_simulation(&now, code);
    int failed = sim != NULL && coupling_start(sim) != 0;
    *seconds = 0.0;
    while (sim != NULL && !failed && n < most && *seconds < enough) {
        const double began = clock_processor();
        failed = coupling_step(sim) != 0;
        *seconds += clock_processor() - began;
        n += !failed;
    }
    if (failed) breakdown_describe(sim, why);
    build_free(sim);
    omp_set_num_threads(threads);
    return n;
}

/* What a step of the case takes tells how long it runs, and whether it will
 * end at once. A step that takes too long for this is left to --try. */
static int print_time(const struct settings *s, const struct case_scales *k)
{
    const int settles =
        s->particles.has_bed && s->particles.bed.settle > 0.0 && !is_kept(s);
    char remark[96], why[BREAKDOWN_TEXT] = "";
    double seconds;
    int code = 0, comes = 0;

    for (int i = 0; i < s->particles.insert.n; i++)
        comes |= !insertion_at_once(&s->particles.insert.item[i].of);
    if (processes_engine != NULL) return 0;
    if (case_scales_cost(k, 1) * k->dt / k->end > enough) {
        printf("  time: winnow check %s --try %.2g tells\n", s->file,
               20.0 * k->dt);
        return 0;
    }
    const long n = first_steps(s, &seconds, &code, why);
    if (why[0] != '\0' && !settles) {
        printf("  the run ENDS: %s\n", why);
        return 3; /* as the run does */
    }
    if (n < 1 || why[0] != '\0') return code;
    snprintf(remark, sizeof remark, "of one core, %sfrom its first %ld steps%s",
             settles || comes ? "at least; " : "about, ", n,
             settles ? ", before the bed has settled"
             : comes ? ", before all grains have come"
                     : "");
    text_line("time", seconds / (double)n * (double)case_steps_until_end(s),
              "s", remark);
    return code;
}

static int print_cost(const struct settings *s, const struct case_scales *k)
{
    const struct output_options *const o = &s->output;
    const double steps = k->end / k->dt;

    puts("Cost");
    text_line("steps", steps, "-", "");
    if (o->history > 0.0)
        print_interval(s, "time between two rows", KEY_OF(s, output.history),
                       o->history, k->dt);
    print_interval(s, "time between two pictures", KEY_OF(s, output.every),
                   o->every, k->dt);
    text_line("particle steps", steps * k->dem_steps * k->particles, "-", "");
    text_line("memory", 1e-6 * case_memory_bytes(s), "MB", "about");
    return print_time(s, k);
}

int check_case(const struct settings *s)
{
    const struct case_scales k = case_scales_of(s);

    if (case_scales_check_memory(s, &k) != 0) return 2;
    if (s->has.particles && build_particles_check(s) != 0) return 2;

    printf("%s\n%s\n", s->title, s->cites);
    print_resolution(s, &k);
    print_quality(s);
    if (k.particles > 0) print_contacts(s, &k);
    if (k.particles > 0) print_stress(s, &k);
    if (k.particles > 0) check_cohesion(s, &k);
    if (k.particles > 0) case_parcels_print(s, &k, check_scales(s, &k).eps_s);
    case_clumps_print(s);
    case_surfaces_print(s, &k);
    processes_check_print(s, &k);
    case_bodies_report(s);
    if (s->output.statistics.on && s->output.statistics.from >= s->output.end)
        text_line("statistics", s->output.statistics.from, "s",
                  "they begin after the end: there are no samples");
    if (s->has.fluid) check_flow(s, &k);
    if (s->has.averaging) check_averaging(s, &k);
    if (s->has.exchange && k.particles > 0) check_drag(s, &k);
    if (k.particles > 0) {
        print_weight(s, &k);
        check_effects(s, &k);
    }
    const int code = print_cost(s, &k);
    check_accuracy(s, &k);
    const int refused = case_scales_check(s); /* as a run is */

    return refused != 0 ? refused : code;
}

static int check_wrong(const char *why)
{
    fprintf(stderr, "winnow: %s\nwinnow check %s\n", why,
            check_command.arguments);
    return 2;
}

static int check_act(const struct command_line *l)
{
    int code;

    if (l->tries != (l->n_words > 1))
        return check_wrong(l->tries ? "--try needs a number of seconds"
                                    : "one argument too many");
    if (l->tries) return check_try(l);
    struct settings *const s =
        case_file_read(l->words[0], l->n_overrides, l->overrides, &code);
    if (s != NULL) code = check_case(s);
    settings_free(s);
    return code;
}

const struct command check_command = {
    "check",
    "CASE [-s path.to.key=value]... [--try SECONDS [-j THREADS]]",
    "check a case and print the numbers that follow from it; --try runs it so "
    "long with all effects that could matter, and without each of them",
    "syj",
    1,
    2,
    check_act};
