/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/coupling.h"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_poly.h>
#include <math.h>

#include "coupling/reaction.h"

double stability_longest_step(double eps_f, double tau_p)
{
    return 2.0 * eps_f * eps_f * tau_p; /* (20.6) */
}

/* The root of 4 M x^2 + (2 - 2 M) x - 4 = 0, as (20.2) for this treatment. */
double stability_frozen_limit(double M)
{
    const double b = 1.0 - M;

    return 4.0 / (b + sqrt(b * b + 16.0 * M));
}

double stability_loading(double rho_s, double eps_s, double rho_f)
{
    return eps_s * rho_s / ((1.0 - eps_s) * rho_f);
}

/* Of a bed that is free: the largest root of (20.12), which is (20.10) where
 * there is no history. */
static double free_bed(const struct added_mass *added, double ratio, double q,
                       double s)
{
    const double C = added->C, H = added->C_history, r = ratio + C;
    gsl_complex x[3];
    double largest = 0.0;

    gsl_poly_complex_solve_cubic((q * (1.0 + 2.0 * C + s * q * C) + H) / r,
                                 ((1.0 - s) * q * q * C + 2.0 * q * H) / r,
                                 q * q * H / r, &x[0], &x[1], &x[2]);
    for (int i = 0; i < 3; i++)
        largest = fmax(largest, gsl_complex_abs(x[i]));
    return largest;
}

/* Of the fluid in a bed at rest: the larger root of (20.13). */
static double bed_at_rest(const struct added_mass *added, double q, double s)
{
    gsl_complex x[2];
    const int n = gsl_poly_complex_solve_quadratic(
        1.0 + s * q * added->C, (1.0 - s) * q * added->C, q * added->C_history,
        &x[0], &x[1]);

    return n == 2 ? fmax(gsl_complex_abs(x[0]), gsl_complex_abs(x[1])) : 0.0;
}

double stability_amplification(const struct added_mass *added, double ratio,
                               double eps_s, int implicit)
{
    const double q = eps_s / (1.0 - eps_s);
    const double s =
        implicit ? reaction_share_in_advance(added->C, ratio, eps_s) : 0.0;

    return fmax(free_bed(added, ratio, q, s), bed_at_rest(added, q, s));
}

double stability_max_solid_fraction(const struct added_mass *added,
                                    double ratio, int implicit)
{
    double low = 0.0, high = 1.0;

    for (int i = 0; i < 50; i++) {
        const double middle = 0.5 * (low + high);
        if (stability_amplification(added, ratio, middle, implicit) < 1.0)
            low = middle;
        else
            high = middle;
    }
    return low;
}
