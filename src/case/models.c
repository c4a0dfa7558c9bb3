/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/models.h"

#include "averaging/averaging.h"
#include "averaging/interpolation.h"
#include "coupling/effects.h"
#include "coupling/drag.h"
#include "fluid/fluid.h"
#include "dem/contact_hertz.h"
#include "dem/integrators.h"
#include "dem/population/sizes.h"

#include <stddef.h>
#include <string.h>

/* The i-th row of a table that ends with a row without a name. */
static int row(const struct model *table, int i, struct model *m)
{
    for (int k = 0; k <= i; k++)
        if (table[k].name == NULL) return 0;
    *m = table[i];
    return 1;
}

static int contact(int i, struct model *m)
{
    const struct contact_law *const *const all = contact_laws;

    for (int k = 0; k <= i; k++)
        if (all[k] == NULL) return 0;
    *m = (struct model){all[i]->name, all[i]->what, all[i]->cite, "", ""};
    m->function = all[i] == &contact_hertz ? "contact_hertz_force"
                                           : "contact_linear_force";
    m->keys = all[i] == &contact_hertz
                  ? "particles.grains.young particles.grains.poisson"
                  : "particles.grains.stiffness";
    return 1;
}

static int integrator(int i, struct model *m)
{
    const struct integrator *const *const all = integrators;

    for (int k = 0; k <= i; k++)
        if (all[k] == NULL) return 0;
    *m = (struct model){all[i]->name, all[i]->what, all[i]->cite, "", ""};
    m->function = all[i]->predicts ? "integrators_correct" : "bodies_advance";
    return 1;
}

static int list(int i, struct model *m)
{
    static const struct model table[] = {
        {"verlet", "pairs up to a skin apart, kept until they have moved it",
         "LS 5.15, 5.16", "neighbours_refresh", "particles.skin"},
        {"link-cells", "pairs of neighbouring cells, sought in each step",
         "LS section 5.2.2", "grid_find", ""},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

/* The keys of a law of sizes: sizes_laws has their names alone. */
static const char *sizes_keys(const char *law)
{
    if (strcmp(law, "normal") == 0)
        return "particles.sizes.mean particles.sizes.deviation "
               "particles.sizes.min particles.sizes.max";
    if (strcmp(law, "lognormal") == 0)
        return "particles.sizes.median particles.sizes.ratio "
               "particles.sizes.min particles.sizes.max "
               "particles.sizes.by";
    if (strcmp(law, "uniform") == 0)
        return "particles.sizes.min particles.sizes.max particles.sizes.by";
    return "particles.sizes.points particles.sizes.by";
}

static int sizes(int i, struct model *m)
{
    const struct sizes_law *const *const all = sizes_laws;

    for (int k = 0; k <= i; k++)
        if (all[k] == NULL) return 0;
    *m = (struct model){all[i]->name, all[i]->what, all[i]->cite,
                        "sizes_quantile", sizes_keys(all[i]->name)};
    return 1;
}

/* Which keys a method of averaging reads. */
static const char *averaging_keys(const struct averaging_method *method)
{
    if (strcmp(method->name, "pcm") == 0) return "averaging.cap";
    if (strcmp(method->name, "diffusion") == 0)
        return "averaging.bandwidth averaging.delta_05 "
               "averaging.bandwidth_variation "
               "averaging.regions averaging.scheme averaging.steps "
               "averaging.tolerance";
    if (strcmp(method->name, "images") == 0)
        return "averaging.bandwidth averaging.delta_05";
    return method->needs_bandwidth ? "averaging.bandwidth" : "";
}

static int averaging(int i, struct model *m)
{
    const struct averaging_method *const *const all = averaging_methods;

    for (int k = 0; k <= i; k++)
        if (all[k] == NULL) return 0;
    *m = (struct model){all[i]->name, all[i]->what, all[i]->cite,
                        all[i]->function, averaging_keys(all[i])};
    return 1;
}

static int scheme(int i, struct model *m)
{
    static const struct model table[] = {
        {"exponential", "the matrix exponential; no steps", "",
         "apply_exponential", ""},
        {"series", "the same, always by its series", "", "chebyshev_apply", ""},
        {"crank-nicolson", "second order; undershoots if the steps are few",
         "SX15 5", "theta_step", "averaging.steps"},
        {"implicit-euler", "first order; never undershoots", "", "theta_step",
         "averaging.steps"},
        {"sdirk2", "second order, L-stable; undershoots little", "",
         "sdirk2_step", "averaging.steps"},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

static int interpolation(int i, struct model *m)
{
    const struct interpolation *const *const all = interpolations;

    for (int k = 0; k <= i; k++)
        if (all[k] == NULL) return 0;
    *m = (struct model){all[i]->name, all[i]->what, all[i]->cite, all[i]->name,
                        ""};
    return 1;
}

/* The function of a law; they are static in drag.c, one for each name. */
static const char *drag_function(const char *law)
{
    if (strcmp(law, "syamlal-obrien") == 0) return "syamlal_obrien";
    return strcmp(law, "gidaspow") == 0 ? "gidaspow" : "schiller_naumann";
}

static int drag(int i, struct model *m)
{
    const struct drag_law *const law = drag_laws[i];

    for (int k = 0; k <= i; k++)
        if (drag_laws[k] == NULL) return 0;
    *m = (struct model){law->name, law->what, law->cite,
                        drag_function(law->name), ""};
    return 1;
}

static int treatment(int i, struct model *m)
{
    static const struct model table[] = {
        {"semi-implicit", "the fluid's own velocity is taken at the new time",
         "XS11 3.13-3.15", "transfer_drag_terms", ""},
        {"explicit", "the drag is a given force during the fluid's step", "",
         "transfer_drag_terms", ""},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

static int relaxation(int i, struct model *m)
{
    static const struct model table[] = {
        {"frozen", "the drag of the sub-step's start, throughout it",
         "XS11 3.18", "apply_frozen", ""},
        {"exponential", "the drag that relaxes as the particle gives in to it",
         "XS11 3.16", "implicit_drag_advance", ""},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

static int form(int i, struct model *m)
{
    static const struct model table[] = {
        {"A", "the fluid has its share of the pressure gradient, eps_f grad p",
         "XS11 2.8", "pressure_gradient_before_particles", ""},
        {"B", "the fluid has all of it, and what the particles feel returns",
         "SX15 2b", "pressure_gradient_before_particles", ""},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

static int coupling(int i, struct model *m)
{
    static const struct model table[] = {
        {"two-way", "what the particles gain the fluid loses", "LS 5",
         "transfer_drag_terms", ""},
        {"one-way", "the fluid does not feel the particles", "LS 5",
         "transfer_drag_terms", ""},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

static int time_scheme(int i, struct model *m)
{
    const struct time_scheme *const s = time_schemes[i];

    for (int k = 0; k <= i; k++)
        if (time_schemes[k] == NULL) return 0;
    *m = (struct model){s->name, s->what, s->cite, s->function, ""};
    return 1;
}

static int convection(int i, struct model *m)
{
    const struct convection_scheme *const s = convection_schemes[i];

    for (int k = 0; k <= i; k++)
        if (convection_schemes[k] == NULL) return 0;
    *m = (struct model){s->name, s->what, s->cite, s->function, ""};
    if (strcmp(s->name, "blended") == 0) m->keys = "fluid.blend";
    if (s->deferred != NULL) m->keys = "fluid.gradient";
    return 1;
}

static int gradient(int i, struct model *m)
{
    const struct velocity_gradient_scheme *const s =
        velocity_gradient_schemes[i];

    for (int k = 0; k <= i; k++)
        if (velocity_gradient_schemes[k] == NULL) return 0;
    *m = (struct model){s->name, s->what, s->cite, s->function, ""};
    return 1;
}

static int continuity(int i, struct model *m)
{
    static const struct model table[] = {
        {"mixture", "the volume fluxes of both phases have no divergence",
         "XS11 2.7", "continuity_source", ""},
        {"void-rate", "the fluid flows out of where the void shrinks",
         "XS11 2.3", "continuity_source", ""},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

static int patch(int i, struct model *m)
{
    static const struct model table[] = {
        {"no-slip", "the fluid stands still at the wall", "", "add_wall_face",
         ""},
        {"slip", "no flow through, no friction along", "", "add_slip_face", ""},
        {"inlet", "a superficial velocity, constant or varying in time", "",
         "boundary_inlet_velocity",
         "fluid.<patch>.inlet fluid.<patch>.profile"},
        {"wall", "a wall that moves along itself and takes the fluid with it",
         "", "add_wall_face", "fluid.<patch>.wall"},
        {"outlet", "a pressure outside", "", "pressure_correct",
         "fluid.<patch>.outlet"},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

static int surface(int i, struct model *m)
{
    static const struct model table[] = {
        {"plane", "its solid behind it, no end", "", "surface_nearest",
         "particles.surfaces.point particles.surfaces.normal"},
        {"cylinder", "the particles inside or outside, no ends", "",
         "surface_nearest",
         "particles.surfaces.point particles.surfaces.axis "
         "particles.surfaces.radius particles.surfaces.particles"},
        {"stl", "triangles from a file; a seam, an edge, a vertex count once",
         "LS section 4.3", "surface_contact_points_find",
         "particles.surfaces.file particles.surfaces.scale "
         "particles.surfaces.point"},
        {NULL, NULL, NULL, NULL, NULL}};
    return row(table, i, m);
}

static int effect(int i, struct model *m)
{
    const struct effect *const e = effects[i];

    for (int k = 0; k <= i; k++)
        if (effects[k] == NULL) return 0;
    *m = (struct model){e->name, e->what, e->equations, e->function, ""};
    return 1;
}

const struct kind models_kinds[] = {
    {"contact", "contact laws", "particles.contact", contact},
    {"integrator", "ways of the particles through time", "particles.integrator",
     integrator},
    {"list", "ways to find the pairs", "particles.list", list},
    {"sizes", "distributions of diameters", "particles.sizes.distribution",
     sizes},
    {"surface", "walls besides those of the box", "particles.surfaces.shape",
     surface},
    {"averaging", "ways from particles to fields", "averaging.method",
     averaging},
    {"scheme", "schemes of the diffusion in pseudo-time", "averaging.scheme",
     scheme},
    {"interpolation", "ways from fields to particles",
     "averaging.interpolation", interpolation},
    {"drag", "drag laws", "exchange.drag", drag},
    {"treatment", "treatments of the drag in the fluid", "exchange.treatment",
     treatment},
    {"slip_integration", "courses of the drag during a sub-step",
     "exchange.slip_integration", relaxation},
    {"model", "forms of the averaged momentum equation", "exchange.model",
     form},
    {"coupling", "directions of the coupling", "exchange.coupling", coupling},
    {"time", "time schemes of the fluid", "fluid.time", time_scheme},
    {"convection", "convection schemes", "fluid.convection", convection},
    {"gradient", "slopes of the velocity", "fluid.gradient", gradient},
    {"continuity", "forms of the mass balance", "fluid.continuity", continuity},
    {"patch", "what happens on a side of the box", "fluid.<patch>", patch},
    {"effect", "further effects, each on where it is named", "effects", effect},
    {NULL, NULL, NULL, NULL}};

const struct kind *models_kind(const char *name)
{
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        if (strcmp(k->name, name) == 0) return k;
    return NULL;
}
