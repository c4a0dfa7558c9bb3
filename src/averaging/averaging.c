/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/averaging.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "averaging/diffusion.h"
#include "averaging/cell_of_particle.h"
#include "averaging/interpolation.h"
#include "averaging/more/kernel_gradient.h"
#include "base/alloc.h"
#include "base/model.h"

struct averaging {
    const struct averaging_method *method;
    struct cell_of_particle *cells;
    void *state;                      /* of the method */
    int fields;                       /* [-] largest number in one call */
    struct averaging_wall *wall;      /* NULL: there is none */
    struct kernel_gradient *gradient; /* NULL: not by a kernel */
    struct averaging_report report;
};

#define AT(member) KEY_AT(averaging_options, member)

const struct key averaging_keys[] = {
    {"averaging", KEY_GROUP, "", "", "",
     "from particles to fields on the mesh and back", "SX15 4-9", "particles",
     .mark = KEY_AFTER_BED, .divided = KEY_DIVIDED_ALL},
    {"averaging.method", KEY_NAME, "", "", NULL,
     "how a particle is spread over the cells",
     "XS11 3.1-3.6, SX15 5, LS section 5.4, EW18 17-21", "", AT(method),
     .models = averaging_methods},
    {"averaging.interpolation", KEY_NAME, "", "", "same",
     "how fields are interpolated to the particles", "XS11 3.9", "",
     AT(interpolation), .models = interpolations},
    {"averaging.gradient_bandwidth", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "the curl of the flow at a particle comes from the derivative of a "
     "Gaussian of this bandwidth; without it, from the gradients in the cells",
     "EW18 B.4-B.10", "effects.saffman|effects.magnus|effects.fluid_torque",
     AT(gradient_bandwidth),
     .divided = "a kernel reaches over the edge of a part"},
    KEY_END};

const struct key averaging_bandwidth_keys[] = {
    {"averaging.bandwidth", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "bandwidth b of kernels and diffusion; of two-grid the width of its cells",
     "SX15 6", "", AT(bandwidth)},
    KEY_END};

const struct key averaging_delta_keys[] = {
    {"averaging.delta_05", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "in place of the bandwidth: width of the Gaussian at half its height",
     "EW18 20", "", AT(delta_05)},
    KEY_END};

double averaging_sigma(double delta_05)
{
    return delta_05 / (2.0 * sqrt(2.0 * log(2.0))); /* [EW18 20] */
}

double averaging_bandwidth(double delta_05)
{
    return sqrt(2.0) * averaging_sigma(delta_05);
}

/* The options with their defaults filled in. */
static struct averaging_options completed(const struct averaging_options *o)
{
    struct averaging_options full = *o;

    if (full.scheme == NULL) full.scheme = diffusion_schemes[0]->name;
    if (full.vary == NULL) full.vary = bandwidth_rules[0]->name;
    if (full.steps == 0) full.steps = 3;
    if (full.tolerance == 0.0) full.tolerance = 1e-6;
    if (full.fields == 0) full.fields = 8;
    return full;
}

const struct averaging_method *
averaging_variant(const struct averaging_method *method,
                  const struct mesh *mesh)
{
    return mesh->shape != NULL && method->polyhedral != NULL
               ? method->polyhedral
               : method;
}

struct averaging *averaging_create(const struct averaging_method *method,
                                   const struct mesh *mesh,
                                   const struct particles *ps,
                                   const struct averaging_options *o)
{
    struct averaging_options full = completed(o);

    if (method->needs_bandwidth && !(full.bandwidth > 0.0)) {
        fprintf(stderr,
                "winnow: the bandwidth of the averaging by %s is %g; "
                "expected a length above 0 [m]\n",
                method->name, full.bandwidth);
        return NULL;
    }
    struct averaging *const a = alloc_zeroed(1, sizeof *a);

    a->method = full.method = averaging_variant(method, mesh);
    a->fields = full.fields;
    a->cells = cell_of_particle_create(mesh, ps);
    if (full.gradient_bandwidth > 0.0)
        a->gradient = kernel_gradient_create(a->cells, full.gradient_bandwidth);
    a->state = a->method->create(a->cells, &full);
    if (a->state != NULL) return a;
    averaging_free(a);
    return NULL;
}

void averaging_free(struct averaging *a)
{
    if (a == NULL) return;
    if (a->state != NULL) a->method->free(a->state);
    kernel_gradient_free(a->gradient);
    owner_free(a->cells);
    free(a);
}

int averaging_bind(struct averaging *a)
{
    struct averaging_report *const r = &a->report;
    const struct particles *const ps = a->cells->ps;

    *r = (struct averaging_report){.worst = {.converged = 1}};
    r->lost = cell_of_particle_find(a->cells);
    if (r->lost > 0) {
        int i = 0;
        while (a->cells->cell[i] >= 0)
            i++;
        r->lost_id = ps->id[i];
        return 1;
    }
    if (a->method->bind != NULL) a->method->bind(a->state, r);
    return 0;
}

/* Extremes of the first of m fields, and the fraction of its integral that is
 * negative. */
static void check_first_field(struct averaging_report *r,
                              const struct mesh *mesh, int m,
                              const double *field)
{
    double below = 0.0, all = 0.0;

    r->lowest = r->highest = field[0];
    for (int c = 0; c < mesh->n_cells; c++) {
        const double f = field[m * c];
        r->lowest = fmin(r->lowest, f);
        r->highest = fmax(r->highest, f);
        all += mesh->V[c] * fabs(f);
        below += mesh->V[c] * fmax(0.0, -f);
    }
    r->negative = all > 0.0 ? below / all : 0.0;
}

void averaging_spread(struct averaging *a, int m, const double *q,
                      double *field)
{
    assert(m >= 1 && m <= a->fields);
    assert(a->report.lost == 0 && a->cells->n == a->cells->ps->n);
    a->method->spread(a->state, m, q, field, &a->report);
    if (a->wall != NULL) a->wall->move_out(a->wall, m, field);
    check_first_field(&a->report, a->cells->mesh, m, field);
}

/* The mean of m fields at each particle, by the weights of the averaging. */
void averaging_gather(struct averaging *a, int m, const double *field,
                      double *q)
{
    assert(m >= 1 && m <= a->fields);
    assert(a->report.lost == 0 && a->cells->n == a->cells->ps->n);
    a->method->gather(a->state, m, averaging_extended(a, m, field), q,
                      &a->report);
}

int averaging_gradient(struct averaging *a, int m, const double *field,
                       double *X)
{
    if (a->gradient == NULL) return 0;
    kernel_gradient_find(a->gradient, m, averaging_extended(a, m, field), X);
    return 1;
}

void averaging_set_wall(struct averaging *a, struct averaging_wall *wall)
{
    a->wall = wall;
}

/* The field with values inside solids in the mesh, where there are any, else
 * itself. */
const double *averaging_extended(struct averaging *a, int m,
                                 const double *field)
{
    return a->wall != NULL ? a->wall->extend(a->wall, m, field) : field;
}

double averaging_capped_fraction(const struct averaging *a, int i)
{
    return a->method->capped_fraction == NULL
               ? 1.0
               : a->method->capped_fraction(a->state, i);
}

void averaging_apply_cap(const struct averaging *a, int m, double *q)
{
    if (a->report.capped == 0) return;
    for (int i = 0; i < a->cells->n; i++)
        for (int k = 0; k < m; k++)
            q[m * i + k] *= averaging_capped_fraction(a, i);
}

const struct cell_of_particle *averaging_cells(const struct averaging *a)
{
    return a->cells;
}

const struct averaging_report *averaging_report(const struct averaging *a)
{
    return &a->report;
}

int averaging_check(const struct averaging_method *method,
                    const struct mesh *mesh, const struct averaging_options *o)
{
    const struct averaging_options full = completed(o);
    return method == &diffusion_method ? diffusion_needed_steps(mesh, &full)
                                       : 0;
}

const struct averaging_method *const averaging_methods[] = {
    &pcm_method,      &dpvm_method,      &dpvm_cube_method,
    &two_grid_method, &kernel_method,    &kernel_gaussian_method,
    &images_method,   &diffusion_method, NULL};

MODEL_NAMED(averaging_method)
