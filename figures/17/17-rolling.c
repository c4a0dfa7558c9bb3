/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The last moments of a sphere that rolls: with the spring of rolling friction
 * that the program has, and with a moment of constant size against the motion.
 * Columns: time [ms] from 1 ms before theory stops it, speeds [um/s] of both.
 */
#include <stdio.h>

#include "dem/contact.h"

int main(void)
{
    const double R = 0.005, g = 9.81, mu_r = 0.025, dt = 2e-5, pi = 3.14159265;
    const double m = 2500.0 * pi / 6.0 * 8.0 * R * R * R, I = 1.4 * m * R * R;
    const double k_t = 2.0 / 7.0 * 2.0 / (1.0 / 2e4 + 1.0 / 2e3);
    const double k_r = k_t * R * R, most = mu_r * R * m * g;
    const double C_r = 2.0 * rolling_damping_ratio * sqrt(I * k_r);
    const double n[3] = {0.0, 1.0, 0.0}, start = most / I * 1.006e-3;
    double theta[3] = {0.0, 0.0, -most / k_r}, M[3];
    double spring[3] = {0.0, 0.0, -start}, constant = start;

    for (int step = 0; step <= 6000; step++) {
        if (step % 9 == 0)
            printf("%.2f %.4g %.4g\n", step * dt * 1e3, -spring[2] * R * 1e6,
                   constant * R * 1e6);
        rolling_moment(M, theta, spring, n, k_r, C_r, most, dt);
        spring[2] += M[2] / I * dt;
        constant -= (constant > 0.0 ? 1.0 : -1.0) * most / I * dt;
    }
    return 0;
}
