/* SPDX-License-Identifier: GPL-3.0-or-later */
/* momentum_balance.c -- the momentum balance of the fluid.
 *
 * In the sum over all cells the exchange between cells cancels: there remain
 * the boundary faces, the particles, and the momentum relabelled by averaging.
 * The sum is computed from fluxes, pressures and velocities, not from the
 * matrix, so it also detects a coefficient that differs between the two sides
 * of a face.
 */
#include "fluid/systems.h"

#include <math.h>

#include "base/vector.h"
#include "fluid/piso.h"
#include "mesh/measures.h"

struct sum {
    double impulse[3]; /* [N s] */
    double gross;      /* [N s] the sum of their magnitudes */
};

/* Adds an impulse [N s] along k, and its size to the gross sum. */
static void momentum_balance_add(struct sum *s, int k, double impulse)
{
    s->impulse[k] += impulse;
    s->gross += fabs(impulse);
}

/* Adds the contributions of boundary face f: convected momentum, the viscous
 * force of a wall or an inlet, and the pressure unless p_face is NULL. */
static void momentum_balance_add_face(const struct fluid *fl,
                                      const double *p_face,
                                      const struct boundary *b, int j, int f,
                                      struct sum *s)
{
    const double dt = fl->options.dt,
                 flow = fl->options.rho * fl->levels->convecting_flux[f];
    const double *const u = &fl->u[3 * fl->mesh->owner[f]];
    const double D = b->kind == BOUNDARY_OUTLET
                         ? 0.0
                         : fl->options.mu * fl->geometry->face_coefficient[f];
    double edge[3];

    boundary_face_velocity(fl, b, j, f, edge);
    for (int k = 0; k < 3; k++) {
        momentum_balance_add(s, k, -dt * flow * edge[k]);
        momentum_balance_add(s, k, dt * D * (edge[k] - u[k]));
        if (p_face != NULL)
            momentum_balance_add(s, k,
                                 -dt * p_face[f] * mesh_S(fl->mesh, f)[k]);
    }
}

static void momentum_balance_add_boundaries(const struct fluid *fl,
                                            const double *p_face, struct sum *s)
{
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        momentum_balance_add_face(fl, p_face, b, j, f, s);
}

void momentum_balance_of_boundaries(const struct fluid *fl, double impulse[3])
{
    struct sum s = {{0.0, 0.0, 0.0}, 0.0};

    momentum_balance_add_boundaries(fl, NULL, &s);
    for (int k = 0; k < 3; k++)
        impulse[k] = s.impulse[k];
}

/* Adds the drag, and the part of the pressure force that acts on the particles.
 */
static void momentum_balance_add_particles(const struct fluid *fl,
                                           struct sum *s)
{
    const double dt = fl->options.dt;

    for (int c = 0; c < fl->mesh->n_cells; c++)
        for (int k = 0; k < 3; k++) {
            const int i = 3 * c + k;
            const double V = fl->mesh->V[c];
            momentum_balance_add(s, k,
                                 dt * V * (fl->F[i] - fl->K[c] * fl->u[i]));
            momentum_balance_add(
                s, k, dt * V * (1.0 - piso_gamma(fl, c)) * fl->grad_p[i]);
        }
}

/* Adds the mean pressure gradient, which is not part of any face. */
static void add_mean_gradient(const struct fluid *fl, struct sum *s)
{
    for (int k = 0; k < 3; k++) {
        double V = 0.0;
        if (fl->mean_gradient[k] == 0.0) continue;
        for (int c = 0; c < fl->mesh->n_cells; c++)
            V += fl->mesh->V[c];
        momentum_balance_add(s, k, -fl->options.dt * V * fl->mean_gradient[k]);
    }
}

/* Adds the impulse [N s] of the bodies that the mesh resolves. */
static void add_immersed(const struct immersed *bodies, struct sum *s)
{
    for (int k = 0; k < 3; k++)
        s->impulse[k] += bodies->impulse[k];
    s->gross += bodies->gross;
}

/* The sum of the magnitudes of the momenta of all cells [N s]. */
static double cells_gross(const struct fluid *fl)
{
    double gross = 0.0;

    for (int i = 0; i < 3 * fl->mesh->n_cells; i++)
        gross += fl->eps[i / 3] * fl->mesh->V[i / 3] * fabs(fl->u[i]);
    return fl->options.rho * gross;
}

/* The scale of the residual. Where the momenta of the cells cancel and no force
 * acts on the fluid, the residual is the rounding error of their sum, and the
 * scale is the sum of their magnitudes. */
static double scale_of(const struct fluid *fl, double worst, double gross)
{
    if (worst <= 1e-10 * gross) return gross;
    const double cells = cells_gross(fl);
    return gross < 1e-8 * cells ? cells : gross;
}

double momentum_balance_residual(const struct fluid *fl, const double before[3],
                                 const double relabelled[3])
{
    struct sum s = {{0.0, 0.0, 0.0}, 0.0};
    double after[3], worst = 0.0;

    momentum_balance_add_boundaries(fl, fl->p_face, &s);
    add_mean_gradient(fl, &s);
    if (fl->options.coupled) momentum_balance_add_particles(fl, &s);
    if (fl->immersed != NULL) add_immersed(fl->immersed, &s);
    fluid_momentum(fl, after);
    for (int k = 0; k < 3 && !isnan(worst); k++) {
        const double known = fl->impulse_weight * s.impulse[k] +
                             fl->levels->reweighted[k] + fl->relabelled[k] -
                             relabelled[k];
        const double off = fabs(after[k] - before[k] - known);
        if (!(off <= worst)) worst = off; /* NaN is the worst */
        s.gross += fabs(before[k]) + fabs(after[k]);
    }
    return worst == 0.0 ? 0.0 : worst / scale_of(fl, worst, s.gross);
}

/* --- wall stress ---------------------------------------------------------- */

int wall_stress_is_wall(const struct fluid *fl, int patch)
{
    const enum boundary_kind kind = fl->options.boundaries[patch].kind;
    return kind == BOUNDARY_NO_SLIP || kind == BOUNDARY_SLIP;
}

/* At a slip wall only the normal part acts. */
static void viscous_force(const struct fluid *fl, const struct boundary *b,
                          int j, int f, double force[3])
{
    const struct mesh *const m = fl->mesh;
    const double *const S = mesh_S(m, f), *const u = &fl->u[3 * m->owner[f]];
    const double SS = vector_dot(S, S), mu = fl->options.mu;
    const double D = mu * SS / vector_dot(S, mesh_d(m, f));
    double turned[3];

    if (b->kind == BOUNDARY_SLIP) {
        for (int k = 0; k < 3; k++)
            force[k] = D * vector_dot(u, S) * S[k] / SS;
        return;
    }
    vector_cross(b->rotation, S, turned);
    for (int k = 0; k < 3; k++)
        force[k] =
            D * (u[k] - boundary_wall_velocity(b, j)[k]) + mu * turned[k];
}

struct wall_stress wall_stress(const struct fluid *fl, int patch, int j)
{
    const struct mesh *const m = fl->mesh;
    const int f = m->patches[patch].first + j;
    const double *const S = mesh_S(m, f);
    struct wall_stress w = {.area = vector_length(S)};
    double x[3];

    mesh_face_middle(m, f, x);
    const double p =
        fluid_boundary_pressure(fl, f) + vector_dot(fl->mean_gradient, x);
    viscous_force(fl, &fl->options.boundaries[patch], j, f, w.viscous);
    const double normal = vector_dot(w.viscous, S) / (w.area * w.area);
    for (int k = 0; k < 3; k++) {
        w.pressure[k] = p * S[k];
        w.shear[k] = (w.viscous[k] - normal * S[k]) / w.area;
    }
    const double y = vector_dot(mesh_d(m, f), S) / w.area;
    const double rho = fl->options.rho, mu = fl->options.mu;
    if (mu > 0.0) w.y_plus = y * sqrt(vector_length(w.shear) * rho) / mu;
    return w;
}
