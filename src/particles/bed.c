/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/bed.h"

#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdio.h>

static double size_of(const double g[3])
{
    return sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
}

/* The direction along which to fill, and from which end: where gravity points,
 * else y from below. */
static int upward(const double g[3], int *from_high)
{
    int up = 1;

    for (int a = 0; a < 3; a++)
        if (fabs(g[a]) > fabs(g[up])) up = a;
    *from_high = g[up] > 0.0;
    return up;
}

/* --- the lattice ------------------------------------------------------------
 */

struct lattice {
    int up, from_high;
    int n[3];        /* [-] places per direction */
    double pitch[3]; /* [m] */
};

/* Places at least 1.05 d apart, spread evenly over the width of the box; as
 * many layers as are needed. */
static int plan_lattice(const struct bed_options *b,
                        const struct dem_options *o, struct lattice *l)
{
    const double d = b->diameter, least = 1.05 * d;
    int layer = 1;

    l->up = upward(b->gravity, &l->from_high);
    for (int a = 0; a < 3; a++) {
        const double length = o->high[a] - o->low[a];
        l->n[a] = (int)floor(length / least + 1e-9);
        if (l->n[a] < 1 && length >= d) l->n[a] = 1; /* one layer just fits */
        l->pitch[a] = a == l->up ? least : length / fmax(1, l->n[a]);
        if (a != l->up) layer *= l->n[a];
    }
    return layer > 0 && (b->count + layer - 1) / layer <= l->n[l->up];
}

int bed_fill(struct particles *ps, const struct bed_options *b,
             const struct dem_options *o)
{
    struct lattice l;

    if (b->count == 0) return 0;
    if (!plan_lattice(b, o, &l)) {
        fprintf(stderr,
                "winnow: %d spheres of %g m do not fit into the box; a loose "
                "lattice has room for %d\n",
                b->count, b->diameter, l.n[0] * l.n[1] * l.n[2]);
        return 1;
    }
    const int a1 = (l.up + 1) % 3, a2 = (l.up + 2) % 3;
    gsl_rng *const random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, (unsigned long)b->seed);
    for (int k = 0; k < b->count; k++) {
        int at[3];
        double x[3];
        at[a1] = k % l.n[a1];
        at[a2] = k / l.n[a1] % l.n[a2];
        at[l.up] = k / (l.n[a1] * l.n[a2]);
        for (int a = 0; a < 3; a++) {
            const double room = 0.5 * (l.pitch[a] - b->diameter) * b->jitter;
            const double away = (at[a] + 0.5) * l.pitch[a] +
                                room * (2.0 * gsl_rng_uniform(random) - 1.0);
            x[a] =
                a == l.up && l.from_high ? o->high[a] - away : o->low[a] + away;
        }
        particles_add(ps, x, b->diameter, b->density);
    }
    gsl_rng_free(random);
    return 0;
}

/* --- settling
 * ----------------------------------------------------------------- */

static double kinetic_energy(const struct particles *ps)
{
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += 0.5 * ps->m[i] *
               (ps->vx[i] * ps->vx[i] + ps->vy[i] * ps->vy[i] +
                ps->vz[i] * ps->vz[i]);
    return sum;
}

static void weigh(struct particles *ps, const double g[3])
{
    for (int i = 0; i < ps->n; i++) {
        ps->ex[i] = ps->m[i] * g[0];
        ps->ey[i] = ps->m[i] * g[1];
        ps->ez[i] = ps->m[i] * g[2];
    }
}

static void stop(struct particles *ps)
{
    for (int i = 0; i < ps->n; i++) {
        ps->vx[i] = ps->vy[i] = ps->vz[i] = 0.0;
        ps->wx[i] = ps->wy[i] = ps->wz[i] = 0.0;
        ps->ex[i] = ps->ey[i] = ps->ez[i] = 0.0;
    }
}

static void measure(const struct particles *ps, const struct bed_options *b,
                    const struct dem_options *o, struct bed_report *r)
{
    int from_high;
    const int up = upward(b->gravity, &from_high);
    const double *const x = up == 0 ? ps->x : up == 1 ? ps->y : ps->z;
    double section = 1.0, solids = 0.0;

    r->height = 0.0;
    for (int i = 0; i < ps->n; i++) {
        const double h = from_high ? o->high[up] - x[i] : x[i] - o->low[up];
        r->height = fmax(r->height, h + 0.5 * ps->d[i]);
    }
    for (int i = 0; i < ps->n; i++) {
        const double h = from_high ? o->high[up] - x[i] : x[i] - o->low[up];
        if (h < 0.5 * r->height) solids += particles_volume(ps, i);
    }
    for (int a = 0; a < 3; a++)
        if (a != up) section *= o->high[a] - o->low[a];
    r->fraction = r->height > 0.0 ? solids / (0.5 * r->height * section) : 0.0;
}

/* At rest: a particle has a millionth of the energy that lifts it by d. */
int bed_settle(struct particles *ps, const struct bed_options *b,
               const struct dem_options *o, struct bed_report *r)
{
    enum { LOOK = 100 }; /* steps between two looks */
    const double g = size_of(b->gravity), quiet = 1e-6;
    struct dem_options soft = *o;
    struct dem_report report = {.lost = 0};
    long steps = 0;

    *r = (struct bed_report){0.0, 0.0, 0.0, 0.0};
    soft.material.restitution = fmin(o->material.restitution, 0.2);
    struct dem *const dem = dem_create(ps, &soft);
    weigh(ps, b->gravity);
    while (g > 0.0 && ps->n > 0 && (double)steps * o->step < b->settle &&
           report.lost == 0) {
        dem_run(dem, LOOK, &report);
        steps += LOOK;
        r->kinetic_energy =
            kinetic_energy(ps) / (ps->n * ps->m[0] * g * b->diameter);
        if (r->kinetic_energy < quiet && (double)steps * o->step > 0.02) break;
    }
    r->time = (double)steps * o->step;
    dem_free(dem);
    stop(ps);
    measure(ps, b, o, r);
    if (report.lost == 0) return 0;
    fprintf(stderr,
            "winnow: %d particles left the box while the bed settled, the "
            "first with id %d; try a smaller particles.step\n",
            report.lost, report.lost_id);
    return 1;
}
