/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scales.c -- how the particles of a case will move through its fluid, before
 * it is run.  Chapter "Further forces".
 *
 * Three ways: a stream against gravity carries a bed or goes through it;
 * particles fall, or rise, and come to rest on a floor; or they drift with the
 * fluid. A solids fraction is at most that of a packed bed and at least that of
 * all particles in the whole box. */
#include "tell/check.h"

#include <gsl/gsl_math.h>
#include <math.h>

#include "base/vector.h"
#include "case/build.h"
#include "case/case_mesh.h"
#include "coupling/drag.h"
#include "coupling/coupling.h"

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
        return (struct placed){.d = 0.5 * (in->d + in->d_most) / in->across,
                               .speed = case_scales_initial_speed(s)};

    for (int i = 0; i < n; i++) {
        const struct place_setup *const one = &s->particles.place.item[i];
        p.d += one->diameter / in->across / n;
        p.speed += vector_length(one->velocity) / n;
        p.spin += vector_length(one->spin) / n;
    }
    return p;
}

static double scales_volume(const struct effect_scales *k)
{
    return M_PI / 6.0 * gsl_pow_3(k->d);
}

/* Of all particles [m^3], which may be parcels of the grains of these scales.
 */
static double volume_of_all(const struct effect_scales *k,
                            const struct case_scales *in)
{
    return in->particles * gsl_pow_3(in->across) * scales_volume(k);
}

/* The volume of the smallest box around all that are placed [m^3]. */
static double around_placed(const struct settings *s)
{
    const int n = s->particles.place.n;
    double around = 1.0;

    for (int a = 0; a < 3; a++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL;
        for (int i = 0; i < n; i++) {
            const struct place_setup *const one = &s->particles.place.item[i];
            lo = fmin(lo, one->position[a] - 0.5 * one->diameter);
            hi = fmax(hi, one->position[a] + 0.5 * one->diameter);
        }
        around *= hi - lo;
    }
    return around;
}

/* The fastest moving wall over the narrowest way across the box [1/s]. */
static double shear_of_walls(const struct settings *s)
{
    double lo[3], hi[3], fastest = 0.0, narrow = HUGE_VAL;

    case_mesh_ends(s, lo, hi);
    for (int i = 0; i < s->sides.n; i++)
        fastest = fmax(fastest, vector_length(s->sides.item[i].wall));
    for (int i = 0; i < 3; i++)
        narrow = fmin(narrow, hi[i] - lo[i]);
    return fastest / narrow;
}

/* The slip of a free fall or rise where eps_s is solid [m/s]. */
static double falls_with(const struct settings *s,
                         const struct effect_scales *k, double eps_s)
{
    const struct drag_law law = build_drag_law(s);

    return drag_settling_slip(&law, k->rho_s, eps_s, k->rho_f, k->mu, k->d,
                              k->gravity);
}

/* The solids fraction at which a stream of this superficial velocity carries
 * the particles: that of a bed as dense as it can be if it does not. */
static double expanded(const struct settings *s, const struct effect_scales *k,
                       double up, double high)
{
    double low = 0.0;

    if (falls_with(s, k, high) * (1.0 - high) > up) return high;
    for (int i = 0; i < 60; i++) {
        const double eps_s = 0.5 * (low + high);
        if (falls_with(s, k, eps_s) * (1.0 - eps_s) > up)
            low = eps_s;
        else
            high = eps_s;
    }
    return low;
}

/* The solids fraction that the grains of a bed meet, over that of the bed: the
 * averaging mixes it with what is above. A layer of eps_s, of the height H on a
 * floor, which mirrors it, becomes smooth over b, and again where its grains
 * are asked, as with b sqrt(2); this is the mean over the grains [-]. */
static double averaged(const struct settings *s, double load, double eps_s)
{
    const struct averaging_options o = build_averaging_options(s);
    const double b = M_SQRT2 * o.method->gaussian * o.bandwidth;
    const int up = vector_axis(s->effects.gravity);
    double lo[3], hi[3];

    case_mesh_ends(s, lo, hi);
    const double height = (hi[up] - lo[up]) * fmin(1.0, load / eps_s);
    const double x = 2.0 * height / b;
    return b > 0.0 ? erf(x) + expm1(-x * x) / (x * M_SQRTPI) : 1.0;
}

/* A bed in a stream that goes against its fall: fluidized, or at rest. In it
 * the velocity of the fluid changes with that of the grains, over no less than
 * a few cells and the width over which they are averaged; and particles behind
 * a bubble fall for the time of a diameter. The stream changes, too, as it
 * begins; in a bed at rest the slip does so only then. */
static void bed_scales(const struct settings *s, struct effect_scales *k,
                       const struct case_scales *in, double load)
{
    const double most = CHECK_PACKED * averaged(s, load, CHECK_PACKED);

    k->passed = fmax(expanded(s, k, in->up, most), load);
    k->carried = expanded(s, k, fmax(in->up, in->jet), most) < most;
    k->eps_s = k->passed;
    for (int i = 0; i < 10; i++) /* a looser bed is higher */
        k->eps_s = fmin(CHECK_PACKED, k->passed / averaged(s, load, k->eps_s));
    k->slip = in->up / (1.0 - k->passed);
    k->length = fmax(2.0 * in->S_c, build_averaging_options(s).bandwidth);
    k->shear = stirred * k->slip / k->length;
    k->stirred = k->carried;
    if (in->jet > 0.0) k->jet = in->up / in->jet;
    if (!k->carried) { /* the stream begins, and then nothing changes */
        k->rests = 1;
        k->time = in->end;
        k->acceleration = k->slip / k->time;
        return;
    }
    k->spin = spun * k->slip / k->d;
    k->time = sqrt(k->d / k->gravity);
    k->acceleration = stirred * k->slip / k->time * fabs(k->rho_s - k->rho_f) /
                          (k->rho_s + 0.5 * k->rho_f) +
                      k->changes;
}

/* A bed that lies there as the run begins; a lattice on a level floor does,
 * too.
 */
static int is_laid(const struct settings *s, const struct effect_scales *k)
{
    const double *const g = s->effects.gravity;
    const int level = fabs(g[vector_axis(g)]) > 0.99 * k->gravity;

    return s->particles.has_bed && k->rho_s > k->rho_f &&
           (level || s->particles.bed.settle > 0.0);
}

/* The slip of spheres that fall or rise, that a stream takes along or passes
 * as they lie, or that walls stir. */
static double free_slip(const struct settings *s, const struct effect_scales *k,
                        const struct case_scales *in, const struct placed *p)
{
    /* A few that are placed where a jet comes in are in it. */
    const double stream =
        s->particles.has_bed ? in->inlet : fmax(in->inlet, in->jet);
    double slip = fmax(stream, p->speed);

    if (k->gravity > 0.0) {
        const double fall = falls_with(s, k, k->eps_s);
        const int stirs = s->particles.surfaces.n > 0;
        if (s->fluid.has_mean_flow && k->partners && fall < in->inlet)
            return fall; /* through a period they go along */
        slip = is_laid(s, k) ? stirs * fmin(fall, in->impact)
                             : fmin(fall, 0.5 * k->gravity * in->end);
        slip = fmax(slip, p->speed);
        if (k->partners) slip = fmax(slip, stream);
    }
    return slip;
}

/* Whether walls or ends hold the fluid, which the drag would else take along,
 * in the direction in which the particles go: that of gravity, of an inlet, or
 * of their first velocities. */
static int is_held(const struct settings *s, const struct case_scales *in)
{
    const double *const g = s->effects.gravity;
    double along[3] = {0.0, 0.0, 0.0};
    int periodic[3], most = 0;

    for (int i = 0; i < s->particles.place.n; i++)
        vector_along(along, 1.0, s->particles.place.item[i].velocity, along);
    case_mesh_periodic(s, periodic);
    for (int k = 1; k < 3; k++)
        if (vector_length(g) > 0.0 ? fabs(g[k]) > fabs(g[most])
                                   : fabs(along[k]) > fabs(along[most]))
            most = k;
    return !periodic[most] || s->fluid.has_mean_flow ||
           (vector_length(g) == 0.0 && in->inlet > 0.0);
}

/* Spheres that fall or rise through the box, or that the stream carries across
 * it. */
static void free_scales(const struct settings *s, struct effect_scales *k,
                        const struct case_scales *in, const struct placed *p,
                        double load)
{
    double lo[3], size[3];

    case_mesh_ends(s, lo, size);
    for (int i = 0; i < 3; i++)
        size[i] -= lo[i];
    k->eps_s = load;
    if (s->particles.place.n > 1) /* a cloud of them */
        k->eps_s = fmin(CHECK_PACKED, volume_of_all(k, in) / around_placed(s));
    k->slip = free_slip(s, k, in, p);
    /* The push accelerates a sphere of the fluid's density like the fluid. */
    if (k->slip == 0.0 && k->mu > 0.0)
        k->slip = k->mean_gradient * k->d * k->d / (18.0 * k->mu) *
                  fabs(1.0 - k->rho_s / k->rho_f);
    k->carried = k->slip > 0.0 || k->mean_gradient > 0.0;
    k->length = 0.5 * fmin(size[0], fmin(size[1], size[2]));
    k->shear = shear_of_walls(s);
    if (k->mean_gradient > 0.0 && k->mu > 0.0) /* at the wall of a channel */
        k->shear = fmax(k->shear, k->mean_gradient * k->length / k->mu);
    k->spin = p->spin;
    k->passed = k->eps_s;
    k->time = k->end;
    k->acceleration = k->slip / k->time;
    k->decays = k->gravity == 0.0;
}

/* In a crowd that falls or rises through a liquid the velocities change as in a
 * bed, over no less than the way of a diameter, until it has come to an end of
 * the box. */
static void crowd_scales(struct effect_scales *k, double way)
{
    if (!k->partners || k->gravity == 0.0 || k->slip == 0.0) return;
    const double T = fmax(sqrt(k->d / k->gravity), k->d / k->slip);

    k->fluctuation = stirred * k->slip / T * fmin(1.0, way / k->slip / k->end) *
                     fabs(k->rho_s - k->rho_f) / (k->rho_s + 0.5 * k->rho_f);
}

/* They spin as in a bed, but all the same way: they roll, as fast as the stream
 * is in the mean (square), and once they have been taken along for a while: in
 * sand and in air this was 0.4 tau. */
static void roll(struct effect_scales *k, double square)
{
    const double x = k->end / (0.4 * k->tau);

    k->turns = 1;
    k->spin = spun * k->slip / k->d;
    k->rolls = square * (1.0 + expm1(-x) / x);
}

/* Grains that a stream moves along their bed, as its drag is above their
 * weight, are stopped by others and start again: their slip changes by itself
 * within tau, and they roll. */
static void swept_scales(struct effect_scales *k, const struct case_scales *in)
{
    k->acceleration = k->changes;
    /* The pressure of the others carries its part, too. */
    const double carried = 0.99 * (1.0 - k->passed) * k->weight;
    if (k->drag < carried * fabs(1.0 - k->rho_f / k->rho_s)) return;
    roll(k, in->square);
    k->time = k->tau;
    k->acceleration += k->slip / k->tau;
}

/* Spheres that come to rest lie as densely as a bed, on whatever floor; or
 * where a stream that goes out has taken them. */
static void pack(const struct settings *s, struct effect_scales *k,
                 const struct case_scales *in)
{
    const double *const g = s->effects.gravity;
    double lo[3], hi[3], way = 0.0;
    int periodic[3], ends = 0;
    const int sinks = s->particles.has_bed && k->rho_s > k->rho_f;

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    for (int i = 0; i < 3; i++)
        if (g[i] != 0.0 && !periodic[i]) {
            way = hypot(way, hi[i] - lo[i]);
            ends = 1;
        }
    k->rests = k->partners && ends &&
               (sinks || way < falls_with(s, k, k->eps_s) * in->end ||
                (in->way > 0.0 && in->way < in->inlet * in->end));
    if (k->rests) k->eps_s = CHECK_PACKED;
    if (sinks && !is_laid(s, k)) roll(k, 1.0); /* down a slope */
    if (k->rests && in->inlet > 0.0) swept_scales(k, in);
    if (!is_laid(s, k)) crowd_scales(k, ends ? way : HUGE_VAL);
}

/* A slip that dies out does so within tau; later by the fluid's mass that is
 * slowed down too, and sooner where the fluid comes along. */
static void settle_time(const struct settings *s, struct effect_scales *k)
{
    if (k->decays && k->slip > 0.0) {
        k->time = k->tau * (1.0 + 0.5 * k->rho_f / k->rho_s);
        if (s->exchange.two_way)
            k->time /= 1.0 + stability_loading(k->rho_s, k->eps_s, k->rho_f);
        k->acceleration = k->slip / k->time;
        const double x = k->end / k->time; /* the drag dies out, too */
        k->changes *= x / -expm1(-x);
    }
    k->acceleration = fmin(k->acceleration, k->slip / k->time);
}

/* Drag [N] where eps_s is solid, of this slip. */
static double drag_at(const struct settings *s, const struct effect_scales *k,
                      double eps_s)
{
    const struct drag_law law = build_drag_law(s);

    return scales_volume(k) * k->slip *
           drag_resistance(&law, 1.0 - eps_s, k->rho_f, k->mu, k->d, k->slip);
}

/* A grain in a jet of the speed U sees it change over the length L, in T = L/U
 * if it goes along, U T/(tau + T), and its slip is the part U tau/(tau + T)
 * that it lacks: U/T of both. The share up/U of them is in the jet. The jet
 * itself loses what it brings, rho up (U - up) over the section, to an eddy as
 * wide as the box; and more of it near its inlet, where a low bed is. */
static void jet_scales(const struct settings *s, struct effect_scales *k,
                       const struct case_scales *in, double load)
{
    const double T = k->length / in->jet;
    const int up = vector_axis(s->effects.gravity);
    double lo[3], hi[3], wide = 0.0;

    case_mesh_ends(s, lo, hi);
    for (int i = 0; i < 3; i++)
        if (i != up) wide = fmax(wide, hi[i] - lo[i]);
    const double high = (hi[up] - lo[up]) * fmin(1.0, load / k->eps_s);
    k->acceleration += in->up * k->tau / ((k->tau + T) * (k->tau + T));
    k->slows = in->up * (in->jet - in->up) / fmin(wide, high + k->length);
}

static void scales_in_fluid(const struct settings *s, struct effect_scales *k,
                            const struct case_scales *in,
                            const struct placed *p)
{
    const double crowd = 0.05; /* [-] of the whole mesh: a bed */

    k->mean_gradient = vector_length(s->fluid.mean_gradient);
    k->rho_f = s->fluid.rho;
    k->mu = s->fluid.mu;
    k->dt = in->dt;
    k->changes = in->changes / in->end;
    const double load = volume_of_all(k, in) / case_mesh_volume(s);
    const int lifts =
        (in->volume > 0.0 || load > crowd) && k->gravity > 0.0 && in->up > 0.0;
    if (lifts)
        bed_scales(s, k, in, load);
    else
        free_scales(s, k, in, p, load);
    k->drag = drag_at(s, k, k->passed);
    k->tau =
        k->slip > 0.0 ? k->rho_s * scales_volume(k) * k->slip / k->drag : 0.0;
    if (k->partners) /* at the relative speed that was measured in beds */
        k->meetings = 6.0 * k->eps_s * stirred * k->slip / k->d;
    settle_time(s, k);
    k->held = is_held(s, in);
    if (k->gravity > 0.0 && in->up <= 0.0) pack(s, k, in);
    if (lifts && k->carried && in->jet > 0.0) jet_scales(s, k, in, load);
}

struct effect_scales check_scales(const struct settings *s,
                                  const struct case_scales *in)
{
    const struct placed p = placed_of(s, in);
    struct effect_scales k = {
        .rho_s = s->particles.grains.density,
        .partners = in->particles > 1,
        .across = in->across,
        .d = in->volume > 0.0
                 ? cbrt(6.0 / M_PI * in->volume / in->particles) / in->across
                 : p.d,
        .end = in->end,
        .rolls = 1.0,
        .gravity = vector_length(s->effects.gravity)};

    k.weight = k.rho_s * scales_volume(&k) * k.gravity;
    if (s->has.exchange)
        scales_in_fluid(s, &k, in, &p);
    else if (k.partners) /* without a fluid they meet, and come to rest */
        k.eps_s = CHECK_PACKED;
    k.force = fmax(k.weight, k.drag);
    k.net = fmax(k.drag, k.weight * fabs(1.0 - k.rho_f / k.rho_s));
    k.force = fmax(k.force, k.mean_gradient * scales_volume(&k));
    if (k.net == 0.0 || k.mean_gradient > 0.0) k.net = k.force;
    return k;
}
