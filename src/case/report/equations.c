/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/equations.h"

#include "averaging/diffusion.h"
#include "averaging/kernel/kernel.h"
#include "coupling/effects/time_average.h"
#include "coupling/drag.h"
#include "case/report/exact.h"
#include "dem/cohesion/capillary.h"
#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"
#include "dem/cohesion/electrostatic.h"
#include "dem/limits.h"
#include "dem/cohesion/van_der_waals.h"

#include <stdio.h>
#include <string.h>

/* Each function unpacks its inputs and calls the room's. */
EQUATION_OF_4(drag_reynolds)
EQUATION_OF_2(drag_terminal_ratio)
EQUATION_OF_7(exact_released)
EQUATION_OF_1(kernel_bell)
EQUATION_OF_2(diffusion_kernel)
EQUATION_OF_2(time_average_weight)
EQUATION_OF_4(contact_linear_damping)
EQUATION_OF_4(electrostatic_force)
EQUATION_OF_4(limits_rayleigh)
EQUATION_OF_4(drag_force)
EQUATION_OF_3(drag_stokes_time)
EQUATION_OF_4(drag_schiller_naumann_time)
EQUATION_OF_2(drag_wen_yu_cd)

static double syamlal_b(const double *x)
{
    return drag_coefficient(drag_law_named("syamlal-obrien"), x[0], x[1], x[2],
                            x[3], x[4]);
}

static double syamlal_beta(const double *x)
{
    return drag_beta(drag_law_named("syamlal-obrien"), x[0], x[1], x[2], x[3],
                     x[4]);
}

static double equations_relaxation_time(const double *x)
{
    return drag_relaxation_time(drag_law_named("syamlal-obrien"), x[0], x[1],
                                x[2], x[3], x[4], x[5]);
}

/* The next three begin with E_i E_j nu_i nu_j R_i R_j. */
static double mean_radius(const double *x)
{
    return contact_hertz_radius(x[4], x[5]);
}

static double hertz_force(const double *x)
{
    const double E = contact_hertz_modulus(x[0], x[2], x[1], x[3]);
    return contact_hertz_force(E, mean_radius(x), x[6]);
}

static double hertz_stiffness(const double *x)
{
    const double E = contact_hertz_modulus(x[0], x[2], x[1], x[3]);
    return contact_hertz_stiffness(E, mean_radius(x));
}

static double mindlin_stiffness(const double *x)
{
    const double G = contact_hertz_shear(x[0], x[2], x[1], x[3]);
    return contact_hertz_tangential(G, mean_radius(x), x[6]);
}

/* [LS 4.11, 4.12] */
static double critical_damping(const double *x)
{
    return contact_linear_dashpot(1.0, x[1], x[0]);
}

static double hamaker(const double *x)
{
    return van_der_waals_force(x[0], van_der_waals_diameter(x[1], x[2]), x[3]);
}

static double bridge(const double *x)
{
    return capillary_force(x[0] * cos(x[1]), capillary_mean(x[2], x[3]));
}

/* The document counts the fluid, alpha; beta is that of [XS11 2.9]. */
static double gidaspow_beta(const double *x)
{
    return drag_beta(drag_law_named("gidaspow"), 1.0 - x[0], x[1], x[2], x[3],
                     x[4]);
}

static const struct equation others[] = {
    {"XS11:2.10", "drag of a particle over eps_f and slip, Syamlal-O'Brien",
     "B = V_p beta / (eps_s eps_f), V_p = pi d^3 / 6",
     "eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "B", "kg/s",
     "drag_coefficient", syamlal_b},
    {"XS11:2.11", "drag of a mixture over slip, Syamlal-O'Brien",
     "beta = (3/4) C_d / V_r^2 rho_f u_r eps_s eps_f / d, C_d = (0.63 + 4.8 "
     "sqrt(V_r / Re))^2",
     "eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "beta",
     "kg/(m^3 s)", "drag_beta", syamlal_beta},
    {"XS11:2.12", "Reynolds number of a particle", "Re = rho_f d u_r / mu",
     "rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "Re", "-",
     EQUATION_BY(drag_reynolds)},
    {"XS11:2.13", "terminal velocity of a suspension over that of one sphere",
     "V_r = (A1 - 0.06 Re + sqrt((0.06 Re)^2 + 0.12 Re (2 A2 - A1) + A1^2)) / "
     "2, A1 = eps_f^4.14, A2 = 0.8 eps_f^1.28 to eps_f = 0.85, eps_f^2.65 "
     "above",
     "Re [-], eps_f [-]", "V_r", "-", EQUATION_BY(drag_terminal_ratio)},
    {"XS11:3.6", "bell kernel", "K = (1 - zeta^2)^4 for zeta < 1, else 0",
     "zeta [-]", "K", "-", EQUATION_BY(kernel_bell)},
    {"XS11:3.17", "time in which drag would stop a particle, Syamlal-O'Brien",
     "tau_p = rho_s eps_s / beta",
     "rho_s [kg/m^3], eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]",
     "tau_p", "s", "drag_relaxation_time", equations_relaxation_time},
    {"XS11:4.1", "velocity of a particle that is released from rest in a fluid",
     "du/dt = (u_f - u) / tau_p, tau_p of XS11:3.17 at u_r = |u_f - u|, u = 0 "
     "at t = 0",
     "rho_s [kg/m^3], eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_f [m/s], "
     "t "
     "[s]",
     "u", "m/s", EQUATION_BY(exact_released)},
    {"SX15:6", "Gaussian kernel equivalent to diffusion",
     "h = exp(-r^2 / b^2) / (pi b^2)^(3/2)", "r [m], b [m]", "h", "1/m^3",
     EQUATION_BY(diffusion_kernel)},
    {"SX15:14", "weight of the past in an exponential moving average",
     "alpha = 1 / (1 + dt / b_t)", "dt [s], b_t [s]", "alpha", "-",
     EQUATION_BY(time_average_weight)},
    {"LS:4.4", "damping of the linear contact for a restitution e",
     "eta = 2 zeta sqrt(k m*), zeta = -ln e / sqrt(pi^2 + ln^2 e), m* = m_i "
     "m_j / (m_i + m_j)",
     "k [N/m], e [-], m_i [kg], m_j [kg]", "eta", "kg/s",
     EQUATION_BY(contact_linear_damping)},
    {"LS:4.7", "elastic normal force between two spheres, Hertz",
     "F_n = (4/3) E* sqrt(R*) delta^(3/2)",
     "E_i [Pa], E_j [Pa], nu_i [-], nu_j [-], R_i [m], R_j [m], delta [m]",
     "F_n", "N", "contact_hertz_force", hertz_force},
    {"LS:4.9", "normal stiffness of two spheres, Hertz",
     "k_n = (4/3) E* sqrt(R*), 1/E* = (1 - nu_i^2) / E_i + (1 - nu_j^2) / E_j, "
     "R* = R_i R_j / (R_i + R_j)",
     "E_i [Pa], E_j [Pa], nu_i [-], nu_j [-], R_i [m], R_j [m]", "k_n",
     "N/m^1.5", "contact_hertz_stiffness", hertz_stiffness},
    {"LS:4.10", "tangential stiffness of two spheres, Mindlin",
     "k_t = 8 G* sqrt(R* delta), 1/G* = (2 - nu_i) / G_i + (2 - nu_j) / G_j, G "
     "= E / (2 (1 + nu))",
     "E_i [Pa], E_j [Pa], nu_i [-], nu_j [-], R_i [m], R_j [m], delta [m]",
     "k_t", "N/m", "contact_hertz_tangential", mindlin_stiffness},
    {"LS:4.11", "critical normal damping of a spring and a mass",
     "eta_n = 2 sqrt(m k_n)", "m [kg], k_n [N/m]", "eta_n", "kg/s",
     "contact_linear_dashpot", critical_damping},
    {"LS:4.12", "critical tangential damping of a spring and a mass",
     "eta_t = 2 sqrt(m k_t)", "m [kg], k_t [N/m]", "eta_t", "kg/s",
     "contact_linear_dashpot", critical_damping},
    {"LS:4.13", "force between two charged spheres; positive repels",
     "F = q_i q_j / (4 pi eps_0 eps_r l^2)",
     "q_i [C], q_j [C], eps_r [-], l [m]", "F", "N",
     EQUATION_BY(electrostatic_force)},
    {"LS:4.14", "van der Waals attraction of two spheres, l their gap",
     "F = A D / (12 l^2), D = D_i D_j / (D_i + D_j)",
     "A [J], D_i [m], D_j [m], l [m]", "F", "N", "van_der_waals_force",
     hamaker},
    {"LS:4.15", "capillary force between two spheres; negative attracts",
     "F = -2 pi R gamma cos(theta), R = (R_i + R_j) / 2",
     "gamma [N/m], theta [rad], R_i [m], R_j [m]", "F", "N", "capillary_force",
     bridge},
    {"LS:5.2", "drag of one sphere of known drag coefficient",
     "F = rho_f (pi d^2 / 4) C_D u_r |u_r| / 2",
     "rho_f [kg/m^3], C_D [-], d [m], u_r [m/s]", "F", "N",
     EQUATION_BY(drag_force)},
    {"LS:5.11", "Rayleigh time of a sphere",
     "T_R = pi r sqrt(rho / G) / (0.1631 nu + 0.8766)",
     "r [m], rho [kg/m^3], G [Pa], nu [-]", "T_R", "s",
     EQUATION_BY(limits_rayleigh)},
    {"LS:5.12", "relaxation time of one sphere after Stokes",
     "tau = rho_p d^2 / (18 mu)", "rho_p [kg/m^3], d [m], mu [Pa s]", "tau",
     "s", EQUATION_BY(drag_stokes_time)},
    {"LS:5.13", "relaxation time of one sphere, Schiller-Naumann",
     "tau = rho_p d^2 / (18 mu) / (1 + 0.15 Re^0.687)",
     "rho_p [kg/m^3], d [m], mu [Pa s], Re [-]", "tau", "s",
     EQUATION_BY(drag_schiller_naumann_time)},
    {"LS:5.26", "drag coefficient of a sphere in a suspension, Wen-Yu",
     "C_d = 24 (1 + 0.15 (alpha Re)^0.687) / (alpha Re); 0.44 from alpha Re = "
     "1000 on",
     "alpha [-], Re [-]", "C_d", "-", EQUATION_BY(drag_wen_yu_cd)},
    {"LS:5.27", "drag of a mixture over slip, Ergun and Wen-Yu (Gidaspow)",
     "beta = 150 eps_s^2 mu / (alpha d^2) + 1.75 eps_s rho_f u_r / d to alpha "
     "= 0.8; (3/4) C_d eps_s alpha rho_f u_r alpha^-2.65 / d above",
     "alpha [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "beta",
     "kg/(m^3 s)", "drag_beta", gidaspow_beta},
    {"", NULL, NULL, "", NULL, NULL, NULL, NULL}};

static const struct equation *const tables[] = {others, equations_forces,
                                                equations_ew18, NULL};

int equations_at(int i, struct equation *e)
{
    for (int t = 0; tables[t] != NULL; t++)
        for (const struct equation *row = tables[t]; row->what != NULL; row++)
            if (i-- == 0) {
                *e = *row;
                return 1;
            }
    return equations_drag(i, e);
}

int equations_named(const char *key, struct equation *e)
{
    for (int i = 0; equations_at(i, e); i++)
        if (strcmp(e->key, key) == 0) return 1;
    *e = (struct equation){.what = NULL};
    return 0;
}

double equations_value(const struct equation *e, const double *in)
{
    return e->value != NULL ? e->value(in) : equations_drag_value(e, in);
}

int equations_inputs(const struct equation *e)
{
    int n = 0;

    for (const char *c = e->inputs; *c != '\0'; c++)
        n += *c == '[';
    return n;
}

int equations_input(const struct equation *e, const char *name, size_t length)
{
    const char *input = e->inputs;

    for (int i = 0; i < equations_inputs(e); i++) {
        if (strcspn(input, " ") == length && strncmp(input, name, length) == 0)
            return i;
        input = strchr(input, ']') + 1;
        input += strspn(input, ", ");
    }
    return -1;
}

void equations_name(const struct equation *e, int i, char name[EQUATIONS_TEXT])
{
    const char *input = e->inputs;

    for (; i > 0; i--) {
        input = strchr(input, ']') + 1;
        input += strspn(input, ", ");
    }
    snprintf(name, EQUATIONS_TEXT, "%.*s", (int)strcspn(input, " "), input);
}
