/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/case_drag.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "coupling/drag.h"
#include "coupling/drag_laws/coefficient.h"
#include "coupling/drag_laws/fluidization.h"
#include "coupling/coupling.h"
#include "coupling/stability/stability.h"
#include "base/vector.h"
#include "case/build.h"
#include "case/checks/check_line.h"
#include "case/particle_options.h"
#include "case/table_numbers.h"
#include "coupling/effect_scales.h"
#include "coupling/effects.h"

/* tau_p [s] of spheres of diameter d [m] at the solids fraction eps_s. */
static double case_drag_relaxation_time(const struct settings *s,
                                        const struct drag_scales *k, double d,
                                        double eps_s)
{
    const struct drag_law law = build_drag_law(s);

    return drag_relaxation_time(&law, s->particles.grains.density, eps_s,
                                s->fluid.rho, s->fluid.mu, d,
                                k->inlet / (1.0 - eps_s));
}

/* The diameter [m] of a sphere of the mean volume of the bed: all sizes of a
 * mixture have the same backflow. */
static double case_drag_mean_diameter(const struct settings *s)
{
    struct bed_options b = particle_options_bed(s);
    const double volume = bed_range(&b).volume;

    particle_options_release(&b);
    return cbrt(6.0 / M_PI * volume / b.count);
}

/* Warns where the law has no data: of the fluid fraction eps_f, or of the Re at
 * which the largest inlet passes grains of the diameter d. */
static void print_range(const struct settings *s, const struct drag_scales *k,
                        double eps_f)
{
    const struct drag_law law = build_drag_law(s);
    const double Re = coefficient_reynolds(eps_f, s->fluid.rho, s->fluid.mu,
                                           k->d, k->inlet / eps_f);
    char remark[128];

    if (eps_f < law.eps_min || eps_f > law.eps_max) {
        snprintf(remark, sizeof remark, "OUTSIDE of %s's data, %g to %g",
                 law.name, law.eps_min, law.eps_max);
        check_line("fluid fraction", eps_f, "-", remark);
    }
    if (k->inlet > 0.0 && !(Re >= law.Re_min && Re <= law.Re_max)) {
        snprintf(remark, sizeof remark, "OUTSIDE of %s's data, %g to %g",
                 law.name, law.Re_min, law.Re_max);
        check_line("Re of the inlet", Re, "-", remark);
    }
}

/* [EW18 22] for a bed as loose as spheres are packed at random. */
static void print_fluidization(const struct settings *s,
                               const struct drag_scales *k)
{
    const double eps_mf = 1.0 - k->eps_s;
    char remark[96];

    const double u = fluidization_velocity(
        eps_mf, s->fluid.rho, s->particles.grains.density, s->fluid.mu,
        case_drag_mean_diameter(s), vector_length(s->effects.gravity));
    if (u <= 0.0) return;
    snprintf(remark, sizeof remark,
             "minimum fluidization, Ergun at eps_s = %g; the inlet has %.3g "
             "times that",
             k->eps_s, k->inlet / u);
    check_line("u_mf", u, "m/s", remark);
}

/* What the effects of the case add to the mass of a sphere of mean size. */
static struct added_mass case_drag_added_mass(const struct settings *s,
                                              double dt)
{
    struct effect_scales k = {.rho_f = s->fluid.rho,
                              .mu = s->fluid.mu,
                              .dt = dt,
                              .d = case_drag_mean_diameter(s)};
    struct added_mass sum = {0};

    for (int i = 0; effects[i] != NULL; i++) {
        double numbers[EFFECT_NUMBERS];
        if (effects[i]->added_mass == NULL ||
            !table_numbers_of_effect(s, effects[i], numbers))
            continue;
        k.numbers = numbers;
        effects[i]->added_mass(&k, &sum);
    }
    return sum;
}

/* The criteria for a bed: (20.6), (20.12), (20.13). */
static void print_bed(const struct settings *s, const struct drag_scales *k)
{
    const struct added_mass added = case_drag_added_mass(s, k->dt);
    const int implicit = s->exchange.treatment == TREATMENT_SEMI_IMPLICIT;
    const double rho_s = s->particles.grains.density;
    const double rho_f = s->fluid.rho;
    const double longest = stability_longest_step(
        1.0 - k->eps_s,
        case_drag_relaxation_time(s, k, case_drag_mean_diameter(s), k->eps_s));
    const double densest =
        stability_max_solid_fraction(&added, rho_s / rho_f, implicit);

    check_line("longest step for a packed bed", longest, "s",
               k->dt <= longest
                   ? "2 eps_f^2 tau_p: the step is below"
                   : "2 eps_f^2 tau_p: NOT STABLE, the step is above");
    check_line("mass loading M", stability_loading(rho_s, k->eps_s, rho_f), "-",
               "mass of the bed over that of the fluid in it");
    check_line(
        "amplification of the pressure",
        stability_amplification(&added, rho_s / rho_f, k->eps_s, implicit), "-",
        k->eps_s < densest ? "factor in a step: it decays"
                           : "NOT STABLE: it grows where the bed is packed");
    /* Spheres of many sizes settle at up to three quarters. */
    check_line("largest stable solid fraction", densest, "-",
               densest < 0.75 && k->eps_s < densest &&
                       s->particles.bed_sizes != NULL
                   ? "eps_s; NOT STABLE where many sizes are denser"
               : added.C > 0.0 ? "eps_s, with the added mass"
                               : "eps_s, without an added mass");
}

void case_drag_print(const struct settings *s, const struct drag_scales *k)
{
    const int asked = s->exchange.substeps;
    const double bed = case_drag_relaxation_time(s, k, k->d, k->eps_s);

    puts("Drag");
    check_line("tau_p", bed, "s", "relaxation time at eps_s = 0.6");
    check_line("tau_p", case_drag_relaxation_time(s, k, k->d, 0.0), "s",
               "of a lone particle");
    check_line(
        "sub-steps", asked > 0 ? asked : coupling_needed_substeps(k->dt / bed),
        "-", asked > 0 ? "as the case asks" : "drag updates in a step, about");
    const int is_bed = s->particles.bed.count > 0;
    print_range(s, k, is_bed ? 1.0 - k->eps_s : 1.0);
    if (!is_bed) return;
    print_fluidization(s, k);
    print_bed(s, k);
}
