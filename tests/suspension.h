/* suspension.h -- spheres that move through a fluid, for the tests of the
 * coupling: a periodic cube, built without a case file. */
#ifndef SUSPENSION_H
#define SUSPENSION_H

#include <check.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/poly/poly.h"
#include "base/alloc.h"
#include "coupling/effects.h"
#include "coupling/coupling.h"
#include "coupling/replacement.h"
#include "dem/population/population.h"

/* A simulation built without a case file: all that the tests vary. */
struct scene {
    const char *averaging, *scheme, *interpolation, *drag;
    enum slip_integration relaxation;
    enum treatment treatment;
    enum continuity continuity;
    int pressure_gradient, substeps, one_way;
    int model_b;
    int whole_drag;      /* without pressure_gradient */
    double virtual_mass; /* [-] C; 0: the effect is off */
    int viscous_stress;
    double basset; /* [-] tolerance of the kernel; 0: the effect is off */
    int saffman, magnus, fluid_torque;
    double roughness;     /* [m] of the lubrication; 0: off */
    double mean_gradient; /* [Pa/m] along x */
    double rho, mu, dt;
    double rho_s, d;
    int n, dem_steps;
    double size;  /* [m] of the cube */
    int cells;    /* a side */
    double shear; /* [-] of the cube, along x over y */
    int tall;     /* 0: the cube; else so many above each other, between a floor
                     and a roof that let the fluid slip */
    double width; /* [-] bandwidth in cells */
    double gradient_width; /* [-] that of gradients at particles; 0: none */
    double cap;            /* [-] of pcm on eps_s; 0: none */
    double gravity[3];
    double fed; /* [1/s] spheres inserted a second, 3000 at most; 0: none */
    double
        sink; /* [-] share of the cube, from below, that takes out; 0: none */
    const struct time_scheme *time; /* NULL: euler */
};

static const struct scene air = {.averaging = "diffusion",
                                 .scheme = "exponential",
                                 .interpolation = "same",
                                 .drag = "syamlal-obrien",
                                 .treatment = TREATMENT_SEMI_IMPLICIT,
                                 .continuity = CONTINUITY_VOID_RATE,
                                 .pressure_gradient = 1,
                                 .rho = 1.2,
                                 .mu = 1.8e-5,
                                 .dt = 2e-4,
                                 .rho_s = 1000.0,
                                 .d = 1e-3,
                                 .n = 400,
                                 .dem_steps = 10,
                                 .size = 0.012,
                                 .cells = 6,
                                 .width = 2.0};

/* Spheres on a lattice with random velocities. */
static inline void scatter(struct simulation *sim, const struct scene *s)
{
    const int tall = s->tall > 0 ? s->tall : 1;
    const int side = (int)ceil(cbrt((double)s->n / tall)), high = side * tall;
    const double pitch = s->size / side;
    gsl_rng *const random = gsl_rng_alloc(gsl_rng_mt19937);

    sim->particles = particles_create(s->n + (s->fed > 0.0 ? 3000 : 0));
    for (int k = 0; k < s->n; k++) {
        const double x[3] = {(k % side + 0.5) * pitch,
                             (k / side % high + 0.5) * pitch,
                             (k / side / high + 0.5) * pitch};
        const int i = particles_add(sim->particles, x, s->d, s->rho_s);
        sim->particles->vx[i] = 0.5 * gsl_rng_uniform(random);
        sim->particles->vy[i] = 0.5 * gsl_rng_uniform(random) - 0.25;
        sim->particles->vz[i] = 0.5 * gsl_rng_uniform(random) - 0.25;
    }
    gsl_rng_free(random);
}

static inline void create_fluid(struct simulation *sim, const struct scene *s)
{
    static const struct boundary slip[] = {{.kind = BOUNDARY_SLIP},
                                           {.kind = BOUNDARY_SLIP}};
    const struct fluid_options fo = {
        .rho = s->rho,
        .mu = s->mu,
        .dt = s->dt,
        .convection = convection_scheme_named("upwind"),
        .continuity = s->continuity,
        .correctors = 2,
        .time = s->time,
        .tolerance = 1e-10,
        .boundaries = slip,
        .coupled = !s->one_way,
        .mean_gradient = {s->mean_gradient, 0.0, 0.0},
        .pressure_shared = s->pressure_gradient && !s->one_way && !s->model_b};

    sim->fluid = fluid_create(sim->mesh, &fo);
    for (int c = 0; c < sim->mesh->n_cells; c++)
        sim->fluid->u[3 * c] = 0.3;
    for (int f = 0; f < sim->mesh->n_faces; f++)
        sim->fluid->phi[f] = 0.3 * mesh_S(sim->mesh, f)[0];
}

static inline void create_coupling(struct simulation *sim,
                                   const struct scene *s)
{
    const struct averaging_options ao = {
        .bandwidth = s->width * s->size / s->cells,
        .scheme = s->scheme,
        .steps = 3,
        .tolerance = 1e-13,
        .cap = s->cap,
        .gradient_bandwidth = s->gradient_width * s->size / s->cells,
        .fields = 4};
    const struct coupling_options co = {
        .law = drag_law_named(s->drag),
        .treatment = s->treatment,
        .slip_integration = s->relaxation,
        .interpolation = interpolation_named(s->interpolation),
        .substeps = s->substeps,
        .two_way = !s->one_way};

    sim->averaging = averaging_create(averaging_method_named(s->averaging),
                                      sim->mesh, sim->particles, &ao);
    sim->coupling = coupling_create(sim, &co);
}

/* Spheres of another size are inserted with a velocity; those with their centre
 * in a box are removed. */
static inline void create_life(struct simulation *sim, const struct scene *s,
                               const struct dem_options *o)
{
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    const double L = s->size;

    sim->population = population_create(&box, s->fed > 0.0, s->sink > 0.0);
    if (s->fed > 0.0)
        sim->population->sources[0].options =
            (struct insertion_options){.hi = {L, L, L},
                                       .velocity = {0.1, -0.4, 0.2},
                                       .diameter = 0.7 * s->d,
                                       .density = s->rho_s,
                                       .count = 3000,
                                       .rate = s->fed,
                                       .seed = 3};
    if (s->sink > 0.0)
        sim->population->sinks[0] =
            (struct population_sink){.hi = {L, s->sink * L, L}, .side = -1};
}

static inline struct simulation *build(const struct scene *s)
{
    struct simulation *const sim = alloc_zeroed(1, sizeof *sim);
    const int tall = s->tall > 0 ? s->tall : 1, open = s->tall == 0;
    const struct box_spec spec = {{s->size, s->size * tall, s->size},
                                  {s->cells, s->cells * tall, s->cells},
                                  {1.0, 1.0, 1.0},
                                  {1, open, 1}};
    struct dem_options o = {
        .law = contact_law_named("linear"),
        .material = {.stiffness = 100.0, .restitution = 0.9, .friction = 0.3},
        .step = s->dt / s->dem_steps,
        .hi = {s->size, s->size * tall, s->size},
        .periodic = {1, open, 1}};

    const double gap[2] = {s->roughness, 0.2 * s->d};
    const struct attraction_scene liquid = {.viscosity = s->mu};
    static struct attraction attraction;

    if (s->roughness > 0.0) {
        attraction = effect_named("lubrication")->attraction(gap, &liquid);
        o.attractions = &attraction;
        o.n_attractions = 1;
    }
    const double shear[3] = {s->shear, 0.0, 0.0};
    sim->mesh = s->shear != 0.0 ? mesh_create_sheared(&spec, shear)
                                : mesh_create_box(&spec);
    sim->dt = s->dt;
    sim->dem_steps = s->dem_steps;
    scatter(sim, s);
    sim->held_force = particles_new_array(sim->particles, "held_force", "N", 3);
    sim->dem = dem_create(sim->particles, &o);
    if (s->fed > 0.0 || s->sink > 0.0) create_life(sim, s, &o);
    create_fluid(sim, s);
    create_coupling(sim, s);
    if (s->gravity[1] != 0.0) effects_create(sim, &gravity_effect, s->gravity);
    if (s->pressure_gradient)
        effects_create(sim, &pressure_gradient_effect, NULL);
    if (s->whole_drag) effects_create(sim, effect_named("whole_drag"), NULL);
    if (s->virtual_mass > 0.0)
        effects_create(sim, effect_named("virtual_mass"), &s->virtual_mass);
    if (s->viscous_stress)
        effects_create(sim, effect_named("viscous_stress"), NULL);
    if (s->basset > 0.0)
        effects_create(sim, effect_named("basset"), &s->basset);
    if (s->saffman) effects_create(sim, effect_named("saffman"), NULL);
    if (s->fluid_torque)
        effects_create(sim, effect_named("fluid_torque"), NULL);
    if (s->magnus) effects_create(sim, effect_named("magnus"), NULL);
    ck_assert_int_eq(coupling_start(sim), 0);
    return sim;
}

static inline void discard(struct simulation *sim)
{
    effects_free(sim);
    owner_free(sim->coupling);
    averaging_free(sim->averaging);
    dem_free(sim->dem);
    owner_free(sim->population);
    particles_free(sim->particles);
    owner_free(sim->fluid);
    mesh_free(sim->mesh);
    free(sim);
}

static inline void run(struct simulation *sim, int steps)
{
    for (int i = 0; i < steps; i++)
        ck_assert_int_eq(coupling_step(sim), 0);
}

/* Sum of |m v| of the particles: the scale of what is exchanged. */
static inline double gross_momentum(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double sum = 0.0;
    for (int i = 0; i < ps->n; i++)
        sum += ps->m[i] * (fabs(ps->vx[i]) + fabs(ps->vy[i]) + fabs(ps->vz[i]));
    return sum;
}

#endif
