/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"
#include "distributed/ranks/partition.h"

#include <math.h>
#include <petscsf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The most ranks that a direction can be cut into. */
static int most(const struct partition *p, int k)
{
    return p->N[k] / p->layers > 1 ? p->N[k] / p->layers : 1;
}

/* The area that is cut, over the box [-]; parts across gravity all have their
 * share of the bed, so that a plane normal to it counts ten times. */
static double cost(const struct partition *p, const int P[3], int down)
{
    double sum = 0.0;

    for (int k = 0; k < 3; k++)
        sum += (P[k] - 1) / p->size_m[k] * (k == down ? 10.0 : 1.0);
    return sum;
}

/* The cheapest way to cut the box into so many parts; 0 if there is none. */
static int choose(struct partition *p, int down, int parts)
{
    double best = HUGE_VAL;

    for (int a = 1; a <= parts; a++)
        for (int b = 1; parts % a == 0 && b <= parts / a; b++) {
            const int P[3] = {a, b, parts / a / b};
            if (parts / a % b != 0 || P[0] > most(p, 0) || P[1] > most(p, 1) ||
                P[2] > most(p, 2) || cost(p, P, down) >= best)
                continue;
            best = cost(p, P, down);
            memcpy(p->P, P, sizeof P);
        }
    return best < HUGE_VAL;
}

/* How many ranks can be used, at most `size`. */
static int largest_that_fits(struct partition *p, int down)
{
    int n = p->size;

    while (n > 1 && !choose(p, down, n))
        n--;
    return n;
}

static int wrong_parts(struct partition *p, const int P[3], int down)
{
    if (P[0] == 0) {
        fprintf(stderr,
                "winnow: %d x %d x %d cells cannot be divided among %d ranks, "
                "each of which needs %d in a direction that is cut; the next "
                "smaller number that fits is %d\n",
                p->N[0], p->N[1], p->N[2], p->size, p->layers,
                largest_that_fits(p, down));
        return 2;
    }
    fprintf(stderr,
            "winnow: ranks = [%d, %d, %d] are %d, and mpirun has started %d; "
            "at most [%d, %d, %d] fit the cells\n",
            P[0], P[1], P[2], P[0] * P[1] * P[2], p->size, most(p, 0),
            most(p, 1), most(p, 2));
    return 2;
}

int partition_init(struct partition *p, const struct box_spec *box,
                   const int P[3], int down, int rank, int size, int layers)
{
    *p = (struct partition){.rank = rank, .size = size, .layers = layers};
    memcpy(p->N, box->cells, sizeof p->N);
    memcpy(p->periodic, box->periodic, sizeof p->periodic);
    memcpy(p->size_m, box->size, sizeof p->size_m);
    int fits = P[0] * P[1] * P[2] == size;
    for (int k = 0; k < 3; k++)
        fits = fits && P[k] <= most(p, k);
    if (P[0] == 0 && !choose(p, down, size)) return wrong_parts(p, P, down);
    if (P[0] != 0 && !fits) return wrong_parts(p, P, down);
    if (P[0] != 0) memcpy(p->P, P, sizeof p->P);
    for (int k = 0; k < 3; k++)
        p->cut[k] = alloc_ints(p->P[k] + 1);
    return 0;
}

/* Planes at equal shares of the weight; no part has less than the layers. */
void partition_cut(struct partition *p, const double *const weight[3])
{
    for (int k = 0; k < 3; k++) {
        const int P = p->P[k], N = p->N[k];
        double all = 0.0, sum = 0.0;
        int c = 0;
        for (int i = 0; i < N; i++)
            all += weight[k][i];
        for (int r = 1; r < P; r++) {
            while (c < N && sum + 0.5 * weight[k][c] < all * r / P)
                sum += weight[k][c++];
            const int least = p->cut[k][r - 1] + p->layers;
            const int highest = N - (P - r) * p->layers;
            p->cut[k][r] = c < least ? least : c > highest ? highest : c;
        }
        p->cut[k][P] = N;
    }
    p->here = partition_extent(p, p->rank);
}

void partition_release(struct partition *p)
{
    for (int k = 0; k < 3; k++)
        free(p->cut[k]);
}

double partition_cells(const struct partition *p)
{
    return (double)p->N[0] * p->N[1] * p->N[2];
}

struct extent partition_extent(const struct partition *p, int rank)
{
    const int r[3] = {rank % p->P[0], rank / p->P[0] % p->P[1],
                      rank / p->P[0] / p->P[1]};
    struct extent e;

    for (int k = 0; k < 3; k++) {
        const int layers = p->P[k] > 1 ? p->layers : 0;
        int end = p->cut[k][r[k] + 1] + layers;
        e.first[k] = p->cut[k][r[k]];
        e.own[k] = p->cut[k][r[k] + 1] - e.first[k];
        e.at[k] = e.first[k] - layers;
        if (!p->periodic[k] && e.at[k] < 0) e.at[k] = 0;
        if (!p->periodic[k] && end > p->N[k]) end = p->N[k];
        e.n[k] = end - e.at[k];
    }
    return e;
}

int partition_whole(const struct partition *p, const struct extent *e, int cell)
{
    const int at[3] = {cell % e->n[0], cell / e->n[0] % e->n[1],
                       cell / e->n[0] / e->n[1]};
    int i[3];

    for (int k = 0; k < 3; k++)
        i[k] = (e->at[k] + at[k] + p->N[k]) % p->N[k];
    return i[0] + p->N[0] * (i[1] + p->N[1] * i[2]);
}

int partition_rank(const struct partition *p, const int i[3])
{
    int r[3] = {0, 0, 0};

    for (int k = 0; k < 3; k++)
        while (i[k] >= p->cut[k][r[k] + 1])
            r[k]++;
    return r[0] + p->P[0] * (r[1] + p->P[1] * r[2]);
}

int partition_owner(const struct partition *p, int whole, int *local)
{
    const int i[3] = {whole % p->N[0], whole / p->N[0] % p->N[1],
                      whole / p->N[0] / p->N[1]};
    const int rank = partition_rank(p, i);
    const struct extent e = partition_extent(p, rank);
    *local =
        i[0] - e.at[0] + e.n[0] * (i[1] - e.at[1] + e.n[1] * (i[2] - e.at[2]));
    return rank;
}

int partition_is_own(const struct extent *e, int cell)
{
    const int at[3] = {cell % e->n[0], cell / e->n[0] % e->n[1],
                       cell / e->n[0] / e->n[1]};

    for (int k = 0; k < 3; k++) {
        const int i = e->at[k] + at[k] - e->first[k];
        if (i < 0 || i >= e->own[k]) return 0;
    }
    return 1;
}

struct mesh *partition_mesh(const struct partition *p, int cut[6])
{
    struct box_spec spec = {.grading = {1.0, 1.0, 1.0}};
    int n = 0;

    for (int k = 0; k < 3; k++) {
        const int is_cut = p->P[k] > 1;
        spec.cells[k] = p->here.n[k];
        spec.size[k] = p->size_m[k] / p->N[k] * p->here.n[k];
        spec.periodic[k] = p->periodic[k] && !is_cut;
        for (int side = 0; side < 2 && !spec.periodic[k]; side++)
            cut[n++] = is_cut &&
                       (p->periodic[k] ||
                        (side == 0 ? p->here.at[k] > 0
                                   : p->here.at[k] + p->here.n[k] < p->N[k]));
    }
    struct mesh *const m = mesh_create_box(&spec);
    for (int k = 0; k < 3; k++) {
        const double shift = p->size_m[k] / p->N[k] * p->here.at[k];
        for (int i = 0; i <= m->box.n[k]; i++)
            m->box.edge[k][i] = p->size_m[k] * (p->here.at[k] + i) / p->N[k];
        for (int c = 0; c < m->n_cells; c++)
            m->centre[3 * c + k] += shift;
        m->lo[k] += shift;
        m->hi[k] += shift;
    }
    return m;
}

/* The direction that a face is normal to. */
static int partition_direction(const struct mesh *m, int f)
{
    int k = 0;

    while (mesh_S(m, f)[k] == 0.0)
        k++;
    return k;
}

struct face_places partition_faces(const struct mesh *m, const int cut[6])
{
    struct face_places p = {alloc_ints(3 * m->n_cells),
                            alloc_ints(3 * m->n_cells)};

    memset(p.up, -1, 3 * (size_t)m->n_cells * sizeof *p.up);
    memset(p.down, -1, 3 * (size_t)m->n_cells * sizeof *p.down);
    for (int f = 0; f < m->n_internal; f++)
        p.up[3 * m->owner[f] + partition_direction(m, f)] = f;
    for (int i = 0; i < m->n_patches; i++)
        for (int f = m->patches[i].first;
             f < m->patches[i].first + m->patches[i].n && !cut[i]; f++) {
            const int k = partition_direction(m, f), at = 3 * m->owner[f] + k;
            *(mesh_S(m, f)[k] > 0.0 ? &p.up[at] : &p.down[at]) = f;
        }
    return p;
}

/* --- halo ----------------------------------------------------------------- */

enum { MOST_FIELDS = 8 };

struct halo {
    MPI_Comm comm;
    int n;
    unsigned char *own;
    double *around; /* 6 a cell: the faces above and below */
    PetscSF sf;
    MPI_Datatype unit[MOST_FIELDS + 1];
};

void halo_must(int error)
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
    struct halo *const h = owner_create(sizeof *h);
    const int *const n = p->here.n;

    h->comm = comm;
    h->n = n[0] * n[1] * n[2];
    h->own = owner_zeroed(h, (size_t)h->n, 1);
    h->around = owner_doubles(h, 6 * h->n);
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
    owner_free(h);
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
