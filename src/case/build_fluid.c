/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build_fluid.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "case/case_mesh.h"
#include "case/models.h"
#include "coupling/coupling.h"

int build_two_way(const struct settings *s)
{
    return settings_has(s, "exchange") &&
           models_value(coupling_directions,
                        settings_text(s, "exchange.coupling"));
}

/* 1 if the case gives a key of one side, whose path this makes. A symmetry of
 * the mesh may be left out. */
static int has(const struct settings *s, const struct patch *p, const char *key,
               char path[128])
{
    const char *const side = settings_side(s, p->name);

    if (side == NULL) return 0;
    snprintf(path, 128, "%s.%s", side, key);
    return settings_has(s, path);
}

static int has_profile(const struct settings *s, const struct patch *p)
{
    char path[128];
    return has(s, p, "profile", path) &&
           strcmp(settings_text(s, path), "parabola") == 0;
}

/* Numbers that the inlets need: a time and a velocity for each point, and one
 * for each face of a profile. */
static int count_numbers(const struct settings *s, const struct mesh *m)
{
    char path[128];
    int n = 0;

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        if (!has(s, p, "inlet", path)) continue;
        n += 2 * settings_points(s, path) + (has_profile(s, p) ? p->n : 0);
    }
    return n;
}

/* 1 if both ends of direction k are walls that hold the fluid. */
static int between_walls(const struct settings *s, int k)
{
    static const char *const ends[3][2] = {
        {"left", "right"}, {"bottom", "top"}, {"back", "front"}};

    for (int i = 0; i < 2; i++) {
        const char *const side = settings_side(s, ends[k][i]);
        char path[128];
        if (side == NULL) return 0; /* periodic */
        snprintf(path, sizeof path, "%s.wall", side);
        const char *const word = settings_text(s, side);
        if (!settings_has(s, path) &&
            (word == NULL ||
             models_value(boundary_kinds, word) != BOUNDARY_NO_SLIP))
            return 0;
    }
    return 1;
}

/* A parabola in each direction that is between walls; mean 1. */
static void fill_profile(const struct settings *s, const struct mesh *m,
                         const struct patch *p, double *profile)
{
    const struct box *const b = &m->box;

    for (int j = 0; j < p->n; j++) {
        const int c = m->owner[p->first + j];
        const int at[3] = {c % b->n[0], c / b->n[0] % b->n[1],
                           c / b->n[0] / b->n[1]};
        profile[j] = 1.0;
        for (int k = 0; k < 3; k++) {
            const double *const x = b->edge[k];
            if (m->S[3 * (p->first + j) + k] == 0.0 && between_walls(s, k))
                profile[j] *= boundary_parabola(x[at[k]] / x[b->n[k]],
                                                x[at[k] + 1] / x[b->n[k]]);
        }
    }
}

/* Its numbers are put where *next points to. */
static struct boundary inlet(const struct settings *s, const struct mesh *m,
                             const struct patch *p, double **next)
{
    char path[128];
    const int n = has(s, p, "inlet", path) ? settings_points(s, path) : 0;
    double *const time = *next, *const velocity = time + n;

    for (int i = 0; i < n; i++)
        settings_point(s, path, i, &time[i], &velocity[i]);
    *next += 2 * n;
    if (!has_profile(s, p))
        return (struct boundary){.kind = BOUNDARY_INLET,
                                 .n_points = n,
                                 .time = time,
                                 .velocity = velocity};
    double *const profile = *next;
    fill_profile(s, m, p, profile);
    *next += p->n;
    return (struct boundary){.kind = BOUNDARY_INLET,
                             .n_points = n,
                             .time = time,
                             .velocity = velocity,
                             .profile = profile};
}

static struct boundary one_boundary(const struct settings *s,
                                    const struct mesh *m, const struct patch *p,
                                    double **next)
{
    struct boundary b = {.kind = BOUNDARY_SLIP};
    char path[128];

    if (settings_side(s, p->name) == NULL) return b;
    if (has(s, p, "inlet", path)) return inlet(s, m, p, next);
    if (has(s, p, "outlet", path)) {
        b.kind = BOUNDARY_OUTLET;
        b.pressure = settings_real(s, path);
    } else if (has(s, p, "wall", path)) {
        b.kind = BOUNDARY_NO_SLIP;
        settings_vector(s, path, b.wall);
    } else
        b.kind = (enum boundary_kind)models_value(
            boundary_kinds, settings_text(s, settings_side(s, p->name)));
    return b;
}

static void create_boundaries(const struct settings *s, struct simulation *sim)
{
    const struct mesh *const m = sim->mesh;
    double *next;

    next = sim->inlet_series = alloc_doubles(count_numbers(s, m));
    sim->boundaries =
        alloc_zeroed((size_t)m->n_patches, sizeof *sim->boundaries);
    for (int i = 0; i < m->n_patches; i++)
        sim->boundaries[i] = one_boundary(s, m, &m->patches[i], &next);
}

/* What drives a flow through periodic ends. */
static void take_drive(const struct settings *s, struct fluid_options *o)
{
    if (settings_has(s, "fluid.mean_gradient"))
        settings_vector(s, "fluid.mean_gradient", o->mean_gradient);
    if (!settings_has(s, "fluid.mean_flow")) return;
    settings_vector(s, "fluid.mean_flow", o->mean_flow);
    case_mesh_periodic(s, o->keeps_flow);
}

void build_fluid(const struct settings *s, struct simulation *sim)
{
    const int shared = settings_has(s, "effects.pressure_gradient");

    create_boundaries(s, sim);
    struct fluid_options o = {
        .rho = settings_real(s, "fluid.density"),
        .mu = settings_real(s, "fluid.viscosity"),
        .dt = sim->dt,
        .cfl =
            settings_has(s, "fluid.cfl") ? settings_real(s, "fluid.cfl") : 0.0,
        .convection =
            convection_scheme_named(settings_text(s, "fluid.convection")),
        .time = time_scheme_named(settings_text(s, "fluid.time")),
        .blend = settings_real(s, "fluid.blend"),
        .velocity_gradient =
            velocity_gradient_scheme_named(settings_text(s, "fluid.gradient")),
        .outer_correctors = settings_int(s, "fluid.outer_correctors"),
        .continuity = (enum continuity)models_value(
            fluid_continuity_forms, settings_text(s, "fluid.continuity")),
        .correctors = settings_int(s, "fluid.correctors"),
        .p_relative_tolerance = settings_real(s, "fluid.p_relative_tolerance"),
        .u_tolerance = settings_real(s, "fluid.u_tolerance"),
        .piso_tolerance = settings_real(s, "fluid.piso_tolerance"),
        .tolerance = settings_real(s, "fluid.tolerance"),
        .coupled = build_two_way(s),
        .pressure_shared =
            build_two_way(s) && shared &&
            models_value(coupling_forms, settings_text(s, "exchange.model")),
        .boundaries = sim->boundaries};
    take_drive(s, &o);
    sim->fluid = fluid_create(sim->mesh, &o);
}
