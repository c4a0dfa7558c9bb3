/* resolved.h -- for tests: a box of fluid with bodies in it. */
#ifndef RESOLVED_H
#define RESOLVED_H

#include <check.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "dem/dem_method.h"
#include "resolved/shapes/block_contacts.h"
#include "resolved/body_motion.h"
#include "resolved/solid_bodies.h"

struct pool {
    struct mesh *mesh;
    struct boundary boundary[6];
    struct fluid *fluid;
    struct solid_bodies *bodies;
};

struct pool_options {
    double size[3];         /* [m] */
    int cells[3], walls[3]; /* 1: no-slip walls in that direction */
    double rho, mu, dt;
    double gradient[3]; /* [Pa/m] */
    double lid;         /* [m/s] velocity of the upper wall along x */
    double inlet;       /* [m/s] of the floor, with an outlet above; 0: walls; o
                           outlives the pool */
    const char *time;   /* NULL: bdf2 */
    double virtual_mass;
    const struct body_method *method;
    int n; /* bodies */
    int dem_steps;
    double tolerance;      /* 0: 1e-10 */
    double piso_tolerance; /* 0: 1e-3 */
};

/* Equal cells, second order in space and time. */
static inline void pool_create(struct pool *p, const struct pool_options *o)
{
    static const double start = 0.0;
    struct box_spec spec = {.grading = {1.0, 1.0, 1.0}};
    struct fluid_options f = {
        .rho = o->rho,
        .mu = o->mu,
        .dt = o->dt,
        .time = time_scheme_named(o->time != NULL ? o->time : "bdf2"),
        .convection = convection_scheme_named("linear"),
        .correctors = 2,
        .piso_tolerance = o->piso_tolerance > 0.0 ? o->piso_tolerance : 1e-3,
        .tolerance = o->tolerance > 0.0 ? o->tolerance : 1e-10,
        .boundaries = p->boundary};
    struct dem_options dem = {
        .law = contact_law_named("linear"),
        .material = {.stiffness = 1.0, .restitution = 0.9},
        .method = dem_method_named("all-pairs"),
        .step = o->dt / (o->dem_steps > 0 ? o->dem_steps : 1)};
    struct solid_bodies_options b = {.method = o->method,
                                     .virtual_mass = o->virtual_mass,
                                     .dem_steps =
                                         o->dem_steps > 0 ? o->dem_steps : 1,
                                     .dem = &dem};

    for (int k = 0; k < 3; k++) {
        spec.size[k] = dem.hi[k] = o->size[k];
        spec.cells[k] = o->cells[k];
        spec.periodic[k] = dem.periodic[k] = !o->walls[k];
        f.mean_gradient[k] = o->gradient[k];
    }
    for (int i = 0; i < 6; i++)
        p->boundary[i] = (struct boundary){.kind = BOUNDARY_NO_SLIP};
    p->mesh = mesh_create_box(&spec);
    for (int i = 0; i < p->mesh->n_patches; i++)
        if (p->mesh->patches[i].name[0] == 't') p->boundary[i].wall[0] = o->lid;
    for (int i = 0; i < p->mesh->n_patches && o->inlet > 0.0; i++) {
        const char *const name = p->mesh->patches[i].name;
        if (strcmp(name, "bottom") == 0)
            p->boundary[i] = (struct boundary){.kind = BOUNDARY_INLET,
                                               .n_points = 1,
                                               .time = &start,
                                               .velocity = &o->inlet};
        if (strcmp(name, "top") == 0)
            p->boundary[i] = (struct boundary){.kind = BOUNDARY_OUTLET};
    }
    p->fluid = fluid_create(p->mesh, &f);
    p->bodies =
        solid_bodies_create(o->n > 0 ? o->n : 1, p->mesh->n_cells, o->rho, &b);
}

static inline void pool_free(struct pool *p)
{
    solid_bodies_free(p->bodies);
    owner_free(p->fluid);
    mesh_free(p->mesh);
}

static inline void pool_run(struct pool *p, int steps)
{
    for (int i = 0; i < steps; i++) {
        ck_assert_int_eq(fluid_step(p->fluid), 0);
        ck_assert_int_eq(body_motion_advance(p->bodies, p->fluid->options.dt),
                         0);
    }
}

/* One sphere in a periodic cube of 1 m, with rho = 1 kg/m^3. */
static inline void pool_one_sphere_by(struct pool *p, double d, int cells,
                                      double mu, double dt, double gradient,
                                      const double x[3],
                                      enum body_motion motion, double density,
                                      const struct body_method *method)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {cells, cells, cells},
                                   .rho = 1.0,
                                   .mu = mu,
                                   .dt = dt,
                                   .gradient = {gradient, 0.0, 0.0},
                                   .method = method,
                                   .time = method == NULL ? "bdf2" : "euler",
                                   .virtual_mass = 2.0};
    const struct body_shape sphere = body_shape_sphere(d);

    pool_create(p, &o);
    solid_bodies_add(p->bodies, &sphere, x, density, motion);
}

static inline void pool_one_sphere(struct pool *p, double d, int cells,
                                   double mu, double dt, double gradient,
                                   const double x[3], enum body_motion motion,
                                   double density)
{
    pool_one_sphere_by(p, d, cells, mu, dt, gradient, x, motion, density, NULL);
}

#endif
