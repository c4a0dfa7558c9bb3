/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_motion.h"

#include "base/rotation.h"
#include "base/vector.h"
#include "dem/box_domain.h"
#include "resolved/body_numbers.h"
#include "resolved/shapes/block_contacts.h"

#include <math.h>
#include <string.h>

/* Mass of the fluid that a body displaces [kg]. */
static double displaced(const struct solid_bodies *b, int i)
{
    return b->rho * b->volume[i];
}

/* Moment of inertia over mass [m^2] of a sphere, of a solid or of fluid. */
static double gyration(const struct solid_bodies *b, int i)
{
    return 0.1 * b->ps->d[i] * b->ps->d[i];
}

/* The force of the fluid comes a step late. From C_v = (K + 1 + 2 C_a -
 * rho_r)/2 down, a change of the velocity comes back larger and with the other
 * sign (24.10). In a crowd C_a is larger (24.12). */
static void set_virtual_mass(struct solid_bodies *b, int i, double dt)
{
    const double width = body_shape_width(&b->shape[i]), R = 0.5 * width;
    const double x = b->mu * dt / (b->rho * R * R);
    const double rho_r = b->mass[i] / displaced(b, i);
    const double C_a =
        body_numbers_added_mass(body_shape_volume(&b->shape[i]), width);
    const double least = b->options.virtual_mass;

    b->C_v[i] = body_numbers_virtual_mass(least, x, rho_r, C_a, b->ps->n);
    b->C_spin[i] = body_numbers_virtual_spin(least, x, rho_r, C_a);
}

/* C_v rho V Delta U_f + C_c rho V Delta U_c [N s], of the change in the step
 * before or, after the contacts, in this one. */
static double added_momentum(const struct solid_bodies *b, int i, int k,
                             double u)
{
    const double C_v = b->C_v[i], C_c = body_numbers_contact_mass(C_v);
    const double by_fluid = b->u_by_fluid[3 * i + k];
    const double by_contacts = u - b->u_old[3 * i + k] - by_fluid;

    return displaced(b, i) * (C_v * by_fluid + C_c * by_contacts);
}

/* [EW18 2]. The force of the fluid [EW18 15], J/dt and what accelerates the
 * fluid inside, and the weight act on the mass with C_v; contacts act during
 * the step on that with C_c, so the former is given as a force on the latter
 * (24.15). */
static void set_forces(struct solid_bodies *b, int i, double dt)
{
    struct particles *const ps = b->ps;
    const double m = displaced(b, i), C_v = b->C_v[i];
    const double u[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    const double added = body_numbers_contact_mass(C_v) * m;
    double outside[3];

    for (int k = 0; k < 3; k++) {
        const double gained = u[k] - b->u_old[3 * i + k];
        b->force[3 * i + k] = (b->impulse[3 * i + k] + m * gained) / dt;
        const double F = b->shape[i].between >> k & 1
                             ? 0.0
                             : b->force[3 * i + k] +
                                   added_momentum(b, i, k, u[k]) / dt +
                                   (b->mass[i] - m) * b->options.gravity[k];
        b->u_by_fluid[3 * i + k] = F * dt / (b->mass[i] + C_v * m);
        outside[k] = F * (b->mass[i] + added) / (b->mass[i] + C_v * m);
        b->u_old[3 * i + k] = u[k];
    }
    if (b->motion[i] != BODY_FREE && b->motion[i] != BODY_SPRING) return;
    ps->ex[i] = outside[0], ps->ey[i] = outside[1], ps->ez[i] = outside[2];
    ps->added_mass[i] = added;
}

/* C_c of the spin [-]. That of a sphere moves no fluid but by viscosity. */
static double contact_spin_mass(const struct solid_bodies *b, int i)
{
    if (b->shape[i].kind != BODY_OUTLINE) return 0.0;
    return body_numbers_contact_mass(b->C_spin[i]);
}

double body_motion_turning_mass(const struct solid_bodies *b, int i)
{
    return b->ps->m[i] + contact_spin_mass(b, i) * displaced(b, i);
}

/* The spin that an outline of this mass [kg] gets of an angular impulse. */
static void spin_of(const struct solid_bodies *b, int i, double m,
                    const double impulse[3], double gained[3])
{
    double G[6];

    body_turn_gyration(b, i, G);
    vector_solve(G, impulse, gained);
    for (int k = 0; k < 3; k++)
        gained[k] /= m;
}

int body_motion_moves_along(const struct solid_bodies *b, int i, int k)
{
    return b->motion[i] == BODY_FREE ? !(b->shape[i].between >> k & 1)
                                     : b->spring[3 * i + k] > 0.0;
}

/* Between two walls about the axis across them alone. */
static void add_to_spin(struct solid_bodies *b, int i, double gained[3])
{
    if (b->motion[i] != BODY_FREE) return;
    for (int k = 0; k < 3; k++)
        if (b->shape[i].between & ~(1 << k)) gained[k] = 0.0;
    b->ps->wx[i] += gained[0];
    b->ps->wy[i] += gained[1];
    b->ps->wz[i] += gained[2];
}

/* [EW18 3]: the spin by the torque of the fluid [EW18 16]. Contacts follow,
 * with the inertia of the solid alone; what they change is not delayed by C_v.
 */
static void body_motion_turn(struct solid_bodies *b, int i, double dt)
{
    struct particles *const ps = b->ps;
    const double C_v = b->C_spin[i], per_mass = gyration(b, i);
    const double I_f = per_mass * displaced(b, i);
    const double I = per_mass * ps->m[i] + C_v * I_f;
    double *const w[3] = {&ps->wx[i], &ps->wy[i], &ps->wz[i]};

    for (int k = 0; k < 3; k++) {
        const double now = *w[k], gained = now - b->w_old[3 * i + k];
        const double J = b->angular[3 * i + k] + b->inertia[3 * i + k] * gained;
        double *const by_fluid = &b->w_by_fluid[3 * i + k];
        b->torque[3 * i + k] = J / dt;
        b->w_old[3 * i + k] = now;
        *by_fluid = (J + C_v * I_f * *by_fluid) / I;
        if (b->motion[i] == BODY_FREE) *w[k] += *by_fluid;
    }
}

/* The same with moments G of its own. What the body has turned by itself is in
 * neither spin of which the difference is taken (body_turn_freely): the fluid
 * inside has turned with it, and its angular momentum is as it was. */
static void turn_outline(struct solid_bodies *b, int i, double dt)
{
    struct particles *const ps = b->ps;
    const double m_f = displaced(b, i), C_v = b->C_spin[i];
    const double C_c = contact_spin_mass(b, i);
    const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};
    double *const by_fluid = &b->w_by_fluid[3 * i];
    double G[6], gained[3], inside[3], late[3], J[3];

    body_turn_gyration(b, i, G);
    vector_between(w, &b->w_old[3 * i], gained);
    body_turn_times(G, gained, inside);
    body_turn_times(G, by_fluid, late);
    for (int k = 0; k < 3; k++) {
        const double of_fluid = b->angular[3 * i + k] + m_f * inside[k];
        b->torque[3 * i + k] = of_fluid / dt;
        b->w_old[3 * i + k] = w[k];
        J[k] = of_fluid + m_f * (C_v * late[k] + C_c * (inside[k] - late[k]));
    }
    spin_of(b, i, ps->m[i] + C_v * m_f, J, by_fluid);
    add_to_spin(b, i, by_fluid);
}

static void clear(struct solid_bodies *b)
{
    const size_t size = 3 * (size_t)b->ps->n * sizeof(double);

    memset(b->impulse, 0, size);
    memset(b->angular, 0, size);
}

/* Without contacts: on as prescribed. Non-zero if a centre leaves the box; that
 * of one that is fixed may be beyond a wall. */
static int body_motion_drift(struct solid_bodies *b, double dt)
{
    const struct dem_options *const o = &b->contacts;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    struct particles *const ps = b->ps;

    for (int i = 0; i < ps->n; i++) {
        double *const x[3] = {&ps->x[i], &ps->y[i], &ps->z[i]};
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        for (int k = 0; k < 3 && b->motion[i] != BODY_FIXED; k++) {
            *x[k] = box_domain_inside(&box, k, *x[k] + dt * v[k]);
            b->dem_report.lost += *x[k] < o->lo[k] || *x[k] > o->hi[k];
        }
    }
    if (b->turn != NULL) body_turn_advance(b, dt);
    return b->dem_report.lost > 0;
}

/* The velocities of those on springs after a step [s], the spring first: as
 * symplectic Euler does it. Their contacts are those of blocks. */
static void pull_springs(struct solid_bodies *b, double step)
{
    const struct dem_options *const o = &b->contacts;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    struct particles *const ps = b->ps;

    for (int i = 0; i < ps->n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        const double e[3] = {ps->ex[i], ps->ey[i], ps->ez[i]};
        double *const v[3] = {&ps->vx[i], &ps->vy[i], &ps->vz[i]};
        for (int k = 0; k < 3 && b->motion[i] == BODY_SPRING; k++) {
            const double stiff = b->spring[3 * i + k];
            const double away =
                box_domain_nearest(&box, k, x[k] - b->anchor[3 * i + k]);
            if (stiff > 0.0)
                *v[k] += step * (e[k] - stiff * away) /
                         (b->mass[i] + ps->added_mass[i]);
        }
    }
}

/* One particle step of all, without lubrication. */
static int move_once(struct solid_bodies *b, double step)
{
    struct dem_report one;

    pull_springs(b, step);
    if (b->dem == NULL) return body_motion_drift(b, step);
    const double deepest = b->dem_report.max_overlap;
    const int failed = dem_run(b->dem, 1, &one);
    b->dem_report = one;
    b->dem_report.max_overlap = fmax(deepest, one.max_overlap);
    if (b->turn != NULL) body_turn_advance(b, step);
    return failed;
}

/* Contacts and lubrication act in each particle step. The report is of all. */
static int body_motion_run_steps(struct solid_bodies *b, int n, double step)
{
    int failed = 0;

    if (b->dem == NULL && b->springs == 0)
        return body_motion_drift(b, n * step);
    if (b->dem != NULL && b->springs == 0 && b->blocks == 0 &&
        b->lubrication.reach == 0.0)
        return dem_run(b->dem, n, &b->dem_report);
    b->dem_report.max_overlap = 0.0;
    b->dem_report.contacts = 0;
    for (int k = 0; k < n && !failed; k++) {
        if (b->lubrication.reach > 0.0) squeeze_film_act(b, step);
        if (b->blocks > 0) {
            const double depth = block_contacts_act(b, step);
            b->dem_report.max_overlap = fmax(b->dem_report.max_overlap, depth);
        }
        failed = move_once(b, step);
    }
    b->dem_report.contacts += b->touching;
    return failed;
}

int body_motion_run(struct solid_bodies *b, int n, double step)
{
    const double most = b->options.max_overlap;

    if (b->met || b->seal.inlet || b->seal.pushes) return 1;
    const int failed = body_motion_run_steps(b, n, step);
    b->deepest = fmax(b->deepest, b->dem_report.max_overlap);
    return failed || (most > 0.0 && b->deepest > most);
}

void body_motion_add_spin(struct solid_bodies *b, int i,
                          const double impulse[3])
{
    const double m = body_motion_turning_mass(b, i);
    const double I = m * gyration(b, i);
    double gained[3] = {impulse[0] / I, impulse[1] / I, impulse[2] / I};

    if (b->shape[i].kind == BODY_OUTLINE) spin_of(b, i, m, impulse, gained);
    add_to_spin(b, i, gained);
}

void body_motion_set_forces(struct solid_bodies *b, double dt)
{
    if (b->exit != NULL) body_exit_look(b);
    for (int i = 0; i < b->ps->n; i++) {
        set_virtual_mass(b, i, dt);
        set_forces(b, i, dt);
        if (b->shape[i].kind == BODY_OUTLINE)
            turn_outline(b, i, dt);
        else
            body_motion_turn(b, i, dt);
    }
    clear(b);
}

int body_motion_advance(struct solid_bodies *b, double dt)
{
    const int n = b->options.dem_steps;

    body_motion_set_forces(b, dt);
    if (!b->moves) return 0;
    b->dt_marked = 0.0; /* they will have moved */
    return body_motion_run(b, n, dt / n);
}

void body_motion_add_momentum(const void *bodies, double total[3])
{
    const struct solid_bodies *const b = bodies;
    const struct particles *const ps = b->ps;

    for (int i = 0; i < ps->n; i++) {
        const double m = displaced(b, i);
        const double u[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        for (int k = 0; k < 3 && b->motion[i] == BODY_FREE; k++)
            total[k] += ps->m[i] * u[k] - m * b->u_old[3 * i + k] +
                        added_momentum(b, i, k, u[k]);
    }
}

/* --- body turn ------------------------------------------------------------ */

/* q becomes the rotation by omega dt after q, of length 1. */
static void body_turn_step(double q[4], const double w[3], double dt)
{
    const double rate = vector_length(w), half = 0.5 * rate * dt;
    const double per = sin(half) / rate;
    const double r[4] = {cos(half), per * w[0], per * w[1], per * w[2]};
    const double before[4] = {q[0], q[1], q[2], q[3]};

    rotation_product(r, before, q);
    rotation_normalize(q);
}

/* Without a torque, which changes the spin: by as much in the step before, too,
 * for nothing has acted on the fluid. */
static void body_turn_freely(struct solid_bodies *b, int i, double dt)
{
    const struct body_outline *const o = b->shape[i].outline;
    const double *const g = o->principal, back[4] = {g[0], -g[1], -g[2], -g[3]};
    const double per_I[3] = {1.0 / o->moments[0], 1.0 / o->moments[1],
                             1.0 / o->moments[2]};
    double *const spin[3] = {&b->ps->wx[i], &b->ps->wy[i], &b->ps->wz[i]};
    const double w[3] = {*spin[0], *spin[1], *spin[2]};
    double q[4], L[3], turned[3];

    rotation_product(&b->turn[4 * i], g, q);
    rotation_spin(q, w, o->moments, L);
    rotation_advance(q, L, per_I, dt);
    rotation_spin(q, L, per_I, turned);
    rotation_product(q, back, &b->turn[4 * i]);
    for (int k = 0; k < 3; k++) {
        b->w_old[3 * i + k] += turned[k] - w[k];
        *spin[k] = turned[k];
    }
}

void body_turn_load(struct solid_bodies *b)
{
    for (int i = 0; i < b->ps->n; i++)
        rotation_matrix(&b->turn[4 * i], b->shape[i].turn);
}

void body_turn_advance(struct solid_bodies *b, double dt)
{
    const struct particles *const ps = b->ps;

    for (int i = 0; i < ps->n; i++) {
        const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};
        if (b->shape[i].kind != BODY_OUTLINE || !(vector_dot(w, w) > 0.0))
            continue;
        if (b->motion[i] == BODY_FREE && b->shape[i].between == 0)
            body_turn_freely(b, i, dt);
        else
            body_turn_step(&b->turn[4 * i], w, dt);
        rotation_matrix(&b->turn[4 * i], b->shape[i].turn);
    }
}

void body_turn_times(const double G[6], const double v[3], double product[3])
{
    for (int k = 0; k < 3; k++)
        product[k] = G[vector_place(k, 0)] * v[0] +
                     G[vector_place(k, 1)] * v[1] +
                     G[vector_place(k, 2)] * v[2];
}

void body_turn_gyration(const struct solid_bodies *b, int i, double G[6])
{
    const struct body_shape *const shape = &b->shape[i];
    const double(*const Q)[3] = shape->turn;

    for (int k = 0; k < 3; k++)
        for (int l = k; l < 3; l++) {
            double half[3];
            body_turn_times(shape->outline->gyration, Q[l], half);
            G[vector_place(k, l)] = vector_dot(Q[k], half);
        }
}
