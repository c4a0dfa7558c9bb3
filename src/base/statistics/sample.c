/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics/sample.h"

#include <math.h>

#include "base/statistics/moments.h"

static int sample_is_near(double x, double x_0, double tolerance)
{
    return fabs(x - x_0) <= tolerance * x_0;
}

struct sample_moments sample_near(int n, const double *value, const double *Re,
                                  const double *eps, double Re_0, double eps_0,
                                  double tolerance, double *room)
{
    struct sample_moments s = {0};

    for (int i = 0; i < n; i++)
        if (sample_is_near(Re[i], Re_0, tolerance) &&
            sample_is_near(eps[i], eps_0, tolerance))
            room[s.n++] = value[i];
    s.mean = moments_mean(s.n, room);
    s.deviation = moments_deviation(s.n, room);
    s.deviation_error = s.n > 0 ? s.deviation / sqrt(2.0 * s.n) : 0.0;
    return s;
}
