/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/equations.h"

#include "averaging/diffusion.h"
#include "averaging/more/images.h"
#include "averaging/kernel.h"
#include "coupling/effects/time_average.h"
#include "coupling/drag.h"
#include "dem/cohesion/capillary.h"
#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"
#include "dem/cohesion/electrostatic.h"
#include "dem/limits.h"
#include "dem/cohesion/van_der_waals.h"

#include <stdio.h>
#include <string.h>

/* Each function below unpacks its inputs and calls the room's. */

static double reynolds(const double *x)
{
    return drag_reynolds(x[0], x[1], x[2], x[3]);
}

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

static double terminal_ratio(const double *x)
{
    return drag_terminal_ratio(x[0], x[1]);
}

static double relaxation_time(const double *x)
{
    return drag_relaxation_time(drag_law_named("syamlal-obrien"), x[0], x[1],
                                x[2], x[3], x[4], x[5]);
}

static double bell(const double *x)
{
    return kernel_bell(x[0]);
}

static double gauss(const double *x)
{
    return diffusion_kernel(x[0], x[1]);
}

static double kernel_sigma_of(const double *x)
{
    return kernel_sigma(x[0]);
}

static double gauss_sigma(const double *x)
{
    return images_kernel(x[0], x[1]);
}

static double fading_weight(const double *x)
{
    return time_average_weight(x[0], x[1]);
}

static double linear_damping(const double *x)
{
    return contact_linear_damping(x[0], x[1], x[2], x[3]);
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

static double charges(const double *x)
{
    return electrostatic_force(x[0], x[1], x[2], x[3]);
}

static double hamaker(const double *x)
{
    return van_der_waals_force(x[0], van_der_waals_diameter(x[1], x[2]), x[3]);
}

static double bridge(const double *x)
{
    return capillary_force(x[0] * cos(x[1]), capillary_mean(x[2], x[3]));
}

static double rayleigh(const double *x)
{
    return limits_rayleigh(x[0], x[1], x[2], x[3]);
}

static double force(const double *x)
{
    return drag_force(x[0], x[1], x[2], x[3]);
}

static double stokes_time(const double *x)
{
    return drag_stokes_time(x[0], x[1], x[2]);
}

static double schiller_naumann_time(const double *x)
{
    return drag_schiller_naumann_time(x[0], x[1], x[2], x[3]);
}

static double wen_yu_cd(const double *x)
{
    return drag_wen_yu_cd(x[0], x[1]);
}

/* The document counts the fluid, alpha; beta is that of [XS11 2.9]. */
static double gidaspow_beta(const double *x)
{
    return drag_beta(drag_law_named("gidaspow"), 1.0 - x[0], x[1], x[2], x[3],
                     x[4]);
}

const struct equation equations_all[] = {
    {"XS11:2.10", "drag of a particle over eps_f and slip, Syamlal-O'Brien",
     "eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "B", "kg/s",
     "drag_coefficient", syamlal_b},
    {"XS11:2.11", "drag of a mixture over slip, Syamlal-O'Brien",
     "eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "beta",
     "kg/(m^3 s)", "drag_beta", syamlal_beta},
    {"XS11:2.12", "Reynolds number of a particle",
     "rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "Re", "-", "drag_reynolds",
     reynolds},
    {"XS11:2.13", "terminal velocity of a suspension over that of one sphere",
     "Re [-], eps_f [-]", "V_r", "-", "drag_terminal_ratio", terminal_ratio},
    {"XS11:3.6", "bell kernel", "zeta [-]", "K", "-", "kernel_bell", bell},
    {"XS11:3.17", "time in which drag would stop a particle, Syamlal-O'Brien",
     "rho_s [kg/m^3], eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]",
     "tau_p", "s", "drag_relaxation_time", relaxation_time},
    {"SX15:6", "Gaussian kernel that diffusion amounts to", "r [m], b [m]", "h",
     "1/m^3", "diffusion_kernel", gauss},
    {"SX15:14", "weight of the past in a fading time mean", "dt [s], b_t [s]",
     "alpha", "-", "time_average_weight", fading_weight},
    {"LS:4.4", "damping of the linear contact for a restitution e",
     "k [N/m], e [-], m_i [kg], m_j [kg]", "eta", "kg/s",
     "contact_linear_damping", linear_damping},
    {"LS:4.7", "elastic normal force between two spheres, Hertz",
     "E_i [Pa], E_j [Pa], nu_i [-], nu_j [-], R_i [m], R_j [m], delta [m]",
     "F_n", "N", "contact_hertz_force", hertz_force},
    {"LS:4.9", "normal stiffness of two spheres, Hertz",
     "E_i [Pa], E_j [Pa], nu_i [-], nu_j [-], R_i [m], R_j [m]", "k_n",
     "N/m^1.5", "contact_hertz_stiffness", hertz_stiffness},
    {"LS:4.10", "tangential stiffness of two spheres, Mindlin",
     "E_i [Pa], E_j [Pa], nu_i [-], nu_j [-], R_i [m], R_j [m], delta [m]",
     "k_t", "N/m", "contact_hertz_tangential", mindlin_stiffness},
    {"LS:4.11", "critical normal damping of a spring and a mass",
     "m [kg], k_n [N/m]", "eta_n", "kg/s", "contact_linear_dashpot",
     critical_damping},
    {"LS:4.12", "critical tangential damping of a spring and a mass",
     "m [kg], k_t [N/m]", "eta_t", "kg/s", "contact_linear_dashpot",
     critical_damping},
    {"LS:4.13", "force between two charged spheres; positive repels",
     "q_i [C], q_j [C], eps_r [-], l [m]", "F", "N", "electrostatic_force",
     charges},
    {"LS:4.14", "van der Waals attraction of two spheres, l their gap",
     "A [J], D_i [m], D_j [m], l [m]", "F", "N", "van_der_waals_force",
     hamaker},
    {"LS:4.15", "capillary force between two spheres; negative attracts",
     "gamma [N/m], theta [rad], R_i [m], R_j [m]", "F", "N", "capillary_force",
     bridge},
    {"LS:5.2", "drag of one sphere of known drag coefficient",
     "rho_f [kg/m^3], C_D [-], d [m], u_r [m/s]", "F", "N", "drag_force",
     force},
    {"LS:5.11", "Rayleigh time of a sphere",
     "r [m], rho [kg/m^3], G [Pa], nu [-]", "T_R", "s", "limits_rayleigh",
     rayleigh},
    {"LS:5.12", "relaxation time of one sphere after Stokes",
     "rho_p [kg/m^3], d [m], mu [Pa s]", "tau", "s", "drag_stokes_time",
     stokes_time},
    {"LS:5.13", "relaxation time of one sphere, Schiller-Naumann",
     "rho_p [kg/m^3], d [m], mu [Pa s], Re [-]", "tau", "s",
     "drag_schiller_naumann_time", schiller_naumann_time},
    {"LS:5.26", "drag coefficient of a sphere in a suspension, Wen-Yu",
     "alpha [-], Re [-]", "C_d", "-", "drag_wen_yu_cd", wen_yu_cd},
    {"LS:5.27", "drag of a mixture over slip, Ergun and Wen-Yu (Gidaspow)",
     "alpha [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]", "beta",
     "kg/(m^3 s)", "drag_beta", gidaspow_beta},
    {"EW18:19", "Gaussian kernel", "r [m], sigma_k [m]", "W", "1/m^3",
     "images_kernel", gauss_sigma},
    {"EW18:20", "its width from that at half its height", "delta_05 [m]",
     "sigma_k", "m", "kernel_sigma", kernel_sigma_of},
    {NULL, NULL, NULL, NULL, NULL, NULL, NULL}};

const struct equation *equations_named(const char *key)
{
    for (const struct equation *e = equations_all; e->key != NULL; e++)
        if (strcmp(e->key, key) == 0) return e;
    return NULL;
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
