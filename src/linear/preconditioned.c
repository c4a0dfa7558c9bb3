/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/preconditioned.h"

#include <stddef.h>

#include "base/parallel_ranges.h"
#include "linear/csr.h"
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

void preconditioned_free(struct preconditioned A)
{
    if (A.matrix != NULL) A.kind->free(A.matrix);
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

static void preconditioned_jacobi_free(void *matrix)
{
    csr_free(matrix);
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

/* z = D^-1 r over a range; returns its part of r.z. */
static double preconditioned_jacobi_divide(int first, int last,
                                           const double *diag, const double *r,
                                           double *z)
{
    for (int i = first; i < last; i++)
        z[i] = r[i] / diag[i];
    return reduce_range(first, last, r, z);
}

static double preconditioned_jacobi_apply(void *matrix, const double *r,
                                          double *z)
{
    const struct csr *const A = matrix;
    double rz;

    PARALLEL_SUM(rz, A->n, 1, preconditioned_jacobi_divide, A->diag, r, z);
    return rz;
}

const struct preconditioned_kind preconditioned_jacobi = {
    .name = "jacobi",
    .create = preconditioned_jacobi_create,
    .free = preconditioned_jacobi_free,
    .set = preconditioned_jacobi_set,
    .multiply = preconditioned_jacobi_multiply,
    .apply = preconditioned_jacobi_apply,
};
