/* SPDX-License-Identifier: GPL-3.0-or-later */
/* huilin_gidaspow.c -- Ergun's packed bed and Wen and Yu's suspension, blended
 * about eps_f = 0.8 by an arcus tangens [Huilin03]: Gidaspow's law without its
 * jump. */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/drag_laws/factor.h"

/* beta_Ergun and beta_WenYu of [LS 5.27], over eps_s 18 mu eps_f / d^2. */
static double ergun_factor(double eps_f, double Re)
{
    return (150.0 * (1.0 - eps_f) + 1.75 * Re) / (18.0 * eps_f * eps_f);
}

static double wen_yu_factor(double eps_f, double Re)
{
    return drag_sphere(Re) * pow(eps_f, -3.65);
}

/* phi_gs = atan(150 x 1.75 (0.2 - eps_s)) / pi + 1/2, the weight of Wen and
 * Yu's law [Huilin03]. */
static double huilin_gidaspow_factor(double eps_f, double Re)
{
    const double phi = atan(262.5 * (eps_f - 0.8)) / M_PI + 0.5;

    return (1.0 - phi) * ergun_factor(eps_f, Re) +
           phi * wen_yu_factor(eps_f, Re);
}

static double huilin_gidaspow(double eps_f, double rho_f, double mu, double d,
                              double u_r)
{
    return drag_by_factor(huilin_gidaspow_factor, eps_f, rho_f, mu, d, u_r);
}

const struct drag_law drag_huilin_gidaspow = {
    .name = "huilin-gidaspow",
    .what = "Gidaspow's law with its two branches blended",
    .equations = "LS 5.25-5.27",
    .function = "huilin_gidaspow",
    .eps_min = 0.35,
    .eps_max = 1.0,
    .Re_max = 2e3,
    .resistance = huilin_gidaspow,
};
