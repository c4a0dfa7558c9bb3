/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_body_mass.c -- what resists in the contacts of bodies, and for how long
 * they touch. Chapter "Resolving the grains". */
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

#include "base/number.h"
#include "base/vector.h"
#include "case/case_steps.h"
#include "case/particle_options.h"
#include "case/resolved/case_blocks.h"
#include "case/resolved/case_bodies.h"
#include "case/resolved/case_outlines.h"
#include "dem/contact_linear.h"
#include "dem/limits.h"
#include "resolved/body_numbers.h"
#include "resolved/body_shape.h"

static const char *const list = case_bodies_spheres;

/* Steps of the fluid that an impact lasts where the case gives no stiffness:
 * the fluid has to follow the rebound. */
static const double steps_an_impact = 8.0;

static double case_body_mass_volume(double d)
{
    return M_PI / 6.0 * d * d * d;
}

/* Volume [m^3] and smallest width [m] of number i of a list; 0, or 1 if its
 * file cannot be read. */
static int size_of(const struct settings *s, const char *of, int i, double *V,
                   double *width)
{
    const int is_block = of == case_blocks_boxes || of == case_blocks_cylinders;
    struct body_outline *const o =
        of == list || is_block ? NULL : case_outlines_read(s, of, i);
    struct body_shape shape;

    if (of == list)
        shape = body_shape_sphere(settings_item_real(s, of, i, "diameter"));
    else if (is_block)
        shape = case_blocks_shape(s, of, i);
    else if (o != NULL)
        shape = body_shape_outline(o);
    else
        return 1;
    *V = body_shape_volume(&shape);
    *width = body_shape_width(&shape);
    body_outline_free(o);
    return 0;
}

double case_bodies_virtual_mass(const struct settings *s, const char *of, int i)
{
    const double least = s->bodies.virtual_mass, rho = s->fluid.rho;
    double V, width;

    if (size_of(s, of, i, &V, &width) != 0) return least;
    const double R = 0.5 * width, x = s->fluid.mu * s->fluid.dt / (rho * R * R);
    return body_numbers_virtual_mass(
        least, x, settings_item_real(s, of, i, "density") / rho,
        body_numbers_added_mass(V, width), case_bodies_count(s));
}

static double contact_volume(const struct settings *s, const char *of, int i)
{
    return of == list
               ? case_body_mass_volume(settings_item_real(s, of, i, "diameter"))
               : case_outlines_contact_volume(s, of, i);
}

/* What a contact of number i of a list has to stop [kg]. */
static double contact_mass(const struct settings *s, const char *of, int i)
{
    const double rho_p = settings_item_real(s, of, i, "density"),
                 rho = s->fluid.rho, C_v = case_bodies_virtual_mass(s, of, i);

    return (rho_p + body_numbers_contact_mass(C_v) * rho) *
           contact_volume(s, of, i);
}

/* The smallest mass in a contact of a body with this motion [kg]; HUGE_VAL:
 * there is none. */
static double lightest_of(const struct settings *s, const char *motion)
{
    const char *const *const all = case_bodies_lists;
    double least = HUGE_VAL;

    for (int l = 0; all[l] != NULL; l++)
        for (int i = 0; i < settings_length(s, all[l]); i++)
            if (case_bodies_is(s, all[l], i, motion))
                least = fmin(least, contact_mass(s, all[l], i));
    return least;
}

/* Of the free ones, or if there are none of those on springs; 0: all are held.
 */
static double lightest(const struct settings *s)
{
    double least = lightest_of(s, "free");

    if (least == HUGE_VAL) least = lightest_of(s, "spring");
    return least < HUGE_VAL ? least : 0.0;
}

/* k with which a mass bounces off a wall in so many steps [LS 4.4]. */
static double stiffness_of(const struct settings *s, double m)
{
    if (s->bodies.stiffness > 0.0) return s->bodies.stiffness;
    const double e = s->bodies.restitution, zeta = contact_damping_ratio(e);
    const double t = steps_an_impact * s->fluid.dt;

    return m > 0.0 ? m * M_PI * M_PI / (t * t * (1.0 - zeta * zeta)) : 1.0;
}

/* 25 in the impact of two of this mass. */
static int dem_steps(const struct settings *s, double k, double m)
{
    const double e = s->bodies.restitution;

    if (s->has.particles) return case_steps_within(s);
    if (m == 0.0) return 1;
    const double t = contact_linear_time(k, e, 0.5 * m);
    return number_clamped(ceil(25.0 * s->fluid.dt / t), 1, 1000000);
}

struct case_bodies_contact case_bodies_contact(const struct settings *s)
{
    const double m = lightest(s), k = stiffness_of(s, m);

    return (struct case_bodies_contact){k, dem_steps(s, k, m)};
}

/* The largest speed [m/s] at time 0. */
static double largest_speed(const struct settings *s)
{
    const char *const *const all = case_bodies_lists;
    double most = 0.0, v[3];

    for (int l = 0; all[l] != NULL; l++)
        for (int i = 0; i < settings_length(s, all[l]); i++) {
            settings_item_vector(s, all[l], i, "velocity", v);
            most = fmax(most, vector_length(v));
        }
    return most;
}

/* Of number i of a list that hits something fixed at a speed, or at that of a
 * fall through its own width: v sqrt(m/k) and what bears its weight, in widths.
 */
static double overlap_of(const struct settings *s, const char *of, int i,
                         double k, double speed)
{
    const double rho = s->fluid.rho,
                 rho_p = settings_item_real(s, of, i, "density");
    double V, width;

    if (size_of(s, of, i, &V, &width) != 0) return 0.0;
    const double weight = fabs(rho_p - rho) * vector_length(s->effects.gravity);
    const double v = fmax(speed, sqrt(weight / rho * width));
    return (v * sqrt(contact_mass(s, of, i) / k) +
            contact_volume(s, of, i) * weight / k) /
           width;
}

double case_bodies_expected_overlap(const struct settings *s)
{
    const char *const *const all = case_bodies_lists;
    const double k = case_bodies_contact(s).stiffness, v = largest_speed(s);
    double most = 0.0;

    for (int l = 0; all[l] != NULL; l++)
        for (int i = 0; i < settings_length(s, all[l]); i++)
            if (case_bodies_is(s, all[l], i, "free"))
                most = fmax(most, overlap_of(s, all[l], i, k, v));
    return most;
}

int case_bodies_check_stiffness(const struct settings *s)
{
    const double e = s->bodies.restitution, m = lightest(s),
                 k = stiffness_of(s, m);
    const double t = contact_linear_time(k, e, 0.5 * m),
                 step = s->fluid.dt / dem_steps(s, k, m);

    if (m == 0.0 || t >= 5.0 * step) return 0;
    return settings_wrong(s, "bodies.stiffness",
                          "%g N/m: an impact lasts %.3g s and a particle step "
                          "%.3g s; expected at least five of them in it",
                          k, t, step);
}
