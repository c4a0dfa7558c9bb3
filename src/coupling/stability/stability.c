/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/stability/stability.h"

#include <math.h>

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

double stability_amplification(double C, double rho_s, double eps_s,
                               double rho_f)
{
    return (1.0 + C) / (rho_s / rho_f + C) * eps_s / (1.0 - eps_s); /* (20.9) */
}

double stability_max_solid_fraction(double C, double rho_s, double rho_f)
{
    const double heavy = (rho_s / rho_f + C) / (1.0 + C);

    return heavy / (1.0 + heavy); /* (20.9) solved for eps_s */
}
