/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/chunk.h"

#include <stddef.h>

static int is_fixed(const struct bodies *b, int i)
{
    return b->own_inverse_mass != NULL && b->own_inverse_mass[i] > 0.0;
}

/* One particle: its velocities before and after the kick, and their mean in the
 * part that is counted, as in bodies.h. */
struct kicked {
    const double *before, *after;
    double mean[8];
    int fixed; /* [-] 1: it moves as prescribed */
};

static struct kicked kicked(const struct bodies *b, int i, const double *before,
                            const double *after, double middle)
{
    struct kicked p = {before, after, {0.0}, is_fixed(b, i)};

    for (int k = 0; k < 8; k++)
        p.mean[k] =
            before[k] + (p.fixed ? 0.5 : middle) * (after[k] - before[k]);
    return p;
}

static double force_power(const double load[8], const double v[8])
{
    return load[0] * v[0] + load[1] * v[1] + load[2] * v[2];
}

/* T . omega = -load . (R omega) (chunk.h). */
static double torque_power(const double load[8], const double v[8])
{
    return -(load[4] * v[4] + load[5] * v[5] + load[6] * v[6]);
}

static double load_power(const double load[8], const double v[8])
{
    return force_power(load, v) + torque_power(load, v);
}

/* The power of an implicit drag (implicit_drag.h) in a kick of dt. */
static double drag_power(const struct bodies *b, int i, const struct kicked *p,
                         const double load[8], double dt)
{
    const double *const held = b->implicit_drag[i];
    const double *const a = b->acceleration[i];
    double power = 0.0;

    for (int k = 0; k < 3; k++) {
        const double given = held[3] * load[k] + a[k];
        const double taken = p->fixed
                                 ? -held[0] * p->after[k]
                                 : (p->after[k] - p->before[k]) / dt - given;
        power += p->mean[k] * taken / held[3];
    }
    return power;
}

/* The work of the external forces, and of what keeps a prescribed particle in
 * its motion: the opposite of that of all others. */
static void count_others(struct chunk_energy *e, const struct bodies *b, int i,
                         const struct kicked *p, const double load[8], double h,
                         double dt)
{
    const int held = b->implicit_drag != NULL;
    const double per_mass = held ? b->implicit_drag[i][3] : p->after[7];
    const double *const a = b->acceleration[i];
    const double drag = held && dt > 0.0 ? drag_power(b, i, p, load, dt) : 0.0;

    e->work += h * (force_power(a, p->mean) / per_mass + drag);
    if (p->fixed) e->prescribed -= h * (load_power(load, p->mean) + drag);
}

static void count_one(struct chunk_energy *e, const struct kicked *p,
                      double part[ENERGY_PARTS][8], double h)
{
    const double *const u = p->mean;

    e->damped_n -= h * force_power(part[ENERGY_DASHPOTS], u);
    e->rolled -= h * torque_power(part[ENERGY_DASHPOTS], u);
    e->damped_t -= h * load_power(part[ENERGY_DASHPOTS_T], u);
    e->released -= h * load_power(part[ENERGY_FRICTION], u);
    e->attracted += h * force_power(part[ENERGY_ATTRACTIONS], u);
}

void chunk_count_kick(struct chunk *s, const struct bodies *b,
                      const struct chunk_kick *kick)
{
    const double h = (kick->to - kick->from) * kick->length;

    for (int i = s->begin; i < s->end; i++) {
        const struct kicked p = kicked(b, i, kick->before[i], kick->after[i],
                                       0.5 * (kick->from + kick->to));
        count_one(&s->energy, &p, kick->part[i - s->begin], h);
        count_others(&s->energy, b, i, &p, s->load[i - s->begin], h,
                     kick->length);
    }
}

void chunk_count_ahead(struct chunk *s, const struct bodies *b, double to)
{
    const double h = to * b->step;
    double after[8];

    for (int i = s->begin; i < s->end; i++) {
        bodies_kicked(b, i, s->load[i - s->begin], after);
        const struct kicked p = kicked(b, i, b->velocity[i], after, 0.5 * to);
        count_one(&s->energy, &p, s->part[i - s->begin], h);
        count_others(&s->energy, b, i, &p, s->load[i - s->begin], h, b->step);
    }
}

/* (1/2) m (v + to dv)^2 - (1/2) m v^2, with the added mass; and the rotation,
 * I = (2/5) m R^2. */
void chunk_measure_ahead(struct chunk *s, const struct bodies *b, double to)
{
    s->energy.ahead = 0.0;
    for (int i = s->begin; i < s->end; i++) {
        const double *const v = b->velocity[i];
        const double m =
            1.0 / (b->implicit_drag != NULL ? b->implicit_drag[i][3] : v[7]);
        double after[8];

        if (is_fixed(b, i) || to == 0.0) continue;
        bodies_kicked(b, i, s->load[i - s->begin], after);
        for (int k = 0; k < 3; k++) {
            const double dv = to * (after[k] - v[k]);
            const double dw = to * (after[4 + k] - v[4 + k]);
            s->energy.ahead += m * dv * (v[k] + 0.5 * dv) +
                               0.4 / v[7] * dw * (v[4 + k] + 0.5 * dw);
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
