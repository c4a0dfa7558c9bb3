/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics/density.h"

#include "base/number.h"

double density_of(int n, const double *x, double low, double high, int n_bins,
                  double *p)
{
    const double width = (high - low) / n_bins;
    int inside = 0;

    for (int i = 0; i < n_bins; i++)
        p[i] = 0.0;
    for (int i = 0; i < n; i++) {
        if (!(x[i] >= low && x[i] < high)) continue;
        p[number_clamped((x[i] - low) / width, 0, n_bins - 1)] += 1.0;
        inside++;
    }
    for (int i = 0; i < n_bins && n > 0; i++)
        p[i] /= n * width;
    return n > 0 ? (double)inside / n : 0.0;
}
