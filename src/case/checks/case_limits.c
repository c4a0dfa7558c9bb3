/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/case_limits.h"

#include <math.h>

#include "base/vector.h"
#include "dem/dem_method.h"
#include "dem/limits.h"
#include "case/population/case_population.h"
#include "case/case_materials.h"
#include "case/particle_options.h"

int case_limits_no_contacts(const struct settings *s)
{
    return s->particles.list->no_contacts;
}

const char *case_limits_name(const struct settings *s, int m)
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
            least = smaller(least, p->diameter);
    }
    return least;
}

/* A bed is of material 0. */
static double smallest_of_bed(const struct settings *s, int m)
{
    if (m != 0 || !s->particles.has_bed) return 0.0;
    struct bed_options b = particle_options_bed(s);
    const struct bed_range range = bed_range(&b);
    particle_options_release(&b);
    return b.count > 0 ? range.min : 0.0;
}

struct case_limits case_limits_of(const struct settings *s, int m, double v)
{
    const struct contact_law *const law = s->particles.contact;
    const struct material of = case_materials_one(s, m);
    struct case_limits k = {.material = m};

    k.density = case_materials_setup(s, m)->density;
    k.d = smaller(smallest_of_bed(s, m), smallest_placed(s, m));
    k.d = smaller(k.d, case_population_diameters(s, m).min);
    if (k.d <= 0.0) return k;
    k.rayleigh = law->wave_time(&of, 0.5 * k.d, k.density);
    k.contact = limits_contact_time(law, &of, k.d, k.density, v);
    k.suggested = limits_step(law, &of, k.d, k.density, v);
    k.longest = limits_longest_step(law, &of, k.d, k.density, v);
    return k;
}

double case_limits_initial_speed(const struct settings *s)
{
    const struct particles_setup *const p = &s->particles;
    double fastest = 0.0;

    for (int i = 0; i < p->place.n; i++)
        fastest = fmax(fastest, vector_length(p->place.item[i].velocity));
    for (int i = 0; i < p->insert.n; i++)
        fastest = fmax(fastest, vector_length(p->insert.item[i].of.velocity));
    return fastest;
}

struct case_limits case_limits_tightest(const struct settings *s, double v)
{
    struct case_limits tightest = case_limits_of(s, 0, v);

    for (int m = 1; m <= s->particles.materials.n; m++) {
        const struct case_limits k = case_limits_of(s, m, v);
        if (k.d > 0.0 && (tightest.d <= 0.0 || k.longest < tightest.longest))
            tightest = k;
    }
    return tightest;
}
