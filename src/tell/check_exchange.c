/* SPDX-License-Identifier: GPL-3.0-or-later */
/* check_exchange.c -- time scales and limits of the drag, and attractions in
 * numbers. */
#include "tell/check.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/vector.h"
#include "case/build.h"
#include "base/text.h"
#include "case/particles/case_materials.h"
#include "case/particles/case_population.h"
#include "case/settings.h"
#include "coupling/coupling.h"
#include "coupling/drag.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "dem/attraction.h"

/* tau_p [s] of spheres of diameter d [m] at the solids fraction eps_s. */
static double case_drag_relaxation_time(const struct settings *s,
                                        const struct case_scales *k, double d,
                                        double eps_s)
{
    const struct drag_law law = build_drag_law(s);

    return drag_relaxation_time(&law, s->particles.grains.density, eps_s,
                                s->fluid.rho, s->fluid.mu, d,
                                k->inlet / (1.0 - eps_s));
}

/* The diameter [m] of a sphere of the mean volume of the bed: all sizes of a
 * mixture have the same backflow. */
static double case_drag_mean_diameter(const struct settings *s,
                                      const struct case_scales *k)
{
    if (s->particles.bed.count == 0) return check_scales(s, k).d;
    struct bed_options b = build_particles_bed(s);
    const double volume = bed_range(&b).volume;

    build_particles_free_bed(&b);
    return cbrt(6.0 / M_PI * volume / b.count) / case_parcels_across(s, 0);
}

/* Whether the case has a bed, or grains that will lie as densely, and so many
 * that they fill a cell. */
static int is_packed(const struct settings *s, const struct case_scales *k)
{
    return s->particles.bed.count > 0 ||
           (s->exchange.two_way && check_scales(s, k).eps_s >= CHECK_PACKED &&
            k->particles * M_PI / 6.0 * gsl_pow_3(k->d) >
                CHECK_PACKED * gsl_pow_3(k->S_c));
}

/* Warns where the law has no data: of the fluid fraction eps_f, or of the Re at
 * which the largest inlet passes grains of the diameter d. */
static void print_range(const struct settings *s, const struct case_scales *k,
                        double eps_f)
{
    const struct drag_law law = build_drag_law(s);
    const double Re = coefficient_reynolds(eps_f, s->fluid.rho, s->fluid.mu,
                                           k->d / k->across, k->inlet / eps_f);
    char remark[128];

    if (eps_f < law.eps_min || eps_f > law.eps_max) {
        snprintf(remark, sizeof remark, "OUTSIDE of %s's data, %g to %g",
                 law.name, law.eps_min, law.eps_max);
        text_line("fluid fraction", eps_f, "-", remark);
    }
    if (k->inlet > 0.0 && !(Re >= law.Re_min && Re <= law.Re_max)) {
        snprintf(remark, sizeof remark, "OUTSIDE of %s's data, %g to %g",
                 law.name, law.Re_min, law.Re_max);
        text_line("Re of the inlet", Re, "-", remark);
    }
}

/* [EW18 22] for a bed as loose as spheres are packed at random. */
static void print_fluidization(const struct settings *s,
                               const struct case_scales *k)
{
    const double eps_mf = 1.0 - CHECK_PACKED;
    char remark[96];

    const double u = fluidization_velocity(
        eps_mf, s->fluid.rho, s->particles.grains.density, s->fluid.mu,
        case_drag_mean_diameter(s, k), vector_length(s->effects.gravity));
    if (u <= 0.0) return;
    int n = snprintf(remark, sizeof remark,
                     "minimum fluidization, Ergun at eps_s = %g", CHECK_PACKED);
    if (k->up > 0.0)
        snprintf(remark + n, sizeof remark - (size_t)n,
                 "; the inlet has %.3g times that", k->inlet / u);
    else if (k->inlet > 0.0)
        snprintf(remark + n, sizeof remark - (size_t)n,
                 "; the inlet is NOT against gravity");
    text_line("u_mf", u, "m/s", remark);
}

/* What the effects of the case add to the mass of a sphere of mean size. */
static struct added_mass case_drag_added_mass(const struct settings *s,
                                              const struct case_scales *in)
{
    struct effect_scales k = {.rho_f = s->fluid.rho,
                              .mu = s->fluid.mu,
                              .dt = in->dt,
                              .d = case_drag_mean_diameter(s, in)};
    struct added_mass sum = {0};

    for (int i = 0; effects[i] != NULL; i++) {
        double numbers[EFFECT_NUMBERS];
        if (effects[i]->added_mass == NULL ||
            !fill_effect_numbers(s, effects[i], numbers))
            continue;
        k.numbers = numbers;
        effects[i]->added_mass(&k, &sum);
    }
    return sum;
}

/* The criteria for a bed: (20.6), (20.12), (20.13). */
static void print_bed(const struct settings *s, const struct case_scales *k)
{
    const struct added_mass added = case_drag_added_mass(s, k);
    const int implicit = s->exchange.treatment == TREATMENT_SEMI_IMPLICIT;
    const double rho_s = s->particles.grains.density;
    const double rho_f = s->fluid.rho;
    const double longest = stability_longest_step(
        1.0 - CHECK_PACKED,
        case_drag_relaxation_time(s, k, case_drag_mean_diameter(s, k),
                                  CHECK_PACKED));
    const double densest =
        stability_max_solid_fraction(&added, rho_s / rho_f, implicit);

    text_line("longest step for a packed bed", longest, "s",
              k->dt <= longest
                  ? "2 eps_f^2 tau_p: the step is below"
                  : "2 eps_f^2 tau_p: NOT STABLE, the step is above");
    text_line("mass loading M", stability_loading(rho_s, CHECK_PACKED, rho_f),
              "-", "mass of the bed over that of the fluid in it");
    text_line(
        "amplification of the pressure",
        stability_amplification(&added, rho_s / rho_f, CHECK_PACKED, implicit),
        "-",
        CHECK_PACKED < densest
            ? "factor in a step: it decays"
            : "NOT STABLE: it grows where the bed is packed");
    /* Spheres of many sizes settle at up to three quarters. */
    text_line("largest stable solid fraction", densest, "-",
              densest < 0.75 && CHECK_PACKED < densest &&
                      s->particles.bed_sizes != NULL
                  ? "eps_s; NOT STABLE where grains of many sizes pack denser"
              : added.C > 0.0 ? "eps_s, with the added mass"
                              : "eps_s, without an added mass");
}

void check_drag(const struct settings *s, const struct case_scales *k)
{
    const int asked = s->exchange.substeps;
    const double d = k->d / k->across; /* of a grain */
    const double bed = case_drag_relaxation_time(s, k, d, CHECK_PACKED);

    puts("Drag");
    text_line("tau_p", bed, "s", "relaxation time at eps_s = 0.6");
    text_line("tau_p", case_drag_relaxation_time(s, k, d, 0.0), "s",
              "of a lone particle");
    text_line("sub-steps",
              asked > 0 ? asked : coupling_needed_substeps(k->dt / bed), "-",
              asked > 0 ? "as the case asks" : "drag updates in a step, about");
    const int packed = is_packed(s, k);
    print_range(s, k, packed ? 1.0 - CHECK_PACKED : 1.0);
    if (!packed) return;
    print_fluidization(s, k);
    print_bed(s, k);
}

static void print_electrostatic(const struct settings *s,
                                const struct attraction *a, double d,
                                double weight)
{
    double most = 0.0;

    for (int k = 0; k < 1 + s->particles.materials.n; k++)
        most = fmax(most, fabs(a->charge[k]));
    text_line("electrostatic / weight",
              electrostatic_force(most, most, a->strength, d) / weight, "-",
              "of the largest charge on touching spheres");
    text_line("electrostatic at its range / touching",
              gsl_pow_2(d / (d + a->range)), "-", "cut off at the range");
}

static void print_van_der_waals(const struct attraction *a, double d,
                                double weight, double travel)
{
    const double D = van_der_waals_diameter(d, d);

    text_line("van der Waals / weight",
              van_der_waals_force(a->strength, D, a->closest) / weight, "-",
              "at the closest gap");
    text_line("van der Waals at its range / closest",
              gsl_pow_2(a->closest / a->range), "-", "cut off at the range");
    text_line(
        "closest gap / path in a step", a->closest / travel, "-",
        a->closest >= travel
            ? "the well is resolved"
            : "NOT RESOLVED: the energy of an impact depends on the step");
}

void check_cohesion(const struct settings *s, const struct case_scales *k)
{
    const double d = k->d, density = k->density;
    const double weight = density * M_PI / 6.0 * gsl_pow_3(d) * 9.81;
    int n;
    struct attraction *const all = case_materials_attractions(s, &n);

    if (n > 0) puts("Cohesion");
    for (int i = 0; i < n; i++) {
        const struct attraction *const a = &all[i];
        if (a->law == &electrostatic) print_electrostatic(s, a, d, weight);
        if (a->law == &van_der_waals)
            print_van_der_waals(a, d, weight, k->impact * k->dem_dt);
        if (a->law == &capillary)
            text_line("capillary / weight",
                      -capillary_force(a->strength, 0.5 * d) / weight, "-",
                      "of two of the smallest particles");
    }
    free(all);
}
