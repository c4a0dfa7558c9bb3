/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/solvers.h"

#include <stddef.h>

#include "base/parallel_ranges.h"
#include "linear/matrix.h"
#include "linear/reduce.h"

struct preconditioned preconditioned_create(int n, int n_links,
                                            const int *owner,
                                            const int *neighbour,
                                            const double *strength,
                                            const double *link, const double *V)
{
    const struct preconditioned_kind *const kind = &multigrid_preconditioned;

    return (struct preconditioned){
        kind, kind->create(n, n_links, owner, neighbour, strength, link, V)};
}

void preconditioned_set(struct preconditioned A, const double *g,
                        const double *sums)
{
    A.kind->set(A.matrix, g, sums);
}

static void *preconditioned_jacobi_create(int n, int n_links, const int *owner,
                                          const int *neighbour,
                                          const double *strength,
                                          const double *link, const double *V)
{
    (void)strength;
    (void)link;
    (void)V;
    return csr_create(n, n_links, owner, neighbour);
}

static void preconditioned_jacobi_set(void *matrix, const double *g,
                                      const double *sums)
{
    csr_set_diffusion(matrix, g, sums);
}

static double preconditioned_jacobi_multiply(const void *matrix,
                                             const double *x, double *y)
{
    const struct csr *const A = matrix;

    csr_multiply(A, x, y);
    return reduce_dot(A->n, x, y);
}

/* r.D^-1 r over a range. */
static double preconditioned_jacobi_sum(int first, int last, const double *diag,
                                        const double *r)
{
    double sum = 0.0;

    for (int i = first; i < last; i++)
        sum += r[i] * (r[i] / diag[i]);
    return sum;
}

static double preconditioned_jacobi_apply(void *matrix, const double *r,
                                          double rr)
{
    const struct csr *const A = matrix;
    double rz;

    (void)rr;
    PARALLEL_SUM(rz, A->n, 1, preconditioned_jacobi_sum, A->diag, r);
    return rz;
}

static void divided_rows(int first, int last, const double *diag,
                         const double *r, double beta, double *p)
{
    for (int i = first; i < last; i++)
        p[i] = r[i] / diag[i] + beta * p[i];
}

static void preconditioned_jacobi_direction(const void *matrix, const double *r,
                                            double beta, double *p)
{
    const struct csr *const A = matrix;

    PARALLEL_RANGES(A->n, 1, divided_rows, A->diag, r, beta, p);
}

const struct preconditioned_kind preconditioned_jacobi = {
    .name = "jacobi",
    .create = preconditioned_jacobi_create,
    .set = preconditioned_jacobi_set,
    .multiply = preconditioned_jacobi_multiply,
    .apply = preconditioned_jacobi_apply,
    .direction = preconditioned_jacobi_direction,
};
