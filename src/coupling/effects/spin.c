/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/spin.h"

#include <gsl/gsl_math.h>
#include <math.h>

#include "base/vector.h"

double spin_reynolds(double rho, double mu, double d, double Omega)
{
    return rho * d * d * Omega / mu;
}

/* Re_r/Re = d |Omega|/|w| is the coefficient at small Re; without viscosity the
 * limit is left. */
double spin_lift_coefficient(double Re, double Re_r)
{
    if (!(Re < HUGE_VAL)) return 0.45;
    return 0.45 +
           (Re_r / Re - 0.45) * exp(-0.05684 * pow(Re_r, 0.4) * pow(Re, 0.3));
}

double spin_force(double rho, double C_LR, double d, double u_r)
{
    return 0.5 * rho * 0.25 * M_PI * d * d * C_LR * fabs(u_r) *
           u_r; /* [LS 5.7] */
}

void spin_lift(double rho, double mu, double d, const double w[3],
               const double Omega[3], double F[3])
{
    const double speed = vector_length(w), spin = vector_length(Omega);
    double size = 0.0;

    if (speed > 0.0 && spin > 0.0)
        size =
            spin_force(rho,
                       spin_lift_coefficient(rho * speed * d / mu,
                                             spin_reynolds(rho, mu, d, spin)),
                       d, speed) /
            (speed * spin);
    vector_cross(w, Omega, F);
    for (int a = 0; a < 3; a++)
        F[a] *= size;
}

double spin_torque_factor(double Re_r)
{
    return Re_r <= 32.0 ? 64.0 * M_PI : 12.9 * sqrt(Re_r) + 128.4;
}

/* T/(I Omega) with T = (1/2) rho (d/2)^5 (factor/Re_r) Omega^2 and I = m d^2/10
 * = pi rho_s d^5/60. */
double spin_decay_rate(double rho, double mu, double d, double rho_s,
                       double Omega)
{
    if (mu == 0.0) return 0.0;
    const double factor = spin_torque_factor(spin_reynolds(rho, mu, d, Omega));
    return 15.0 / 16.0 * factor * mu / (M_PI * rho_s * d * d);
}
