/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/fluid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "base/vector.h"
#include "linear/reduce.h"
#include "fluid/momentum_system.h"
#include "fluid/piso.h"
#include "fluid/time_levels.h"

struct fluid *fluid_create(const struct mesh *mesh,
                           const struct fluid_options *options)
{
    struct fluid *const fl = alloc_zeroed(1, sizeof *fl);

    fl->mesh = mesh;
    fl->options = *options;
    memcpy(fl->mean_gradient, options->mean_gradient, sizeof fl->mean_gradient);
    systems_create(fl);
    for (int c = 0; c < mesh->n_cells; c++)
        fl->eps[c] = fl->eps_n[c] = fl->eps_nm1[c] = 1.0;
    return fl;
}

void fluid_free(struct fluid *fl)
{
    if (fl == NULL) return;
    systems_free(fl);
    free(fl);
}

void fluid_reset_eps_history(struct fluid *fl)
{
    const size_t size = (size_t)fl->mesh->n_cells * sizeof *fl->eps;
    memcpy(fl->eps_n, fl->eps, size);
    memcpy(fl->eps_nm1, fl->eps, size);
}

/* Sums over a range of cells of the momentum and of the residual force that is
 * added to the next step [N s], [N]. */
struct momentum_sums {
    double momentum[3], residual[3];
};

static void fluid_add_momentum(int first, int last, const struct fluid *fl,
                               const double *eps, struct momentum_sums *partial)
{
    struct momentum_sums *const s =
        &partial[parallel_ranges_of(fl->mesh->n_cells, first)];
    double mass[VEC3_BLOCK], one[VEC3_BLOCK];

    for (int i = 0; i < VEC3_BLOCK; i++)
        one[i] = 1.0;
    for (int n; first < last; first += n) {
        n = last - first < VEC3_BLOCK ? last - first : VEC3_BLOCK;
        for (int i = 0; i < n; i++)
            mass[i] = fl->options.rho * eps[first + i] * fl->mesh->V[first + i];
        vec3_sum(n, mass, fl->u + 3L * first, s->momentum);
        vec3_sum(n, one, fl->momentum->residual + 3L * first, s->residual);
    }
}

void fluid_momentum(const struct fluid *fl, double momentum[3])
{
    const double *const eps =
        ddt_uses_new_time(&fl->options) ? fl->eps_n : fl->eps_nm1;
    const double dt =
        fl->dt_older; /* the residual is a force during the last step */
    struct momentum_sums partial[PARALLEL_RANGES_COUNT] = {{{0.0}, {0.0}}};

    PARALLEL_RANGES(fl->mesh->n_cells, 8, fluid_add_momentum, fl, eps, partial);
    for (int k = 0; k < 3; k++) {
        momentum[k] = ddt_pending(fl) * fl->momentum_gained[k];
        for (int s = 0; s < PARALLEL_RANGES_COUNT; s++)
            momentum[k] += partial[s].momentum[k] + dt * partial[s].residual[k];
    }
}

void fluid_mean_flow(const struct fluid *fl, double flow[3])
{
    const struct mesh *const m = fl->mesh;
    double V = 0.0;

    flow[0] = flow[1] = flow[2] = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        V += m->V[c];
        for (int k = 0; k < 3; k++)
            flow[k] += fl->eps[c] * m->V[c] * fl->u[3 * c + k];
    }
    for (int k = 0; k < 3; k++)
        flow[k] /= V;
}

double fluid_kinetic_energy(const struct fluid *fl)
{
    double sum = 0.0;

    for (int c = 0; c < fl->mesh->n_cells; c++) {
        const double *const u = &fl->u[3 * c];
        sum += fl->eps[c] * fl->mesh->V[c] * vector_dot(u, u);
    }
    return 0.5 * fl->options.rho * sum;
}

double fluid_patch_pressure(const struct fluid *fl, const struct patch *patch)
{
    double force = 0.0, surface = 0.0;

    for (int f = patch->first; f < patch->first + patch->n; f++) {
        const double area = vector_length(&fl->mesh->S[3 * f]);
        force += area * fl->p_face[f];
        surface += area;
    }
    return surface > 0.0 ? force / surface : 0.0;
}
