/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_parcels.c -- each particle stands for several grains.
 * Chapter "Fewer or other particles".
 *
 * A case describes grains. Before anything is made of it, its lengths, springs,
 * charges, counts and rates become those of parcels, which are l times as wide
 * and as heavy as l^3 grains: all lengths times l at the same density, velocity
 * and modulus, so that a stress and an overlap over the diameter stay what they
 * are. A quantity in [Pa]^a [m]^b [m/s]^c is multiplied by l^b. What the fluid
 * does is left to dem/particles.h. */
#include "case/particles/case_population.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/text.h"
#include "case/case_mesh.h"
#include "case/checks/checks.h"
#include "case/particles/case_materials.h"
#include "coupling/effects.h"

/* Exact for a whole l, on any machine. */
static double parcels_length(double grains)
{
    const double l = cbrt(grains), whole = round(l);
    return whole * whole * whole == grains ? whole : l;
}

double case_parcels_across(const struct settings *s, int material)
{
    double grains = s->particles.parcel.grains;

    if (grains == 0.0) return 1.0;
    if (material > 0 && s->particles.materials.item[material - 1].parcel > 0.0)
        grains = s->particles.materials.item[material - 1].parcel;
    return parcels_length(grains);
}

/* 1 if all materials have the same l. */
static int parcels_are_alike(const struct settings *s)
{
    const double l = case_parcels_across(s, 0);

    for (int k = 1; k <= s->particles.materials.n; k++)
        if (case_parcels_across(s, k) != l) return 0;
    return 1;
}

/* Whether every parcel has one grain. */
static int parcels_are_grains(const struct settings *s)
{
    return parcels_are_alike(s) && case_parcels_across(s, 0) == 1.0;
}

double *case_parcels_table(const struct settings *s)
{
    const int n = case_materials_total(s);

    if (parcels_are_grains(s)) return NULL;
    double *const across = alloc_doubles(n);
    for (int k = 0; k < n; k++)
        across[k] = case_parcels_across(s, k % (s->particles.materials.n + 1));
    return across;
}

/* --- restitution ---------------------------------------------------------- */

int case_parcels_keep_dissipation(const struct settings *s)
{
    return s->particles.parcel.grains > 0.0 && !parcels_are_grains(s) &&
           strcmp(s->particles.parcel.restitution, "dissipation") == 0;
}

/* Haff's law loses (1 - e^2)/d of the energy: e_p^2 = 1 - l (1 - e^2) [Lu14].
 */
double case_parcels_restitution(const struct settings *s, double e)
{
    return case_parcels_keep_dissipation(s)
               ? sqrt(
                     fmax(1.0 - case_parcels_across(s, 0) * (1.0 - e * e), 0.0))
               : e;
}

static int parcels_too_inelastic(const struct settings *s, double e)
{
    const double l = case_parcels_across(s, 0);

    if (!case_parcels_keep_dissipation(s) || l * (1.0 - e * e) < 1.0) return 0;
    return settings_wrong(s, KEY_OF(s, particles.parcel.restitution),
                          "parcels of %g diameters cannot lose as much as "
                          "grains of e = %g do: expected l (1 - e^2) < 1, here "
                          "it is %g; at most %.4g grains, or \"kept\"",
                          l, e, l * (1.0 - e * e), pow(1.0 - e * e, -3.0));
}

static int parcels_check_restitution(const struct settings *s)
{
    int code = parcels_too_inelastic(s, s->particles.grains.of.restitution);

    for (int k = 0; k < s->particles.materials.n && code == 0; k++)
        code = parcels_too_inelastic(
            s, s->particles.materials.item[k].of.restitution);
    for (int k = 0; k < s->particles.pairs.n && code == 0; k++)
        if (s->particles.pairs.item[k].has_restitution)
            code = parcels_too_inelastic(
                s, s->particles.pairs.item[k].of.restitution);
    return code;
}

/* --- what cannot be ------------------------------------------------------- */

static const char *parcels_needing_one_size(const struct settings *s)
{
    if (case_parcels_keep_dissipation(s))
        return KEY_OF(s, particles.parcel.restitution);
    for (int k = 0; effects[k] != NULL; k++)
        if (effects[k]->attraction != NULL &&
            settings_has(s, effects[k]->keys[0]->path))
            return effects[k]->keys[0]->path;
    return NULL;
}

/* Refuses what parcels cannot be. 0, or 2 after a message. */
static int parcels_check(const struct settings *s)
{
    const char *const one = parcels_needing_one_size(s);

    if (s->has.bodies)
        return settings_wrong(
            s, KEY_OF(s, particles.parcel.grains),
            "around bodies that the flow is resolved around there are grains, "
            "not parcels; leave particles.parcel or bodies out");
    if (one != NULL && !parcels_are_alike(s))
        return settings_wrong(
            s, one,
            "it needs the same number of grains in a parcel of each material");
    return parcels_check_restitution(s);
}

/* --- from grains to parcels ----------------------------------------------- */

/* The spring and the charge of a parcel of l diameters (32.2). */
static void parcels_scale_material(struct material *m, double l)
{
    m->stiffness *= l;
    m->charge *= l * l * l;
}

/* So many grains in whole parcels, to the nearest. 0, or 2 after a message. */
static int parcels_count(struct settings *s, const char *key, double l,
                         int *count)
{
    const double N = l * l * l, n = round(*count / N);

    if (*count > 0 && n < 1.0)
        return settings_wrong(
            s, key,
            "%d grains are less than half of a parcel, which stands for %g",
            *count, N);
    s->particles.parcel.asked += *count;
    s->particles.parcel.made += n * N;
    return number_int(n, count); /* at most as many as grains: N >= 1 */
}

/* The same as case_parcels_across, for the name of a material. */
static double parcels_across_named(const struct settings *s, const char *name)
{
    return case_parcels_across(s, case_materials_number(s, name));
}

/* Makes sources of grains those of parcels. 0, or 2 after a message. */
static int parcels_make_sources(struct settings *s)
{
    int code = 0;

    for (int i = 0; i < s->particles.insert.n && code == 0; i++) {
        struct insert_setup *const in = &s->particles.insert.item[i];
        const double l = parcels_across_named(s, in->material);
        in->of.diameter *= l;
        in->of.rate /= l * l * l;
        code = parcels_count(s, "particles.insert", l, &in->count);
    }
    return code;
}

int case_parcels_make(struct settings *s)
{
    struct particles_setup *const p = &s->particles;
    const double l = case_parcels_across(s, 0);
    int code = p->parcel.grains > 0.0 ? parcels_check(s) : 0;

    if (code != 0 || parcels_are_grains(s)) return code;
    parcels_scale_material(&p->grains.of, l);
    for (int k = 0; k < p->materials.n; k++)
        parcels_scale_material(&p->materials.item[k].of,
                               case_parcels_across(s, k + 1));
    for (int k = 0; k < p->pairs.n; k++) { /* half springs in series */
        const double a = parcels_across_named(s, p->pairs.item[k].between);
        const double b = parcels_across_named(s, p->pairs.item[k].and);
        p->pairs.item[k].of.stiffness *= 2.0 * a * b / (a + b);
    }
    for (int i = 0; i < p->place.n; i++)
        p->place.item[i].diameter *=
            parcels_across_named(s, p->place.item[i].material);
    p->bed.diameter *= l;
    code = parcels_count(s, KEY_OF(s, particles.bed.count), l, &p->bed.count);
    return code != 0 ? code : parcels_make_sources(s);
}

void case_parcels_sizes(struct sizes_options *o, double l)
{
    double *const lengths[] = {&o->mean, &o->deviation, &o->median, &o->min,
                               &o->max};
    double(*const point)[2] = (double(*)[2])o->point;
    int n = 0;

    for (int k = 0; k < 5; k++)
        *lengths[k] *= l;
    for (int k = 0; k < o->n; k++)
        point[k][0] *= l;
    for (const struct key *k = o->law->own_keys; k != NULL && k->path != NULL;
         k++, n++)
        if (strcmp(k->unit, "m") == 0) o->own[n] *= l;
}

void case_parcels_attraction(const struct settings *s, struct attraction *a)
{
    const double l = case_parcels_across(s, 0);

    a->strength *= pow(l, a->law->parcel_power);
    if (a->law->far_field) return;
    a->range *= l;
    a->closest *= l;
}

/* --- what is said --------------------------------------------------------- */

void case_parcels_tell(const struct settings *s)
{
    const double asked = s->particles.parcel.asked;
    const double made = s->particles.parcel.made;

    if (!s->quiet && fabs(made - asked) > 1e-9 * asked)
        fprintf(stderr,
                "the %.0f grains of the case are no whole number of parcels: "
                "there are as many parcels as stand for %.6g\n",
                asked, made);
}

/* Fewer across than that, and the looser layers at both walls are a large part
 * of a bed [-]: with four, eps_f of Mueller's bed is 0.413 where it is 0.383.
 */
static const double parcels_across_enough = 10.0;

/* The narrowest way between two walls of the box. */
static double narrowest(const struct settings *s)
{
    double lo[3], hi[3], least = HUGE_VAL;
    int periodic[3];

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    for (int k = 0; k < 3; k++)
        if (!periodic[k]) least = fmin(least, hi[k] - lo[k]);
    return least;
}

/* The mean free path where eps_s is solid, with Carnahan and Starling's g_0
 * [m]: l times that of the grains. */
static double free_path(double d, double eps_s)
{
    const double g_0 = (1.0 - 0.5 * eps_s) / pow(1.0 - eps_s, 3.0);
    return d / (6.0 * M_SQRT2 * eps_s * g_0);
}

/* The opening [m] through which parcels fall at nine tenths of the rate of
 * their grains, (width - 1.4 d)^2.5 [Beverloo61]. */
static double wide_opening(const struct case_scales *k)
{
    const double q = pow(0.9, 0.4);
    return 1.4 * k->d_most * (1.0 - q / k->across) / (1.0 - q);
}

/* Of the narrowest way between walls [m], and of the free path [m]. */
static void print_width(double width, double path, const struct case_scales *k)
{
    text_line("width / parcel", width / k->d_most, "-",
              width < parcels_across_enough * k->d_most
                  ? "FEW: looser layers at the walls raise eps_f"
                  : "of the narrowest way between walls");
    if (path < HUGE_VAL)
        text_line("free path / width", path / width, "-",
                  path > 0.1 * width
                      ? "LONG: parcels meet the walls, where grains meet grains"
                      : "l times that of grains");
}

void case_parcels_print(const struct settings *s, const struct case_scales *k,
                        double eps_s)
{
    const double l = k->across, width = narrowest(s);

    if (parcels_are_grains(s)) return;
    puts("Parcels");
    text_line("grains in a parcel", l * l * l, "-", "N = l^3");
    text_line("l", l, "-", "diameter of a parcel over that of its grains");
    if (s->particles.parcel.asked > 0.0)
        text_line("grains", s->particles.parcel.made, "-",
                  s->particles.parcel.made == s->particles.parcel.asked
                      ? "of beds and sources, in whole parcels"
                      : "no whole number of parcels: to the nearest");
    if (s->particles.list->no_contacts) return;
    text_line("restitution of parcels", case_materials_one(s, 0).restitution,
              "-",
              case_parcels_keep_dissipation(s)
                  ? "they lose what their grains would; walls keep e"
                  : "as of grains: they cool l times more slowly");
    if (width < HUGE_VAL) print_width(width, free_path(k->d, eps_s), k);
    text_line("wide opening", wide_opening(k), "m",
              "passes parcels at 0.9 of the rate of grains; narrower: slower");
}
