/* SPDX-License-Identifier: GPL-3.0-or-later */
/* spheres.c -- what LAMMPS is told, and what is taken from it.
 *
 * At the end of a run LAMMPS has the force f at that time, the outside part F
 * included, and begins the next with half a kick of it. So a new F is written
 * to its fix external, and F_new - F_old is added to f: the impulse of N steps
 * is N dt F, to rounding.
 *
 * Of LAMMPS 29 Sep 2021, measured: a run that begins with `pre yes` applies
 * Tsuji's polynomial again to the dashpots of the walls, so only the first one
 * does; and opening it sets the number of our threads to 1. */
#include "distributed/ranks/spheres.h"

#include <assert.h>
#include <math.h>
#include <omp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LAMMPS_LIB_MPI
#include <lammps/library.h>

#include "base/alloc.h"
#include "dem/dem_internal.h"
#include "distributed/ranks/spheres_internal.h"

/* What LAMMPS knows of a sphere by itself; all else is kept beside it. */
static const char told[] = "count next_id id material x y z vx vy vz wx wy wz d"
                           " m ex ey ez cfx cfy cfz";
/* And at the end of a row: f, torque and F of the last step, and the rank that
 * first had the sphere. */
enum { EXTRA = 10, AT_ONCE = 20000, OWN = 12 };

static void tell_line(void *lammps, const char *line)
{
    lammps_command(lammps, line);
}

static void tell(struct spheres *q, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
static void tell(struct spheres *q, const char *format, ...)
{
    char line[4096];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    tell_line(q->lammps, line);
}

double **spheres_rows(const struct spheres *q, const char *name)
{
    return lammps_extract_atom(q->lammps, name);
}

int spheres_count(const struct spheres *q)
{
    return *(int *)lammps_extract_global(q->lammps, "nlocal");
}

/* --- beginning ------------------------------------------------------------ */

static void open_lammps(struct spheres *q)
{
    char *words[] = {"winnow", "-log", "none", "-screen", "none", "-nocite"};
    const int threads = omp_get_max_threads();

    q->lammps = lammps_open(6, words, q->comm, NULL);
    omp_set_num_threads(threads);
    words_begin(&q->w, tell_line, q->lammps);
    tell(q, "atom_modify map hash");
    tell(q, "processors %d %d %d map xyz", q->p->P[0], q->p->P[1], q->p->P[2]);
}

static void keep(struct spheres *q)
{
    tell(q, "fix kept all property/atom d2_kept %d", q->width);
}

/* LAMMPS cuts the box where the cells are cut. */
static void cut(struct spheres *q)
{
    char line[4096] = "balance 1.0";
    size_t n = strlen(line);

    if (q->p->size == 1) return;
    for (int k = 0; k < 3; k++) {
        if (q->p->P[k] == 1) continue;
        n += (size_t)snprintf(line + n, sizeof line - n, " %c", 'x' + k);
        for (int r = 1; r < q->p->P[k]; r++)
            n += (size_t)snprintf(line + n, sizeof line - n, " %.17g",
                                  (double)q->p->cut[k][r] / q->p->N[k]);
    }
    tell(q, "%s", line);
}

/* The rows of some particles, as they are sent: what LAMMPS has, and the kept
 * ones. */
static void pack(const struct spheres *q, const struct particles *ps,
                 const struct arrays *all, int first, int n, double *row)
{
    for (int i = first; i < first + n; i++, row += OWN + q->width) {
        const double own[OWN] = {
            ps->x[i],  ps->y[i],
            ps->z[i],  ps->vx[i],
            ps->vy[i], ps->vz[i],
            ps->wx[i], ps->wy[i],
            ps->wz[i], ps->d[i],
            ps->m[i],  ps->material != NULL ? ps->material[i] + 1.0 : 1.0};
        double *to = row + OWN;
        memcpy(row, own, sizeof own);
        for (int k = 0; k < all->n; k++) {
            const int w = all->at[k].width;
            if (arrays_named(all->name[k], told)) continue;
            memcpy(to, (const double *)all->at[k].values + (long)w * i,
                   (size_t)w * sizeof *to);
            to += w;
        }
        assert(to == row + OWN + q->width - EXTRA);
    }
}

/* Sends some of the spheres to all ranks, each of which creates those within
 * its part of the box; their ids in LAMMPS begin at 1. */
static void create(struct spheres *q, const int *id, int n, double *row)
{
    const int width = OWN + q->width, before = spheres_count(q);
    double *const x = alloc_doubles(3 * n);
    int *const type = alloc_ints(n), *const place =
                                         alloc_ints(q->dem->ps->next_id);

    for (int i = 0; i < n; i++) {
        memcpy(&x[3 * i], &row[(long)width * i], 3 * sizeof *x);
        type[i] = (int)row[(long)width * i + 11];
        place[id[i] - 1] = i;
    }
    lammps_create_atoms(q->lammps, n, id, type, x, NULL, NULL, 0);
    double **const v = spheres_rows(q, "v"),
                   **const omega = spheres_rows(q, "omega");
    double **const kept = spheres_rows(q, "d2_kept");
    double *const R = lammps_extract_atom(q->lammps, "radius");
    double *const m = lammps_extract_atom(q->lammps, "rmass");
    const int *const tag = lammps_extract_atom(q->lammps, "id");
    for (int i = before; i < spheres_count(q); i++) {
        const double *const r = &row[(long)width * place[tag[i] - 1]];
        memcpy(v[i], r + 3, 3 * sizeof *r);
        memcpy(omega[i], r + 6, 3 * sizeof *r);
        R[i] = 0.5 * r[9];
        m[i] = r[10];
        memcpy(kept[i], r + OWN, (size_t)q->width * sizeof *r);
        kept[i][q->width - 1] = q->p->rank;
    }
    free(x);
    free(type);
    free(place);
}

static void send_all(struct spheres *q, const struct particles *all)
{
    struct arrays list;
    struct particles *own;
    double *const row = alloc_doubles(AT_ONCE * (OWN + q->width));
    int *const id = alloc_ints(AT_ONCE);
    int n = all != NULL ? all->n : 0;

    memcpy(&own, &all, sizeof own); /* a visit that reads */
    if (all != NULL) arrays_of_particles(own, &list);
    MPI_Bcast(&n, 1, MPI_INT, 0, q->comm);
    for (int first = 0; first < n; first += AT_ONCE) {
        const int some = n - first < AT_ONCE ? n - first : AT_ONCE;
        if (all != NULL) pack(q, all, &list, first, some, row);
        for (int i = 0; i < some && all != NULL; i++)
            id[i] = all->id[first + i] + 1;
        MPI_Bcast(id, some, MPI_INT, 0, q->comm);
        MPI_Bcast(row, some * (OWN + q->width), MPI_DOUBLE, 0, q->comm);
        create(q, id, some, row);
    }
    free(row);
    free(id);
}

/* --- taking and giving ---------------------------------------------------- */

/* The spheres of this rank, as LAMMPS has them now. Returns how many are
 * outside the box or, beyond what there is room for, cannot be taken. */
static int pull(struct spheres *q)
{
    struct particles *const ps = q->dem->ps;
    double **const x = spheres_rows(q, "x"), **const v = spheres_rows(q, "v");
    double **const omega = spheres_rows(q, "omega"),
                   **const kept = spheres_rows(q, "d2_kept");
    const double *const R = lammps_extract_atom(q->lammps, "radius");
    const double *const m = lammps_extract_atom(q->lammps, "rmass");
    const int *const tag = lammps_extract_atom(q->lammps, "id");
    const int *const type = lammps_extract_atom(q->lammps, "type");
    const int there = spheres_count(q);

    ps->n = there < ps->capacity ? there : ps->capacity;
    for (int i = 0; i < ps->n; i++) {
        const double *from = kept[i];
        ps->x[i] = x[i][0], ps->y[i] = x[i][1], ps->z[i] = x[i][2];
        ps->vx[i] = v[i][0], ps->vy[i] = v[i][1], ps->vz[i] = v[i][2];
        ps->wx[i] = omega[i][0], ps->wy[i] = omega[i][1];
        ps->wz[i] = omega[i][2];
        ps->d[i] = 2.0 * R[i], ps->m[i] = m[i], ps->id[i] = tag[i] - 1;
        if (ps->material != NULL) ps->material[i] = type[i] - 1;
        for (int k = 0; k < q->kept.n; k++) {
            const int w = q->kept.at[k].width;
            memcpy((double *)q->kept.at[k].values + (long)w * i, from,
                   (size_t)w * sizeof *from);
            from += w;
        }
    }
    return there - ps->n;
}

/* The outside force, and what is kept, to LAMMPS. */
static void push(struct spheres *q)
{
    const struct particles *const ps = q->dem->ps;
    double **const F = lammps_fix_external_get_force(q->lammps, "push");
    double **const f = spheres_rows(q, "f"),
                   **const kept = spheres_rows(q, "d2_kept");

    for (int i = 0; i < ps->n; i++) {
        const double now[3] = {ps->ex[i], ps->ey[i], ps->ez[i]};
        double *to = kept[i];
        for (int k = 0; k < 3; k++) {
            f[i][k] += now[k] - F[i][k];
            F[i][k] = now[k];
        }
        for (int k = 0; k < q->kept.n; k++) {
            const int w = q->kept.at[k].width;
            memcpy(to, (const double *)q->kept.at[k].values + (long)w * i,
                   (size_t)w * sizeof *to);
            to += w;
        }
    }
}

static void run(struct dem *dem, int steps, struct dem_report *r)
{
    struct spheres *const q = dem->state;

    *r = (struct dem_report){.steps = steps, .lost_through = -1};
    push(q);
    tell(q, "run %d pre no post no", steps);
    spheres_report(q, pull(q), r);
}

/* --- starting ------------------------------------------------------------- */

/* Contacts, walls and motion. */
static void equip(struct spheres *q)
{
    words_contacts(&q->w, tell_line, q->lammps);
    tell(q, "fix push all external pf/array 1");
    tell(q, "fix move all nve/sphere");
    tell(q, "thermo 0");
}

/* The first run, which computes the forces. */
static void start(struct spheres *q)
{
    double own[2];

    tell(q, "run 0 post no");
    pull(q);
    own[0] = q->dem->ps->n;
    own[1] = 0.0;
    for (int i = 0; i < q->dem->ps->n; i++)
        own[1] += q->dem->ps->id[i];
    MPI_Allreduce(MPI_IN_PLACE, own, 2, MPI_DOUBLE, MPI_SUM, q->comm);
    q->all = (long)own[0];
    q->id_sum = (long)own[1];
}

void spheres_place(struct spheres *q, const struct particles *all)
{
    open_lammps(q);
    words_box(&q->w, tell_line, q->lammps);
    keep(q);
    send_all(q, all);
    cut(q);
    equip(q);
    start(q);
}

/* f, torque and F, to the end of a row and back. */
static void exchange_forces(struct spheres *q, int to_row)
{
    double **const F = lammps_fix_external_get_force(q->lammps, "push");
    double **const from[3] = {spheres_rows(q, "f"), spheres_rows(q, "torque"),
                              F};
    double **const kept = spheres_rows(q, "d2_kept");

    for (int i = 0; i < spheres_count(q); i++)
        for (int k = 0; k < 9; k++) {
            double *const row = &kept[i][q->width - EXTRA + k];
            double *const value = &from[k / 3][i][k % 3];
            if (to_row)
                *row = *value;
            else
                *value = *row;
        }
}

void spheres_load(struct spheres *q, const char *file)
{
    open_lammps(q);
    tell(q, "read_restart %s", file);
    keep(q);
    q->w.starts = q->p->size > 1 ? 2 : 1;
    equip(q); /* before the cut, whose start drops what nobody has claimed */
    cut(q);
    start(q);
    exchange_forces(q, 0);
}

void spheres_save(struct spheres *q, const char *file)
{
    push(q);
    exchange_forces(q, 1);
    tell(q, "write_restart %s noinit", file);
}

long spheres_moved(const struct spheres *q)
{
    double **const kept = spheres_rows(q, "d2_kept");
    long moved = 0;

    for (int i = 0; i < spheres_count(q); i++)
        moved += kept[i][q->width - 1] != q->p->rank;
    MPI_Allreduce(MPI_IN_PLACE, &moved, 1, MPI_LONG, MPI_SUM, q->comm);
    return moved;
}

struct spheres *spheres_create(struct dem *dem, const struct partition *p,
                               const struct words *w, MPI_Comm comm)
{
    struct spheres *const q = alloc_zeroed(1, sizeof *q);
    struct arrays *const a = &q->kept;
    struct arrays all;

    q->dem = dem;
    q->p = p;
    q->w = *w;
    q->comm = comm;
    dem->state = q;
    arrays_of_particles(dem->ps, &all);
    for (int k = 0; k < all.n; k++) {
        if (arrays_named(all.name[k], told)) continue;
        q->width += all.at[k].width;
        a->at[a->n++] = all.at[k];
    }
    q->width += EXTRA;
    return q;
}

/* --- the method ----------------------------------------------------------- */

static void release(struct dem *dem)
{
    struct spheres *const q = dem->state;

    if (q != NULL && q->lammps != NULL) lammps_close(q->lammps);
    free(q);
}

static const char *unknown(const struct dem_options *o)
{
    (void)o; /* distributed/refusal.h has looked at the case */
    return NULL;
}

static double skin(const struct dem_options *o, double mean)
{
    return o->skin > 0.0 ? o->skin : mean / 6.0;
}

static int create_later(struct dem *dem)
{
    (void)dem; /* spheres_create */
    return 0;
}

static void changed(struct dem *dem)
{
    (void)dem;
}

const struct dem_method spheres_method = {.name = "lammps",
                                          .what = "by LAMMPS, on all ranks",
                                          .equations = "",
                                          .function = "spheres_place",
                                          .unknown = unknown,
                                          .skin = skin,
                                          .create = create_later,
                                          .free = release,
                                          .run = run,
                                          .changed = changed,
                                          .limit_overlap = changed};
