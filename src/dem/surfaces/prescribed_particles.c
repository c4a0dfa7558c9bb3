/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/prescribed_particles.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

/* [-] factor of 1/m for a prescribed particle: with 0, a contact of two of them
 * would divide 0 by 0. */
static const double fraction_within = 1e-12;

struct prescribed_particles *
prescribed_particles_create(const struct prescribed_particle *list, int n)
{
    struct prescribed_particles *const d = alloc_zeroed(1, sizeof *d);

    d->list = list;
    d->n = n;
    d->index = alloc_ints(n);
    d->is_on = alloc_ints(n);
    return d;
}

void prescribed_particles_free(struct prescribed_particles *d)
{
    if (d == NULL) return;
    free(d->index);
    free(d->is_on);
    free(d);
}

void prescribed_particles_locate(struct prescribed_particles *d,
                                 const struct particles *ps)
{
    for (int k = 0; k < d->n; k++) {
        d->index[k] = -1;
        for (int i = 0; i < ps->n && d->index[k] < 0; i++)
            if (ps->id[i] == d->list[k].id) d->index[k] = i;
    }
}

/* Sets 1/m to nearly 0 and the outside acceleration to 0, so that no force
 * changes the velocity. The coefficient k of the drag -k v is unchanged,
 * because its reaction still acts on the fluid. */
static void set_inverse_mass(struct bodies *b, const struct particles *ps,
                             int i)
{
    b->motion[i].per_m = fraction_within / ps->m[i];
    b->own_inverse_mass[i] = 1.0 / ps->m[i];
    memset(b->acceleration[i], 0, sizeof b->acceleration[i]);
    if (b->drag == NULL) return;
    const double per_mass = fraction_within / (ps->m[i] + ps->added_mass[i]);
    b->drag[i] = (struct row_drag){ps->drag_coefficient[i] * per_mass, 1.0, 1.0,
                                   per_mass};
}

/* Restores the row of bodies_load. The present loads are those of a particle of
 * nearly infinite mass, whose dashpots would accelerate a finite mass far too
 * much; they are set to 0. */
static void restore_inverse_mass(struct bodies *b, const struct particles *ps,
                                 int i, struct row_load *load)
{
    if (load != NULL) memset(load, 0, sizeof *load);
    const double per_mass = 1.0 / ps->m[i];

    b->motion[i].per_m = per_mass;
    b->own_inverse_mass[i] = 0.0;
    b->acceleration[i][0] = ps->ex[i] * per_mass;
    b->acceleration[i][1] = ps->ey[i] * per_mass;
    b->acceleration[i][2] = ps->ez[i] * per_mass;
    if (b->drag != NULL) bodies_load_drag(b, ps, i, i + 1);
}

static void set_velocity_of(const struct motion *m, struct bodies *b, int i,
                            double t, double dt)
{
    const struct pose now = motion_pose(m, t);
    double *const v = b->motion[i].v, *const x = b->place[i].x;

    if (dt > 0.0) {
        const struct pose next = motion_pose(m, t + dt);
        double start[3], to[3];
        motion_origin(&now, x, start);
        motion_place(&next, start, to);
        for (int k = 0; k < 3; k++)
            v[k] = (to[k] - x[k]) / dt;
    } else {
        motion_velocity(&now, x, v);
    }
    for (int k = 0; k < 3; k++)
        b->motion[i].s[k] = b->place[i].R * now.spin[k];
}

/* Energy of translation and rotation, and of the added mass [J]. */
static double prescribed_particles_kinetic(const struct bodies *b,
                                           const struct particles *ps, int i)
{
    const struct row_motion *const own = &b->motion[i];
    const double m = ps->m[i] + (b->drag != NULL ? ps->added_mass[i] : 0.0);

    return 0.5 * m * vector_dot(own->v, own->v) +
           0.2 * ps->m[i] * vector_dot(own->s, own->s);
}

/* [W] T . omega = -turn . (R omega) (bodies.h). */
static double power_on(const struct row_motion *m, const struct row_load *load)
{
    double power = 0.0;

    for (int k = 0; k < 3; k++)
        power += load->F[k] * m->v[k] - load->turn[k] * m->s[k];
    return power;
}

static int owned_index(const struct prescribed_particles *d, int k, int begin,
                       int end)
{
    return d->index[k] >= begin && d->index[k] < end;
}

double prescribed_particles_set_velocities(struct prescribed_particles *d,
                                           struct bodies *b,
                                           const struct particles *ps,
                                           int begin, int end,
                                           struct row_load *load, double t,
                                           double dt, double kick)
{
    double gained = 0.0;

    for (int k = 0; k < d->n; k++) {
        const struct motion *const m = &d->list[k].motion;
        const int i = d->index[k], on = motion_is_on(m, t);

        if (!owned_index(d, k, begin, end)) continue;
        if (on) {
            set_inverse_mass(b, ps, i);
            gained -= prescribed_particles_kinetic(b, ps, i);
            set_velocity_of(m, b, i, t, dt);
            gained += prescribed_particles_kinetic(b, ps, i);
        } else if (d->is_on[k]) {
            if (load != NULL)
                gained -= kick * power_on(&b->motion[i], &load[i - begin]);
            restore_inverse_mass(b, ps, i,
                                 load != NULL ? &load[i - begin] : NULL);
        }
        d->is_on[k] = on;
    }
    return gained;
}

void prescribed_particles_fix_mass(const struct prescribed_particles *d,
                                   struct bodies *b, const struct particles *ps,
                                   int begin, int end)
{
    for (int k = 0; k < d->n; k++)
        if (owned_index(d, k, begin, end) && d->is_on[k])
            set_inverse_mass(b, ps, d->index[k]);
}

void prescribed_particles_restore_mass(const struct prescribed_particles *d,
                                       struct bodies *b,
                                       const struct particles *ps, int begin,
                                       int end)
{
    for (int k = 0; k < d->n; k++)
        if (owned_index(d, k, begin, end) && d->is_on[k])
            restore_inverse_mass(b, ps, d->index[k], NULL);
}
