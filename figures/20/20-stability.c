/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 20-stability.c -- which treatments of drag are stable, and where.
 *
 *   20-stability suspension|one|bed|edge
 *
 * One line a treatment, mass loading M and step over relaxation time x: what
 * became of the spheres.
 *
 *   suspension, one   cases/closed-box.cfg, 64 spheres or one: they fly, the
 *                     drag stops them, nothing else acts. Their velocity should
 *                     fall to the common one, where all momentum is shared.
 *   bed               cases/small-bed.cfg at rest, blown through at a fifth of
 *                     what would lift it. The bed should stay a bed.
 *   edge              the longest x of the bed for M = 100, semi-implicit
 *
 * M is the mass of the spheres over that of the fluid in a cell with spheres;
 * x = k dt/m. The fluid's density makes M, its viscosity x.
 */
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "coupling/coupling.h"
#include "case/build.h"
#include "case/case_file.h"

enum { STEPS = 400, MOST = 12, TEXT = 200, EXPLICIT = 0, BED = 2 };
static const char *const systems[] = {"suspension", "one", "bed"};
static const double rho_s = 1000.0, gravity = 9.81; /* [kg/m^3], [m/s^2] */

struct run {
    int system, treatment, relaxation;
    double M, x; /* [-] */
};

/* What a case is to be overridden with. */
struct overrides {
    char text[MOST][TEXT];
    const char *list[MOST];
    int n;
};

static void say(struct overrides *o, const char *key, const char *value)
{
    snprintf(o->text[o->n], TEXT, "%s=%s", key, value);
    o->list[o->n] = o->text[o->n];
    o->n++;
}

static void give(struct overrides *o, const char *key, double value)
{
    char text[40];

    snprintf(text, sizeof text, "%.12e", value);
    say(o, key, text);
}

/* The viscosity [Pa s] with which one sphere in the bed has k = m x/dt at the
 * given slip; the least there is if inertia alone gives more. */
static double viscosity(double k, double rho, double d, double slip)
{
    const struct drag_law *const law = drag_law_named("gidaspow");
    const double V = M_PI / 6.0 * d * d * d;
    double low = 1e-12, high = 1e12;

    for (int i = 0; i < 200; i++) {
        const double mu = sqrt(low * high);
        if (V * drag_resistance(law, 0.45, rho, mu, d, slip) < k)
            low = mu;
        else
            high = mu;
    }
    return low;
}

/* Drag and pressure together bear a fifth of the weight: k U/eps^2 = m g/5. */
static void prepare_bed(struct overrides *o, double rho, double x)
{
    const double d = 1.2e-3, dt = 1e-4, eps = 0.45;
    const double m = rho_s * M_PI / 6.0 * d * d * d, k = m * x / dt;
    const double U = 0.2 * m * gravity * eps * eps / k;

    say(o, "exchange.drag", "gidaspow");
    give(o, "fluid.step", dt);
    give(o, "fluid.viscosity", viscosity(k, rho, d, U / eps));
    give(o, "fluid.bottom.inlet", U);
}

static void prepare_box(struct overrides *o, double x, int one)
{
    const double d = 1e-3, dt = 1e-6;

    say(o, "exchange.drag", "schiller-naumann");
    give(o, "fluid.step", dt);
    give(o, "particles.step", dt);
    give(o, "fluid.viscosity", rho_s * d * d / 18.0 * x / dt); /* Stokes */
    if (one)
        say(o, "particles.place",
            "({position=[0.0015,0.0015,0.0015]; velocity=[0.3,0.0,0.0]; "
            "diameter=1e-3;})");
}

/* Drag alone: no force of the pressure. */
static void without_pressure(struct simulation *sim)
{
    for (int i = 0; i < sim->n_effects; i++)
        if (sim->effects[i].effect->free != NULL)
            sim->effects[i].effect->free(sim->effects[i].memory);
    sim->n_effects = 0;
    sim->fluid->options.pressure_shared = 0;
}

static struct simulation *prepare(const struct run *r)
{
    static const char *const treatment[] = {"explicit", "semi-implicit"};
    static const char *const relaxation[] = {"frozen", "exponential"};
    const double eps_s = r->system == BED ? 0.55 : M_PI / 6.0 * 1e-9 / 27e-9;
    const double rho = rho_s * eps_s / (1.0 - eps_s) / r->M;
    struct overrides o = {.n = 0};
    int code;

    say(&o, "exchange.treatment", treatment[r->treatment]);
    say(&o, "exchange.slip_integration", relaxation[r->relaxation]);
    say(&o, "exchange.substeps", "1");
    give(&o, "fluid.density", rho);
    if (r->system == BED)
        prepare_bed(&o, rho, r->x);
    else
        prepare_box(&o, r->x, r->system == 1);
    struct settings *const s = case_file_read(
        r->system == BED ? "cases/small-bed.cfg" : "cases/closed-box.cfg", o.n,
        o.list, &code);
    if (s == NULL) exit(code);
    struct simulation *const sim = build_simulation(s, &code);
    settings_free(s);
    if (sim == NULL) exit(code);
    if (r->system != BED) without_pressure(sim);
    /* grains lighter than the fluid: weight less buoyancy as in air */
    else
        sim->gravity[1] = -gravity / (1.0 - rho / rho_s);
    return sim;
}

/* Mean velocity along x less that at which fluid and spheres, 64 cells of the
 * one and n of the other, move together. */
static double excess(const struct simulation *sim, double M, double first)
{
    const struct particles *const ps = sim->particles;
    const double share = M * ps->n / 64.0;
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->vx[i];
    return sum / ps->n - first * share / (1.0 + share);
}

/* "sluggish": more than 1 % is left of the excess, where ten times the time
 * that it should take has passed. (One sphere waits for the fluid elsewhere.)
 */
static const char *verdict_of_box(const struct run *r, struct simulation *sim)
{
    int failed = coupling_start(sim), turns = 0;
    const double v0 = excess(sim, r->M, 0.0), first = excess(sim, r->M, v0);
    const double due = r->x * STEPS * (1.0 + r->M * sim->particles->n / 64.0);
    double last = first;

    for (int i = 0; i < STEPS && !failed; i++) {
        failed = coupling_step(sim);
        const double now = excess(sim, r->M, v0);
        failed |= !(fabs(now) < 10.0 * v0);
        turns += fabs(now) > 1e-6 * first && now * last < 0.0;
        last = now;
    }
    return failed      ? "diverged"
           : turns > 2 ? "oscillating"
           : r->system == 0 && fabs(last) > 0.01 * first && due > 50.0
               ? "sluggish"
               : "stable";
}

/* The bed is at rest within what it had from settling, or shaken by more than
 * a sphere gains in falling a tenth of its diameter. */
static const char *verdict_of_bed(struct simulation *sim)
{
    int failed = coupling_start(sim);
    double fastest = 0.0;

    for (int i = 0; i < STEPS && !failed; i++) {
        failed = coupling_step(sim);
        if (i > STEPS / 2) fastest = fmax(fastest, sim->dem_report.max_speed);
        failed |= !(sim->dem_report.max_speed < 1.0);
    }
    return failed                                   ? "diverged"
           : fastest > sqrt(0.2 * gravity * 1.2e-3) ? "oscillating"
                                                    : "stable";
}

/* Halves the interval (in the logarithm) until it is known to 2 %. */
static void print_edge(int relaxation)
{
    double low = 0.3, high = 3.0;

    for (int i = 0; i < 7; i++) {
        const struct run r = {BED, 1, relaxation, 100.0, sqrt(low * high)};
        struct simulation *const sim = prepare(&r);
        if (strcmp(verdict_of_bed(sim), "stable") == 0)
            low = r.x;
        else
            high = r.x;
        build_free(sim);
    }
    printf("%s %.2f\n", relaxation ? "exponential" : "frozen", low);
}

int main(int n, char **word)
{
    int system = 0;

    for (int i = 0; i < 3; i++)
        if (n > 1 && strcmp(word[1], systems[i]) == 0) system = i;
    /* what goes wrong is what is wanted here: it need not be said each time */
    if (freopen("/dev/null", "w", stderr) == NULL) return 4;
    if (n > 1 && strcmp(word[1], "edge") == 0) {
        print_edge(0);
        print_edge(1);
        return 0;
    }
    printf("# %s\n# treatment, M [-], x [-], verdict\n", systems[system]);
    for (int k = 0; k < 4; k++)
        for (int a = -3; a <= 3; a++)
            for (int b = -2; b <= 8; b++) {
                const struct run r = {system, k / 2, k % 2, pow(10.0, a),
                                      pow(10.0, 0.5 * b)};
                struct simulation *const sim = prepare(&r);
                printf("%s-%s %g %.3g %s\n",
                       r.treatment == EXPLICIT ? "explicit" : "semi-implicit",
                       r.relaxation ? "exponential" : "frozen", r.M, r.x,
                       system == BED ? verdict_of_bed(sim)
                                     : verdict_of_box(&r, sim));
                build_free(sim);
            }
    return 0;
}
