/* SPDX-License-Identifier: GPL-3.0-or-later */
/* equations_forces.c -- the further forces of LS 5.1, for `winnow eval`. */
#include "case/report/equations.h"

#include <stddef.h>

#include "coupling/effects/basset.h"
#include "coupling/effects/saffman.h"
#include "coupling/effects/spin.h"

EQUATION_OF_5(basset_force)
EQUATION_OF_3(saffman_reynolds)
EQUATION_OF_4(saffman_force)
EQUATION_OF_4(spin_force)

const struct equation equations_forces[] = {
    {"LS:5.4", "Basset's history force at a constant rate of the slip",
     "F = 3 d^2 sqrt(pi rho_f mu t) dw/dt, from w = 0 on",
     "rho_f [kg/m^3], mu [Pa s], d [m], t [s], rate [m/s^2]", "F", "N",
     EQUATION_BY(basset_force)},
    {"LS:5.5", "Reynolds number of a shear", "Re_G = d^2 G / nu",
     "d [m], nu [m^2/s], G [1/s]", "Re_G", "-", EQUATION_BY(saffman_reynolds)},
    {"LS:5.6", "Saffman's lift, as printed", "F = 1.61 mu d u_r sqrt(Re_G)",
     "mu [Pa s], d [m], u_r [m/s], Re_G [-]", "F", "N",
     EQUATION_BY(saffman_force)},
    {"LS:5.7", "Magnus's lift for a spin normal to the slip",
     "F = rho_f (pi d^2 / 4) C_LR |u_r| u_r / 2",
     "rho_f [kg/m^3], C_LR [-], d [m], u_r [m/s]", "F", "N",
     EQUATION_BY(spin_force)},
    {"", NULL, NULL, "", NULL, NULL, NULL, NULL}};
