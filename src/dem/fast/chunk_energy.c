/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <stddef.h>

#include "base/vector.h"
#include "dem/fast/neighbours.h"

static int is_fixed(const struct bodies *b, int i)
{
    return b->own_inverse_mass != NULL && b->own_inverse_mass[i] > 0.0;
}

/* One particle: its motion before and after the kick, and the mean of its
 * velocities in the part that is counted, as in bodies.h. */
struct kicked {
    const struct row_motion *before, *after;
    struct row_motion mean;
    int fixed; /* [-] 1: it moves as prescribed */
};

static struct kicked kicked(const struct bodies *b, int i,
                            const struct row_motion *before,
                            const struct row_motion *after, double middle)
{
    struct kicked p = {before, after, *before, is_fixed(b, i)};
    const double part = p.fixed ? 0.5 : middle;

    for (int k = 0; k < 3; k++) {
        p.mean.v[k] += part * (after->v[k] - before->v[k]);
        p.mean.s[k] += part * (after->s[k] - before->s[k]);
    }
    return p;
}

/* [W] T . omega = -turn . (R omega). */
static double torque_power(const struct row_load *load,
                           const struct row_motion *m)
{
    return -vector_dot(load->turn, m->s);
}

static double load_power(const struct row_load *load,
                         const struct row_motion *m)
{
    return vector_dot(load->F, m->v) + torque_power(load, m);
}

/* The power of an implicit drag (implicit_drag.h) in a kick of dt. */
static double drag_power(const struct bodies *b, int i, const struct kicked *p,
                         const struct row_load *load, double dt)
{
    const struct row_drag *const drag = &b->drag[i];
    const double *const a = b->acceleration[i];
    double power = 0.0;

    for (int k = 0; k < 3; k++) {
        const double given = drag->per_m * load->F[k] + a[k];
        const double dv = p->after->v[k] - p->before->v[k];
        const double taken =
            p->fixed ? -drag->rate * p->after->v[k] : dv / dt - given;
        power += p->mean.v[k] * taken / drag->per_m;
    }
    return power;
}

/* The work of the external forces, and of what keeps a prescribed particle in
 * its motion: the opposite of that of all others. */
static void count_others(struct chunk_energy *e, const struct bodies *b, int i,
                         const struct kicked *p, const struct row_load *load,
                         double h, double dt)
{
    const int held = b->drag != NULL;
    const double per_mass = held ? b->drag[i].per_m : p->after->per_m;
    const double *const a = b->acceleration[i];
    const double drag = held && dt > 0.0 ? drag_power(b, i, p, load, dt) : 0.0;

    e->work += h * (vector_dot(a, p->mean.v) / per_mass + drag);
    if (p->fixed) e->prescribed -= h * (load_power(load, &p->mean) + drag);
}

static void count_one(struct chunk_energy *e, const struct kicked *p,
                      const struct row_load part[ENERGY_PARTS], double h)
{
    const struct row_motion *const m = &p->mean;

    e->damped_n -= h * vector_dot(part[ENERGY_DASHPOTS].F, m->v);
    e->rolled -= h * torque_power(&part[ENERGY_DASHPOTS], m);
    e->damped_t -= h * load_power(&part[ENERGY_DASHPOTS_T], m);
    e->released -= h * load_power(&part[ENERGY_FRICTION], m);
    e->attracted += h * vector_dot(part[ENERGY_ATTRACTIONS].F, m->v);
}

void chunk_count_kick(struct chunk *s, const struct bodies *b,
                      const struct chunk_kick *kick)
{
    const double h = (kick->to - kick->from) * kick->length;

    for (int i = s->begin; i < s->end; i++) {
        const struct kicked p = kicked(b, i, &kick->before[i], &kick->after[i],
                                       0.5 * (kick->from + kick->to));
        count_one(&s->energy, &p, kick->part[i - s->begin], h);
        count_others(&s->energy, b, i, &p, &s->load[i - s->begin], h,
                     kick->length);
    }
}

void chunk_count_ahead(struct chunk *s, const struct bodies *b, double to)
{
    const double h = to * b->step;

    for (int i = s->begin; i < s->end; i++) {
        const struct row_load *const load = &s->load[i - s->begin];
        const struct row_motion after = bodies_kicked(b, i, load);
        const struct kicked p = kicked(b, i, &b->motion[i], &after, 0.5 * to);
        count_one(&s->energy, &p, s->part[i - s->begin], h);
        count_others(&s->energy, b, i, &p, load, h, b->step);
    }
}

/* (1/2) m (v + to dv)^2 - (1/2) m v^2, with the added mass; and the rotation,
 * I = (2/5) m R^2. */
void chunk_measure_ahead(struct chunk *s, const struct bodies *b, double to)
{
    s->energy.ahead = 0.0;
    for (int i = s->begin; i < s->end; i++) {
        const struct row_motion *const now = &b->motion[i];
        const double m =
            1.0 / (b->drag != NULL ? b->drag[i].per_m : now->per_m);

        if (is_fixed(b, i) || to == 0.0) continue;
        const struct row_motion after =
            bodies_kicked(b, i, &s->load[i - s->begin]);
        for (int k = 0; k < 3; k++) {
            const double dv = to * (after.v[k] - now->v[k]);
            const double ds = to * (after.s[k] - now->s[k]);
            s->energy.ahead += m * dv * (now->v[k] + 0.5 * dv) +
                               0.4 / now->per_m * ds * (now->s[k] + 0.5 * ds);
        }
    }
}

void chunk_begin_budget(struct chunk_energy *e)
{
    e->stored = e->tangential;
    e->released_before = e->released;
    e->normal = e->tangential = 0.0;
}

void chunk_end_budget(struct chunk_energy *e)
{
    if (e->skip_release)
        e->released = e->released_before;
    else
        e->released += e->stored - e->tangential;
}

/* --- the budget of all chunks --------------------------------------------- */

/* (1/2) m_a v^2 of the added mass (implicit_drag.h). */
static double added_mass_energy(const struct bodies *b)
{
    double sum = 0.0;

    for (int i = 0; i < b->n && b->drag != NULL; i++) {
        const struct row_motion *const m = &b->motion[i];
        const double added = 1.0 / b->drag[i].per_m - 1.0 / m->per_m;
        sum += 0.5 * added * vector_dot(m->v, m->v);
    }
    return sum;
}

static void budget_add(struct energy *e, const struct chunk_energy *part)
{
    e->normal += part->normal;
    e->tangential += part->tangential;
    e->damped_n += part->damped_n;
    e->damped_t += part->damped_t;
    e->slid += part->slid;
    e->released += part->released;
    e->rolled += part->rolled;
    e->work += part->work;
    e->attracted += part->attracted;
    e->walls += part->prescribed;
}

struct energy neighbours_energy(const struct neighbours *nb)
{
    struct energy e = {.kinetic = added_mass_energy(nb->bodies)};

    for (int s = 0; s < nb->n_chunks; s++) {
        const struct chunk *const own = &nb->chunks[s];
        e.kinetic += own->measures.translation + own->measures.rotation +
                     own->energy.ahead;
        budget_add(&e, &own->energy);
        if (nb->surfaces != NULL)
            budget_add(&e, surfaces_energy(nb->surfaces, s));
    }
    return e;
}
