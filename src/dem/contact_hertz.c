/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/contact_hertz.h"
#include "dem/particles_setup.h"

#include "dem/contact.h"

double contact_hertz_modulus(double E_i, double nu_i, double E_j, double nu_j)
{
    return 1.0 / ((1.0 - nu_i * nu_i) / E_i + (1.0 - nu_j * nu_j) / E_j);
}

double contact_hertz_shear(double E_i, double nu_i, double E_j, double nu_j)
{
    const double G_i = E_i / (2.0 * (1.0 + nu_i));
    const double G_j = E_j / (2.0 * (1.0 + nu_j));

    return 1.0 / ((2.0 - nu_i) / G_i + (2.0 - nu_j) / G_j);
}

double contact_hertz_radius(double R_i, double R_j)
{
    return R_i * R_j / (R_i + R_j);
}

double contact_hertz_stiffness(double E_star, double R_star)
{
    return 4.0 / 3.0 * E_star * sqrt(R_star); /* [LS 4.9] */
}

/* The largest overlap turns the whole energy m* v^2 / 2 into (2/5) k_n
 * delta^(5/2); the duration over delta / v is 2 int_0^1 dx/sqrt(1 - x^(5/2)).
 */
double contact_hertz_time(double E_star, double R_star, double m_star, double v)
{
    const double k_n = contact_hertz_stiffness(E_star, R_star);
    const double delta = pow(1.25 * m_star * v * v / k_n, 0.4);

    return 2.94327518 * delta / v;
}

static struct contact_constants
contact_hertz_constants(const struct material_pair *p)
{
    const struct material *const i = p->of[0], *const j = p->of[1];
    const double E_star =
        contact_hertz_modulus(i->young, i->poisson, j->young, j->poisson);
    const double G_star =
        contact_hertz_shear(i->young, i->poisson, j->young, j->poisson);
    return (struct contact_constants){
        .normal = E_star,
        .tangential = G_star,
        .damping_n = contact_damping_ratio(p->restitution),
        .damping_t = sqrt(4.0 * G_star / E_star), /* sqrt(S_t / S_n) */
        .friction = p->friction,
        .rolling = p->rolling,
    };
}

static double contact_hertz_duration(const struct material *m, double R_star,
                                     double m_star, double v)
{
    const double E_star =
        contact_hertz_modulus(m->young, m->poisson, m->young, m->poisson);
    return contact_hertz_time(E_star, R_star, m_star, v);
}

static double contact_hertz_wave_time(const struct material *m, double r,
                                      double rho)
{
    const double G = m->young / (2.0 * (1.0 + m->poisson));
    return limits_rayleigh(r, rho, G, m->poisson);
}

/* The constants of each material. */
const struct key contact_hertz_keys[] = {
    {"particles.grains.young", KEY_REAL, "Pa", "> 0", KEY_MODEL_REQUIRED,
     "Young's modulus E", "LS 4.9", "",
     KEY_AT(particles_setup, grains.of.young)},
    {"particles.grains.poisson", KEY_REAL, "-", ">= 0, <= 0.5",
     KEY_MODEL_REQUIRED, "Poisson's ratio nu", "LS 4.9", "",
     KEY_AT(particles_setup, grains.of.poisson)},
    {"particles.materials.young", KEY_REAL, "Pa", "> 0", KEY_MODEL_REQUIRED,
     "Young's modulus E", "LS 4.9", "", KEY_AT(material_setup, of.young)},
    {"particles.materials.poisson", KEY_REAL, "-", ">= 0, <= 0.5",
     KEY_MODEL_REQUIRED, "Poisson's ratio nu", "LS 4.9", "",
     KEY_AT(material_setup, of.poisson)},
    KEY_END};

const struct contact_law contact_hertz = {
    .name = "hertz",
    .what = "elastic spheres after Hertz and Mindlin",
    .equations = "LS 4.7-4.10",
    .function = "contact_hertz_force",
    .keys = {contact_hertz_keys},
    .constants = contact_hertz_constants,
    .duration = contact_hertz_duration,
    .wave_time = contact_hertz_wave_time,
    .respond = contact_hertz_respond,
};
