/* SPDX-License-Identifier: GPL-3.0-or-later */
/* equations.c -- the rows of check.h. */
#include "tell/check.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "averaging/averaging.h"
#include "averaging/diffusion.h"
#include "averaging/more/kernel_gradient.h"
#include "coupling/drag.h"
#include "coupling/effects/forces.h"
#include "dem/attraction.h"
#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"
#include "dem/contact.h"
#include "resolved/body_numbers.h"

/* A function of one to seven numbers as the value of an equation whose inputs
 * are these: EQUATION_OF_2(f), and EQUATION_BY(f) as the end of its row. */
#define EQUATION_OF(f, ...)                                                    \
    static double value_of_##f(const double *x)                                \
    {                                                                          \
        return f(__VA_ARGS__);                                                 \
    }
#define EQUATION_OF_1(f) EQUATION_OF(f, x[0])
#define EQUATION_OF_2(f) EQUATION_OF(f, x[0], x[1])
#define EQUATION_OF_3(f) EQUATION_OF(f, x[0], x[1], x[2])
#define EQUATION_OF_4(f) EQUATION_OF(f, x[0], x[1], x[2], x[3])
#define EQUATION_OF_5(f) EQUATION_OF(f, x[0], x[1], x[2], x[3], x[4])
#define EQUATION_OF_6(f) EQUATION_OF(f, x[0], x[1], x[2], x[3], x[4], x[5])
#define EQUATION_OF_7(f)                                                       \
    EQUATION_OF(f, x[0], x[1], x[2], x[3], x[4], x[5], x[6])
#define EQUATION_BY(f) #f, value_of_##f

/* Each function unpacks its inputs and calls the room's. */
EQUATION_OF_4(drag_reynolds)
EQUATION_OF_2(drag_terminal_ratio)
EQUATION_OF_7(drag_released)
EQUATION_OF_1(kernel_polynomial)
EQUATION_OF_2(diffusion_kernel)
EQUATION_OF_2(time_average_weight)
EQUATION_OF_4(contact_linear_damping)
EQUATION_OF_4(electrostatic_force)
EQUATION_OF_4(limits_rayleigh)
EQUATION_OF_4(drag_force)
EQUATION_OF_3(drag_stokes_time)
EQUATION_OF_4(drag_schiller_naumann_time)
EQUATION_OF_2(drag_wen_yu_cd)
EQUATION_OF_4(body_numbers_reynolds)
EQUATION_OF_3(body_numbers_inverse_froude)
EQUATION_OF_2(body_numbers_density_ratio)
EQUATION_OF_2(body_numbers_stokes)
EQUATION_OF_5(basset_force)
EQUATION_OF_3(saffman_reynolds)
EQUATION_OF_4(saffman_force)
EQUATION_OF_4(spin_force)
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
EQUATION_OF_6(kernel_gradient_row)

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

static double sphere_cd(const double *x)
{
    return drag_wen_yu_cd(1.0, x[0]);
}

/* In the order of the documents; the further forces are of LS 5.1. */
static const struct equation rows[] = {
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
    {"XS11:3.6", "bell-shaped kernel",
     "K = (1 - zeta^2)^4 for zeta < 1, else 0", "zeta [-]", "K", "-",
     EQUATION_BY(kernel_polynomial)},
    {"XS11:3.17", "time in which drag would stop a particle, Syamlal-O'Brien",
     "tau_p = rho_s eps_s / beta",
     "rho_s [kg/m^3], eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_r [m/s]",
     "tau_p", "s", "drag_relaxation_time", equations_relaxation_time},
    {"XS11:4.1", "velocity of a particle that is released from rest in a fluid",
     "du/dt = (u_f - u) / tau_p, tau_p of XS11:3.17 at u_r = |u_f - u|, u = 0 "
     "at t = 0",
     "rho_s [kg/m^3], eps_s [-], rho_f [kg/m^3], mu [Pa s], d [m], u_f [m/s], "
     "t [s]",
     "u", "m/s", EQUATION_BY(drag_released)},
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
    {"EW18:6", "Reynolds number of the inlet", "Re_in = rho_f V L / mu",
     "rho_f [kg/m^3], V [m/s], L [m], mu [Pa s]", "Re_in", "-",
     EQUATION_BY(body_numbers_reynolds)},
    {"EW18:7", "inverse Froude number", "Fr = g L / V^2",
     "g [m/s^2], L [m], V [m/s]", "Fr", "-",
     EQUATION_BY(body_numbers_inverse_froude)},
    {"EW18:8", "density ratio", "rho_r = rho_p / rho_f",
     "rho_p [kg/m^3], rho_f [kg/m^3]", "rho_r", "-",
     EQUATION_BY(body_numbers_density_ratio)},
    {"EW18:9", "Stokes number", "St = rho_r Re_in / 18", "rho_r [-], Re_in [-]",
     "St", "-", EQUATION_BY(body_numbers_stokes)},
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
    {"EW18:B.7", "slope by a kernel at a particle in a row of three cells",
     "X = sum w r (phi - phi_i) / sum w r^2, r = {-h, 0, h} - x, w = exp(-r^2 "
     "/ b^2), phi_i = sum w phi / sum w",
     "h [m], b [m], x [m], phi_1 [-], phi_2 [-], phi_3 [-]", "X", "1/m",
     EQUATION_BY(kernel_gradient_row)}};

/* Every drag law by its name. */

static const char prefix[] = "drag:";

/* Adds the keys that the law alone reads, without their group. */
static void add_own_inputs(const struct key *keys, char *inputs)
{
    for (const struct key *k = keys; k != NULL && k->path != NULL; k++) {
        const size_t used = strlen(inputs);
        snprintf(inputs + used, EQUATIONS_INPUT_TEXT - used, ", %s [%s]",
                 strrchr(k->path, '.') + 1, k->unit);
    }
}

static int equations_drag(int i, struct equation *e)
{
    for (int k = 0; k <= i; k++)
        if (drag_laws[k] == NULL) return 0;
    const struct drag_law *const law = drag_laws[i];
    *e = (struct equation){
        .what = law->what,
        .formula =
            "F = F_d / (3 pi mu d eps_f u_r), Re = eps_f rho_f d u_r / mu",
        .inputs = "eps_f [-], Re [-]",
        .out = "F",
        .unit = "-",
        .function = law->function};
    snprintf(e->key, sizeof e->key, "%s%s", prefix, law->name);
    add_own_inputs(law->own_keys, e->inputs);
    return 1;
}

/* The drag over Stokes' law at the superficial slip eps_f u_r, x = eps_f and
 * the Reynolds number of that slip: beta/eps_s of (9.7) over 18 mu eps_f/d^2.
 * In units of d, rho_f and mu. The numbers of the law's own keys follow. */
static double equations_drag_value(const struct equation *e, const double *x)
{
    struct drag_law law = *drag_law_named(e->key + strlen(prefix));

    if (x[0] > 1.0 || x[1] < 0.0) return NAN;
    for (int k = 0; law.own_keys != NULL && law.own_keys[k].path != NULL; k++)
        law.own[k] = x[2 + k];
    return drag_resistance(&law, x[0], 1.0, 1.0, 1.0, x[1] / x[0]) /
           (18.0 * x[0]);
}

int equations_at(int i, struct equation *e)
{
    const int n = sizeof rows / sizeof *rows;

    if (i >= n) return equations_drag(i - n, e);
    *e = rows[i];
    return 1;
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

/* The i-th of its inputs, "Re [-], ...". */
static const char *input_at(const struct equation *e, int i)
{
    const char *input = e->inputs;

    for (; i > 0; i--) {
        input = strchr(input, ']') + 1;
        input += strspn(input, ", ");
    }
    return input;
}

int equations_input(const struct equation *e, const char *name, size_t length)
{
    for (int i = 0; i < equations_inputs(e); i++)
        if (strcspn(input_at(e, i), " ") == length &&
            strncmp(input_at(e, i), name, length) == 0)
            return i;
    return -1;
}

void equations_name(const struct equation *e, int i, char name[EQUATIONS_TEXT])
{
    const char *const input = input_at(e, i);

    snprintf(name, EQUATIONS_TEXT, "%.*s", (int)strcspn(input, " "), input);
}
