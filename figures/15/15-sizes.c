/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 15-sizes.c -- the sizes of XS11's Case 4, drawn and exact.
 *
 * For 50 diameters the share that is smaller, of the number and of the mass of
 * all particles: of the distribution, and of 2160 particles drawn from it.
 * Then the moments of both.
 */
#include <gsl/gsl_math.h>
#include <gsl/gsl_rng.h>
#include <stdio.h>

#include "base/alloc.h"
#include "dem/population/sizes.h"

enum { COUNT = 2160, LINES = 50 };

/* Share of the d^k of all that is in diameters below x. */
static double drawn_below(const double *d, int k, double x)
{
    double below = 0.0, all = 0.0;

    for (int i = 0; i < COUNT; i++) {
        const double part = gsl_pow_int(d[i], k);
        all += part;
        below += d[i] < x ? part : 0.0;
    }
    return below / all;
}

static double drawn_mean(const double *d, int k)
{
    double sum = 0.0;

    for (int i = 0; i < COUNT; i++)
        sum += gsl_pow_int(d[i], k) / COUNT;
    return sum;
}

int main(void)
{
    const struct sizes_options o = {.law = sizes_law_named("normal"),
                                    .mean = 1.25e-3,
                                    .deviation = 0.5e-3,
                                    .min = 0.083e-3,
                                    .max = 2.5e-3};
    struct sizes *const s = sizes_create(&o);
    gsl_rng *const random = gsl_rng_alloc(gsl_rng_ranlxd1);
    double d[COUNT];

    for (int i = 0; i < COUNT; i++)
        d[i] = sizes_quantile(s, gsl_rng_uniform(random));
    puts("# d [mm], share below by number and by mass, exact; the same, drawn");
    for (int i = 1; i <= LINES; i++) {
        const double x = 2.5e-3 * i / LINES;
        printf("%.3f %.5f %.5f %.5f %.5f\n", 1e3 * x,
               sizes_moment_below(s, 0, x),
               sizes_moment_below(s, 3, x) / sizes_moment(s, 3),
               drawn_below(d, 0, x), drawn_below(d, 3, x));
    }
    puts("## moments");
    printf("mean = %.4f mm\nmean_drawn = %.4f mm\n", 1e3 * sizes_moment(s, 1),
           1e3 * drawn_mean(d, 1));
    printf("cube = %.4f mm3\ncube_drawn = %.4f mm3\n", 1e9 * sizes_moment(s, 3),
           1e9 * drawn_mean(d, 3));
    printf("small_number = %.2f %%\nsmall_mass = %.3f %%\n",
           100.0 * sizes_moment_below(s, 0, 0.83e-3),
           100.0 * sizes_moment_below(s, 3, 0.83e-3) / sizes_moment(s, 3));
    gsl_rng_free(random);
    owner_free(s);
    return 0;
}
