/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pieces.c -- fields and particles of all parts to the record, and back. */
#include "distributed/ranks/part.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/coupling.h"
#include "distributed/ranks/arrays.h"

/* How many numbers each rank sends, and where they are put. */
struct counts {
    int *n, *at, all;
};

static struct counts counts_of(const struct part *part, int mine)
{
    struct counts c = {alloc_ints(part->p.size), alloc_ints(part->p.size), 0};

    MPI_Gather(&mine, 1, MPI_INT, c.n, 1, MPI_INT, 0, part->comm);
    for (int r = 0; r < part->p.size && part->p.rank == 0; r++) {
        c.at[r] = c.all;
        c.all += c.n[r];
    }
    return c;
}

static void counts_free(struct counts *c)
{
    free(c->n);
    free(c->at);
}

/* --- cells ---------------------------------------------------------------- */

/* The cells of the record in the order in which the ranks send their own. */
static int *order_of_cells(const struct part *part)
{
    const struct partition *const p = &part->p;
    int *const cell = alloc_ints(p->N[0] * p->N[1] * p->N[2]), n = 0;

    for (int r = 0; r < p->size; r++) {
        const struct extent e = partition_extent(p, r);
        for (int c = 0; c < e.n[0] * e.n[1] * e.n[2]; c++)
            if (partition_is_own(&e, c)) cell[n++] = partition_whole(p, &e, c);
    }
    return cell;
}

/* What moves the fields: order and places are those of the record, on the first
 * rank only. */
struct mover {
    struct part *part;
    int *order;
    struct face_places places;
    double *piece, *all; /* up to 6 a cell */
};

static struct mover mover_of(struct part *part, const struct mesh *whole)
{
    static const int none[6] = {0, 0, 0, 0, 0, 0};
    struct mover v = {.part = part,
                      .piece = alloc_doubles(6 * part->sim->mesh->n_cells)};

    if (whole == NULL) return v;
    v.order = order_of_cells(part);
    v.places = partition_faces(whole, none);
    v.all = alloc_doubles(6 * whole->n_cells);
    return v;
}

static void mover_free(struct mover *v)
{
    free(v->order);
    free(v->places.up);
    free(v->places.down);
    free(v->piece);
    free(v->all);
}

/* m numbers a cell: own cells of `part` to `whole`, or the other way. */
static void move_cells(const struct mover *v, int m, double *part,
                       double *whole, int to_record)
{
    const struct part *const p = v->part;
    const unsigned char *const own = halo_own(p->halo);
    const size_t size = (size_t)m * sizeof(double);
    int n = 0;

    for (int c = 0; c < p->sim->mesh->n_cells; c++)
        if (own[c]) memcpy(v->piece + (long)m * n++, part + (long)m * c, size);
    struct counts c = counts_of(p, m * n);
    if (to_record)
        MPI_Gatherv(v->piece, m * n, MPI_DOUBLE, v->all, c.n, c.at, MPI_DOUBLE,
                    0, p->comm);
    for (int i = 0; i < c.all / m; i++) {
        double *const one = v->all + (long)m * i;
        double *const other = whole + (long)m * v->order[i];
        memcpy(to_record ? other : one, to_record ? one : other, size);
    }
    if (!to_record)
        MPI_Scatterv(v->all, c.n, c.at, MPI_DOUBLE, v->piece, m * n, MPI_DOUBLE,
                     0, p->comm);
    counts_free(&c);
    for (int i = 0, k = 0; i < p->sim->mesh->n_cells && !to_record; i++)
        if (own[i]) memcpy(part + (long)m * i, v->piece + (long)m * k++, size);
    if (!to_record) halo_refresh(p->halo, m, part);
}

/* The faces around each cell, as six numbers of it: 1: to the numbers. */
static void around(const struct face_places *at, int cells, double *face,
                   double *six, int to_six)
{
    for (int i = 0; i < 3 * cells; i++) {
        const int f[2] = {at->up[i], at->down[i]};
        for (int k = 0; k < 2; k++) {
            if (f[k] >= 0 && to_six) six[2 * i + k] = face[f[k]];
            if (f[k] >= 0 && !to_six) face[f[k]] = six[2 * i + k];
        }
    }
}

static void move_faces(const struct mover *v, double *part, double *whole,
                       const struct mesh *whole_mesh, int to_record)
{
    const struct mesh *const m = v->part->sim->mesh;
    double *const mine = alloc_doubles(6 * m->n_cells);
    double *const all =
        whole != NULL ? alloc_doubles(6 * whole_mesh->n_cells) : NULL;

    if (to_record) around(&v->part->places, m->n_cells, part, mine, 1);
    if (!to_record && whole != NULL)
        around(&v->places, whole_mesh->n_cells, whole, all, 1);
    move_cells(v, 6, mine, all, to_record);
    if (!to_record) around(&v->part->places, m->n_cells, part, mine, 0);
    if (to_record && whole != NULL)
        around(&v->places, whole_mesh->n_cells, whole, all, 0);
    free(mine);
    free(all);
}

/* Numbers that are the same on all ranks. */
static void move_scalars(const struct part *part, double *here, double *record,
                         int n, int to_record)
{
    const size_t size = (size_t)n * sizeof *here;

    if (record != NULL)
        memcpy(to_record ? record : here, to_record ? here : record, size);
    if (!to_record) MPI_Bcast(here, n, MPI_DOUBLE, 0, part->comm);
}

static void move_fluid(struct part *part, struct simulation *record,
                       const char *list, int to_record)
{
    struct mover v = mover_of(part, record != NULL ? record->mesh : NULL);
    struct simulation *const sim = part->sim;
    struct arrays here, there;

    arrays_of_fluid(sim->fluid, &here);
    if (record != NULL) arrays_of_fluid(record->fluid, &there);
    for (int i = 0; i < here.n; i++) {
        const struct state_array *const a = &here.at[i];
        double *const whole = record != NULL ? there.at[i].values : NULL;
        if (list != NULL && !arrays_named(here.name[i], list)) continue;
        if (a->rows == sim->mesh->n_cells)
            move_cells(&v, a->width, a->values, whole, to_record);
        else if (a->rows == sim->mesh->n_faces)
            move_faces(&v, a->values, whole,
                       record != NULL ? record->mesh : NULL, to_record);
        else
            move_scalars(part, a->values, whole, (int)a->rows * a->width,
                         to_record);
    }
    if (list == NULL)
        move_cells(&v, 4, sim->coupling->field,
                   record != NULL ? record->coupling->field : NULL, to_record);
    mover_free(&v);
}

/* --- particles ------------------------------------------------------------ */

/* Numbers of a particle in a row, its id first. */
static int row_of(const struct arrays *a, int i, double *row, int to_row)
{
    int n = 0;

    for (int k = 0; k < a->n; k++) {
        const struct state_array *const s = &a->at[k];
        if (arrays_named(a->name[k], "count next_id")) continue;
        for (int w = 0; w < s->width; w++, n++) {
            const long at = (long)s->width * i + w;
            double *const x = s->type == STATE_REAL ? s->values : NULL;
            int *const whole = s->values;
            if (to_row && row != NULL)
                row[n] = x != NULL ? x[at] : whole[at];
            else if (row != NULL && x != NULL)
                x[at] = row[n];
            else if (row != NULL)
                whole[at] = (int)row[n];
        }
    }
    return n;
}

static void collect_particles(struct part *part, struct simulation *record)
{
    struct particles *const ps = part->sim->particles;
    struct arrays here, there;

    arrays_of_particles(ps, &here);
    const int width = row_of(&here, 0, NULL, 1);
    double *const mine = alloc_doubles(width * ps->n);
    for (int i = 0; i < ps->n; i++)
        row_of(&here, i, mine + (long)width * i, 1);
    struct counts c = counts_of(part, width * ps->n);
    double *const all = alloc_doubles(c.all);
    MPI_Gatherv(mine, width * ps->n, MPI_DOUBLE, all, c.n, c.at, MPI_DOUBLE, 0,
                part->comm);
    if (record != NULL) {
        arrays_of_particles(record->particles, &there);
        /* the record is sorted: none is inserted, so ids are 0, 1, ... */
        for (int i = 0; i < c.all / width; i++)
            row_of(&there, (int)all[(long)width * i], all + (long)width * i, 0);
        record->particles->n = c.all / width;
    }
    counts_free(&c);
    free(mine);
    free(all);
}

/* --- all -------------------------------------------------------------------
 */

static void add_tally(const struct part *part, const struct effect_tally *t,
                      struct effect_tally *to)
{
    double sum[2] = {t->sum, t->weight}, most[2] = {t->largest, t->seconds};

    MPI_Allreduce(MPI_IN_PLACE, sum, 2, MPI_DOUBLE, MPI_SUM, part->comm);
    MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, part->comm);
    if (to != NULL)
        *to = (struct effect_tally){.sum = sum[0],
                                    .weight = sum[1],
                                    .largest = most[0],
                                    .seconds = most[1]};
}

void part_collect(struct part *part, struct simulation *record,
                  const char *list)
{
    const struct simulation *const sim = part->sim;

    move_fluid(part, record, list, 1);
    collect_particles(part, record);
    add_tally(part, &sim->force_scale,
              record != NULL ? &record->force_scale : NULL);
    for (int i = 0; i < sim->n_effects; i++)
        add_tally(part, &sim->effects[i].tally,
                  record != NULL ? &record->effects[i].tally : NULL);
}

void part_spread(struct part *part, struct simulation *record)
{
    move_fluid(part, record, NULL, 0);
    solve_refresh(part->solve, part->sim->fluid);
}
