/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics/temperature.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <string.h>

#include "base/statistics/moments.h"

double temperature_of(int n, const double *v)
{
    const double s = moments_deviation(n, v);

    return s * s;
}

double temperature_bed_height(int n, const double *y, double floor)
{
    return n > 0 ? 2.0 * (moments_mean(n, y) - floor) : 0.0;
}

double temperature_percentile(int n, const double *y, double q, double *room)
{
    if (n == 0) return 0.0;
    memcpy(room, y, (size_t)n * sizeof *room);
    gsl_sort(room, 1, (size_t)n);
    return gsl_stats_quantile_from_sorted_data(room, 1, (size_t)n, q);
}
