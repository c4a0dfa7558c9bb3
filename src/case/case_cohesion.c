/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_cohesion.h"

#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "coupling/effects.h"
#include "dem/cohesion/capillary.h"
#include "dem/cohesion/electrostatic.h"
#include "dem/cohesion/van_der_waals.h"
#include "case/case_materials.h"
#include "case/case_file.h"

static int count_materials(const struct settings *s)
{
    return 1 + settings_length(s, "particles.materials");
}

/* 1 if the program has the effect and the case names it. */
static int is_named(const struct settings *s, const char *path)
{
    const char *const name = path + sizeof "effects." - 1;
    return effects_named(name) != NULL && settings_has(s, path);
}

static int is_attraction(const struct settings *s, const struct effect *e)
{
    return e->attraction != NULL && settings_has(s, e->keys[0].path);
}

/* One block: the attractions, then the charges of the materials. */
struct attraction *case_cohesion_create(const struct settings *s, int *n)
{
    const int materials = count_materials(s);
    struct attraction *all;
    double *charge, numbers[8];

    *n = 0;
    for (int k = 0; effects[k] != NULL; k++)
        *n += is_attraction(s, effects[k]);
    if (*n == 0) return NULL;
    all = alloc_zeroed(1, (size_t)*n * sizeof *all +
                              (size_t)materials * sizeof *charge);
    charge = (double *)(all + *n);
    for (int k = 0; k < materials; k++)
        charge[k] = case_materials_one(s, k).charge;
    const struct attraction_scene scene = {
        charge,
        settings_has(s, "fluid") ? settings_real(s, "fluid.viscosity") : 0.0};
    for (int k = 0, i = 0; effects[k] != NULL; k++) {
        const struct effect *const e = effects[k];
        if (!is_attraction(s, e)) continue;
        case_file_parameters(s, e->keys, numbers, 8);
        all[i++] = e->attraction(numbers, &scene);
    }
    return all;
}

int case_cohesion_check(const struct settings *s)
{
    int charged = 0;

    for (int k = 0; k < count_materials(s); k++)
        charged |= case_materials_one(s, k).charge != 0.0;
    if (is_named(s, "effects.electrostatic") && !charged)
        return settings_wrong(s, "effects.electrostatic",
                              "no material has a charge: give "
                              "particles.grains.charge [C]");
    if (is_named(s, "effects.lubrication") &&
        settings_real(s, "effects.lubrication.roughness") >=
            settings_real(s, "effects.lubrication.range"))
        return settings_wrong(
            s, "effects.lubrication",
            "the range must be longer than the roughness, "
            "%g m",
            settings_real(s, "effects.lubrication.roughness"));
    if (!is_named(s, "effects.van_der_waals") ||
        settings_real(s, "effects.van_der_waals.min_gap") <
            settings_real(s, "effects.van_der_waals.range"))
        return 0;
    return settings_wrong(s, "effects.van_der_waals",
                          "the range must be longer than the closest gap, "
                          "%g m",
                          settings_real(s, "effects.van_der_waals.min_gap"));
}

static void line(const char *name, double value, const char *unit,
                 const char *remark)
{
    printf("  %-38s %10.4g %-4s %s\n", name, value, unit, remark);
}

static void print_electrostatic(const struct settings *s,
                                const struct attraction *a, double d,
                                double weight)
{
    double most = 0.0;

    for (int k = 0; k < count_materials(s); k++)
        most = fmax(most, fabs(a->charge[k]));
    line("electrostatic / weight",
         electrostatic_force(most, most, a->strength, d) / weight, "-",
         "of the largest charge on touching spheres");
    line("electrostatic at its range / touching", gsl_pow_2(d / (d + a->range)),
         "-", "what the range cuts off");
}

static void print_van_der_waals(const struct attraction *a, double d,
                                double weight, double travel)
{
    const double D = van_der_waals_diameter(d, d);

    line("van der Waals / weight",
         van_der_waals_force(a->strength, D, a->closest) / weight, "-",
         "at the closest gap");
    line("van der Waals at its range / closest",
         gsl_pow_2(a->closest / a->range), "-", "what the range cuts off");
    line("closest gap / way of a step", a->closest / travel, "-",
         a->closest >= travel
             ? "the well is resolved"
             : "NOT RESOLVED: what an impact gains in the well is by chance");
}

void case_cohesion_print(const struct settings *s, double d, double density,
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
            line("capillary / weight",
                 -capillary_force(a->strength, 0.5 * d) / weight, "-",
                 "of two of the smallest particles");
    }
    free(all);
}
