/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/dem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "particles/neighbours.h"

struct dem {
    struct particles *ps;
    struct dem_options options;
    struct contact_constants constants;
    struct neighbours *neighbours;
    double *load[6];  /* [N], [N m] contact forces and torques, attached */
    double *spill[6]; /* the same, from the strip before */
    double *fastest;  /* [m^2/s^2] speed squared, of each strip */
    double travel;    /* [m] nobody has moved further since the last look */
    int listed;       /* 0: no list yet */
    struct dem_report report;
};

static double largest(const struct particles *ps)
{
    double d = 0.0;

    for (int i = 0; i < ps->n; i++)
        d = fmax(d, ps->d[i]);
    return d > 0.0 ? d : 1.0;
}

struct dem *dem_create(struct particles *ps, const struct dem_options *o)
{
    struct dem *const dem = alloc_zeroed(1, sizeof *dem);
    const double d_max = largest(ps);

    dem->ps = ps;
    dem->options = *o;
    if (o->skin <= 0.0) dem->options.skin = 0.3 * d_max;
    dem->constants = o->law->constants(&o->material);
    dem->neighbours = neighbours_create(ps, o->low, o->high, o->periodic,
                                        dem->options.skin, d_max);
    for (int a = 0; a < 6; a++) {
        dem->load[a] = alloc_doubles(ps->capacity);
        dem->spill[a] = alloc_doubles(ps->capacity);
        particles_attach(ps, dem->load[a], 1);
    }
    dem->fastest = alloc_doubles(MOST_STRIPS);
    dem->report.lost_id = -1;
    return dem;
}

void dem_free(struct dem *dem)
{
    if (dem == NULL) return;
    for (int a = 0; a < 6; a++) {
        particles_detach(dem->ps, dem->load[a]);
        free(dem->load[a]);
        free(dem->spill[a]);
    }
    neighbours_free(dem->neighbours);
    free(dem->fastest);
    free(dem);
}

void dem_forget(struct dem *dem)
{
    dem->listed = 0;
    for (int e = 0; e < dem->neighbours->pairs.n; e++)
        pair_list_forget(&dem->neighbours->pairs, e);
    for (int e = 0; e < dem->neighbours->walls.n; e++)
        pair_list_forget(&dem->neighbours->walls, e);
}

/* --- integration --------------------------------------------------------- */

/* Velocities of particles first .. last - 1 by the present forces for dt; I =
 * m d^2 / 10 [LS 4.1]. */
static void kick(struct dem *dem, int first, int last, double dt)
{
    struct particles *const ps = dem->ps;
    double *const *const F = dem->load;

    for (int i = first; i < last; i++) {
        const double per_m = dt / ps->m[i];
        const double per_I = 10.0 * per_m / (ps->d[i] * ps->d[i]);
        ps->vx[i] += (F[0][i] + ps->ex[i]) * per_m;
        ps->vy[i] += (F[1][i] + ps->ey[i]) * per_m;
        ps->vz[i] += (F[2][i] + ps->ez[i]) * per_m;
        ps->wx[i] += F[3][i] * per_I;
        ps->wy[i] += F[4][i] * per_I;
        ps->wz[i] += F[5][i] * per_I;
    }
}

/* Positions; returns the square of the highest speed. */
static double drift(struct particles *ps, int first, int last, double dt)
{
    double most = 0.0;

    for (int i = first; i < last; i++) {
        const double v2 = ps->vx[i] * ps->vx[i] + ps->vy[i] * ps->vy[i] +
                          ps->vz[i] * ps->vz[i];
        ps->x[i] += ps->vx[i] * dt;
        ps->y[i] += ps->vy[i] * dt;
        ps->z[i] += ps->vz[i] * dt;
        most = v2 > most ? v2 : most;
    }
    return most;
}

/* Kick and drift of all strips; nobody has then moved further than the fastest
 * times dt. */
static void move(struct dem *dem, double kick_time)
{
    const struct pair_list *const l = &dem->neighbours->pairs;
    const double dt = dem->options.step;
    double most = 0.0;

#pragma omp parallel for schedule(static)
    for (int s = 0; s < l->n_strips; s++) {
        const int first = l->particle_start[s], last = l->particle_start[s + 1];
        kick(dem, first, last, kick_time);
        dem->fastest[s] = drift(dem->ps, first, last, dt);
    }
    for (int s = 0; s < l->n_strips; s++)
        most = fmax(most, dem->fastest[s]);
    dem->report.max_speed = sqrt(most);
    dem->travel += dem->report.max_speed * dt;
}

/* --- forces -------------------------------------------------------------- */

static void clear_loads(struct dem *dem, int first, int last)
{
    const size_t size = (size_t)(last - first) * sizeof(double);

    for (int a = 0; a < 6; a++) {
        memset(&dem->load[a][first], 0, size);
        memset(&dem->spill[a][first], 0, size);
    }
}

/* The forces within a strip and on the next one; springs follow for dt. */
static void strip_force(struct dem *dem, int s, double dt,
                        struct strip_forces *f)
{
    const struct contact_law *const law = dem->options.law;
    const int *const periodic = dem->options.periodic;

    for (int a = 0; a < 6; a++) {
        f->own[a] = dem->load[a];
        f->spill[a] = dem->spill[a];
    }
    f->contacts = 0;
    f->max_overlap = 0.0;
    (periodic[0] || periodic[1] || periodic[2] ? law->pairs_periodic
                                               : law->pairs)(
        &dem->constants, dt, dem->ps, &dem->neighbours->pairs, s, f);
    law->walls(&dem->constants, dt, dem->ps, &dem->neighbours->walls, s, f);
}

static void add_spill(struct dem *dem, int first, int last)
{
    for (int a = 0; a < 6; a++)
        for (int i = first; i < last; i++)
            dem->load[a][i] += dem->spill[a][i];
}

static void forces(struct dem *dem, double dt)
{
    const struct pair_list *const l = &dem->neighbours->pairs;
    struct strip_forces f[MOST_STRIPS];

#pragma omp parallel
    {
#pragma omp for schedule(static)
        for (int s = 0; s < l->n_strips; s++)
            clear_loads(dem, l->particle_start[s], l->particle_start[s + 1]);
#pragma omp for schedule(static)
        for (int s = 0; s < l->n_strips; s++)
            strip_force(dem, s, dt, &f[s]);
#pragma omp for schedule(static)
        for (int s = 0; s < l->n_strips; s++)
            add_spill(dem, l->particle_start[s], l->particle_start[s + 1]);
    }
    dem->report.contacts = 0;
    for (int s = 0; s < l->n_strips; s++) {
        dem->report.contacts += f[s].contacts;
        dem->report.max_overlap =
            fmax(dem->report.max_overlap, f[s].max_overlap);
    }
}

/* --- the list ------------------------------------------------------------ */

/* Lost: its surface has left the box (its centre by a whole period, where the
 * box is periodic), or position or velocity is not a number. */
static int is_lost(const struct dem *dem, int i)
{
    const struct particles *const ps = dem->ps;
    const struct dem_options *const o = &dem->options;
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
    const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};

    for (int a = 0; a < 3; a++) {
        const double margin =
            o->periodic[a] ? o->high[a] - o->low[a] : 0.5 * ps->d[i];
        if (!isfinite(v[a]) || !(x[a] > o->low[a] - margin) ||
            !(x[a] < o->high[a] + margin))
            return 1;
    }
    return 0;
}

static int count_lost(struct dem *dem)
{
    const struct particles *const ps = dem->ps;
    struct dem_report *const r = &dem->report;

    r->lost = 0;
    for (int i = 0; i < ps->n; i++) {
        if (!is_lost(dem, i) || r->lost++ > 0) continue;
        r->lost_id = ps->id[i];
        r->lost_at[0] = ps->x[i];
        r->lost_at[1] = ps->y[i];
        r->lost_at[2] = ps->z[i];
    }
    return r->lost;
}

/* The list is good until somebody has moved half the skin. The fastest times
 * dt, added up, bounds that; when the bound is used up we measure. */
static int keep_list(struct dem *dem)
{
    const double most = 0.5 * dem->options.skin;

    if (dem->listed && dem->travel < most) return 0;
    if (count_lost(dem) > 0) return 1;
    if (dem->listed) {
        dem->travel = neighbours_moved(dem->neighbours, dem->ps);
        if (dem->travel + 2.0 * dem->report.max_speed * dem->options.step <
            most)
            return 0;
    }
    neighbours_rebuild(dem->neighbours, dem->ps);
    dem->report.rebuilds++;
    dem->travel = 0.0;
    dem->listed = 1;
    return 0;
}

/* The first list, and the forces of contacts that exist from the start; no
 * time has passed in them. */
static int begin(struct dem *dem)
{
    if (dem->listed) return 0;
    if (keep_list(dem) != 0) return 1;
    forces(dem, 0.0);
    return 0;
}

int dem_run(struct dem *dem, int steps, struct dem_report *report)
{
    const double dt = dem->options.step;

    dem->report.max_overlap = 0.0;
    int failed = begin(dem);
    for (int k = 0; k < steps && !failed; k++) {
        move(dem, k == 0 ? 0.5 * dt : dt); /* two half kicks are one */
        failed = keep_list(dem);
        if (failed) break;
        forces(dem, dt);
        dem->report.steps++;
    }
    if (!failed && steps > 0) kick(dem, 0, dem->ps->n, 0.5 * dt);
    if (!failed) failed = count_lost(dem) > 0;
    *report = dem->report;
    return failed;
}
