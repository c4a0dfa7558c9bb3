/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/prescribed_particles.h"

#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

/* [-] factor of 1/m for a prescribed particle: with 0, a contact of two of them
 * would divide 0 by 0. */
static const double fraction_within = 1e-12;

struct prescribed_particles *
prescribed_particles_create(const struct prescribed_particle *list, int n)
{
    struct prescribed_particles *const d = owner_create(sizeof *d);

    d->list = list;
    for (int k = 0; k < n; k++) {
        d->n += prescribed_last(&list[k]) - list[k].id + 1;
        if (prescribed_last(&list[k]) >= d->n_ids)
            d->n_ids = prescribed_last(&list[k]) + 1;
    }
    d->range = owner_ints(d, d->n);
    d->is_on = owner_ints(d, d->n);
    d->found = owner_zeroed(d, (size_t)d->n, sizeof *d->found);
    d->number = owner_ints(d, d->n_ids);
    for (int id = 0; id < d->n_ids; id++)
        d->number[id] = -1;
    for (int k = 0, q = 0; k < n; k++)
        for (int id = list[k].id; id <= prescribed_last(&list[k]); id++) {
            d->range[q] = k;
            d->number[id] = q++;
        }
    return d;
}

void prescribed_particles_locate(struct prescribed_particles *d,
                                 const struct particles *ps)
{
    d->n_found = 0;
    for (int i = 0; i < ps->n; i++) {
        const int id = ps->id[i], q = id < d->n_ids ? d->number[id] : -1;
        if (q >= 0) d->found[d->n_found++] = (struct prescribed_place){i, q};
    }
}

/* The number in `found` of the first at or behind this index. */
static int first_from(const struct prescribed_particles *d, int index)
{
    int lo = 0, hi = d->n_found;

    while (lo < hi) {
        const int middle = (lo + hi) / 2;
        if (d->found[middle].index < index)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo;
}

/* Sets 1/m to nearly 0 and the outside acceleration to 0, so that no force
 * changes the velocity. The coefficient k of the drag -k v is unchanged,
 * because its reaction still acts on the fluid. */
static void set_inverse_mass(struct rows *b, const struct particles *ps, int i)
{
    b->motion[i].per_m = fraction_within / ps->m[i];
    b->own_inverse_mass[i] = 1.0 / ps->m[i];
    memset(b->acceleration[i], 0, sizeof b->acceleration[i]);
    if (b->drag == NULL) return;
    const double per_mass = fraction_within / (ps->m[i] + ps->added_mass[i]);
    b->drag[i] = (struct row_drag){ps->drag_coefficient[i] * per_mass, 1.0, 1.0,
                                   per_mass};
}

/* For a step from one pose to the other in dt; dt = 0: the velocity now. */
static void set_velocity_of(const struct pose *now, const struct pose *next,
                            struct rows *b, int i, double dt)
{
    double *const v = b->motion[i].v, *const x = b->place[i].x;

    if (dt > 0.0) {
        double start[3], to[3];
        motion_origin(now, x, start);
        motion_place(next, start, to);
        for (int k = 0; k < 3; k++)
            v[k] = (to[k] - x[k]) / dt;
    } else {
        motion_velocity(now, x, v);
    }
    for (int k = 0; k < 3; k++)
        b->motion[i].s[k] = b->place[i].R * now->spin[k];
}

/* Energy of translation and rotation, and of the added mass [J]. */
static double prescribed_particles_kinetic(const struct rows *b,
                                           const struct particles *ps, int i)
{
    const struct row_motion *const own = &b->motion[i];
    const double m = ps->m[i] + (b->drag != NULL ? ps->added_mass[i] : 0.0);

    return 0.5 * m * vector_dot(own->v, own->v) +
           0.2 * ps->m[i] * vector_dot(own->s, own->s);
}

/* [W] T . omega = -turn . (R omega) (rows.h). */
static double power_on(const struct row_motion *m, const struct row_load *load)
{
    double power = 0.0;

    for (int k = 0; k < 3; k++)
        power += load->F[k] * m->v[k] - load->turn[k] * m->s[k];
    return power;
}

double prescribed_particles_set_velocities(
    struct prescribed_particles *d, struct rows *b, const struct particles *ps,
    int begin, int end, struct row_load *load, double t, double dt, double kick)
{
    struct pose now, next;
    double gained = 0.0;
    int posed = -1; /* the range of which both are */

    for (int q = first_from(d, begin), last = first_from(d, end); q < last;
         q++) {
        const int i = d->found[q].index, number = d->found[q].number;
        const struct motion *const m = &d->list[d->range[number]].motion;
        struct row_load *const own = load != NULL ? &load[i - begin] : NULL;
        const int on = motion_is_on(m, t);

        if (on && posed != d->range[number]) {
            posed = d->range[number];
            now = motion_pose(m, t);
            next = motion_pose(m, t + dt);
        }
        if (on) {
            set_inverse_mass(b, ps, i);
            gained -= prescribed_particles_kinetic(b, ps, i);
            set_velocity_of(&now, &next, b, i, dt);
            gained += prescribed_particles_kinetic(b, ps, i);
        } else if (d->is_on[number]) {
            /* Dashpots of nearly infinite masses would accelerate a finite one
             * far too much. */
            if (own != NULL) gained -= kick * power_on(&b->motion[i], own);
            if (own != NULL) memset(own, 0, sizeof *own);
            rows_load_mass(b, ps, i);
        }
        d->is_on[number] = on;
    }
    return gained;
}

void prescribed_particles_set_mass(const struct prescribed_particles *d,
                                   struct rows *b, const struct particles *ps,
                                   int begin, int end, int fixed)
{
    for (int q = first_from(d, begin), last = first_from(d, end); q < last; q++)
        if (d->is_on[d->found[q].number])
            (fixed ? set_inverse_mass : rows_load_mass)(b, ps,
                                                        d->found[q].index);
}
