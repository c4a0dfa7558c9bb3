/* SPDX-License-Identifier: GPL-3.0-or-later */
/* stress_law.c -- the stress of particles that do not meet. Chapter "Fewer or
 * other particles".
 */
#include "coupling/effects/forces.h"

#include <math.h>

/* 2 (1 + e) g_0 [-], and eps_s times its slope: (eps/eps_cp)^(1/3) of it. */
static double lun_factor(const struct particle_stress_law *law, double eps_s,
                         double *eps_slope)
{
    const double root = cbrt(eps_s / law->packing);
    const double factor = 1.2 * (1.0 + law->e) / (1.0 - root);

    *eps_slope = factor * root / (3.0 * (1.0 - root));
    return factor;
}

double particle_stress(const struct particle_stress_law *law, double P,
                       double eps_s)
{
    double unused;

    if (law->lun)
        return P * eps_s * (1.0 + eps_s * lun_factor(law, eps_s, &unused));
    return P * pow(eps_s, law->exponent) / (law->packing - eps_s);
}

double particle_stress_slope(const struct particle_stress_law *law, double P,
                             double eps_s)
{
    double eps_slope;

    if (law->lun) {
        const double factor = lun_factor(law, eps_s, &eps_slope);
        return P * (1.0 + eps_s * (2.0 * factor + eps_slope));
    }
    return particle_stress(law, P, eps_s) *
           (law->exponent / eps_s + 1.0 / (law->packing - eps_s));
}

/* Newton's method for ln tau in ln y, y = eps / (eps_cp - eps): nearly a line
 * of slope 1 to beta. It begins where eps is for a small tau. */
double particle_stress_fraction(const struct particle_stress_law *law, double P,
                                double tau)
{
    const double cp = law->packing;

    if (tau <= 1e-300 * P) return 0.0; /* and no number below becomes 0 */
    if (!law->lun && law->exponent == 2.0)
        return 2.0 * tau * cp / (tau + sqrt(tau * tau + 4.0 * P * tau * cp));
    double eps = fmin(
        0.5 * cp, law->lun ? tau / P : pow(tau / P * cp, 1.0 / law->exponent));
    double ln_y = log(eps / (cp - eps));
    for (int k = 0; k < 50; k++) {
        const double now = particle_stress(law, P, eps);
        const double slope =
            particle_stress_slope(law, P, eps) / now * eps * (cp - eps) / cp;
        const double change = log(tau / now) / slope;
        ln_y += change;
        eps = cp / (1.0 + exp(-ln_y));
        if (fabs(change) < 1e-12) break;
    }
    return eps;
}
