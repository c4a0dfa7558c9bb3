/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/diffusion_matrix.h"

#include <stddef.h>

/* Coefficient of the flux through internal face f: g (phi_N - phi_P) [m]. */
static double diffusion_coefficient(const struct mesh *m, int f)
{
    const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
    const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
    const double Sd = S[0] * d[0] + S[1] * d[1] + S[2] * d[2];
    return SS / Sd;
}

/* A = diag + factor times the Laplacian of [SX15 5a]; only internal faces have
 * a flux [SX15 5c]. D: one more factor for each face, or NULL. */
void diffusion_matrix_fill(struct csr *A, const struct mesh *m,
                           const double *diag, double factor, const double *D)
{
    for (int c = 0; c < m->n_cells; c++)
        A->diag[c] = diag != NULL ? diag[c] : 0.0;
    for (int f = 0; f < m->n_internal; f++) {
        const double g =
            factor * diffusion_coefficient(m, f) * (D != NULL ? D[f] : 1.0);
        A->a[A->upper[f]] = A->a[A->lower[f]] = -g;
        A->diag[m->owner[f]] += g;
        A->diag[m->neighbour[f]] += g;
    }
}
