/* SPDX-License-Identifier: GPL-3.0-or-later */
/* spheres_report.c -- sums over the spheres of all ranks, and which are lost.
 */
#include "distributed/ranks/spheres.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LAMMPS_LIB_MPI
#include <lammps/library.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/dem_method.h"

/* The overlap with the walls of the box, over the diameter. */
static double wall_overlap(const struct spheres *q, const double *x, double R)
{
    double deepest = 0.0;

    for (int k = 0; k < 3; k++) {
        if (q->w.periodic[k]) continue;
        deepest = fmax(deepest, R - (x[k] - q->w.lo[k]));
        deepest = fmax(deepest, R - (q->w.hi[k] - x[k]));
    }
    return 0.5 * deepest / R;
}

/* Touching pairs, half of each at either end, and the deepest overlap, at the
 * end of a run: LAMMPS itself does not record it. */
static void measure_contacts(struct spheres *q, double *contacts,
                             double *deepest)
{
    enum { NEIGHBOUR = 0x3FFFFFFF }; /* without LAMMPS' bits of bonds */
    double **const x = spheres_rows(q, "x");
    const double *const R = lammps_extract_atom(q->lammps, "radius");
    const int own = spheres_count(q);
    const int list = lammps_find_pair_neighlist(q->lammps, "granular", 1, 0, 0);

    for (int e = 0; e < own; e++) {
        const double alone = wall_overlap(q, x[e], R[e]);
        *deepest = fmax(*deepest, alone);
        *contacts += alone > 0.0;
    }
    const int n = list < 0 ? 0 : lammps_neighlist_num_elements(q->lammps, list);
    for (int e = 0; e < n; e++) {
        int i, many, *others;
        lammps_neighlist_element_neighbors(q->lammps, list, e, &i, &many,
                                           &others);
        for (int k = 0; k < many; k++) {
            const int j = others[k] & NEIGHBOUR;
            const double a = x[i][0] - x[j][0], b = x[i][1] - x[j][1],
                         c = x[i][2] - x[j][2], R2 = R[i] + R[j];
            const double rr = a * a + b * b + c * c;
            if (rr >= R2 * R2) continue;
            *deepest = fmax(*deepest, (R2 - sqrt(rr)) / R2);
            *contacts += j < own ? 1.0 : 0.5;
        }
    }
}

/* Within the cells of this rank and their layers. */
static int spheres_report_is_inside(const struct spheres *q, const double *x)
{
    const struct partition *const p = q->p;
    int in = 1;

    for (int k = 0; k < 3; k++) {
        const double width = p->size_m[k] / p->N[k];
        const double lo = width * p->here.at[k];
        if (p->periodic[k] && p->P[k] == 1)
            in &= isfinite(x[k]);
        else
            in &= x[k] >= lo && x[k] <= lo + width * p->here.n[k];
    }
    return in;
}

enum { SUMS = 6, MAXIMA = 5 };

/* Where a lost sphere was before the run. */
static void find_lost(const struct spheres *q, struct dem_report *r)
{
    double at[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

    if (r->lost_id < 0 || isfinite(r->lost_at[0])) return;
    for (int i = 0; i < q->n_before; i++)
        if (q->id_before[i] == r->lost_id)
            memcpy(at, &q->x_before[3 * i], sizeof at);
    MPI_Allreduce(at, r->lost_at, 3, MPI_DOUBLE, MPI_MAX, q->comm);
}

void spheres_report(struct spheres *q, int untaken, struct dem_report *r)
{
    const struct particles *const ps = q->dem->ps;
    double sum[SUMS] = {spheres_count(q), 0, 0, 0, 0, untaken};
    double most[MAXIMA] = {0.0, 0.0, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

    measure_contacts(q, &sum[4], &most[0]);
    for (int i = 0; i < ps->n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};
        sum[2] += 0.5 * ps->m[i] * vector_dot(v, v);
        sum[3] += 0.05 * ps->m[i] * ps->d[i] * ps->d[i] * vector_dot(w, w);
        most[1] = fmax(most[1], vector_length(v));
        if (spheres_report_is_inside(q, x)) {
            sum[1] += ps->id[i];
            continue;
        }
        sum[0] -= 1.0;
        memcpy(most + 2, x, sizeof x);
    }
    MPI_Allreduce(MPI_IN_PLACE, sum, SUMS, MPI_DOUBLE, MPI_SUM, q->comm);
    MPI_Allreduce(MPI_IN_PLACE, most, MAXIMA, MPI_DOUBLE, MPI_MAX, q->comm);
    r->translation = sum[2];
    r->rotation = sum[3];
    r->contacts = (int)sum[4];
    r->max_overlap = most[0];
    r->max_speed = most[1];
    r->lost = (int)(q->all - (long)sum[0] + (long)sum[5]);
    r->lost_id = r->lost == 1 ? (int)(q->id_sum - (long)sum[1]) : -1;
    for (int k = 0; k < 3; k++)
        r->lost_at[k] = isfinite(most[2 + k]) ? most[2 + k] : (double)NAN;
    find_lost(q, r);
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

long spheres_all(const struct spheres *q, double *mean_diameter)
{
    const double *const R = lammps_extract_atom(q->lammps, "radius");
    double sum[2] = {spheres_count(q), 0.0};

    for (int i = 0; i < spheres_count(q); i++)
        sum[1] += 2.0 * R[i];
    MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, q->comm);
    *mean_diameter = sum[0] > 0.0 ? sum[1] / sum[0] : 0.0;
    return (long)sum[0];
}

/* The slab of cells of a direction. */
static int spheres_report_slab(const struct partition *p, int k, double x)
{
    const double at = floor(x / p->size_m[k] * p->N[k]);

    return at < 0.0 ? 0 : at > p->N[k] - 1.0 ? p->N[k] - 1 : (int)at;
}

void spheres_weigh(const struct spheres *q, double each, double *weight[3])
{
    double **const x = spheres_rows(q, "x");

    for (int k = 0; k < 3; k++) {
        double *const own = alloc_doubles(q->p->N[k]);
        for (int i = 0; i < spheres_count(q); i++)
            own[spheres_report_slab(q->p, k, x[i][k])] += each;
        MPI_Allreduce(MPI_IN_PLACE, own, q->p->N[k], MPI_DOUBLE, MPI_SUM,
                      q->comm);
        for (int i = 0; i < q->p->N[k]; i++)
            weight[k][i] += own[i];
        free(own);
    }
}

int spheres_share(const struct spheres *q)
{
    double **const x = spheres_rows(q, "x");
    int *const n = alloc_ints(q->p->size);

    for (int i = 0; i < spheres_count(q); i++) {
        const int cell[3] = {spheres_report_slab(q->p, 0, x[i][0]),
                             spheres_report_slab(q->p, 1, x[i][1]),
                             spheres_report_slab(q->p, 2, x[i][2])};
        n[partition_rank(q->p, cell)]++;
    }
    MPI_Allreduce(MPI_IN_PLACE, n, q->p->size, MPI_INT, MPI_SUM, q->comm);
    const int own = n[q->p->rank];
    free(n);
    return own;
}
