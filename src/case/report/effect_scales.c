/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/case_effects.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

#include "base/vector.h"
#include "case/build.h"
#include "case/checks/case_limits.h"
#include "case/case_mesh.h"
#include "case/extent/case_extent.h"
#include "coupling/drag.h"

static const double packed = 0.6; /* [-] solids fraction of a bed at rest */

/* What was measured in beds of gas and of water: the share of the slip by which
 * a grain's velocity changes in the time of a fall over its diameter, most of
 * it by contacts [-], and its spin over slip/d [-]. */
static const double stirred = 0.3, spun = 0.1;

/* The mean diameter [m], velocity [m/s] and spin [rad/s] of placed spheres. */
struct placed {
    double d, speed, spin;
};

static struct placed placed_of(const struct settings *s,
                               const struct case_scales *in)
{
    const int n = s->particles.place.n;
    struct placed p = {0.0, 0.0, 0.0};

    if (n == 0) /* all of them are inserted */
        return (struct placed){.d = 0.5 * (in->d + in->d_most),
                               .speed = case_limits_initial_speed(s)};

    for (int i = 0; i < n; i++) {
        const struct place_setup *const one = &s->particles.place.item[i];
        p.d += one->diameter / n;
        p.speed += vector_length(one->velocity) / n;
        p.spin += vector_length(one->spin) / n;
    }
    return p;
}

/* The fastest moving wall over the narrowest way across the box [1/s]. */
static double shear_of_walls(const struct settings *s)
{
    double lo[3], size[3], fastest = 0.0;

    case_mesh_ends(s, lo, size);
    for (int i = 0; i < s->sides.n; i++)
        fastest = fmax(fastest, vector_length(s->sides.item[i].wall));
    return fastest / fmin(size[0], fmin(size[1], size[2]));
}

static double effect_scales_volume(const struct effect_scales *k)
{
    return M_PI / 6.0 * gsl_pow_3(k->d);
}

/* Drag [N] at a slip w where eps_s is solid. */
static double drag_at(const struct settings *s, const struct effect_scales *k,
                      double eps_s, double w)
{
    const struct drag_law law = build_drag_law(s);

    return effect_scales_volume(k) * w *
           drag_resistance(&law, 1.0 - eps_s, k->rho_f, k->mu, k->d, w);
}

/* The slip at which the drag carries the weight less the buoyancy. */
static double terminal(const struct settings *s, const struct effect_scales *k,
                       double eps_s)
{
    const double pull =
        fabs(k->rho_s - k->rho_f) * effect_scales_volume(k) * k->gravity;
    double low = 0.0, high = 1e3;

    for (int i = 0; i < 100; i++) {
        const double w = 0.5 * (low + high);
        if (drag_at(s, k, eps_s, w) / (1.0 - eps_s) < pull)
            low = w;
        else
            high = w;
    }
    return low;
}

/* The solids fraction at which a stream of this superficial velocity carries
 * the particles: `packed` if it does not. */
static double expanded(const struct settings *s, const struct effect_scales *k,
                       double inlet)
{
    double low = 0.0, high = packed;

    if (terminal(s, k, packed) * (1.0 - packed) > inlet) return packed;
    for (int i = 0; i < 60; i++) {
        const double eps_s = 0.5 * (low + high);
        if (terminal(s, k, eps_s) * (1.0 - eps_s) > inlet)
            low = eps_s;
        else
            high = eps_s;
    }
    return low;
}

/* A bed in a stream: fluidized, or at rest. In it the gas velocity changes by
 * the slip over a few cells between bubbles, and particles behind a bubble fall
 * for the time of a diameter. In a bed at rest the slip changes only when the
 * stream begins. */
static void bed_scales(const struct settings *s, struct effect_scales *k,
                       const struct case_scales *in)
{
    k->eps_s = in->inlet > 0.0 ? expanded(s, k, in->inlet) : packed;
    k->carried = k->eps_s < packed;
    k->slip = in->inlet / (1.0 - k->eps_s);
    k->length = 2.0 * in->S_c;
    k->shear = k->slip / k->length;
    if (!k->carried) { /* the stream begins, and then nothing changes */
        k->time = in->end;
        k->acceleration = k->slip / k->time;
        return;
    }
    k->spin = spun * k->slip / k->d;
    k->time = sqrt(k->d / k->gravity);
    k->acceleration = stirred * k->slip / k->time * fabs(k->rho_s - k->rho_f) /
                      (k->rho_s + 0.5 * k->rho_f);
}

/* Spheres that are far from each other: they fall, or the stream carries them.
 */
static void dilute_scales(const struct settings *s, struct effect_scales *k,
                          const struct case_scales *in, const struct placed *p)
{
    double lo[3], size[3];

    case_mesh_ends(s, lo, size);
    k->eps_s = in->particles * effect_scales_volume(k) / case_extent_volume(s);
    k->slip = fmax(in->inlet, p->speed);
    if (k->gravity > 0.0)
        k->slip = fmax(p->speed, fmin(terminal(s, k, k->eps_s),
                                      0.5 * k->gravity * in->end));
    if (k->slip == 0.0 && k->mu > 0.0) /* of the push alone */
        k->slip = k->mean_gradient * k->d * k->d / (18.0 * k->mu);
    k->carried = 1;
    k->length = 0.5 * fmin(size[0], fmin(size[1], size[2]));
    k->shear = shear_of_walls(s);
    if (k->mean_gradient > 0.0 && k->mu > 0.0) /* at the wall of a channel */
        k->shear = fmax(k->shear, k->mean_gradient * k->length / k->mu);
    k->spin = p->spin;
    k->time = s->output.end;
    k->acceleration = k->slip / k->time;
    if (k->gravity == 0.0) k->time = 0.0; /* the slip dies out within tau */
}

/* A slip that dies out does so within tau. Of its history force the two parts,
 * of the first slip and of its decay, have opposite signs, and leave a quarter
 * of the size: that of a 16th of the time. */
static void settle_time(struct effect_scales *k)
{
    if (k->time == 0.0) {
        k->acceleration = k->slip / k->tau;
        k->time = k->tau / 16.0;
    }
    k->acceleration = fmin(k->acceleration, k->slip / k->time);
}

/* Placed grains that are so many that they form a bed in the stream. */
static int is_crowd(const struct settings *s, const struct effect_scales *k,
                    const struct case_scales *in)
{
    const double crowd = 0.05; /* [-] of the whole mesh */

    return in->inlet > 0.0 && k->gravity > 0.0 &&
           in->particles * effect_scales_volume(k) >
               crowd * case_extent_volume(s);
}

struct effect_scales case_effects_scales(const struct settings *s,
                                         const struct case_scales *in)
{
    const struct placed p = placed_of(s, in);
    struct effect_scales k = {
        .rho_s = s->particles.grains.density,
        .d = in->volume > 0.0 ? cbrt(6.0 / M_PI * in->volume / in->particles)
                              : p.d,
        .gravity = vector_length(s->effects.gravity)};

    k.weight = k.rho_s * effect_scales_volume(&k) * k.gravity;
    if (s->has.exchange) {
        k.mean_gradient = vector_length(s->fluid.mean_gradient);
        k.rho_f = s->fluid.rho;
        k.mu = s->fluid.mu;
        k.dt = in->dt;
        if (in->volume > 0.0 || is_crowd(s, &k, in))
            bed_scales(s, &k, in);
        else
            dilute_scales(s, &k, in, &p);
        k.drag = drag_at(s, &k, k.eps_s, k.slip);
        k.tau = k.slip > 0.0
                    ? k.rho_s * effect_scales_volume(&k) * k.slip / k.drag
                    : 0.0;
        settle_time(&k);
    }
    k.force = fmax(k.weight, k.drag);
    return k;
}
