/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 23-signal.c -- a signal with a memory [EW18 33], with two steps.
 *
 * sigma = 1, T = 1, steps of 0.02 and of 0.2. First block: time and the first
 * of the signals, then of the second. Second block: lag, R of 400 signals of
 * each, and exp(-tau / T).
 */
#include <math.h>
#include <stdio.h>

#include "base/statistics.h"
#include "coupling/effects/forces.h"

enum { N = 8192, SIGNALS = 400, LAGS = 250 };

static void fill(double dt, int which, double *C)
{
    const double a = stochastic_drag_memory(dt, 1.0);

    C[0] = random_normal(1, which, 0, 0);
    for (int k = 1; k < N; k++)
        C[k] = stochastic_drag_step(a, 1.0, C[k - 1],
                                    random_normal(1, which, k, 0));
}

int main(void)
{
    static const double step[] = {0.02, 0.2};
    static double C[N], c[2][LAGS], R[2][LAGS];

    for (int s = 0; s < 2; s++) {
        fill(step[s], s, C);
        for (int k = 0; k * step[s] <= 12.0; k++)
            printf("%.2f %.4f\n", k * step[s], C[k]);
        printf("\n\n");
    }
    for (int s = 0; s < 2; s++) {
        for (int i = 0; i < SIGNALS; i++) {
            fill(step[s], i, C);
            correlation_add(N, C, LAGS, c[s]);
        }
        correlation_normalise(LAGS, c[s], R[s]);
    }
    for (int k = 0; k < LAGS; k += 10) {
        printf("%.2f %.4f", k * step[0], R[0][k]);
        printf(" %.4f %.4f\n", R[1][k / 10], exp(-k * step[0]));
    }
    return 0;
}
