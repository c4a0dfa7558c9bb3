/* diffusion_matrix.h -- the Laplacian of the diffusion. Chapter "Averaging". */
#ifndef AVERAGING_DIFFUSION_MATRIX_H
#define AVERAGING_DIFFUSION_MATRIX_H

#include "linear/csr.h"
#include "mesh/mesh.h"

/* A = diag + factor times -V div (D grad) [m]; diag [m^3] or NULL for none. D:
 * one more factor for each internal face [-], or NULL for 1. */
void diffusion_matrix_fill(struct csr *A, const struct mesh *m,
                           const double *diag, double factor, const double *D);

#endif
