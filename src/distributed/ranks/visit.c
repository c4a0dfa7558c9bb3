/* SPDX-License-Identifier: GPL-3.0-or-later */
/* visit.c -- the cells of all ranks in one file, in the order of the box. */
#include "distributed/ranks/pieces.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/coupling.h"

enum { NAME = 64 };

struct visit {
    struct part *part;
    struct state *to; /* on the first rank; NULL */
    MPI_File file;
    MPI_Offset at; /* [byte] of the next array */
    int loading, failed;
    uint64_t sum; /* [-] of all bits that this rank has written or read */
};

/* Before each array there is its name. */
static void put_name(struct visit *v, const char *path)
{
    char name[NAME] = {0};

    snprintf(name, NAME, "%s", path);
    MPI_File_set_view(v->file, v->at, MPI_BYTE, MPI_BYTE, "native",
                      MPI_INFO_NULL);
    if (v->part->p.rank == 0 && !v->loading)
        MPI_File_write_at(v->file, 0, name, NAME, MPI_BYTE, MPI_STATUS_IGNORE);
    v->at += NAME;
}

/* The numbers of the own cells, m each, from or to their places in the file. */
static void visit_move(struct visit *v, const char *path, int m, double *own)
{
    const struct partition *const p = &v->part->p;
    const struct extent *const e = &p->here;
    const int all[3] = {p->N[2], p->N[1], m * p->N[0]};
    const int mine[3] = {e->own[2], e->own[1], m * e->own[0]};
    const int first[3] = {e->first[2], e->first[1], m * e->first[0]};
    const int n = m * e->own[0] * e->own[1] * e->own[2];
    MPI_Datatype box;
    MPI_Status status;
    int moved;

    put_name(v, path);
    MPI_Type_create_subarray(3, all, mine, first, MPI_ORDER_C, MPI_DOUBLE,
                             &box);
    MPI_Type_commit(&box);
    MPI_File_set_view(v->file, v->at, MPI_DOUBLE, box, "native", MPI_INFO_NULL);
    const int error =
        v->loading ? MPI_File_read_all(v->file, own, n, MPI_DOUBLE, &status)
                   : MPI_File_write_all(v->file, own, n, MPI_DOUBLE, &status);
    MPI_Get_count(&status, MPI_DOUBLE, &moved);
    v->failed |= error != MPI_SUCCESS || moved != n;
    MPI_Type_free(&box);
    v->at += (MPI_Offset)(8.0 * m * partition_cells(p));
    for (int i = 0; i < n; i++) {
        uint64_t bits;
        memcpy(&bits, &own[i], sizeof bits);
        v->sum += bits;
    }
}

/* m numbers a cell. */
static void visit_cells(struct visit *v, const char *path, int m, double *field)
{
    const unsigned char *const own = halo_own(v->part->halo);
    const int cells = v->part->sim->mesh->n_cells;
    double *const packed = alloc_doubles(m * cells);
    const size_t size = (size_t)m * sizeof *field;

    for (int c = 0, n = 0; c < cells; c++)
        if (own[c]) memcpy(packed + (long)m * n++, field + (long)m * c, size);
    visit_move(v, path, m, packed);
    for (int c = 0, n = 0; c < cells && v->loading; c++)
        if (own[c]) memcpy(field + (long)m * c, packed + (long)m * n++, size);
    if (v->loading) halo_refresh(v->part->halo, m, field);
    free(packed);
}

/* The faces above and below each cell, as six numbers of it. */
static void visit_faces(struct visit *v, const char *path, double *face)
{
    const struct face_places *const at = &v->part->places;
    const int n = v->part->sim->mesh->n_cells;
    double *const six = alloc_doubles(6 * n);

    for (int i = 0; i < 6 * n && !v->loading; i++) {
        const int f = (i % 2 ? at->down : at->up)[i / 2];
        six[i] = f >= 0 ? face[f] : 0.0;
    }
    visit_cells(v, path, 6, six);
    for (int i = 0; i < 6 * n && v->loading; i++) {
        const int f = (i % 2 ? at->down : at->up)[i / 2];
        if (f >= 0) face[f] = six[i];
    }
    free(six);
}

/* Numbers that are the same on all ranks. */
static void visit_same(struct visit *v, const struct state_array *a)
{
    const size_t size = a->type == STATE_REAL   ? sizeof(double)
                        : a->type == STATE_LONG ? sizeof(long)
                                                : sizeof(int);

    if (v->to != NULL && !v->to->failed)
        v->to->failed = v->to->visit(v->to->store, a);
    if (v->loading)
        MPI_Bcast(a->values, (int)((size_t)a->rows * (size_t)a->width * size),
                  MPI_BYTE, 0, v->part->comm);
}

static int visit_one(void *store, const struct state_array *a)
{
    struct visit *const v = store;
    const struct mesh *const m = v->part->sim->mesh;

    if (a->rows == m->n_cells)
        visit_cells(v, a->path, a->width, a->values);
    else if (a->rows == m->n_faces)
        visit_faces(v, a->path, a->values);
    else
        visit_same(v, a);
    return 0;
}

long pieces_visit(struct part *part, const char *file, struct state *to,
                  int loading)
{
    const int mode =
        loading ? MPI_MODE_RDONLY : MPI_MODE_CREATE | MPI_MODE_WRONLY;
    struct visit v = {.part = part, .to = to, .loading = loading};
    struct state s = {.loading = loading, .visit = visit_one, .store = &v};

    v.failed = MPI_File_open(part->comm, file, mode, MPI_INFO_NULL, &v.file) !=
               MPI_SUCCESS;
    if (!v.failed) {
        fluid_state(part->sim->fluid, &s);
        coupling_state(part->sim, &s);
        v.failed |= MPI_File_close(&v.file) != MPI_SUCCESS;
    }
    if (loading && !v.failed) solve_refresh(part->solve, part->sim->fluid);
    MPI_Allreduce(MPI_IN_PLACE, &v.sum, 1, MPI_UINT64_T, MPI_SUM, part->comm);
    MPI_Allreduce(MPI_IN_PLACE, &v.failed, 1, MPI_INT, MPI_MAX, part->comm);
    if (v.failed && part->p.rank == 0)
        fprintf(stderr, "winnow: %s cannot be %s\n", file,
                loading ? "read" : "written");
    return v.failed ? -1 : (long)(v.sum & INT64_MAX);
}
