/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/neighbours.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/vector.h"
#include "dem/fast/sweep.h"

/* The work of prescribed particles on others and the energy that they gain come
 * from outside. */
static void chunk_step_advance(const struct neighbours *nb, struct chunk *own,
                               int begin, int end,
                               const struct step_parameters *by)
{
    struct row_load *const load = chunk_load(own, begin - own->begin);
    struct rows *const b = nb->rows;

    if (by->budget && end > begin)
        memcpy(&b->before[begin], &b->motion[begin],
               (size_t)(end - begin) * sizeof *b->before);
    if (nb->prescribed != NULL && by->prescribed)
        own->energy.prescribed += prescribed_particles_set_velocities(
            nb->prescribed, b, nb->ps, begin, end, load, by->t, by->drift,
            by->kick);
    rows_advance(b, begin, end, load, by->kick, by->drift, own->max_speed_now);
    if (by->look)
        own->margin_left_now =
            fmin(own->margin_left_now, rows_margin_left(b, begin, end));
}

/* What the budget counts after all particles of the chunk have moved, in an
 * order that does not depend on the threads. */
static void chunk_step_count(const struct neighbours *nb, int s,
                             const struct step_parameters *by)
{
    struct chunk *const own = &nb->chunks[s];
    const struct chunk_kick kick = {
        by->kick, by->from, 1.0, nb->rows->before, nb->rows->motion, own->part};

    if (!by->budget) return;
    chunk_count_kick(own, nb->rows, &kick);
    if (nb->surfaces != NULL)
        surface_contacts_count(&nb->surfaces->chunk[s],
                               (1.0 - by->from) * by->kick);
}

/* The loads of the contacts that end with this block. */
static void load_block(const struct neighbours *nb, struct chunk *own, int k,
                       const struct step_parameters *by)
{
    const struct chunk_block begin = {own->begin, 0, own->contacts.n_pairs, 0};
    const struct chunk_block *const to = &own->blocks[k];
    const struct chunk_block *const from = k > 0 ? to - 1 : &begin;

    chunk_zero_loads(own, from->n_loads, to->n_loads);
    own->fetched = to->n_loads;
    own->reached = k + 1 < own->n_blocks ? to[1].n_loads : to->n_loads;
    sweep_contacts(own, nb->rows, by->constants, by->dt, from->pairs,
                   to->pairs);
    sweep_contacts(own, nb->rows, by->constants, by->dt, from->walls,
                   to->walls);
    if (own->max_overlap > own->deep.depth)
        chunk_check_overlaps(own, nb->rows, from, to);
}

/* --- attractions (attraction.h) ------------------------------------------- */

static int material_in_row(const struct rows *b, int i)
{
    return b->material != NULL ? b->material[i] : 0;
}

static void add_attraction_of_pairs(struct chunk *s, const struct rows *b,
                                    const struct attraction *a, int i)
{
    const struct neighbour_list *const v = &s->pairs;
    const int own = i - s->begin, of_i = material_in_row(b, i);
    const struct row_place *const x = &b->place[i];
    const struct row_motion *const m = &b->motion[i];

    for (int q = v->start[own]; q < v->start[own + 1]; q++) {
        const int j = v->partner[q], at = j - s->begin;
        const struct row_place *const y = &b->place[j];
        const struct row_motion *const u = &b->motion[j];
        double *const theirs = s->load[at < 0 ? at + b->n : at].F;
        double dx[3], r2 = 0.0, closing = 0.0;

        for (int k = 0; k < 3; k++) {
            dx[k] = x->x[k] - y->x[k];
            dx[k] -= b->box.length[k] * rint(dx[k] * b->box.inverse[k]);
            r2 += dx[k] * dx[k];
        }
        const double r = sqrt(r2), gap = r - x->R - y->R;
        if (gap > a->range) continue;
        for (int k = 0; k < 3 && a->law->damping != NULL; k++)
            closing -= (m->v[k] - u->v[k]) * dx[k] / r;
        const double F =
            attraction_of_pair(a, of_i, material_in_row(b, j), x->R, y->R, gap,
                               closing, m->per_m + u->per_m, b->step);
        for (int k = 0; k < 3; k++) {
            s->load[own].F[k] += F / r * dx[k];
            theirs[k] -= F / r * dx[k];
        }
    }
}

/* Adds the forces of the six sides of the box. */
static void add_attraction_of_walls(struct chunk *s, const struct rows *b,
                                    const struct attraction *a, int i)
{
    const struct neighbour_list *const v = &s->walls;
    const int own = i - s->begin;
    const struct row_motion *const m = &b->motion[i];

    for (int q = v->start[own]; q < v->start[own + 1]; q++) {
        const int wall = v->partner[q], k = wall / 2;
        const double out = wall % 2 ? -1.0 : 1.0;
        s->load[own].F[k] +=
            out * attraction_of_wall(a, b->place[i].R,
                                     rows_wall_gap(&b->box, &b->place[i], wall),
                                     -out * m->v[k], m->per_m, b->step);
    }
}

static void add_attraction(struct chunk *s, const struct rows *b,
                           const struct attraction *a)
{
    for (int i = s->begin; i < s->end; i++) {
        add_attraction_of_pairs(s, b, a, i);
        if (a->law->wall != NULL || a->law->damping != NULL)
            add_attraction_of_walls(s, b, a, i);
    }
}

/* Adds sign times the loads to the part of the attractions. */
static void add_to_attractions(struct chunk *own, double sign)
{
    for (int q = 0; q < own->window; q++)
        for (int k = 0; k < 3; k++)
            own->part[q][ENERGY_ATTRACTIONS].F[k] += sign * own->load[q].F[k];
}

/* Adds the loads of surfaces and attractions on a chunk. */
static void load_others(struct neighbours *nb, int s,
                        const struct step_parameters *by)
{
    struct chunk *const own = &nb->chunks[s];
    const int counted = by->budget && by->n_attractions > 0;

    if (nb->surfaces != NULL)
        surfaces_add_loads(nb->surfaces, s, own, nb->rows, by->constants,
                           by->dt);
    if (counted) add_to_attractions(own, -1.0);
    for (int k = 0; k < by->n_attractions; k++)
        add_attraction(own, nb->rows, &by->attractions[k]);
    if (counted) add_to_attractions(own, 1.0);
}

/* Computes loads, then motion, block by block. Blocks wait if other chunks may
 * still add loads to them or still need their positions. */
static void load_and_move_chunk(struct neighbours *nb, int s,
                                const struct step_parameters *by, int waiting)
{
    struct chunk *const own = &nb->chunks[s];
    const int shared = chunk_loads_shared(nb, s, by),
              late = own->begin + shared;

    if (!waiting) chunk_loads_begin(nb, s, by);
    for (int k = 0, begin = own->begin; k < own->n_blocks; k++) {
        const int end = own->blocks[k].end;
        if (!waiting) load_block(nb, own, k, by);
        if ((begin < late) == waiting) {
            chunk_add_loads(nb->chunks, nb->n_chunks, s, nb->rows->n, begin,
                            end);
            chunk_step_advance(nb, own, begin, end, by);
        }
        begin = end;
    }
    if (waiting) return;
    chunk_loads_end(nb, s, by);
    load_others(nb, s, by);
}

/* Publishes the largest speeds of the chunk, and its least margin, after all
 * threads have read the previous ones. */
static void publish_extremes(struct chunk *own)
{
    memcpy(own->max_speed, own->max_speed_now, sizeof own->max_speed);
    memset(own->max_speed_now, 0, sizeof own->max_speed_now);
    own->margin_left = own->margin_left_now;
    own->margin_left_now = HUGE_VAL;
}

/* The motion of clumps, and then the budget of all chunks, whose balls have
 * their velocities only now. */
static void chunk_step_move_clumps(struct neighbours *nb,
                                   const struct chunk_range *mine,
                                   const struct step_parameters *by)
{
    if (nb->ps->clumps == NULL || by->kick == 0.0) return;
    fast_clumps_kick(nb, by->kick, by->budget);
    for (int s = mine->first; s < mine->last; s++)
        chunk_step_count(nb, s, by);
    if (by->budget) neighbours_barrier(nb);
    fast_clumps_drift(nb, by->drift);
}

void chunk_step_load_and_move(struct neighbours *nb,
                              const struct step_parameters *by)
{
    const struct chunk_range mine = neighbours_balanced_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        if (by->budget) chunk_begin_budget(&nb->chunks[s].energy);
        load_and_move_chunk(nb, s, by, 0);
        if (by->budget) chunk_end_budget(&nb->chunks[s].energy);
    }
    neighbours_barrier(nb);
    if (nb->surfaces != NULL && mine.first == 0 && mine.last > 0)
        surfaces_wear(nb->surfaces, by->dt);
    for (int s = mine.first; s < mine.last; s++) {
        load_and_move_chunk(nb, s, by, 1);
        if (nb->ps->clumps == NULL) chunk_step_count(nb, s, by);
        publish_extremes(&nb->chunks[s]);
    }
    neighbours_barrier(nb);
    chunk_step_move_clumps(nb, &mine, by);
}

void chunk_step_move(struct neighbours *nb, const struct step_parameters *by)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        chunk_step_advance(nb, own, own->begin, own->end, by);
        if (nb->ps->clumps == NULL) chunk_step_count(nb, s, by);
        publish_extremes(own);
    }
    neighbours_barrier(nb);
    chunk_step_move_clumps(nb, &mine, by);
}

/* --- chunk energy --------------------------------------------------------- */

static int is_fixed(const struct rows *b, int i)
{
    return b->own_inverse_mass != NULL && b->own_inverse_mass[i] > 0.0;
}

/* One particle: its motion before and after the kick, and the mean of its
 * velocities in the part that is counted, as in rows.h. */
struct kicked {
    const struct row_motion *before, *after;
    struct row_motion mean;
    int fixed; /* [-] 1: it moves as prescribed */
};

static struct kicked kicked(const struct rows *b, int i,
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
static double drag_power(const struct rows *b, int i, const struct kicked *p,
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
static void count_others(struct chunk_energy *e, const struct rows *b, int i,
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

void chunk_count_kick(struct chunk *s, const struct rows *b,
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

void chunk_count_ahead(struct chunk *s, const struct rows *b, double to)
{
    const double h = to * b->step;

    for (int i = s->begin; i < s->end; i++) {
        const struct row_load *const load = &s->load[i - s->begin];
        const struct row_motion after = rows_kicked(b, i, load);
        const struct kicked p = kicked(b, i, &b->motion[i], &after, 0.5 * to);
        count_one(&s->energy, &p, s->part[i - s->begin], h);
        count_others(&s->energy, b, i, &p, load, h, b->step);
    }
}

/* (1/2) m (v + to dv)^2 - (1/2) m v^2, with the added mass; and the rotation,
 * I = (2/5) m R^2. */
void chunk_measure_ahead(struct chunk *s, const struct rows *b, double to)
{
    s->energy.ahead = 0.0;
    for (int i = s->begin; i < s->end; i++) {
        const struct row_motion *const now = &b->motion[i];
        const double m =
            1.0 / (b->drag != NULL ? b->drag[i].per_m : now->per_m);

        if (is_fixed(b, i) || to == 0.0) continue;
        const struct row_motion after =
            rows_kicked(b, i, &s->load[i - s->begin]);
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
static double added_mass_energy(const struct rows *b)
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
    struct energy e = {.kinetic = added_mass_energy(nb->rows)};

    for (int s = 0; s < nb->n_chunks; s++) {
        const struct chunk *const own = &nb->chunks[s];
        e.kinetic += own->measures.translation + own->measures.rotation +
                     own->energy.ahead;
        budget_add(&e, &own->energy);
        if (nb->surfaces != NULL)
            budget_add(&e, &nb->surfaces->chunk[s].pairs.energy);
    }
    return e;
}
