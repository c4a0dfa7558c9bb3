/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/ldu.h"

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "linear/reduce.h"

#include <stdlib.h>
#include <string.h>

struct ldu *ldu_create(int n, int n_links, const int *owner,
                       const int *neighbour, const struct face_pieces *pieces)
{
    struct ldu *const A = alloc_zeroed(1, sizeof *A);

    A->n = n;
    A->n_links = n_links;
    A->upper = alloc_doubles(n_links);
    A->lower = alloc_doubles(n_links);
    A->pieces = pieces;
    if (pieces == NULL) A->rows = csr_create(n, n_links, owner, neighbour);
    return A;
}

void ldu_free(struct ldu *A)
{
    if (A == NULL) return;
    free(A->upper);
    free(A->lower);
    csr_free(A->rows);
    free(A);
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

void ldu_rows(int first, int last, const struct ldu *A, const double *diag3,
              const double *x, double *y)
{
    struct face_piece p = {0};

    if (A->pieces == NULL) {
        csr_rows_each(first, last, A->rows, 3, diag3, x, y);
        return;
    }
    if (diag3 == NULL)
        memset(y + 3L * first, 0, 3 * (size_t)(last - first) * sizeof *y);
    else
        for (long i = 3L * first; i < 3L * last; i++)
            y[i] = diag3[i] * x[i];
    while (faces_next_of_cells(A->pieces, first, last, &p) && is_inner(A, &p))
        vec3_add(p.n, 1.0, entries(A, &p), x + 3L * p.other, y + 3L * p.cell);
}
