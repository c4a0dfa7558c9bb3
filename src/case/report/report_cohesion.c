/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/report_cohesion.h"

#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>

#include "case/cohesion/case_cohesion.h"
#include "case/checks/check_line.h"
#include "dem/cohesion/capillary.h"
#include "dem/cohesion/electrostatic.h"
#include "dem/cohesion/van_der_waals.h"

static void print_electrostatic(const struct settings *s,
                                const struct attraction *a, double d,
                                double weight)
{
    double most = 0.0;

    for (int k = 0; k < 1 + s->particles.materials.n; k++)
        most = fmax(most, fabs(a->charge[k]));
    check_line("electrostatic / weight",
               electrostatic_force(most, most, a->strength, d) / weight, "-",
               "of the largest charge on touching spheres");
    check_line("electrostatic at its range / touching",
               gsl_pow_2(d / (d + a->range)), "-", "cut off at the range");
}

static void print_van_der_waals(const struct attraction *a, double d,
                                double weight, double travel)
{
    const double D = van_der_waals_diameter(d, d);

    check_line("van der Waals / weight",
               van_der_waals_force(a->strength, D, a->closest) / weight, "-",
               "at the closest gap");
    check_line("van der Waals at its range / closest",
               gsl_pow_2(a->closest / a->range), "-", "cut off at the range");
    check_line(
        "closest gap / path in a step", a->closest / travel, "-",
        a->closest >= travel
            ? "the well is resolved"
            : "NOT RESOLVED: the energy of an impact depends on the step");
}

void report_cohesion(const struct settings *s, double d, double density,
                     double dt, double speed)
{
    const double weight = density * M_PI / 6.0 * gsl_pow_3(d) * 9.81;
    int n;
    struct attraction *const all = case_cohesion_create(s, &n);

    if (n > 0) puts("Cohesion");
    for (int k = 0; k < n; k++) {
        const struct attraction *const a = &all[k];
        if (a->law == &electrostatic) print_electrostatic(s, a, d, weight);
        if (a->law == &van_der_waals)
            print_van_der_waals(a, d, weight, speed * dt);
        if (a->law == &capillary)
            check_line("capillary / weight",
                       -capillary_force(a->strength, 0.5 * d) / weight, "-",
                       "of two of the smallest particles");
    }
    free(all);
}
