/* SPDX-License-Identifier: GPL-3.0-or-later */
/* equations_ew18.c -- the rows of EW18 in equations.h. */
#include "case/report/equations.h"

#include "averaging/averaging.h"
#include "averaging/more/images.h"
#include "coupling/drag.h"
#include "coupling/drag_laws/beetstra.h"
#include "coupling/drag_laws/coefficient.h"
#include "coupling/drag_laws/di_felice.h"
#include "coupling/drag_laws/fluidization.h"
#include "coupling/effects/stochastic_drag.h"

#include <stddef.h>

/* Each function unpacks its inputs and calls the room's. */
EQUATION_OF_1(averaging_sigma)
EQUATION_OF_2(images_kernel)
EQUATION_OF_6(fluidization_velocity)
EQUATION_OF_5(coefficient_of_force)
EQUATION_OF_5(coefficient_reynolds)
EQUATION_OF_4(stochastic_drag_step)
EQUATION_OF_3(stochastic_drag_mean)
EQUATION_OF_3(stochastic_drag_variance)
EQUATION_OF_2(stochastic_drag_time)
EQUATION_OF_5(drag_di_felice_force)
EQUATION_OF_1(drag_di_felice_exponent)
EQUATION_OF_5(drag_beetstra_force)
EQUATION_OF_2(drag_beetstra_factor)

static double sphere_cd(const double *x)
{
    return drag_wen_yu_cd(1.0, x[0]);
}

const struct equation equations_ew18[] = {
    {"EW18:19", "Gaussian kernel",
     "W = exp(-r^2 / (2 sigma_k^2)) / (2 pi sigma_k^2)^(3/2)",
     "r [m], sigma_k [m]", "W", "1/m^3", EQUATION_BY(images_kernel)},
    {"EW18:20", "its width from that at half its height",
     "sigma_k = delta_05 / (2 sqrt(2 ln 2))", "delta_05 [m]", "sigma_k", "m",
     EQUATION_BY(averaging_sigma)},
    {"EW18:22", "velocity of minimum fluidization, superficial, Ergun",
     "(1 - eps) (rho_s - rho_f) g = beta u_mf, beta = 150 (1 - eps)^2 mu / "
     "(eps^3 d^2) + 1.75 (1 - eps) rho_f u_mf / (eps^3 d)",
     "eps_mf [-], rho_f [kg/m^3], rho_s [kg/m^3], mu [Pa s], d [m], g [m/s^2]",
     "u_mf", "m/s", EQUATION_BY(fluidization_velocity)},
    {"EW18:26", "drag coefficient of a force, with the superficial slip",
     "C_d = 8 F / (pi rho_f d^2 eps^2 u_r |u_r|)",
     "F [N], rho_f [kg/m^3], d [m], eps [-], u_r [m/s]", "C_d", "-",
     EQUATION_BY(coefficient_of_force)},
    {"EW18:27", "Reynolds number with the superficial slip",
     "Re_p = rho_f d eps |u_r| / mu",
     "eps [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "Re_p", "-",
     EQUATION_BY(coefficient_reynolds)},
    {"EW18:33", "fluctuation of the drag coefficient after a step",
     "C_next = a C + b sqrt(1 - a^2) w", "a [-], b [-], C [-], w [-]", "C_next",
     "-", EQUATION_BY(stochastic_drag_step)},
    {"EW18:35", "fluctuation to be expected after n steps", "E = a^n C",
     "a [-], n [-], C [-]", "E", "-", EQUATION_BY(stochastic_drag_mean)},
    {"EW18:36", "variance to be expected after n steps",
     "Var = b^2 (1 - a^(2 n))", "a [-], b [-], n [-]", "Var", "-",
     EQUATION_BY(stochastic_drag_variance)},
    {"EW18:37", "integral time of the fluctuation", "T = -dt / ln(a)",
     "a [-], dt [s]", "T", "s", EQUATION_BY(stochastic_drag_time)},
    {"EW18:A.1", "Reynolds number with the superficial slip",
     "Re_p = rho_f d eps |u_r| / mu",
     "eps [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "Re_p", "-",
     EQUATION_BY(coefficient_reynolds)},
    {"EW18:A.2", "drag after Di Felice, without the mean pressure gradient",
     "F = (1/2) C_d rho_f (pi d^2 / 4) (eps u_r)^2 eps^-chi; as printed, the "
     "whole force with u_r^2, it is 1 / eps^2 times that",
     "eps [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "F", "N",
     EQUATION_BY(drag_di_felice_force)},
    {"EW18:A.3", "exponent of the fluid fraction after Di Felice",
     "chi = 3.7 - 0.65 exp(-(1.5 - log10(Re))^2 / 2)", "Re [-]", "chi", "-",
     EQUATION_BY(drag_di_felice_exponent)},
    {"EW18:A.4", "drag coefficient of one sphere",
     "C_d = 24 (1 + 0.15 Re^0.687) / Re; 0.44 from Re = 1000 on", "Re [-]",
     "C_d", "-", "drag_wen_yu_cd", sphere_cd},
    {"EW18:A.5", "drag after Beetstra, the whole force",
     "F = 3 pi mu d u_r g(eps, Re_p), Re_p with the superficial slip",
     "eps [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "F", "N",
     EQUATION_BY(drag_beetstra_force)},
    {"EW18:A.6", "factor to Stokes' law after Beetstra",
     "g = 10 (1 - eps) / eps^2 + eps^2 (1 + 1.5 sqrt(1 - eps)) + 0.413 Re / "
     "(24 eps^2) (1 / eps + 3 eps (1 - eps) + 8.4 Re^-0.343) / (1 + 10^(3 (1 - "
     "eps)) Re^(-0.5 - 2 (1 - eps)))",
     "eps [-], Re [-]", "g", "-", EQUATION_BY(drag_beetstra_factor)},
    {"", NULL, NULL, "", NULL, NULL, NULL, NULL}};
