/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pieces.c -- what ParaView opens, and what the first rank draws. */
#include "base/alloc.h"
#include "base/file.h"
#include "coupling/coupling.h"
#include "distributed/ranks/pieces.h"
#include "output/vtk.h"
#include "record/snapshot.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* m numbers of each own cell, in a new array. */
static double *own_numbers(const struct part *part, int m, const double *field)
{
    const unsigned char *const own = halo_own(part->halo);
    const int cells = part->sim->mesh->n_cells;
    double *const packed = alloc_doubles(m * cells);
    int n = 0;

    for (int c = 0; c < cells; c++)
        if (own[c])
            memcpy(packed + (long)m * n++, field + (long)m * c,
                   (size_t)m * sizeof *field);
    return packed;
}

/* --- ParaView ------------------------------------------------------------- */

void pieces_name(const char *path, int rank, int with_folder,
                 char name[PIECES_PATH])
{
    const char *const slash = strrchr(path, '/');
    const char *const from = with_folder || slash == NULL ? path : slash + 1;
    const char *const dot = strrchr(path, '.');

    snprintf(name, PIECES_PATH, "%.*s_%d.%s", (int)(dot - from), from, rank,
             dot + 2);
}

static int write_cells(const struct part *part, struct vtk_file *w,
                       const char *piece, const struct snapshot *s, int n,
                       struct vtk_array *arrays)
{
    const struct extent *const e = &part->p.here;
    struct mesh own = {.n_cells = e->own[0] * e->own[1] * e->own[2]};

    for (int k = 0; k < 3; k++) {
        own.box.n[k] = e->own[k];
        own.box.edge[k] = part->sim->mesh->box.edge[k] + e->first[k] - e->at[k];
    }
    for (int i = 0; i < n; i++)
        arrays[i].values =
            own_numbers(part, arrays[i].components, arrays[i].values);
    const int failed =
        vtk_write_box_at(w, piece, &own, e->first, s->t, n, arrays);
    for (int i = 0; i < n; i++) {
        void *packed;
        memcpy(&packed, &arrays[i].values, sizeof packed);
        free(packed);
    }
    return failed;
}

static void put_arrays(FILE *f, const char *section, int n,
                       const struct vtk_array *arrays)
{
    fprintf(f, "<P%s>\n", section);
    for (int i = 0; i < n; i++)
        fprintf(
            f,
            "<PDataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\"/>\n",
            vtk_array_type(&arrays[i]), arrays[i].name, arrays[i].components);
    fprintf(f, "</P%s>\n", section);
}

static void put_list(FILE *f, const struct part *part, const char *path,
                     const char *kind, int of_cells)
{
    char name[PIECES_PATH];

    for (int r = 0; r < part->p.size; r++) {
        const struct extent e = partition_extent(&part->p, r);
        pieces_name(path, r, 0, name);
        fprintf(f, "<Piece ");
        for (int k = 0; k < 3 && of_cells; k++)
            fprintf(f, "%s%d %d%s", k == 0 ? "Extent=\"" : " ", e.first[k],
                    e.first[k] + e.own[k], k == 2 ? "\" " : "");
        fprintf(f, "Source=\"%s\"/>\n", name);
    }
    fprintf(f, "</P%s>\n</VTKFile>\n", kind);
}

/* The file that lists the pieces. */
static int write_list(const struct part *part, const char *path, int of_cells,
                      int n, const struct vtk_array *arrays)
{
    static const double none = 0.0;
    const struct vtk_array at[3] = {
        {.name = of_cells ? "x" : "position",
         .components = of_cells ? 1 : 3,
         .values = &none},
        {.name = "y", .components = 1, .values = &none},
        {.name = "z", .components = 1, .values = &none}};
    const char *const kind = of_cells ? "RectilinearGrid" : "PolyData";
    const int *const N = part->p.N;
    struct file *const file = file_create(path);

    if (file == NULL) return 1;
    FILE *const f = file_stream(file);
    fprintf(f,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"P%s\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<P%s ",
            kind, kind);
    if (of_cells)
        fprintf(f, "WholeExtent=\"0 %d 0 %d 0 %d\" ", N[0], N[1], N[2]);
    fprintf(f, "GhostLevel=\"0\">\n");
    put_arrays(f, of_cells ? "CellData" : "PointData", n, arrays);
    put_arrays(f, of_cells ? "Coordinates" : "Points", of_cells ? 3 : 1, at);
    put_list(f, part, path, kind, of_cells);
    return file_commit(file);
}

int pieces_write(const struct part *part, const struct snapshot *s,
                 const char *path)
{
    const int of_cells = strstr(path, ".pvtr") != NULL;
    const double *const x[3] = {s->x[0], s->x[1], s->x[2]};
    struct vtk_array arrays[FIELD_OUTPUT_ARRAYS];
    const int n = of_cells ? field_output_of_fluid(part->sim, s, arrays)
                           : field_output_of_particles(s, arrays);
    struct vtk_file *const w = vtk_file_create();
    char piece[PIECES_PATH];
    int failed =
        part->p.rank == 0 && write_list(part, path, of_cells, n, arrays);

    pieces_name(path, part->p.rank, 1, piece);
    failed |= of_cells
                  ? write_cells(part, w, piece, s, n, arrays)
                  : vtk_write_particles(w, piece, s->n, x, s->t, n, arrays);
    vtk_file_free(w);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, part->comm);
    return failed;
}

/* --- the picture ---------------------------------------------------------- */

/* n numbers of each rank, one rank after the other, as a new array on the first
 * one; *all: how many. */
static double *gathered(const struct part *part, const double *mine, int n,
                        int *all)
{
    int *const count = alloc_ints(part->p.size);
    int *const at = alloc_ints(part->p.size + 1);

    MPI_Gather(&n, 1, MPI_INT, count, 1, MPI_INT, 0, part->comm);
    for (int r = 0; r < part->p.size; r++)
        at[r + 1] = at[r] + count[r];
    double *const x = alloc_doubles(at[part->p.size]);
    MPI_Gatherv(mine, n, MPI_DOUBLE, x, count, at, MPI_DOUBLE, 0, part->comm);
    *all = at[part->p.size];
    free(count);
    free(at);
    return x;
}

static void gather_cells(const struct part *part, int m, const double *from,
                         double *to)
{
    const int *const own = part->p.here.own;
    double *const packed = own_numbers(part, m, from);
    int n, i = 0;
    double *const all =
        gathered(part, packed, m * own[0] * own[1] * own[2], &n);

    for (int r = 0; r < part->p.size && to != NULL; r++) {
        const struct extent e = partition_extent(&part->p, r);
        for (int c = 0; c < e.n[0] * e.n[1] * e.n[2]; c++)
            if (partition_is_own(&e, c))
                memcpy(to + (long)m * partition_whole(&part->p, &e, c),
                       all + (long)m * i++, (size_t)m * sizeof *all);
    }
    free(packed);
    free(all);
}

enum { ROW = 12 }; /* [-] numbers a particle */

static void gather_particles(const struct part *part, const struct snapshot *s,
                             struct snapshot *whole)
{
    double *const row = alloc_doubles(ROW * s->n);
    int n;

    for (int i = 0; i < s->n; i++) {
        const double one[ROW] = {s->x[0][i], s->x[1][i],  s->x[2][i],
                                 s->v[0][i], s->v[1][i],  s->v[2][i],
                                 s->w[0][i], s->w[1][i],  s->w[2][i],
                                 s->d[i],    s->speed[i], s->id[i]};
        memcpy(&row[ROW * i], one, sizeof one);
    }
    double *const all = gathered(part, row, ROW * s->n, &n);
    for (int i = 0; i < n / ROW && whole != NULL; i++) {
        const double *const one = &all[ROW * i];
        for (int k = 0; k < 3; k++) {
            whole->x[k][i] = one[k];
            whole->v[k][i] = one[3 + k];
            whole->w[k][i] = one[6 + k];
        }
        whole->d[i] = one[9];
        whole->speed[i] = one[10];
        whole->id[i] = (int)one[11];
    }
    if (whole != NULL) whole->n = n / ROW;
    free(row);
    free(all);
}

void pieces_gather(const struct part *part, const struct snapshot *s,
                   struct snapshot *whole, int with)
{
    const struct snapshot none = {.t = 0.0}, *const to = whole ? whole : &none;

    gather_cells(part, 1, s->eps, to->eps);
    gather_cells(part, 1, s->eps_s, to->eps_s);
    gather_cells(part, 1, s->p, to->p);
    gather_cells(part, 3, s->u, to->u);
    gather_cells(part, 3, s->u_s, to->u_s);
    if (with) gather_particles(part, s, whole);
    if (whole != NULL) whole->t = s->t;
}

/* --- visit: the cells of all ranks in one file, in the order of the box. */

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
    double *const packed = own_numbers(v->part, m, field);

    visit_move(v, path, m, packed);
    for (int c = 0, n = 0; c < v->part->sim->mesh->n_cells && v->loading; c++)
        if (own[c])
            memcpy(field + (long)m * c, packed + (long)m * n++,
                   (size_t)m * sizeof *field);
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

    /* by its name: a part may have as many boundary faces as cells */
    if (strcmp(a->path, "/fluid/p_face") == 0)
        visit_faces(v, a->path, (double *)a->values - m->n_internal);
    else if (a->rows == m->n_cells)
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
