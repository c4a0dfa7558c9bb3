/* SPDX-License-Identifier: GPL-3.0-or-later */
/* breakdown.c -- the message when a computation breaks down. */
#include "coupling/simulation.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "dem/dem_method.h"
#include "mesh/measures.h"

enum { OVERLAP_TEXT = 256 };

static void other_name(const struct simulation *sim, int other, char *text,
                       size_t size)
{
    if (other >= 0)
        snprintf(text, size, "particle %d", other);
    else if (other > -7)
        snprintf(text, size, "the %s wall across %c",
                 (-1 - other) % 2 ? "upper" : "lower", 'x' + (-1 - other) / 2);
    else
        snprintf(text, size, "the wall \"%s\"", sim->surface_names[-7 - other]);
}

/* The deepest overlap, its two partners and its place, as one clause of a
 * sentence. */
static void overlap_describe(const struct simulation *sim,
                             char text[OVERLAP_TEXT])
{
    const struct dem_overlap deep = dem_deepest(sim->dem);
    char other[128];

    other_name(sim, deep.other, other, sizeof other);
    snprintf(text, OVERLAP_TEXT,
             "particle %d and %s overlap by %.3g of their mean diameter, at "
             "[%g, %g, %g] m",
             deep.id, other, deep.depth, deep.at[0], deep.at[1], deep.at[2]);
}

static int fluid_broke(const struct simulation *sim)
{
    const struct fluid_report *const r = &sim->fluid->report;
    return !r->momentum.converged || !r->pressure.converged ||
           !isfinite(r->mass_residual) || !isfinite(r->cfl);
}

static void describe_fluid(const struct simulation *sim, const char *when,
                           char text[BREAKDOWN_TEXT])
{
    const struct fluid_report *const r = &sim->fluid->report;
    const double angle = mesh_quality(sim->mesh).non_orthogonal;
    char advice[128] = "Try a smaller fluid.step (CFL below 1) or "
                       "fluid.convection = \"upwind\"";

    if (angle > 80.0)
        snprintf(advice, sizeof advice,
                 "The mesh has links at %.1f degrees to the normals of their "
                 "faces, more than 80: improve it",
                 angle);
    snprintf(text, BREAKDOWN_TEXT,
             "the flow solver broke down %s: momentum %s after %d iterations "
             "(residual %.2g), pressure %s after %d (residual %.2g), CFL "
             "number %.3g.\n%s",
             when, r->momentum.converged ? "solved" : "not solved",
             r->momentum.iterations, r->momentum.after,
             r->pressure.converged ? "solved" : "not solved",
             r->pressure.iterations, r->pressure.after, r->cfl, advice);
}

/* Through a surface, by its name. */
static void describe_through(const struct simulation *sim, const char *when,
                             char text[BREAKDOWN_TEXT])
{
    const struct dem_report *const r = &sim->dem_report;

    snprintf(text, BREAKDOWN_TEXT,
             "%d particle%s went through a wall %s, the first with id %d, "
             "through \"%s\", at [%g, %g, %g] m; the largest overlap was %.3g "
             "d, the highest speed %.3g m/s.\nTry a smaller particles.step "
             "(winnow check suggests one) or a stiffer material",
             r->lost, r->lost == 1 ? "" : "s", when, r->lost_id,
             sim->surface_names[r->lost_through], r->lost_at[0], r->lost_at[1],
             r->lost_at[2], r->max_overlap, r->max_speed);
}

static void describe_lost(const struct simulation *sim, const char *when,
                          char text[BREAKDOWN_TEXT])
{
    const struct dem_report *const r = &sim->dem_report;
    const struct dem_method *const by = dem_created_with(sim->dem)->method;

    snprintf(text, BREAKDOWN_TEXT,
             "%d particle%s left the box or %s no longer anywhere %s, the "
             "first with id %d, at [%g, %g, %g] m; the largest overlap was "
             "%.3g d, the highest speed %.3g m/s.\nTry a smaller "
             "particles.step%s",
             r->lost, r->lost == 1 ? "" : "s", r->lost == 1 ? "is" : "are",
             when, r->lost_id, r->lost_at[0], r->lost_at[1], r->lost_at[2],
             r->max_overlap, r->max_speed,
             by != NULL && by->no_contacts
                 ? ""
                 : " (winnow check suggests one); a stiffer material helps "
                   "only if its contacts are resolved");
}

static void describe_crossing(const struct simulation *sim, const char *when,
                              char text[BREAKDOWN_TEXT])
{
    const struct dem_report *const r = &sim->dem_report;

    snprintf(text, BREAKDOWN_TEXT,
             "particles %d and %d passed through each other %s, within a "
             "particle step of %g s and without a contact; the highest speed "
             "was %.3g m/s.\nTry a smaller particles.step: none may move by "
             "more than half of its diameter in one",
             r->crossing.id[0], r->crossing.id[1], when,
             dem_created_with(sim->dem)->step, r->max_speed);
}

static void describe_overlap(const struct simulation *sim, const char *when,
                             char text[BREAKDOWN_TEXT])
{
    char who[OVERLAP_TEXT];

    overlap_describe(sim, who);
    snprintf(text, BREAKDOWN_TEXT,
             "%s %s, more than particles.max_overlap, %g.\nTry a stiffer "
             "material with a smaller particles.step (winnow check suggests "
             "one), or a higher particles.max_overlap if this is meant",
             who, when, dem_deepest(sim->dem).most);
}

static void describe_solids(const struct simulation *sim, const char *when,
                            char text[BREAKDOWN_TEXT])
{
    snprintf(text, BREAKDOWN_TEXT,
             "a cell holds more solids than it has room for %s: the lowest "
             "fluid fraction is %.3g.\nTry averaging.method = \"diffusion\", "
             "or \"kernel\" with a bandwidth from 1.5 of the largest cells on, "
             "larger cells, or averaging.cap with \"pcm\"",
             when, sim->coupling->report.eps_lowest);
}

/* No fluid is left in a cell; or hardly any, less than packed spheres leave: a
 * particle that is lost then was thrown out by its drag, and no smaller step
 * keeps it. */
static int is_full(const struct simulation *sim)
{
    return sim->coupling != NULL &&
           sim->coupling->report.eps_lowest <
               (sim->dem_report.lost > 0 ? 0.05 : DBL_MIN);
}

/* The void fraction of each cell is positive, but interpolated to a particle it
 * is not. */
static void describe_seen(const struct simulation *sim, const char *when,
                          char text[BREAKDOWN_TEXT])
{
    snprintf(
        text, BREAKDOWN_TEXT,
        "the fluid fraction interpolated to a particle is %.3g %s, though that "
        "of no cell is below %.3g.\nTry averaging.method = \"diffusion\", or "
        "\"kernel\" with a bandwidth from 1.5 of the largest cells on, larger "
        "cells, or averaging.interpolation = \"nearest\"",
        sim->coupling->report.lowest_interpolated, when,
        sim->coupling->report.eps_lowest);
}

/* The largest solids fraction at which the exchange of momentum is stable
 * (coupling.h), where the cells hold more than that; else 0. Effects that add
 * to the mass of the particles are not looked at. */
static double passed_stability(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const struct added_mass none = {0};
    double mass = 0.0, volume = 0.0;

    if (sim->coupling == NULL) return 0.0;
    for (int i = 0; i < ps->n; i++) {
        mass += ps->m[i];
        volume += particles_volume(ps, i);
    }
    for (int i = 0; i < sim->n_effects; i++)
        if (sim->effects[i].effect->added_mass != NULL) return 0.0;
    if (mass == 0.0) return 0.0;
    const double densest = stability_max_solid_fraction(
        &none, mass / volume / sim->fluid->options.rho,
        sim->coupling->options.treatment == TREATMENT_SEMI_IMPLICIT);
    return 1.0 - sim->coupling->report.eps_lowest > densest ? densest : 0.0;
}

static void describe_unstable(const struct simulation *sim, const char *when,
                              char text[BREAKDOWN_TEXT])
{
    snprintf(text, BREAKDOWN_TEXT,
             "the grains are so light that their exchange of momentum with the "
             "fluid is not stable where more than %.3g of the volume is solid, "
             "and %.3g was: accelerations grew until the particles broke down "
             "%s, with %.3g m/s.\nTry effects.virtual_mass, fewer grains in a "
             "place or heavier ones; winnow check names the limit",
             passed_stability(sim), 1.0 - sim->coupling->report.eps_lowest,
             when, sim->dem_report.max_speed);
}

/* 1 if the particles went where they cannot. */
static int particles_broke(const struct simulation *sim)
{
    return sim->particles != NULL &&
           (sim->dem_report.lost > 0 || sim->dem_report.crossing.found ||
            (sim->dem != NULL &&
             sim->dem_report.max_overlap > dem_deepest(sim->dem).most));
}

/* The message of an effect that failed; NULL if none did. */
static const char *trouble_of(const struct simulation *sim)
{
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect_state *const e = &sim->effects[i];
        const char *const text =
            e->effect->failure != NULL ? e->effect->failure(e->memory) : NULL;
        if (text != NULL) return text;
    }
    return NULL;
}

void breakdown_describe(const struct simulation *sim, char text[BREAKDOWN_TEXT])
{
    char when[64];

    snprintf(when, sizeof when, "at t = %g s (step %ld)", sim->t,
             sim->steps + 1);
    if (sim->fluid != NULL && sim->fluid->t > 0.0 && fluid_broke(sim))
        describe_fluid(sim, when, text);
    else if (trouble_of(sim) != NULL)
        snprintf(text, BREAKDOWN_TEXT, "%s %s", trouble_of(sim), when);
    else if (is_full(sim))
        describe_solids(sim, when, text);
    else if (particles_broke(sim) && passed_stability(sim) > 0.0)
        describe_unstable(sim, when, text);
    else if (sim->surface_names != NULL && sim->dem_report.lost > 0 &&
             sim->dem_report.lost_through >= 0)
        describe_through(sim, when, text);
    else if (sim->particles != NULL && sim->dem_report.lost > 0)
        describe_lost(sim, when, text);
    else if (sim->particles != NULL && sim->dem_report.crossing.found)
        describe_crossing(sim, when, text);
    else if (sim->dem != NULL &&
             sim->dem_report.max_overlap > dem_deepest(sim->dem).most)
        describe_overlap(sim, when, text);
    else if (sim->coupling != NULL &&
             sim->coupling->report.lowest_interpolated <= 0.0)
        describe_seen(sim, when, text);
    else
        snprintf(text, BREAKDOWN_TEXT,
                 "a value is no longer finite %s.\nTry smaller steps", when);
}

int breakdown_overlaps(const struct simulation *sim)
{
    return sim->dem != NULL && dem_deepest(sim->dem).id >= 0;
}

void breakdown_warn(int *told, const struct simulation *sim)
{
    char text[OVERLAP_TEXT];

    if (*told || !breakdown_overlaps(sim)) return;
    *told = 1;
    overlap_describe(sim, text);
    fprintf(stderr,
            "winnow: t = %g s: %s: more than %g (particles.expected_overlap). "
            "That is more than the grains should have: try a stiffer material "
            "with a smaller particles.step, or give the key the overlap that "
            "is meant%s\n",
            sim->t, text, dem_deepest(sim->dem).expected,
            passed_stability(sim) > 0.0
                ? "; and cells hold more than the \"largest stable solid "
                  "fraction\" of winnow check"
                : "");
}
