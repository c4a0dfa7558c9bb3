/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics/filter.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

void filter_boxes(int n_fine, const double *V, const double *chi,
                  const int *box, int m, const double *phi, int n_boxes,
                  double *mean, double *chi_mean)
{
    double *const volume = alloc_doubles(n_boxes);

    memset(mean, 0, (size_t)(m * n_boxes) * sizeof *mean);
    memset(chi_mean, 0, (size_t)n_boxes * sizeof *chi_mean);
    for (int c = 0; c < n_fine; c++) {
        volume[box[c]] += V[c];
        chi_mean[box[c]] += chi[c] * V[c];
        for (int k = 0; k < m; k++)
            mean[m * box[c] + k] += chi[c] * V[c] * phi[m * c + k];
    }
    for (int b = 0; b < n_boxes; b++) {
        for (int k = 0; k < m; k++)
            mean[m * b + k] = chi_mean[b] > 0.0 ? mean[m * b + k] / chi_mean[b]
                                                : 0.0; /* [EW18 25] */
        if (volume[b] > 0.0) chi_mean[b] /= volume[b];
    }
    free(volume);
}
