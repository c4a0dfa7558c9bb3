/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/reaction.h"
#include "coupling/transfer.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/parallel_ranges.h"
#include "coupling/coupling.h"
#include "coupling/processes.h"

/* Sets eps and eps_us from m fields, of which the first is eps_s and the
 * others, if there are any, are eps_s u_s. */
static void take_solids(struct simulation *sim, int m)
{
    struct fluid *const fl = sim->fluid;
    const double *const field = sim->coupling->field;
    double lowest = 1.0;

    for (int c = 0; c < sim->mesh->n_cells; c++) {
        fl->eps[c] = 1.0 - field[m * c];
        lowest = fl->eps[c] < lowest ? fl->eps[c] : lowest;
        for (int k = 0; k < m - 1; k++)
            fl->eps_us[3 * c + k] = field[m * c + 1 + k];
    }
    sim->coupling->report.eps_lowest = lowest;
}

/* Continuity of the mixture contains eps_s u_s; the void-rate form does not,
 * and its steps average these fields less [SX15 section 3.4]. */
int reaction_average(struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    struct coupling *const cp = sim->coupling;
    const int m = sim->fluid->options.continuity == CONTINUITY_MIXTURE ? 4 : 1;

#pragma omp parallel for schedule(static) if (ps->n >= TRANSFER_MANY)
    for (int i = 0; i < ps->n; i++) {
        const double V = particles_volume(ps, i);
        cp->amount[m * i] = V;
        if (m == 1) continue;
        cp->amount[4 * i + 1] = V * ps->vx[i];
        cp->amount[4 * i + 2] = V * ps->vy[i];
        cp->amount[4 * i + 3] = V * ps->vz[i];
    }
    averaging_apply_cap(sim->averaging, m, cp->amount);
    averaging_spread(sim->averaging, m, cp->amount, cp->field);
    take_solids(sim, m);
    cp->options.interpolation->apply(sim->averaging, 1, sim->fluid->eps, NULL,
                                     cp->eps);
    double lowest = 1.0;
#pragma omp simd reduction(min : lowest)
    for (int i = 0; i < ps->n; i++)
        lowest = cp->eps[i] < lowest ? cp->eps[i] : lowest;
    cp->report.eps_lowest =
        shared_smallest(sim->fluid->options.shared, cp->report.eps_lowest);
    cp->report.lowest_interpolated =
        shared_smallest(sim->fluid->options.shared, lowest);
    return cp->report.eps_lowest <= 0.0 ||
           cp->report.lowest_interpolated <= 0.0;
}

/* The terms of each particle in the next step of the fluid: a coefficient of
 * the velocity and a force. */
static void estimate_drag_impulse(struct simulation *sim)
{
    const int n = sim->particles->n;
    struct coupling *const cp = sim->coupling;
    const int implicit = cp->options.treatment == TREATMENT_SEMI_IMPLICIT;

#pragma omp parallel for schedule(static) if (n >= TRANSFER_MANY)
    for (int i = 0; i < n; i++) {
        cp->k[i] = implicit ? cp->rate[i] : 0.0;
        cp->amount[4 * i] = cp->k[i];
        for (int a = 0; a < 3; a++)
            cp->amount[4 * i + 1 + a] = cp->k[i] * cp->u_mean[3 * i + a] -
                                        cp->unpaid_impulse[3 * i + a] / sim->dt;
    }
}

/* The share s [-] of an added mass C [-] that the fluid is charged in
 * advance (20.11). */
double reaction_share_in_advance(double C, double ratio, double eps_s)
{
    const double q = eps_s / (1.0 - eps_s);
    /* (20.11): a s^2 + b s + c = 0 */
    const double a = q * C * q * C;
    const double b = 2.0 * C * (q * (1.0 + 2.0 * C) + 2.0 * (ratio + C));
    const double c = (1.0 + 2.0 * C) * (1.0 + 2.0 * C) - 4.0 * (ratio + C) * C;

    return c < 0.0 ? -2.0 * c / (b + sqrt(b * b - 4.0 * a * c)) : 0.0;
}

/* The part [kg] of the inertia of effects beside the drag
 * (effects/effect_force.h) that the fluid receives in advance, by (20.11). */
static double inertia_in_advance(const struct simulation *sim, int i)
{
    const struct coupling *const cp = sim->coupling;
    const double m_f =
        sim->fluid->options.rho * particles_volume(sim->particles, i);
    const double eps_s = fmin(fmax(1.0 - cp->eps[i], 0.0), 0.9);

    return cp->inertia[i] *
           reaction_share_in_advance(cp->inertia[i] / m_f,
                                     sim->particles->m[i] / m_f, eps_s);
}

static void add_inertia(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;

    for (int i = 0; i < sim->particles->n; i++) {
        const double k = inertia_in_advance(sim, i) / sim->dt;
        cp->amount[4 * i] += k;
        for (int a = 0; a < 3; a++)
            cp->amount[4 * i + 1 + a] += k * cp->u_before[3 * i + a];
    }
}

/* [XS11 3.15]: K = eps rho Omega, F = eps rho A, including the unpaid impulse.
 */
static void take_drag_terms(struct simulation *sim)
{
    struct fluid *const fl = sim->fluid;
    const double *const field = sim->coupling->field;
    const double *const g = sim->gravity;
    const double rho = fl->options.pressure_shared ? 0.0 : fl->options.rho;

    for (int c = 0; c < sim->mesh->n_cells; c++) {
        fl->K[c] = field[4 * c];
        for (int k = 0; k < 3; k++) /* the whole weight that the hydrostatic
                                       pressure balances, eps rho g */
            fl->F[3 * c + k] =
                field[4 * c + 1 + k] - (1.0 - fl->eps[c]) * rho * g[k];
    }
}

void reaction_drag_terms(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;
    const struct replacement *const removed = cp->replacement;

    estimate_drag_impulse(sim);
    if (cp->inertia != NULL) add_inertia(sim);
    averaging_spread(sim->averaging, 4, cp->amount, cp->field);
    for (int j = 0; removed != NULL && j < 3 * sim->mesh->n_cells; j++)
        cp->field[4 * (j / 3) + 1 + j % 3] -=
            removed->unpaid_impulse[j] / sim->dt;
    take_drag_terms(sim);
}

/* Compares the impulse that the fluid lost to K and F with the sum over the
 * particles. They are equal to rounding if gathering is the adjoint of
 * spreading. */
static void check_exchange(struct simulation *sim, const double expected[3],
                           double scale)
{
    const struct fluid *const fl = sim->fluid;
    const double *const field = sim->coupling->field;
    const double *const V =
        sim->processes != NULL ? sim->processes->V : sim->mesh->V;
    double sum[4] = {0.0, 0.0, 0.0, scale}, off = 0.0;

    for (int k = 0; k < 3; k++) {
        double received = 0.0;
        for (int c = 0; c < sim->mesh->n_cells; c++)
            received +=
                V[c] * sim->dt *
                (field[4 * c] * fl->u[3 * c + k] - field[4 * c + 1 + k]);
        sum[k] = received - expected[k];
    }
    processes_sum(sim, 4, sum);
    for (int k = 0; k < 3; k++)
        off = fmax(off, fabs(sum[k]));
    sim->coupling->report.exchange_residual = sum[3] > 0.0 ? off / sum[3] : 0.0;
}

/* The fluid has received the unpaid impulse of removed particles. */
static void add_removed(struct replacement *r, int n_cells, double expected[3],
                        double *scale)
{
    for (int k = 0; k < 3; k++) {
        expected[k] += r->unpaid_sum[k];
        *scale += fabs(r->unpaid_sum[k]);
        r->unpaid_sum[k] = 0.0;
    }
    memset(r->unpaid_impulse, 0,
           3 * (size_t)n_cells * sizeof *r->unpaid_impulse);
}

/* The same for the part of the inertia of effects that the fluid received. */
static void subtract_inertia(struct simulation *sim, double expected[3],
                             double *scale)
{
    struct coupling *const cp = sim->coupling;

    for (int i = 0; i < sim->particles->n; i++) {
        const double m = inertia_in_advance(sim, i);
        for (int a = 0; a < 3; a++) {
            const int j = 3 * i + a;
            const double estimate = m * (cp->smooth[j] - cp->u_before[j]);
            expected[a] += estimate;
            *scale += fabs(estimate);
            cp->unpaid_impulse[j] -= estimate;
        }
        cp->inertia[i] = 0.0;
    }
}

/* What the fluid received for each particle of a range is added to `sums`,
 * three components and the absolute values. */
static void subtract_range(int first, int last, struct simulation *sim,
                           double (*sums)[4])
{
    struct coupling *const cp = sim->coupling;
    const double more = sim->fluid->impulse_weight - 1.0;
    double *const sum = sums[parallel_ranges_of(sim->particles->n, first)];

    for (int i = first; i < last; i++)
        for (int k = 0; k < 3; k++) {
            const int j = 3 * i + k;
            const double estimate =
                sim->dt * cp->k[i] * (cp->smooth[j] - cp->u_mean[j]);
            sum[k] += estimate + cp->unpaid_impulse[j];
            sum[3] += fabs(estimate) + fabs(cp->unpaid_impulse[j]);
            cp->unpaid_impulse[j] =
                -estimate - more * (estimate + cp->unpaid_impulse[j]);
        }
}

/* The fluid received dt (k (u^new - u_mean) + unpaid_impulse / dt) for a
 * particle, with u^new interpolated by the adjoint of the averaging; and in the
 * first step of BDF2 it is to receive half of that once more. */
static void subtract_received(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;
    double expected[3] = {0.0, 0.0, 0.0}, scale = 0.0;
    double sums[PARALLEL_RANGES_COUNT][4] = {{0.0}};

    PARALLEL_RANGES(sim->particles->n, 12, subtract_range, sim, sums);
    for (int s = 0; s < PARALLEL_RANGES_COUNT; s++) {
        for (int k = 0; k < 3; k++)
            expected[k] += sums[s][k];
        scale += sums[s][3];
    }
    if (cp->inertia != NULL) subtract_inertia(sim, expected, &scale);
    if (cp->replacement != NULL)
        add_removed(cp->replacement, sim->mesh->n_cells, expected, &scale);
    check_exchange(sim, expected, scale);
}

void reaction_receive(struct simulation *sim)
{
    averaging_gather(sim->averaging, 3, sim->fluid->u, sim->coupling->smooth);
    if (sim->fluid->t > 0.0) subtract_received(sim);
}
