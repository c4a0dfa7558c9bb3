/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "exchange/transfer.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "exchange/coupling.h"
#include "exchange/replacement.h"

enum { MANY = 1000 }; /* particles from which on a second thread pays */

static double volume(const struct particles *ps, int i)
{
    return M_PI / 6.0 * ps->d[i] * ps->d[i] * ps->d[i];
}

static double slip_speed(const struct simulation *sim, int i)
{
    const struct particles *const ps = sim->particles;
    const double *const u = &sim->coupling->u_f[3 * i];
    const double x = u[0] - ps->vx[i], y = u[1] - ps->vy[i],
                 z = u[2] - ps->vz[i];
    return sqrt(x * x + y * y + z * z);
}

/* k_i = eps_f B_i = V_p beta / eps_s [XS11 2.9-2.11], [kg/s]. */
static double drag_rate(const struct simulation *sim, int i)
{
    const struct fluid_options *const o = &sim->fluid->options;
    const struct particles *const ps = sim->particles;
    return volume(ps, i) * sim->coupling->options.law->resistance(
                               sim->coupling->eps[i], o->rho, o->mu, ps->d[i],
                               slip_speed(sim, i));
}

/* From m fields a cell, of which the first is eps_s and the next, if there are
 * any, are eps_s u_s. */
static void take_solids(struct simulation *sim, int m)
{
    struct fluid *const fl = sim->fluid;
    struct coupling_report *const report = &sim->coupling->report;
    const double *const field = sim->coupling->field;

    report->eps_lowest = 1.0;
    for (int c = 0; c < sim->mesh->n_cells; c++) {
        fl->eps[c] = 1.0 - field[m * c];
        report->eps_lowest = fmin(report->eps_lowest, fl->eps[c]);
        for (int k = 0; k < m - 1; k++)
            fl->eps_us[3 * c + k] = field[m * c + 1 + k];
    }
}

/* Continuity of the mixture has eps_s u_s in it; the void-rate form has not,
 * and its steps do with that many fields less [SX15 section 3.4]. */
static int needs_velocity(const struct simulation *sim)
{
    return sim->fluid->options.continuity == CONTINUITY_MIXTURE;
}

void transfer_solids_velocity(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    struct coupling *const cp = sim->coupling;

    if (cp == NULL || !cp->options.two_way || needs_velocity(sim)) return;
    for (int i = 0; i < ps->n; i++) {
        const double V = volume(ps, i);
        cp->smooth[3 * i] = V * ps->vx[i]; /* not in use between two steps */
        cp->smooth[3 * i + 1] = V * ps->vy[i];
        cp->smooth[3 * i + 2] = V * ps->vz[i];
    }
    averaging_leave_out(sim->averaging, 3, cp->smooth);
    averaging_spread(sim->averaging, 3, cp->smooth, sim->fluid->eps_us);
}

int transfer_average(struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    struct coupling *const cp = sim->coupling;

    if (averaging_bind(sim->averaging) != 0) return 1;
    if (!cp->options.two_way) { /* one particle alone in undisturbed fluid */
        for (int i = 0; i < ps->n; i++)
            cp->eps[i] = 1.0;
        return 0;
    }
    const int m = needs_velocity(sim) ? 4 : 1;
#pragma omp parallel for schedule(static) if (ps->n >= MANY)
    for (int i = 0; i < ps->n; i++) {
        const double V = volume(ps, i);
        cp->amount[m * i] = V;
        if (m == 1) continue;
        cp->amount[4 * i + 1] = V * ps->vx[i];
        cp->amount[4 * i + 2] = V * ps->vy[i];
        cp->amount[4 * i + 3] = V * ps->vz[i];
    }
    averaging_leave_out(sim->averaging, m, cp->amount);
    averaging_spread(sim->averaging, m, cp->amount, cp->field);
    take_solids(sim, m);
    cp->options.interpolation->apply(sim->averaging, 1, sim->fluid->eps, NULL,
                                     cp->eps);
    cp->report.seen_lowest = 1.0;
    for (int i = 0; i < ps->n; i++)
        cp->report.seen_lowest = fmin(cp->report.seen_lowest, cp->eps[i]);
    return cp->report.eps_lowest <= 0.0 || cp->report.seen_lowest <= 0.0;
}

/* What the fluid is charged with in its next step, for each particle: a rate
 * per velocity and a force. */
static void charge_particles(struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    struct coupling *const cp = sim->coupling;
    const int implicit = cp->options.treatment == TREATMENT_SEMI_IMPLICIT;
    double shortest = INFINITY;

#pragma omp parallel for schedule(static)                                      \
    reduction(min                                                              \
              : shortest) if (ps->n >= MANY)
    for (int i = 0; i < ps->n; i++) {
        const double k = drag_rate(sim, i);
        shortest = fmin(shortest, ps->m[i] / k); /* tau_p [XS11 3.16] */
        cp->k[i] = implicit ? k : 0.0;
        cp->amount[4 * i] = cp->k[i];
        for (int a = 0; a < 3; a++)
            cp->amount[4 * i + 1 + a] = cp->k[i] * cp->u_mean[3 * i + a] -
                                        cp->owed[3 * i + a] / sim->dt;
    }
    cp->report.shortest_time = shortest;
}

/* [XS11 3.15]: K = eps rho Omega, F = eps rho A, both with what is owed. */
static void take_drag_terms(struct simulation *sim)
{
    struct fluid *const fl = sim->fluid;
    const double *const field = sim->coupling->field;
    const double *const g = sim->gravity;
    const double rho = fl->options.pressure_shared ? 0.0 : fl->options.rho;

    for (int c = 0; c < sim->mesh->n_cells; c++) {
        fl->K[c] = field[4 * c];
        for (int k = 0; k < 3; k++) /* all of the weight of p_h, eps rho g */
            fl->F[3 * c + k] =
                field[4 * c + 1 + k] - (1.0 - fl->eps[c]) * rho * g[k];
    }
}

void transfer_drag_terms(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;

    charge_particles(sim);
    if (!cp->options.two_way) return;
    averaging_spread(sim->averaging, 4, cp->amount, cp->field);
    replacement_charge(cp->replacement, sim->mesh->n_cells, sim->dt, cp->field);
    take_drag_terms(sim);
}

/* Compares the impulse that the fluid lost to K and F with the sum of what
 * the particles were charged. Equal to rounding if gathering is the adjoint of
 * spreading. */
static void check_payment(struct simulation *sim, const double charged[3],
                          double scale)
{
    const struct fluid *const fl = sim->fluid;
    const double *const field = sim->coupling->field;
    double off = 0.0;

    for (int k = 0; k < 3; k++) {
        double paid = 0.0;
        for (int c = 0; c < sim->mesh->n_cells; c++)
            paid += sim->mesh->V[c] * sim->dt *
                    (field[4 * c] * fl->u[3 * c + k] - field[4 * c + 1 + k]);
        off = fmax(off, fabs(paid - charged[k]));
    }
    sim->coupling->report.exchange_residual = scale > 0.0 ? off / scale : 0.0;
}

/* For removed particles the fluid paid what it still owed. */
static void add_removed(const struct replacement *r, double charged[3],
                        double *scale)
{
    for (int k = 0; k < 3 && r != NULL; k++) {
        charged[k] += r->unpaid_sum[k];
        *scale += fabs(r->unpaid_sum[k]);
    }
}

/* The fluid paid dt (k (u^new - u_mean) + owed / dt) for a particle, u^new
 * seen through the adjoint of averaging. */
static void settle_payment(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;
    double charged[3] = {0.0, 0.0, 0.0}, scale = 0.0;

    for (int i = 0; i < sim->particles->n; i++)
        for (int k = 0; k < 3; k++) {
            const int j = 3 * i + k;
            const double estimate =
                sim->dt * cp->k[i] * (cp->smooth[j] - cp->u_mean[j]);
            charged[k] += estimate + cp->owed[j];
            scale += fabs(estimate) + fabs(cp->owed[j]);
            cp->owed[j] = -estimate;
        }
    add_removed(cp->replacement, charged, &scale);
    check_payment(sim, charged, scale);
    replacement_settle(cp->replacement, sim->mesh->n_cells);
}

/* 1: what a particle sees of the fluid is the adjoint already. */
static int seen_alike(const struct coupling *cp)
{
    return cp->options.interpolation == interpolation_named("same");
}

/* Only the interpolation "linear" uses boundary velocities. */
void transfer_velocity(struct simulation *sim, double *u_f)
{
    struct coupling *const cp = sim->coupling;

    if (cp->u_b != NULL) fluid_boundary_velocity(sim->fluid, cp->u_b);
    cp->options.interpolation->apply(sim->averaging, 3, sim->fluid->u, cp->u_b,
                                     u_f);
}

void transfer_fluid(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;

    if (cp->options.two_way) {
        averaging_gather(sim->averaging, 3, sim->fluid->u, cp->smooth);
        if (sim->fluid->t > 0.0) settle_payment(sim);
    }
    if (cp->options.two_way && seen_alike(cp))
        memcpy(cp->u_f, cp->smooth,
               3 * (size_t)sim->particles->n * sizeof *cp->u_f);
    else
        transfer_velocity(sim, cp->u_f);
}

void transfer_open_account(struct simulation *sim)
{
    memset(sim->coupling->u_mean, 0,
           3 * (size_t)sim->particles->n * sizeof(double));
}

/* Mean drag f and mean velocity v of particle i over its share of the step,
 * into the sums [XS11 3.20]. */
static void account(struct simulation *sim, int i, const double f[3],
                    const double v[3], double share)
{
    struct coupling *const cp = sim->coupling;
    const double time = cp->options.two_way ? share * sim->dt : 0.0;

    for (int a = 0; a < 3; a++) {
        cp->owed[3 * i + a] += f[a] * time;
        cp->u_mean[3 * i + a] += v[a] * share;
    }
}

/* k (u_f - v) [XS11 4.1]: known at once, and constant in the sub-step. */
static void apply_frozen(struct simulation *sim, int i, double share)
{
    struct particles *const ps = sim->particles;
    const double k = drag_rate(sim, i), *const u = &sim->coupling->u_f[3 * i];
    const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    const double f[3] = {k * (u[0] - v[0]), k * (u[1] - v[1]),
                         k * (u[2] - v[2])};

    account(sim, i, f, v, share);
    ps->ex[i] += f[0];
    ps->ey[i] += f[1];
    ps->ez[i] += f[2];
}

/* k u_f is constant; -k v comes as it goes. */
static void apply_exponential(struct simulation *sim, int i)
{
    struct particles *const ps = sim->particles;
    const double k = drag_rate(sim, i), *const u = &sim->coupling->u_f[3 * i];

    ps->resistance[i] = k;
    ps->ex[i] += k * u[0];
    ps->ey[i] += k * u[1];
    ps->ez[i] += k * u[2];
    for (int a = 0; a < 3; a++)
        ps->resisted[3 * i + a] = 0.0;
}

void transfer_apply_drag(struct simulation *sim, int steps)
{
    const int n = sim->particles->n;
    const int frozen = sim->coupling->options.relaxation == RELAXATION_FROZEN;
    const double share = (double)steps / sim->dem_steps;

#pragma omp parallel for schedule(static) if (n >= MANY)
    for (int i = 0; i < n; i++)
        if (frozen)
            apply_frozen(sim, i, share);
        else
            apply_exponential(sim, i);
}

/* Mean drag f = k (u - v) over the sub-step, and the v that belongs to it. */
void transfer_collect_drag(struct simulation *sim, int steps)
{
    const struct particles *const ps = sim->particles;
    const double share = (double)steps / sim->dem_steps, T = share * sim->dt;

    if (sim->coupling->options.relaxation == RELAXATION_FROZEN) return;
#pragma omp parallel for schedule(static) if (ps->n >= MANY)
    for (int i = 0; i < ps->n; i++) {
        const double k = ps->resistance[i];
        const double *const u = &sim->coupling->u_f[3 * i];
        double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]}, f[3];
        for (int a = 0; a < 3; a++) {
            const double held_back = ps->resisted[3 * i + a] / T;
            f[a] = k * u[a] + held_back;
            if (k > 0.0) v[a] = -held_back / k;
        }
        account(sim, i, f, v, share);
    }
}
