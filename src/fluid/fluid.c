/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/fluid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "base/vector.h"
#include "fluid/face_jump.h"
#include "fluid/systems.h"
#include "fluid/piso.h"
#include "linear/faces.h"
#include "linear/reduce.h"

struct fluid *fluid_create(const struct mesh *mesh,
                           const struct fluid_options *options)
{
    struct fluid *const fl = owner_create(sizeof *fl);

    fl->mesh = mesh;
    fl->options = *options;
    memcpy(fl->mean_gradient, options->mean_gradient, sizeof fl->mean_gradient);
    systems_create(fl);
    for (int c = 0; c < mesh->n_cells; c++)
        fl->eps[c] = fl->eps_n[c] = fl->eps_nm1[c] = 1.0;
    return fl;
}

void fluid_reset_eps_history(struct fluid *fl)
{
    const size_t size = (size_t)fl->mesh->n_cells * sizeof *fl->eps;

    if (!fl->options.coupled) return;
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

double fluid_boundary_pressure(const struct fluid *fl, int f)
{
    return f < fl->faces->n ? fl->p_face[f] : fl->p[fl->mesh->owner[f]];
}

double fluid_patch_pressure(const struct fluid *fl, const struct patch *patch)
{
    double force = 0.0, surface = 0.0;

    for (int f = patch->first; f < patch->first + patch->n; f++) {
        const double area = vector_length(mesh_S(fl->mesh, f));
        force += area * fluid_boundary_pressure(fl, f);
        surface += area;
    }
    return surface > 0.0 ? force / surface : 0.0;
}

/* What a checkpoint has of the fluid.  Chapter "Nothing is
 * lost".
 *
 * These are all fields of the last time levels; the matrices and the terms of a
 * step follow from them (systems.c lists all arrays). */

static void cells_state(struct fluid *fl, struct state *s)
{
    const int n = fl->mesh->n_cells;
    const int old = fl->options.coupled ? n : 0; /* else they are in eps */

    state_reals(s, "u", "m/s", fl->u, n, 3);
    state_reals(s, "u_older", "m/s", fl->u_older, n, 3);
    state_reals(s, "p", "Pa", fl->p, n, 1);
    state_reals(s, "grad_p", "Pa/m", fl->grad_p, n, 3);
    state_reals(s, "eps", "-", fl->eps, n, 1);
    state_reals(s, "eps_n", "-", fl->eps_n, old, 1);
    state_reals(s, "eps_nm1", "-", fl->eps_nm1, old, 1);
    state_reals(s, "F", "N/m^3", fl->F, n, 3);
    state_reals(s, "K", "kg/(m^3 s)", fl->K, n, 1);
    state_reals(s, "eps_us", "m/s", fl->eps_us, n, 3);
    state_reals(s, "residual", "N", fl->momentum->residual, n, 3);
    state_reals(s, "smooth_force", "N/m^3", fl->jump->smooth_force, n, 3);
}

static void faces_state(struct fluid *fl, struct state *s)
{
    const int n = fl->mesh->n_faces, inner = fl->mesh->n_internal;

    state_reals(s, "p_face", "Pa", fl->p_face + inner, n - inner, 1);
    state_reals(s, "phi", "m^3/s", fl->phi, n, 1);
    state_reals(s, "phi_older", "m^3/s", fl->phi_older, n, 1);
}

static void fluid_state_sums(struct fluid *fl, struct state *s)
{
    state_reals(s, "mean_gradient", "Pa/m", fl->mean_gradient, 3, 1);
    state_reals(s, "momentum_gained", "N s", fl->momentum_gained, 3, 1);
    state_reals(s, "relabelled", "N s", fl->relabelled, 3, 1);
    state_real(s, "replaced", "kg", &fl->replaced);
    state_reals(s, "replaced_momentum", "N s", fl->replaced_momentum, 3, 1);
}

void fluid_state(struct fluid *fl, struct state *s)
{
    state_begin(s, "fluid");
    state_real(s, "t", "s", &fl->t);
    state_real(s, "dt_older", "s", &fl->dt_older);
    cells_state(fl, s);
    faces_state(fl, s);
    fluid_state_sums(fl, s);
    state_end(s);
}

/* The keys of the group `fluid`, and the members of struct
 * fluid_options that they fill. */

#define AT(member) KEY_AT(fluid_options, member)

const struct key fluid_keys[] = {
    {"fluid", KEY_GROUP, "", "", "", "the fluid; left out: particles alone",
     "XS11 2.7, 2.8", "", .mark = KEY_AFTER_BED, .divided = KEY_DIVIDED_ALL},
    {"fluid.density", KEY_REAL, "kg/m^3", "> 0", NULL,
     "density of the fluid, rho_f", "XS11 2.8", "", AT(rho)},
    {"fluid.viscosity", KEY_REAL, "Pa s", ">= 0", NULL, "dynamic viscosity, mu",
     "XS11 2.8", "", AT(mu)},
    {"fluid.step", KEY_REAL, "s", "> 0", NULL,
     "time step of the fluid and of the coupling", "XS11 Algorithm 3.1", "",
     AT(dt)},
    {"fluid.time", KEY_NAME, "", "", "euler",
     "time scheme: implicit Euler or second-order implicit", "XS11, SX15", "",
     AT(time), .models = time_schemes},
    {"fluid.convection", KEY_NAME, "", "", "upwind", "convection scheme",
     "XS11 2.8", "", AT(convection), .models = convection_schemes},
    {"fluid.continuity", KEY_NAME, "", "", "mixture",
     "form of the mass balance", "XS11 2.3, 2.7", "", AT(continuity),
     .choices = fluid_continuity_forms},
    {"fluid.correctors", KEY_INT, "-", ">= 1, <= 20", "2",
     "pressure corrections in a step (PISO), at least", "XS11 Algorithm 3.1",
     "", AT(correctors)},
    {"fluid.piso_tolerance", KEY_REAL, "-", ">= 0", "1e-3",
     "further corrections until the relative splitting error of the momentum "
     "is below this, and small beside the inertia; 0: none",
     "", "", AT(piso_tolerance)},
    {"fluid.outer_correctors", KEY_INT, "-", ">= 0, <= 20", "0",
     "outer iterations: how often a step is repeated with its new velocity", "",
     "", AT(outer_correctors)},
    {"fluid.u_tolerance", KEY_REAL, "-", ">= 0, < 1", "0.0",
     "residual of the predicted velocity; 0: fluid.tolerance", "", "",
     AT(u_tolerance)},
    {"fluid.p_relative_tolerance", KEY_REAL, "-", ">= 0, < 1", "0.0",
     "relative residual at which all corrections but the last stop", "", "",
     AT(p_relative_tolerance)},
    {"fluid.cfl", KEY_REAL, "-", "> 0", "",
     "largest Courant number; where fluid.step has a larger one it is divided",
     "LS 5.9, 5.10", "", AT(cfl)},
    {"fluid.mean_gradient", KEY_VECTOR, "Pa/m", "", "",
     "mean gradient of the pressure in periodic directions", "", "",
     AT(mean_gradient), KEY_GIVEN(fluid_options, has_mean_gradient)},
    {"fluid.mean_flow", KEY_VECTOR, "m/s", "", "",
     "mean superficial velocity that is kept in periodic directions", "", "",
     AT(mean_flow), KEY_GIVEN(fluid_options, has_mean_flow)},
    {"fluid.tolerance", KEY_REAL, "-", ">= 1e-15, < 1", "1e-8",
     "relative residual of the linear solvers", "", "", AT(tolerance)},
    {"fluid.<patch>", KEY_PATCH, "", "", "",
     "a side of the box: left right (x), bottom top (y), back front (z), or "
     "two at once: sides, bottom_top, front_back; or a patch of the mesh",
     "XS11 2.8", ""},
    KEY_END};
