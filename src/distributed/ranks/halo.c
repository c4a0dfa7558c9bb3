/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distributed/ranks/halo.h"

#include <petscsf.h>
#include <stdlib.h>

#include "base/alloc.h"

enum { MOST_FIELDS = 8 };

struct halo {
    MPI_Comm comm;
    int n;
    unsigned char *own;
    double *around; /* 6 a cell: the faces above and below */
    PetscSF sf;
    MPI_Datatype unit[MOST_FIELDS + 1];
};

/* What PETSc cannot do here is a bug or a lack of memory. */
static void halo_must(PetscErrorCode error)
{
    if (error != 0) MPI_Abort(MPI_COMM_WORLD, 4);
}

/* The roots are the cells of each rank, the leaves its copies of others'. */
static void make_forest(struct halo *h, const struct partition *p)
{
    PetscInt *const leaf = alloc_zeroed((size_t)h->n, sizeof *leaf);
    PetscSFNode *const root = alloc_zeroed((size_t)h->n, sizeof *root);
    PetscInt leaves = 0;

    for (int c = 0; c < h->n; c++) {
        int local;
        if (h->own[c]) continue;
        root[leaves].rank =
            partition_owner(p, partition_whole(p, &p->here, c), &local);
        root[leaves].index = local;
        leaf[leaves++] = c;
    }
    halo_must(PetscSFCreate(h->comm, &h->sf));
    halo_must(PetscSFSetGraph(h->sf, h->n, leaves, leaf, PETSC_COPY_VALUES,
                              root, PETSC_COPY_VALUES));
    halo_must(PetscSFSetUp(h->sf));
    free(leaf);
    free(root);
}

struct halo *halo_create(const struct partition *p, MPI_Comm comm)
{
    struct halo *const h = alloc_zeroed(1, sizeof *h);
    const int *const n = p->here.n;

    h->comm = comm;
    h->n = n[0] * n[1] * n[2];
    h->own = alloc_zeroed((size_t)h->n, 1);
    h->around = alloc_doubles(6 * h->n);
    for (int c = 0; c < h->n; c++)
        h->own[c] = (unsigned char)partition_is_own(&p->here, c);
    h->unit[1] = MPI_DOUBLE; /* PETSc adds no others of one number */
    for (int m = 2; m <= MOST_FIELDS; m++) {
        MPI_Type_contiguous(m, MPI_DOUBLE, &h->unit[m]);
        MPI_Type_commit(&h->unit[m]);
    }
    make_forest(h, p);
    return h;
}

void halo_free(struct halo *h)
{
    if (h == NULL) return;
    halo_must(PetscSFDestroy(&h->sf));
    for (int m = 2; m <= MOST_FIELDS; m++)
        MPI_Type_free(&h->unit[m]);
    free(h->own);
    free(h->around);
    free(h);
}

void halo_refresh(struct halo *h, int m, double *field)
{
    halo_must(PetscSFBcastBegin(h->sf, h->unit[m], field, field, MPI_REPLACE));
    halo_must(PetscSFBcastEnd(h->sf, h->unit[m], field, field, MPI_REPLACE));
}

void halo_add(struct halo *h, int m, double *field)
{
    halo_must(PetscSFReduceBegin(h->sf, h->unit[m], field, field, MPI_SUM));
    halo_must(PetscSFReduceEnd(h->sf, h->unit[m], field, field, MPI_SUM));
}

void halo_refresh_faces(struct halo *h, const struct face_places *at,
                        double *face)
{
    for (int i = 0; i < 3 * h->n; i++) {
        h->around[2 * i] = at->up[i] < 0 ? 0.0 : face[at->up[i]];
        h->around[2 * i + 1] = at->down[i] < 0 ? 0.0 : face[at->down[i]];
    }
    halo_refresh(h, 6, h->around);
    for (int i = 0; i < 3 * h->n; i++) {
        if (h->own[i / 3]) continue;
        if (at->up[i] >= 0) face[at->up[i]] = h->around[2 * i];
        if (at->down[i] >= 0) face[at->down[i]] = h->around[2 * i + 1];
    }
}

const unsigned char *halo_own(const struct halo *h)
{
    return h->own;
}

double halo_largest(const struct halo *h, double x)
{
    MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_MAX, h->comm);
    return x;
}

void halo_sum(const struct halo *h, int n, double *x)
{
    MPI_Allreduce(MPI_IN_PLACE, x, n, MPI_DOUBLE, MPI_SUM, h->comm);
}
