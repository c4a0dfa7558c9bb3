/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/matrix.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "linear/field_groups.h"
#include "linear/reduce.h"

/* Sets `start` from the number of entries of each row: a link has one entry in
 * the row of each of its unknowns. */
static void count_rows(struct csr *A, const int *owner, const int *neighbour)
{
    for (int l = 0; l < A->n_links; l++) {
        assert(owner[l] >= 0 && owner[l] < A->n);
        assert(neighbour[l] >= 0 && neighbour[l] < A->n);
        A->start[owner[l] + 1]++;
        A->start[neighbour[l] + 1]++;
    }
    for (int i = 0; i < A->n; i++)
        A->start[i + 1] += A->start[i];
}

/* Moves the entry at e, the last of its row so far, to its place among the
 * others, which are sorted. link[e] is the link of entry e, or its complement
 * (~) if e is the lower entry of the link. */
static void csr_insert(struct csr *A, int *link, int first, int e)
{
    const int col = A->col[e], moved = link[e];

    for (; e > first && A->col[e - 1] > col; e--) {
        A->col[e] = A->col[e - 1];
        link[e] = link[e - 1];
    }
    A->col[e] = col;
    link[e] = moved;
}

static void csr_fill_rows(struct csr *A, int *link, const int *owner,
                          const int *neighbour)
{
    int *const used = alloc_ints(A->n);

    for (int l = 0; l < A->n_links; l++) {
        const int i = owner[l], j = neighbour[l];
        int e = A->start[i] + used[i]++;

        A->col[e] = j;
        link[e] = l;
        csr_insert(A, link, A->start[i], e);
        e = A->start[j] + used[j]++;
        A->col[e] = i;
        link[e] = ~l;
        csr_insert(A, link, A->start[j], e);
    }
    free(used);
}

struct csr *csr_create(int n, int n_links, const int *owner,
                       const int *neighbour)
{
    struct csr *const A = owner_create(sizeof *A);

    A->n = n;
    A->n_links = n_links;
    A->start = owner_ints(A, n + 1);
    A->col = owner_ints(A, 2 * n_links);
    A->a = owner_doubles(A, 2 * n_links);
    A->diag = owner_doubles(A, n);
    A->upper = owner_ints(A, n_links);
    A->lower = owner_ints(A, n_links);

    int *const link = alloc_ints(2 * n_links);

    count_rows(A, owner, neighbour);
    csr_fill_rows(A, link, owner, neighbour);
    for (int e = 0; e < 2 * n_links; e++)
        if (link[e] >= 0)
            A->upper[link[e]] = e;
        else
            A->lower[~link[e]] = e;
    free(link);
    return A;
}

void csr_set_diffusion(struct csr *A, const double *g, const double *sums)
{
    memcpy(A->diag, sums, (size_t)A->n * sizeof *sums);
    for (int l = 0; l < A->n_links; l++) {
        const int owner = A->col[A->lower[l]], neighbour = A->col[A->upper[l]];
        const double entry = owner == neighbour ? 0.0 : g[l];

        A->a[A->upper[l]] = A->a[A->lower[l]] = -entry;
        A->diag[owner] += entry;
        A->diag[neighbour] += entry;
    }
}

static void csr_rows(int first, int last, const struct csr *A, const double *x,
                     double *y)
{
    for (int i = first; i < last; i++) {
        double sum = A->diag[i] * x[i];

        for (int e = A->start[i]; e < A->start[i + 1]; e++)
            sum += A->a[e] * x[A->col[e]];
        y[i] = sum;
    }
}

void csr_multiply(const struct csr *A, const double *x, double *y)
{
    PARALLEL_RANGES(A->n, 4, csr_rows, A, x, y);
}

/* Computes rows for `width` fields from the k-th of m on. The diagonal has one
 * number for each row (step = 0), one for each row and field (step = 1), or is
 * left out (NULL). */
FIELD_GROUPS_KERNEL rows_of(int width, int k, int first, int last,
                            const struct csr *A, int m, const double *diag,
                            int step, const double *x, double *y)
{
    for (int i = first; i < last; i++) {
        const double *const xi = x + (long)m * i + k;
        const long at = step ? (long)m * i + k : i;
        double sum[FIELD_GROUPS_WIDTH] = {0.0};

        for (int f = 0; f < width && diag != NULL; f++)
            sum[f] = diag[at + f * step] * xi[f];
        for (int e = A->start[i]; e < A->start[i + 1]; e++) {
            const double a = A->a[e];
            const double *const xj = x + (long)m * A->col[e] + k;

            for (int f = 0; f < width; f++)
                sum[f] += a * xj[f];
        }
        for (int f = 0; f < width; f++)
            y[(long)m * i + k + f] = sum[f];
    }
}

static void rows_many(int first, int last, const struct csr *A, int m,
                      const double *x, double *y)
{
    FOR_FIELD_GROUPS(m, rows_of, first, last, A, m, A->diag, 0, x, y);
}

void csr_multiply_many(const struct csr *A, int m, const double *x, double *y)
{
    PARALLEL_RANGES(A->n, 4 * m, rows_many, A, m, x, y);
}

void csr_rows_each(int first, int last, const struct csr *A, int m,
                   const double *diag, const double *x, double *y)
{
    FOR_FIELD_GROUPS(m, rows_of, first, last, A, m, diag, 1, x, y);
}

/* --- ldu ------------------------------------------------------------------ */

struct ldu *ldu_create(int n, int n_links, const int *owner,
                       const int *neighbour, const struct face_pieces *pieces)
{
    struct ldu *const A = owner_create(sizeof *A);

    A->n = n;
    A->n_links = n_links;
    A->diagonals = 3;
    A->upper = owner_doubles(A, n_links);
    A->lower = owner_doubles(A, n_links);
    A->pieces = pieces;
    if (pieces == NULL)
        A->rows = owner_join(A, csr_create(n, n_links, owner, neighbour));
    return A;
}

static void ldu_fill_rows(int first, int last, struct ldu *A)
{
    const struct csr *const R = A->rows;

    for (int l = first; l < last; l++) {
        R->a[R->upper[l]] = A->upper[l];
        R->a[R->lower[l]] = A->lower[l];
    }
}

void ldu_update(struct ldu *A)
{
    if (A->rows != NULL) PARALLEL_RANGES(A->n_links, 2, ldu_fill_rows, A);
}

/* The entries of the rows of a piece, which are contiguous. */
static const double *entries(const struct ldu *A, const struct face_piece *p)
{
    return (p->out > 0.0 ? A->upper : A->lower) + p->face;
}

/* Whether a piece of successive faces consists of links between two cells. */
static int is_inner(const struct ldu *A, const struct face_piece *p)
{
    return p->face < A->n_links;
}

void ldu_row_sums(int first, int last, const struct ldu *A, double *sum)
{
    struct face_piece p = {0};

    for (int i = first; i < last; i++)
        sum[i] = 0.0;
    if (A->pieces == NULL) {
        for (int i = first; i < last; i++)
            for (int e = A->rows->start[i]; e < A->rows->start[i + 1]; e++)
                sum[i] += A->rows->a[e];
        return;
    }
    while (faces_next_of_cells(A->pieces, first, last, &p) && is_inner(A, &p)) {
        const double *restrict a = entries(A, &p);
        double *restrict s = sum + p.cell;

        for (int j = 0; j < p.n; j++)
            s[j] += a[j];
    }
}

void ldu_diagonal_rows(int first, int last, const struct ldu *A,
                       const double *diag, const double *x, double *y)
{
    double diag3[3 * VEC3_BLOCK];

    for (int n; first < last; first += n, y += 3L * n) {
        const double *d = diag + (long)A->diagonals * first;

        n = last - first < VEC3_BLOCK ? last - first : VEC3_BLOCK;
        if (A->diagonals == 1) {
            vec3_spread(n, d, diag3);
            d = diag3;
        }
        for (int i = 0; i < 3 * n; i++)
            y[i] = d[i] * x[3L * first + i];
    }
}

void ldu_rows(int first, int last, const struct ldu *A, const double *diag,
              const double *x, double *y)
{
    struct face_piece p = {0};

    if (A->pieces == NULL) {
        FOR_FIELD_GROUPS(3, rows_of, first, last, A->rows, 3, diag,
                         A->diagonals == 3, x, y);
        return;
    }
    if (diag == NULL)
        memset(y + 3L * first, 0, 3 * (size_t)(last - first) * sizeof *y);
    else
        ldu_diagonal_rows(first, last, A, diag, x, y + 3L * first);
    while (faces_next_of_cells(A->pieces, first, last, &p) && is_inner(A, &p))
        vec3_add(p.n, 1.0, entries(A, &p), x + 3L * p.other, y + 3L * p.cell);
}
