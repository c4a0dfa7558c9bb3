/* SPDX-License-Identifier: GPL-3.0-or-later */
/* no_contacts.c -- particles without contacts, for one- and two-way coupling.
 * Chapter "Further forces".
 *
 *   m dv/dt = F   [LS 4.1]
 *
 * There are no pairs, so each particle takes all steps of a run before the next
 * one begins. The walls of the box are smooth and reflect it at once, v_n to
 * -e v_n with the restitution e of wall and grain, so that the step need not
 * resolve the impact. The spin is unchanged.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/interrupt.h"
#include "dem/box_domain.h"
#include "dem/dem_internal.h"
#include "dem/implicit_drag.h"

/* Number of particles above which a second thread is faster. */
enum { MANY = 1000 };

/* Steps of a particle after which it looks for a signal: some 0.1 ms. */
enum { LOOK = 10000 };

/* The gains of an implicit drag in the first, the later and the last kick. */
enum { KICKS = 3 };

/* One particle during a run; the forces on it are constant. */
struct free_particle {
    double x[3], v[3]; /* [m], [m/s] */
    double R, m;       /* [m]; [kg] with the added mass */
    double a[3];       /* [m/s^2] of the external force */
    double rate;       /* [1/s] k/m of an implicit drag */
    double gain[KICKS];
    double restitution; /* [-] at a wall */
    double impulse[3];  /* [N s] of -k v */
    double work, lost;  /* [J] of the forces; in the walls */
};

/* Lengths [s] of the kicks. */
struct kicks {
    double dt[KICKS], step;
};

static struct kicks kicks_of(const struct dem_options *o)
{
    const double dt = o->step;

    return (struct kicks){
        {o->integrator->first * dt, dt, o->integrator->last * dt}, dt};
}

/* e of the grain's material against that of the walls. */
static double restitution_at(const struct dem *dem, int i)
{
    const struct materials *const all = dem->options.materials;
    const struct particles *const ps = dem->ps;
    const int own = ps->material != NULL ? ps->material[i] : 0;

    return all == NULL
               ? dem->options.material.restitution
               : materials_pair(&dem->options.material, all, own, all->wall)
                     .restitution;
}

static struct free_particle free_particle_of(const struct dem *dem, int i,
                                             const struct kicks *kicks)
{
    const struct particles *const ps = dem->ps;
    const int drag = ps->drag_coefficient != NULL;
    struct free_particle t = {.x = {ps->x[i], ps->y[i], ps->z[i]},
                              .v = {ps->vx[i], ps->vy[i], ps->vz[i]},
                              .R = 0.5 * ps->d[i],
                              .m = ps->m[i] + (drag ? ps->added_mass[i] : 0.0),
                              .restitution = restitution_at(dem, i)};
    const double F[3] = {ps->ex[i], ps->ey[i], ps->ez[i]};

    for (int k = 0; k < 3; k++)
        t.a[k] = F[k] / t.m;
    t.rate = drag ? ps->drag_coefficient[i] / t.m : 0.0;
    for (int q = 0; q < KICKS; q++)
        t.gain[q] = implicit_drag_gain(t.rate * kicks->dt[q]);
    return t;
}

/* v += F/m dt [LS 4.1], with a drag -k v as in implicit_drag.h. */
static void no_contacts_kick(struct free_particle *t, double gain, double dt)
{
    for (int k = 0; k < 3; k++) {
        const double dv = gain * (t->a[k] - t->rate * t->v[k]) * dt;
        t->v[k] += dv;
        t->impulse[k] += t->m * (dv - t->a[k] * dt);
    }
}

/* Reflects a particle at a wall that it approaches: its distance beyond the
 * wall becomes e times that distance in front of it, as it would without
 * forces. */
static void rebound(struct free_particle *t, const struct box_domain *box)
{
    for (int w = 0; w < 6; w++) {
        const int k = w / 2;
        const double into = w % 2 ? 1.0 : -1.0;
        const double gap = box_domain_gap(box, w, t->x) - t->R;
        const double e = t->restitution;
        if (box->periodic[k] || gap >= 0.0 || into * t->v[k] <= 0.0) continue;
        t->lost += 0.5 * t->m * (1.0 - e * e) * t->v[k] * t->v[k];
        t->work += t->m * t->a[k] * (1.0 + e) * into * gap;
        t->x[k] += (1.0 + e) * into * gap;
        t->v[k] *= -e;
    }
}

static void no_contacts_drift(struct free_particle *t,
                              const struct box_domain *box, double dt)
{
    for (int k = 0; k < 3; k++) {
        t->x[k] += dt * t->v[k];
        t->work +=
            dt * t->m * (t->a[k] * t->v[k] - t->rate * t->v[k] * t->v[k]);
    }
    rebound(t, box);
}

/* Kick, drift, kick, drift, ... (integrator.h). Non-zero if a signal ended it
 * early. */
static int travel(struct free_particle *t, const struct box_domain *box,
                  const struct kicks *kicks, int steps)
{
    for (int k = 0; k < steps; k++) {
        if (k % LOOK == LOOK - 1 && interrupt_arrived()) return 1;
        const int q = k == 0 ? 0 : 1;
        no_contacts_kick(t, t->gain[q], kicks->dt[q]);
        no_contacts_drift(t, box, kicks->step);
    }
    if (steps > 0) no_contacts_kick(t, t->gain[2], kicks->dt[2]);
    return 0;
}

static void no_contacts_store(const struct free_particle *t,
                              const struct box_domain *box,
                              struct particles *ps, int i)
{
    ps->x[i] = box_domain_inside(box, 0, t->x[0]);
    ps->y[i] = box_domain_inside(box, 1, t->x[1]);
    ps->z[i] = box_domain_inside(box, 2, t->x[2]);
    ps->vx[i] = t->v[0], ps->vy[i] = t->v[1], ps->vz[i] = t->v[2];
    for (int k = 0; k < 3 && ps->drag_impulse != NULL; k++)
        ps->drag_impulse[3 * i + k] += t->impulse[k];
}

/* --- the sums of a run ---------------------------------------------------- */

static double no_contacts_kinetic(const struct particles *ps, int i, double m)
{
    const double v2 =
        ps->vx[i] * ps->vx[i] + ps->vy[i] * ps->vy[i] + ps->vz[i] * ps->vz[i];
    return 0.5 * m * v2;
}

static double rotation(const struct particles *ps, int i)
{
    const double w2 =
        ps->wx[i] * ps->wx[i] + ps->wy[i] * ps->wy[i] + ps->wz[i] * ps->wz[i];
    return 0.05 * ps->m[i] * ps->d[i] * ps->d[i] * w2;
}

/* Wholly outside, or not finite: a comparison with NaN is false. */
static int no_contacts_is_lost(const struct box_domain *box,
                               const struct particles *ps, int i)
{
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};

    for (int w = 0; w < 6; w++) {
        const double gap = box_domain_gap(box, w, x);
        if (!(box->periodic[w / 2] ? fabs(gap) < HUGE_VAL
                                   : gap >= -0.5 * ps->d[i]))
            return 1;
    }
    return !(no_contacts_kinetic(ps, i, 1.0) + rotation(ps, i) < HUGE_VAL);
}

static void no_contacts_measure(const struct particles *ps,
                                const struct box_domain *box,
                                struct dem_report *r)
{
    r->lost_id = r->lost_through = -1;
    for (int i = 0; i < ps->n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        r->max_speed =
            fmax(r->max_speed, sqrt(2.0 * no_contacts_kinetic(ps, i, 1.0)));
        r->translation += no_contacts_kinetic(ps, i, ps->m[i]);
        r->rotation += rotation(ps, i);
        if (!no_contacts_is_lost(box, ps, i) || r->lost++ > 0) continue;
        r->lost_id = ps->id[i];
        memcpy(r->lost_at, x, sizeof x);
    }
}

static double all_kinetic(const struct particles *ps)
{
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum +=
            no_contacts_kinetic(
                ps, i,
                ps->m[i] + (ps->added_mass != NULL ? ps->added_mass[i] : 0.0)) +
            rotation(ps, i);
    return sum;
}

/* One thread adds up the budget, in the order of the particles. Returns how
 * many of them a signal has stopped. */
static int move_all(struct dem *dem, const struct box_domain *box, int steps)
{
    struct particles *const ps = dem->ps;
    struct energy *const e = dem->energy;
    const struct kicks kicks = kicks_of(&dem->options);
    int stopped = 0;

#pragma omp parallel for schedule(static) reduction(+ : stopped)               \
    if (ps->n >= MANY && e == NULL)
    for (int i = 0; i < ps->n; i++) {
        struct free_particle t = free_particle_of(dem, i, &kicks);
        stopped += i % MANY == MANY - 1 && interrupt_arrived();
        if (stopped > 0) continue;
        stopped += travel(&t, box, &kicks, steps);
        no_contacts_store(&t, box, ps, i);
        if (e == NULL) continue;
        e->work += t.work;
        e->damped_n += t.lost;
    }
    return stopped;
}

static void no_contacts_run(struct dem *dem, int steps, struct dem_report *r)
{
    const struct box_domain *const box = dem->state;
    struct energy *const e = dem->energy;

    *r = (struct dem_report){.steps = steps};
    if (e != NULL) {
        const double before = energy_residual(e);
        e->kinetic = all_kinetic(dem->ps);
        e->added += energy_residual(e) - before;
    }
    if (move_all(dem, box, steps) > 0) r->steps = 0;
    if (e != NULL) e->kinetic = all_kinetic(dem->ps);
    no_contacts_measure(dem->ps, box, r);
    dem->motion_steps += dem->motion_on ? steps : 0;
}

/* --- the other functions of dem_method.h ---------------------------------- */

static const char *no_contacts_unsupported(const struct dem_options *o)
{
    if (o->n_surfaces > 0) return "surfaces";
    if (o->n_prescribed > 0) return "prescribed particles";
    if (o->n_attractions > 0) return "forces between particles at a distance";
    if (o->integrator != NULL && o->integrator->predicts)
        return "integrators that compute the forces twice";
    return NULL;
}

static int no_contacts_create(struct dem *dem)
{
    const struct dem_options *const o = &dem->options;
    struct box_domain *const box = dem->state = alloc_zeroed(1, sizeof *box);

    *box = box_domain_of(o->lo, o->hi, o->periodic);
    return 0;
}

static void no_contacts_release(struct dem *dem)
{
    free(dem->state);
}

static void no_contacts_nothing(struct dem *dem)
{
    (void)dem; /* no list, no histories, no overlaps */
}

static void nothing_to_visit(struct dem *dem, struct state *s)
{
    (void)dem, (void)s;
}

static struct dem_history *no_histories(struct dem *dem, int *n)
{
    (void)dem;
    *n = 0;
    return NULL;
}

static void no_springs_back(struct dem *dem, const struct dem_history *list,
                            int n, const int *index)
{
    (void)dem, (void)list, (void)n, (void)index;
}

const struct dem_method no_contacts_method = {
    .name = "none",
    .what = "no contacts between particles; walls reflect them",
    .equations = "LS 4.1",
    .function = "travel",
    .no_contacts = 1,
    .unsupported = no_contacts_unsupported,
    .create = no_contacts_create,
    .free = no_contacts_release,
    .run = no_contacts_run,
    .changed = no_contacts_nothing,
    .limit_overlap = no_contacts_nothing,
    .visit = nothing_to_visit,
    .histories = no_histories,
    .restore_histories = no_springs_back};
