/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/case_drag.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

#include "coupling/drag.h"
#include "coupling/stability.h"
#include "case/build_particles.h"

static void line(const char *name, double value, const char *unit,
                 const char *remark)
{
    printf("  %-38s %10.4g %-4s %s\n", name, value, unit, remark);
}

/* tau_p [s] of spheres of diameter d [m] that take eps_s of the room. */
static double relaxation_time(const struct settings *s,
                              const struct drag_scales *k, double d,
                              double eps_s)
{
    return drag_relaxation_time(
        drag_law_named(settings_text(s, "exchange.drag")),
        settings_real(s, "particles.grains.density"), eps_s,
        settings_real(s, "fluid.density"), settings_real(s, "fluid.viscosity"),
        d, k->inlet / (1.0 - eps_s));
}

/* The sphere [m] of the bed's mean volume: the backflow of a mixture is shared
 * by all its sizes. */
static double mean_diameter(const struct settings *s)
{
    struct bed_options b = build_bed_options(s);
    const double volume = bed_range(&b).volume;

    build_bed_release(&b);
    return cbrt(6.0 / M_PI * volume / b.count);
}

/* What only a bed asks for: (20.6), (20.9). */
static void print_bed(const struct settings *s, const struct drag_scales *k)
{
    const int helped = settings_has(s, "effects.virtual_mass");
    const double C =
        helped ? settings_real(s, "effects.virtual_mass.coefficient") : 0.0;
    const double rho_s = settings_real(s, "particles.grains.density");
    const double rho_f = settings_real(s, "fluid.density");
    const double longest = stability_longest_step(
        1.0 - k->eps_s, relaxation_time(s, k, mean_diameter(s), k->eps_s));
    const double densest = stability_max_solid_fraction(C, rho_s, rho_f);

    line("longest step for a packed bed", longest, "s",
         k->dt <= longest ? "2 eps_f^2 tau_p: the step is below"
                          : "2 eps_f^2 tau_p: NOT STABLE, the step is above");
    line("mass loading M", stability_loading(rho_s, k->eps_s, rho_f), "-",
         "mass of the bed over that of the fluid in it");
    line("swing of the pressure",
         stability_amplification(C, rho_s, k->eps_s, rho_f), "-",
         k->eps_s < densest ? "part of it left after a step: it dies out"
                            : "NOT STABLE: it grows where the bed is packed");
    line("densest bed without it", densest, "-",
         helped ? "eps_s, with virtual mass" : "eps_s, without virtual mass");
}

void case_drag_print(const struct settings *s, const struct drag_scales *k)
{
    const int asked = settings_int(s, "exchange.substeps");
    const double bed = relaxation_time(s, k, k->d, k->eps_s);

    puts("Drag");
    line("tau_p", bed, "s", "relaxation time at eps_s = 0.6");
    line("tau_p", relaxation_time(s, k, k->d, 0.0), "s", "of a lone particle");
    line("sub-steps", asked > 0 ? asked : stability_substeps(k->dt / bed), "-",
         asked > 0 ? "as the case asks" : "drag updates in a step, about");
    if (settings_has(s, "particles.bed") &&
        settings_int(s, "particles.bed.count") > 0)
        print_bed(s, k);
}
