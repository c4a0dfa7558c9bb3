/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/reaction.h"
#include "coupling/transfer.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/parallel_ranges.h"
#include "base/vector.h"
#include "coupling/coupling.h"
#include "dem/clumps.h"

/* Speed of the fluid relative to particle i [m/s]. */
static double slip_speed(const struct simulation *sim, int i)
{
    double w[3];

    coupling_slip(sim, i, w);
    return vector_length(w);
}

/* k_i = eps_f B_i = V_p beta / eps_s [XS11 2.9-2.11], [kg/s]. A ball of a clump
 * has its share of the drag on a body with the clump's volume and surface. */
static void drag_rates(int first, int last, const struct simulation *sim,
                       double *k)
{
    const struct drag_law *const law = sim->coupling->options.law;
    const struct fluid_options *const o = &sim->fluid->options;
    const struct particles *const ps = sim->particles;
    const double *const eps = &sim->coupling->eps[first];
    double d[PARALLEL_RANGES_BLOCK], slip[PARALLEL_RANGES_BLOCK];
    const int n = last - first;

    for (int i = 0; i < n; i++) {
        d[i] = clumps_grain(ps, first + i);
        slip[i] = slip_speed(sim, first + i);
    }
    if (law->resistance_many != NULL)
        law->resistance_many(n, eps, o->rho, o->mu, d, slip, &k[first]);
    for (int i = 0; i < n; i++) {
        if (law->resistance_many == NULL)
            k[first + i] =
                drag_resistance(law, eps[i], o->rho, o->mu, d[i], slip[i]);
        k[first + i] *= particles_volume(ps, first + i);
    }
}

/* The balls of clumps that are alone: their body has the drag of the sphere of
 * its volume times the ratio for its shape. */
static void shape_drag(const struct simulation *sim, double *k)
{
    const struct coupling_options *const o = &sim->coupling->options;
    const struct fluid_options *const f = &sim->fluid->options;
    const struct particles *const ps = sim->particles;

#pragma omp parallel for schedule(static) if (ps->n >= TRANSFER_MANY)
    for (int i = 0; i < ps->n; i++) {
        const double eps = sim->coupling->eps[i], lone = drag_shape_lone(eps);
        if (!clumps_own(ps, i) || lone == 0.0) continue;
        const double d = clumps_sphere(ps, i), slip = slip_speed(sim, i);
        const double psi = clumps_grain(ps, i) / d;
        const double Re = drag_reynolds(f->rho, f->mu, d, eps * slip);
        const double alone =
            particles_volume(ps, i) * drag_shape_ratio(o->shape, psi, Re) *
            drag_resistance(o->law, eps, f->rho, f->mu, d, slip);
        k[i] += lone * (alone - k[i]);
    }
}

/* k of all particles for their present slip, changed by the effects that do so.
 */
static void find_drag_rates(struct simulation *sim, double *k)
{
    const int n = sim->particles->n;

    PARALLEL_BLOCKS(n, 32, drag_rates, sim, k);
    if (sim->coupling->options.shape != NULL &&
        sim->coupling->options.shape->factor != NULL)
        shape_drag(sim, k);
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect_state *const e = &sim->effects[i];
        if (e->effect->drag != NULL) e->effect->drag(e->memory, sim, k);
    }
}

double transfer_drag(const struct simulation *sim, int i)
{
    return sim->coupling->rate[i] * slip_speed(sim, i);
}

void transfer_solids_velocity(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    struct coupling *const cp = sim->coupling;

    if (cp == NULL || !cp->options.two_way ||
        sim->fluid->options.continuity == CONTINUITY_MIXTURE)
        return; /* which has averaged them */
    for (int i = 0; i < ps->n; i++) {
        const double V = particles_volume(ps, i);
        cp->smooth[3 * i] = V * ps->vx[i]; /* not in use between two steps */
        cp->smooth[3 * i + 1] = V * ps->vy[i];
        cp->smooth[3 * i + 2] = V * ps->vz[i];
    }
    averaging_apply_cap(sim->averaging, 3, cp->smooth);
    averaging_spread(sim->averaging, 3, cp->smooth, sim->fluid->eps_us);
}

int transfer_average(struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    struct coupling *const cp = sim->coupling;

    if (averaging_bind(sim->averaging) != 0) return 1;
    if (!cp->options.two_way) { /* one-way coupling: undisturbed fluid */
        for (int i = 0; i < ps->n; i++)
            cp->eps[i] = 1.0;
        return 0;
    }
    return reaction_average(sim);
}

/* k of the slip at the end of the step, and the shortest relaxation time. */
void transfer_drag_terms(struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    struct coupling *const cp = sim->coupling;
    double shortest = INFINITY;

    find_drag_rates(sim, cp->rate);
#pragma omp parallel for schedule(static)                                      \
    reduction(min                                                              \
              : shortest) if (ps->n >= TRANSFER_MANY)
    for (int i = 0; i < ps->n; i++) {
        const double own = ps->m[i] / cp->rate[i]; /* [XS11 3.16] */
        shortest = own < shortest ? own : shortest;
    }
    cp->report.shortest_time =
        shared_smallest(sim->fluid->options.shared, shortest);
    if (cp->options.two_way) reaction_drag_terms(sim);
}

/* Only the interpolation "linear" uses boundary velocities. */
void transfer_velocity(struct simulation *sim, double *u_f)
{
    struct coupling *const cp = sim->coupling;

    if (cp->u_b != NULL) fluid_boundary_velocity(sim->fluid, cp->u_b);
    cp->options.interpolation->apply(sim->averaging, 3, sim->fluid->u, cp->u_b,
                                     u_f);
}

/* Interpolates the fluid velocity [m/s] to each particle; the interpolation
 * "same" is the adjoint of the averaging. */
void transfer_fluid(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;

    if (cp->options.two_way) reaction_receive(sim);
    if (cp->options.two_way &&
        cp->options.interpolation == interpolation_named("same"))
        memcpy(cp->u_f, cp->smooth,
               3 * (size_t)sim->particles->n * sizeof *cp->u_f);
    else
        transfer_velocity(sim, cp->u_f);
}

void transfer_start_velocity(struct simulation *sim, int first)
{
    const struct particles *const ps = sim->particles;

    for (int i = first; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        memcpy(&sim->coupling->u_mean[3 * i], v, sizeof v);
    }
}

void transfer_begin_substeps(struct simulation *sim)
{
    memset(sim->coupling->u_mean, 0,
           3 * (size_t)sim->particles->n * sizeof(double));
}

/* Adds the mean drag f and the mean velocity v of particle i in a sub-step to
 * the sums [XS11 3.20]. */
static void add_received(struct simulation *sim, int i, const double f[3],
                         const double v[3], double share)
{
    struct coupling *const cp = sim->coupling;
    const double time = cp->options.two_way ? share * sim->dt : 0.0;

    for (int a = 0; a < 3; a++) {
        cp->unpaid_impulse[3 * i + a] += f[a] * time;
        cp->u_mean[3 * i + a] += v[a] * share;
    }
}

/* k (u_f - v) [XS11 4.1]: known at once, and constant in the sub-step. */
static void apply_frozen(struct simulation *sim, int i, double share)
{
    struct particles *const ps = sim->particles;
    const double k = sim->coupling->amount[i];
    const double *const u = &sim->coupling->u_f[3 * i];
    const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    const double f[3] = {k * (u[0] - v[0]), k * (u[1] - v[1]),
                         k * (u[2] - v[2])};

    add_received(sim, i, f, v, share);
    ps->ex[i] += f[0];
    ps->ey[i] += f[1];
    ps->ez[i] += f[2];
}

/* k u_f is constant; -k v is integrated with the motion. */
static void transfer_apply_exponential(struct simulation *sim, int i)
{
    struct particles *const ps = sim->particles;
    const double k = sim->coupling->amount[i];
    const double *const u = &sim->coupling->u_f[3 * i];

    ps->drag_coefficient[i] = k;
    ps->ex[i] += k * u[0];
    ps->ey[i] += k * u[1];
    ps->ez[i] += k * u[2];
    for (int a = 0; a < 3; a++)
        ps->drag_impulse[3 * i + a] = 0.0;
}

void transfer_begin_substep(struct simulation *sim, int steps)
{
    const int n = sim->particles->n;
    const int frozen =
        sim->coupling->options.slip_integration == SLIP_INTEGRATION_FROZEN;
    const double share = (double)steps / sim->dem_steps;

    find_drag_rates(sim, sim->coupling->amount);
#pragma omp parallel for schedule(static) if (n >= TRANSFER_MANY)
    for (int i = 0; i < n; i++)
        if (frozen)
            apply_frozen(sim, i, share);
        else
            transfer_apply_exponential(sim, i);
}

/* Mean drag f = k (u - v) over the sub-step, and the corresponding mean v. */
void transfer_end_substep(struct simulation *sim, int steps)
{
    const struct particles *const ps = sim->particles;
    const double share = (double)steps / sim->dem_steps, T = share * sim->dt;

    if (sim->coupling->options.slip_integration == SLIP_INTEGRATION_FROZEN)
        return;
#pragma omp parallel for schedule(static) if (ps->n >= TRANSFER_MANY)
    for (int i = 0; i < ps->n; i++) {
        const double k = ps->drag_coefficient[i];
        const double *const u = &sim->coupling->u_f[3 * i];
        double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]}, f[3];
        for (int a = 0; a < 3; a++) {
            const double held_back = ps->drag_impulse[3 * i + a] / T;
            f[a] = k * u[a] + held_back;
            if (k > 0.0) v[a] = -held_back / k;
        }
        add_received(sim, i, f, v, share);
    }
}
