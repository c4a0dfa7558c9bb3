/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 02-caps.c -- what a sliding spring keeps: four rules on one impact.
 *
 * Test 6 of Chung and Ooi (2011), aluminium: a sphere that spins falls on a
 * rigid plane. Hertz and Mindlin with damping, e = 0.5, mu = 0.4. Along the
 * wall the slip s moves two sevenths of the mass.
 *
 *   02-caps curve   slip after over slip before, for each rule, and theirs
 *   02-caps rms     how far each is from theirs
 *   02-caps push    the largest force [N] along the slip of a fast slide
 */
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <string.h>

#include "dem/contact_hertz.h"

static const double R = 0.1, E = 70e9, nu = 0.33, rho = 2700.0;
static const double mu = 0.4, e = 0.5, v_n = 0.2;

enum { DASHPOT_TOO, WHOLE_FORCE, SPRING_FIRST, GIVES_WAY, RULES };
static const char *const rules[] = {"spring and dashpot", "the spring alone",
                                    "spring capped first",
                                    "reduced to the cap"};

/* Figure of Chung and Ooi, as digitised by the Kratos developers: mu (1 + e)
 * v_n over two sevenths of the slip, and the slip after over before. */
static const double theirs[][2] = {
    {0.18717, 0.81522},   {0.35829, 0.62625},  {0.5508, 0.43937},
    {0.76471, 0.2378},    {0.97861, 0.017323}, {1.2139, -0.096063},
    {1.492, -0.11076},    {1.7701, -0.089764}, {2.0909, -0.058268},
    {2.5187, -0.0057743}, {2.9893, 0.048819},  {3.631, 0.10341},
    {4.508, 0.13911},     {5.7701, 0.1622},    {7.8449, 0.2042},
    {11.909, 0.25879},    {23.995, 0.33858}};
enum { POINTS = sizeof theirs / sizeof *theirs };

/* Force along the wall; the spring is cut after the rule. */
static double friction(int rule, double k, double eta, double s, double most,
                       double *xi)
{
    if (rule == SPRING_FIRST && k * fabs(*xi) > most)
        *xi = copysign(most / k, *xi);
    const double trial = -k * *xi - eta * s;
    const double F = fmax(-most, fmin(most, trial));

    if (rule == DASHPOT_TOO && F != trial) *xi = -(F + eta * s) / k;
    if (rule == WHOLE_FORCE && F != trial) *xi = -F / k;
    if (rule == GIVES_WAY && F != trial && k * fabs(*xi) > most) *xi = -F / k;
    return F;
}

/* The slip after over before; `push` is the largest force along the slip. */
static double impact(int rule, double before, double *push)
{
    const double m = rho * 4.0 / 3.0 * M_PI * R * R * R;
    const double E_star = E / (1.0 - nu * nu);
    const double G_star = E / (2.0 * (1.0 + nu)) / (2.0 - nu);
    const double zeta = contact_damping_ratio(e);
    const double dt = 1e-4 * contact_hertz_time(E_star, R, m, v_n);
    double v = -v_n, delta = v_n * dt, s = before, xi = 0.0;

    *push = 0.0;
    while (delta > 0.0) {
        const double S_n = contact_hertz_slope(E_star, R, delta);
        const double k = contact_hertz_tangential(G_star, R, delta);
        const double F_n = contact_hertz_force(E_star, R, delta) -
                           contact_hertz_damping(zeta, S_n, m) * v;
        xi += s * dt;
        const double F = friction(rule, k, contact_hertz_damping(zeta, k, m), s,
                                  mu * fabs(F_n), &xi);
        v += F_n / m * dt;
        s += 3.5 * F / m * dt;
        delta -= v * dt;
        *push = fmax(*push, F * before / fabs(before));
    }
    return s / before;
}

static double slip(int i)
{
    return 3.5 * mu * (1.0 + e) * v_n / theirs[i][0];
}

int main(int argc, char **argv)
{
    const char *const mode = argc == 2 ? argv[1] : "";
    double push;

    if (strcmp(mode, "curve") == 0)
        puts("# 7/2 mu (1 + e) v_n over slip; slip after over before by the "
             "four "
             "rules, and published");
    for (int i = 0; i < POINTS && strcmp(mode, "curve") == 0; i++) {
        printf("%7.3f", theirs[i][0]);
        for (int rule = 0; rule < RULES; rule++)
            printf(" %8.4f", impact(rule, slip(i), &push));
        printf(" %8.4f\n", theirs[i][1]);
    }
    for (int rule = 0; rule < RULES && strcmp(mode, "rms") == 0; rule++) {
        double sum = 0.0;
        for (int i = 0; i < POINTS; i++) {
            const double miss = impact(rule, slip(i), &push) - theirs[i][1];
            sum += miss * miss;
        }
        printf("%-22s %.3f\n", rules[rule], sqrt(sum / POINTS));
    }
    for (int rule = 0; rule < RULES && strcmp(mode, "push") == 0; rule++) {
        impact(rule, 5.0, &push);
        printf("%-22s %.0f\n", rules[rule], push);
    }
    return 0;
}
