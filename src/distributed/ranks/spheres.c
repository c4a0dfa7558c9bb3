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
#include "base/alloc.h"
#include "base/vector.h"
#include "dem/dem_method.h"
#include "distributed/ranks/spheres.h"

#include <math.h>
#include <omp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LAMMPS_LIB_MPI
#include <lammps/library.h>

/* What LAMMPS knows of a sphere by itself; all else is kept beside it. */
static const char told[] = " count next_id id material x y z vx vy vz wx wy wz "
                           "d m ex ey ez cfx cfy cfz ";
/* At the end of a row: f, torque and F of the last step, and the rank that
 * first had the sphere. */
enum { EXTRA = 10 };

static void tell_lammps(void *lammps, const char *line)
{
    lammps_command(lammps, line);
}

/* Tells LAMMPS one line. */
__attribute__((format(printf, 2, 3))) static void
spheres_tell(const struct spheres *q, const char *format, ...)
{
    char line[4096];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    lammps_command(q->lammps, line);
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

struct spheres *spheres_create(const struct partition *p, const struct words *w,
                               const char *file, MPI_Comm comm)
{
    char *words[] = {"winnow", "-log", "none", "-screen", "none", "-nocite"};
    const int threads = omp_get_max_threads();
    struct spheres *const q = owner_create(sizeof *q);

    q->p = p;
    q->w = *w;
    q->comm = comm;
    q->loaded = file != NULL;
    q->lammps = lammps_open(6, words, comm, NULL);
    omp_set_num_threads(threads);
    words_begin(w, tell_lammps, q->lammps);
    spheres_tell(q, "atom_modify map hash");
    spheres_tell(q, "processors %d %d %d map xyz", p->P[0], p->P[1], p->P[2]);
    if (q->loaded)
        spheres_tell(q, "read_restart %s", file);
    else
        words_box(w, tell_lammps, q->lammps);
    return q;
}

void spheres_free(struct spheres *q)
{
    if (q == NULL) return;
    lammps_close(q->lammps);
    owner_free(q);
}

/* LAMMPS keeps the order of those that it takes; its ids begin at 1. */
void spheres_add(struct spheres *q, int n, const struct sphere *s)
{
    const int before = spheres_count(q);
    double *const x = alloc_doubles(3 * n);
    int *const type = alloc_ints(n), *const id = alloc_ints(n);

    for (int i = 0; i < n; i++) {
        memcpy(&x[3 * i], s[i].x, sizeof s[i].x);
        type[i] = s[i].type;
        id[i] = s[i].id + 1;
    }
    lammps_create_atoms(q->lammps, n, id, type, x, NULL, NULL, 0);
    double **const v = spheres_rows(q, "v"),
                   **const omega = spheres_rows(q, "omega");
    double *const R = lammps_extract_atom(q->lammps, "radius");
    double *const m = lammps_extract_atom(q->lammps, "rmass");
    const int *const tag = lammps_extract_atom(q->lammps, "id");
    for (int i = before, k = 0; i < spheres_count(q); i++) {
        while (id[k] != tag[i])
            k++;
        memcpy(v[i], s[k].v, sizeof s[k].v);
        memcpy(omega[i], s[k].w, sizeof s[k].w);
        R[i] = 0.5 * s[k].d;
        m[i] = s[k].m;
    }
    free(x);
    free(type);
    free(id);
}

/* LAMMPS cuts the box where the cells are cut. */
static void spheres_cut(struct spheres *q)
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
    spheres_tell(q, "%s", line);
}

/* Contacts, walls and motion; and how they end. */
static void spheres_equip(struct spheres *q, const struct words *w)
{
    q->w = *w;
    words_contacts(w, tell_lammps, q->lammps);
    spheres_tell(q, "fix push all external pf/array 1");
    spheres_tell(q, "fix move all nve/sphere");
    spheres_tell(q, "thermo 0");
}

static void spheres_strip(struct spheres *q)
{
    words_no_walls(&q->w, tell_lammps, q->lammps);
    spheres_tell(q, "unfix push");
    spheres_tell(q, "unfix move");
}

/* --- taking and giving ---------------------------------------------------- */

/* The kept numbers of sphere i to LAMMPS' row, or the other way. */
static void copy_kept(const struct spheres *q, int i, double *row, int to_row)
{
    for (int k = 0; k < q->n_kept; row += q->kept_width[k++]) {
        const int w = q->kept_width[k];
        double *const own = q->kept[k] + (long)w * i;
        memcpy(to_row ? row : own, to_row ? own : row, (size_t)w * sizeof *row);
    }
}

/* The spheres of this rank, as LAMMPS has them now. Returns how many are
 * more than there is room for. */
static int spheres_pull(struct spheres *q)
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
        ps->x[i] = x[i][0], ps->y[i] = x[i][1], ps->z[i] = x[i][2];
        ps->vx[i] = v[i][0], ps->vy[i] = v[i][1], ps->vz[i] = v[i][2];
        ps->wx[i] = omega[i][0], ps->wy[i] = omega[i][1];
        ps->wz[i] = omega[i][2];
        ps->d[i] = 2.0 * R[i], ps->m[i] = m[i], ps->id[i] = tag[i] - 1;
        if (ps->material != NULL) ps->material[i] = type[i] - 1;
        copy_kept(q, i, kept[i], 0);
    }
    if (there > ps->n)
        fprintf(stderr,
                "winnow: rank %d has %d particles and room for %d: --resume "
                "divides the case anew\n",
                q->p->rank, there, ps->n);
    return there - ps->n;
}

/* The external force, and what is kept, to LAMMPS. */
static void spheres_push(struct spheres *q)
{
    const struct particles *const ps = q->dem->ps;
    double **const F = lammps_fix_external_get_force(q->lammps, "push");
    double **const f = spheres_rows(q, "f"),
                   **const kept = spheres_rows(q, "d2_kept");

    for (int i = 0; i < ps->n; i++) {
        const double now[3] = {ps->ex[i], ps->ey[i], ps->ez[i]};
        for (int k = 0; k < 3; k++) {
            f[i][k] += now[k] - F[i][k];
            F[i][k] = now[k];
        }
        copy_kept(q, i, kept[i], 1);
    }
}

/* Where a sphere is that may be lost in the run. */
static void note_places(struct spheres *q)
{
    const struct particles *const ps = q->dem->ps;

    q->n_before = ps->n;
    for (int i = 0; i < ps->n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        q->id_before[i] = ps->id[i];
        memcpy(&q->x_before[3 * i], x, sizeof x);
    }
}

static void spheres_run(struct dem *dem, int steps, struct dem_report *r)
{
    struct spheres *const q = dem->state;

    *r = (struct dem_report){.steps = steps, .lost_through = -1};
    spheres_push(q);
    note_places(q);
    spheres_tell(q, "run %d pre no post no", steps);
    spheres_report(q, spheres_pull(q), r);
}

/* --- starting ------------------------------------------------------------- */

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
            *(to_row ? row : value) = *(to_row ? value : row);
        }
}

/* The arrays of the particles that LAMMPS does not know, as the visit of their
 * state lists them (base/state.h). */
static int list_kept(void *store, const struct state_array *a)
{
    struct spheres *const q = store;
    char word[80];

    snprintf(word, sizeof word, " %s ", strrchr(a->path, '/') + 1);
    if (strstr(told, word) != NULL) return 0;
    q->kept[q->n_kept] = a->values;
    q->kept_width[q->n_kept++] = a->width;
    q->width += a->width;
    return 0;
}

static void attach(struct spheres *q, struct dem *dem)
{
    struct state s = {.visit = list_kept, .store = q};

    q->dem = dem;
    dem->state = q;
    q->width = EXTRA;
    dem->ps->n = 1; /* arrays of no rows are not visited */
    particles_state(dem->ps, &s);
    dem->ps->n = 0;
    q->id_before = owner_ints(q, dem->ps->capacity);
    q->x_before = owner_doubles(q, 3 * dem->ps->capacity);
    spheres_tell(q, "fix kept all property/atom d2_kept %d", q->width);
}

/* The first run, which computes the forces. */
static void spheres_start(struct spheres *q)
{
    double own[2], **kept;

    spheres_tell(q, "run 0 post no");
    kept = spheres_rows(q, "d2_kept");
    for (int i = 0; i < spheres_count(q) && !q->loaded; i++)
        kept[i][q->width - 1] = q->p->rank;
    spheres_pull(q);
    own[0] = q->dem->ps->n;
    own[1] = 0.0;
    for (int i = 0; i < q->dem->ps->n; i++)
        own[1] += q->dem->ps->id[i];
    MPI_Allreduce(MPI_IN_PLACE, own, 2, MPI_DOUBLE, MPI_SUM, q->comm);
    q->all = (long)own[0];
    q->id_sum = (long)own[1];
}

/* What a file has of contacts is dropped if the box is cut before anybody has
 * claimed it. */
void spheres_begin(struct spheres *q, struct dem *dem, const struct words *w)
{
    struct words own = *w;

    own.starts = q->loaded && q->p->size > 1 ? 2 : 1;
    attach(q, dem);
    if (!q->loaded) spheres_cut(q);
    spheres_equip(q, &own);
    if (q->loaded) spheres_cut(q);
    spheres_start(q);
    if (q->loaded) exchange_forces(q, 0);
}

void spheres_save(struct spheres *q, const char *file)
{
    spheres_push(q);
    exchange_forces(q, 1);
    spheres_tell(q, "write_restart %s noinit", file);
}

/* --- the method ----------------------------------------------------------- */

static void spheres_release(struct dem *dem)
{
    spheres_free(dem->state);
}

static double skin(const struct dem_options *o, double mean)
{
    return o->skin > 0.0 ? o->skin : mean / 6.0;
}

/* LAMMPS is started by spheres_begin. What it does not know has been refused
 * before (processes_check.c). */
const struct dem_method spheres_method = {.name = "lammps",
                                          .what = "by LAMMPS, on all ranks",
                                          .equations = "",
                                          .function = "spheres_begin",
                                          .skin = skin,
                                          .free = spheres_release,
                                          .run = spheres_run};

/* --- settle: a bed comes to rest on all ranks.
 *
 * As in dem/bed_settling.h: first with a viscous drag, without which rolling
 * spheres would not stop, then without it, until the spheres have as little
 * energy as there. The material is the real one all the time, and meanwhile
 * LAMMPS moves the planes that cut the box, for there are no cells yet. */

static const double settling_drag = 3.0; /* [-] relaxation over sqrt(d/g) */
enum { CHECK_EVERY = 50 };

static void spheres_settle_begin(struct spheres *q, const struct words *w,
                                 double step, const double g[3])
{
    const double size = vector_length(g);
    const int *const P = q->p->P;
    struct words own = *w;

    own.step = step;
    own.starts = 1;
    spheres_equip(q, &own);
    spheres_tell(q, "fix fall all gravity %.17g vector %.17g %.17g %.17g", size,
                 g[0] / size, g[1] / size, g[2] / size);
    if (q->p->size > 1)
        spheres_tell(q, "fix even all balance 1000 1.05 shift %s%s%s 10 1.02",
                     P[0] > 1 ? "x" : "", P[1] > 1 ? "y" : "",
                     P[2] > 1 ? "z" : "");
    spheres_tell(q, "run 0 post no");
}

static void spheres_settle_end(struct spheres *q)
{
    if (q->p->size > 1) spheres_tell(q, "unfix even");
    spheres_tell(q, "unfix fall");
    spheres_strip(q);
}

/* Multiplies all velocities; returns the kinetic energy before, over the energy
 * of falling by the height d [-]. */
static double spheres_settle_slow_down(struct spheres *q, double factor,
                                       double g, double d)
{
    const double *const R = lammps_extract_atom(q->lammps, "radius");
    const double *const m = lammps_extract_atom(q->lammps, "rmass");
    double **const v = spheres_rows(q, "v"),
                   **const w = spheres_rows(q, "omega");
    double sum[2] = {0.0, 0.0};

    for (int i = 0; i < spheres_count(q); i++) {
        sum[0] += m[i] * (0.5 * vector_dot(v[i], v[i]) +
                          0.2 * R[i] * R[i] * vector_dot(w[i], w[i]));
        sum[1] += m[i] * g * d;
        for (int k = 0; k < 3; k++) {
            v[i][k] *= factor;
            w[i][k] *= factor;
        }
    }
    MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, q->comm);
    return sum[0] / sum[1];
}

void spheres_settle(struct spheres *q, const struct words *w, double step,
                    const struct bed_options *bed, struct bed_report *r)
{
    const double g = vector_length(bed->gravity);
    const double fall = sqrt(bed->diameter / g), interval = CHECK_EVERY * step;

    *r = (struct bed_report){.settled = 0};
    spheres_settle_begin(q, w, step, bed->gravity);
    for (int part = 0; part < 2; part++) {
        const double kept = part ? 1.0 : exp(-interval / settling_drag / fall);
        const double least = part ? 0.0 : 1.5 * fall;
        do {
            spheres_tell(q, "run %d pre no post no", CHECK_EVERY);
            r->time += interval;
            r->steps += CHECK_EVERY;
            r->kinetic = spheres_settle_slow_down(q, kept, g, bed->diameter);
            r->settled = r->kinetic < BED_SETTLED_ENERGY && r->time >= least;
        } while (!r->settled && r->time < bed->settle);
        if (!r->settled) break;
    }
    spheres_settle_end(q);
}
