/* SPDX-License-Identifier: GPL-3.0-or-later */
/* velocity.c -- the velocity from the momentum equation: predictor, corrector,
 * and the residual of the equation.
 */
#include "fluid/systems.h"

#include <math.h>
#include <stddef.h>

#include "base/parallel_ranges.h"
#include "base/vector.h"
#include "linear/reduce.h"
#include "fluid/piso.h"

/* The remaining part of the wall force, -D n_k (n . u - n_k u_k) at a wall that
 * is not normal to an axis, is explicit, with the present velocity. */
static void add_slip_residual(const struct fluid *fl, double *right)
{
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f) {
        if (b->kind != BOUNDARY_SLIP) continue;
        const int c = fl->mesh->owner[f];
        const double *const S = mesh_S(fl->mesh, f), *const u = &fl->u[3 * c];
        const double Su = vector_dot(S, u);
        const double D = fl->options.mu * fl->geometry->face_coefficient[f];
        for (int k = 0; k < 3; k++)
            right[3 * c + k] -=
                D * S[k] * (Su - S[k] * u[k]) / piso_square(fl, f);
    }
}

/* The end of a block of cells whose data fit into the first-level cache. */
static int velocity_block_end(int first, int last)
{
    return first + VEC3_BLOCK < last ? first + VEC3_BLOCK : last;
}

/* gamma V of the cells of a block, three times each [m^3]. */
static void spread_gamma_volumes(int first, int last, const struct fluid *fl,
                                 double *weight3)
{
    double weight[VEC3_BLOCK];

    for (int c = first; c < last; c++)
        weight[c - first] = piso_gamma(fl, c) * fl->mesh->V[c];
    vec3_spread(last - first, weight, weight3);
}

/* right = to plus the other terms of the right-hand side for a given pressure
 * [N], the old-time terms and -gamma V grad p; for a block of cells. */
static void add_known(int first, int last, const struct fluid *fl,
                      const double *restrict to, double *restrict right)
{
    const double *restrict old = fl->levels->old_time_source + 3L * first;
    const double *restrict grad_p = fl->grad_p + 3L * first;
    double weight[3 * VEC3_BLOCK];

    spread_gamma_volumes(first, last, fl, weight);
    for (int i = 0; i < 3 * (last - first); i++)
        right[i] = to[i] + (old[i] - weight[i] * grad_p[i]);
}

static void known_rows(int first, int last, const struct fluid *fl)
{
    const struct momentum_system *const momentum = fl->momentum;

    for (int end; first < last; first = end) {
        end = velocity_block_end(first, last);
        add_known(first, end, fl, momentum->b + 3L * first,
                  momentum->H + 3L * first);
    }
}

struct solve_report velocity_predict(struct fluid *fl)
{
    struct momentum_system *const momentum = fl->momentum;

    PARALLEL_RANGES(fl->mesh->n_cells, 12, known_rows, fl);
    if (momentum->oblique_slip) add_slip_residual(fl, momentum->H);
    const double tolerance = fl->options.u_tolerance > 0.0
                                 ? fl->options.u_tolerance
                                 : fl->options.tolerance;

    if (fl->options.shared != NULL)
        return fl->options.shared->momentum(fl->options.shared->parts, fl,
                                            tolerance);
    return bicgstab_solve(momentum->matrix, momentum_diagonal(momentum),
                          momentum->H, fl->u, tolerance, 1e-300, 200,
                          momentum->bicgstab);
}

/* H = b - slip u - sum a_N u_N after the predictor: the sum follows from the
 * right-hand side, the diagonal and the residual of the solver. */
static void predicted_rows(int first, int last, const struct fluid *fl,
                           const double *residual)
{
    const struct momentum_system *const momentum = fl->momentum;

    for (int end; first < last; first = end) {
        const long at = 3L * first;
        const double *restrict b = momentum->b + at;
        const double *restrict u = fl->u + at, *restrict r = residual + at;
        double *restrict H = momentum->H + at, diag[3 * VEC3_BLOCK];
        end = velocity_block_end(first, last);
        vec3_spread(end - first, momentum->diag + first, diag);
        for (int i = 0; i < 3 * (end - first); i++)
            H[i] = b[i] - H[i] + r[i] + diag[i] * u[i];
    }
}

void velocity_predicted_sum(struct fluid *fl)
{
    struct momentum_system *const momentum = fl->momentum;

    if (fl->options.shared != NULL) { /* whose solvers leave no residual */
        velocity_neighbour_sum(fl);
        return;
    }

    PARALLEL_RANGES(fl->mesh->n_cells, 12, predicted_rows, fl,
                    bicgstab_residual(momentum->bicgstab));
    if (momentum->oblique_slip) add_slip_residual(fl, momentum->H);
}

/* H = b - slip u - sum a_N u_N */
static void neighbour_rows(int first, int last, const struct fluid *fl)
{
    const struct momentum_system *const momentum = fl->momentum;
    const double *restrict b = momentum->b, *restrict u = fl->u;
    double *restrict H = momentum->H;

    ldu_rows(first, last, momentum->matrix, NULL, u, H);
    for (int i = 3 * first; i < 3 * last; i++)
        H[i] = b[i] - H[i];
    for (int end; first < last && momentum->diag3 != NULL; first = end) {
        const double *restrict diag3 = momentum->diag3;
        double diag[3 * VEC3_BLOCK];
        end = velocity_block_end(first, last);
        vec3_spread(end - first, momentum->diag + first, diag);
        for (int i = 3 * first; i < 3 * end; i++)
            H[i] -= (diag3[i] - diag[i - 3 * first]) * u[i];
    }
}

/* H [N] of (6.2): known terms less what the neighbours' velocities
 * contribute. */
void velocity_neighbour_sum(struct fluid *fl)
{
    struct momentum_system *const momentum = fl->momentum;

    PARALLEL_BLOCKS(fl->mesh->n_cells, 12, neighbour_rows, fl);
    if (momentum->oblique_slip) add_slip_residual(fl, momentum->H);
}

/* H contains the force of the slip walls with the old velocity. Where viscous
 * diffusion crosses the cell within a step this would be unstable from one
 * corrector to the next, and the force is implicit in the new velocity: added
 * to both sides for a block of cells, the right and the diagonal a. */
static void add_stiff_slip(int first, int last, const struct fluid *fl,
                           double *restrict right, double *restrict a)
{
    const double *restrict diag3 = fl->momentum->diag3 + 3L * first;
    const double *restrict u = fl->u + 3L * first;
    double ddt[3 * VEC3_BLOCK];

    vec3_spread(last - first, fl->levels->ddt + first, ddt);
    for (int i = 0; i < 3 * (last - first); i++) {
        const double slip = diag3[i] - a[i];
        const double stiff = slip > 0.25 * ddt[i] ? slip : 0.0;
        right[i] += stiff * u[i];
        a[i] += stiff;
    }
}

static void correct_rows(int first, int last, struct fluid *fl)
{
    const struct momentum_system *const momentum = fl->momentum;

    for (int end; first < last; first = end) {
        const long at = 3L * first;
        double *restrict u = fl->u + at;
        double right[3 * VEC3_BLOCK], a[3 * VEC3_BLOCK];
        end = velocity_block_end(first, last);
        const int n = 3 * (end - first);
        add_known(first, end, fl, momentum->H + at, right);
        vec3_spread(end - first, momentum->diag + first, a);
        if (momentum->diag3 != NULL) add_stiff_slip(first, end, fl, right, a);
        for (int i = 0; i < n; i++)
            u[i] = right[i] / a[i];
    }
}

void velocity_correct(struct fluid *fl)
{
    PARALLEL_RANGES(fl->mesh->n_cells, 12, correct_rows, fl);
}

/* The largest residual, term and inertia, rho eps V du/dt, of each range. */
struct extremes {
    double worst, largest, inertia; /* [N] */
};

/* The coefficient of the new velocity in the inertia, three times each. */
static void spread_rates(int first, int last, const struct time_levels *l,
                         double *rate3)
{
    double rate[VEC3_BLOCK];

    for (int c = first; c < last; c++)
        rate[c - first] =
            l->ddt[c] + (l->ddt_older != NULL ? l->ddt_older[c] : 0.0);
    vec3_spread(last - first, rate, rate3);
}

static double velocity_larger(double a, double b)
{
    return b > a ? b : a;
}

static void velocity_residual_rows(int first, int last, struct fluid *fl,
                                   struct extremes *extremes)
{
    struct momentum_system *const momentum = fl->momentum;
    const int partial = parallel_ranges_of(fl->mesh->n_cells, first);
    struct extremes r = extremes[partial];

    if (!momentum->oblique_slip) neighbour_rows(first, last, fl);
    for (int end; first < last; first = end) {
        const long at = 3L * first;
        const double *restrict u = fl->u + at;
        double *restrict residual = momentum->residual + at;
        const double *restrict old = fl->levels->old_time_source + at;
        double right[3 * VEC3_BLOCK], a[3 * VEC3_BLOCK], rate[3 * VEC3_BLOCK];
        end = velocity_block_end(first, last);
        add_known(first, end, fl, momentum->H + at, right);
        vec3_spread(end - first, momentum->diag + first, a);
        spread_rates(first, end, fl->levels, rate);
        for (int i = 0; i < 3 * (end - first); i++) {
            residual[i] = right[i] - a[i] * u[i];
            r.worst = velocity_larger(r.worst, fabs(residual[i]));
            r.largest = velocity_larger(r.largest, fabs(a[i] * u[i]));
            r.inertia =
                velocity_larger(r.inertia, fabs(rate[i] * u[i] - old[i]));
        }
    }
    extremes[partial] = r;
}

/* Sets H as well, in the same pass where the walls add nothing to it. */
double velocity_residual(struct fluid *fl)
{
    const int n = fl->mesh->n_cells;
    struct extremes extremes[PARALLEL_RANGES_COUNT] = {{0.0, 0.0, 0.0}},
                    all = {0.0, 0.0, 0.0};

    if (fl->momentum->oblique_slip) velocity_neighbour_sum(fl);
    PARALLEL_BLOCKS(n, 12, velocity_residual_rows, fl, extremes);
    for (int s = 0; s < PARALLEL_RANGES_COUNT; s++) {
        all.worst = fmax(all.worst, extremes[s].worst);
        all.largest = fmax(all.largest, extremes[s].largest);
        all.inertia = fmax(all.inertia, extremes[s].inertia);
    }
    fl->momentum->inertia = all.inertia;
    if (fl->options.shared != NULL)
        return fl->options.shared->residual(fl->options.shared->parts, fl);
    if (fl->immersed != NULL && fl->immersed->largest_term != NULL)
        all.largest = fl->immersed->largest_term(fl->immersed, fl);
    if (all.largest == 0.0) return 0.0;
    fl->momentum->inertia /= all.largest;
    return all.worst / all.largest;
}
