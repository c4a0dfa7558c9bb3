/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The spread of numbers that lie far from zero, in two ways.
 *
 *     sh figures/run.sh figures/12/12-mean.c
 */
#include "base/alloc.h"
#include "output/means/means.h"

#include <math.h>
#include <stdio.h>

enum { N = 1000 };

static double noise(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) / 8388607.5 - 1.0;
}

int main(void)
{
    /* Noise twice, about the mean and with the other sign: its own mean is
     * zero and its spread is known. */
    double square = 0.0;
    unsigned seed = 1;

    for (int i = 0; i < N; i++)
        square += pow(noise(&seed), 2);

    const double spread = sqrt(square / N);

    printf("# mean over spread, error by sums, by mean_add\n");
    for (double far = 1.0; far < 2e10; far *= 10.0) {
        const double middle = ldexp(round(ldexp(far * spread, 8)), -8);
        struct mean *const m = mean_create(1);
        double sum = 0.0, squares = 0.0;

        seed = 1;
        for (int i = 0; i < N; i++) {
            const double s = noise(&seed);

            for (int sign = -1; sign <= 1; sign += 2) {
                const double x = middle + sign * s;

                mean_add(m, 1.0, &x, NULL);
                sum += x;
                squares += x * x;
            }
        }

        const double difference = squares / (2 * N) - pow(sum / (2 * N), 2);
        const double plain = difference > 0.0 ? sqrt(difference) : 0.0;

        printf("%.0e %.1e %.1e\n", far, fabs(plain / spread - 1.0) + 1e-16,
               fabs(mean_spread(m, 0) / spread - 1.0) + 1e-16);
        owner_free(m);
    }
    return 0;
}
