/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/contact_linear.h"
#include "dem/particles_setup.h"

#include <gsl/gsl_math.h>

static const double sticking_mass = 2.0 / 7.0; /* [-] of m*, for a sphere */

double contact_linear_damping(double k, double e, double m_i, double m_j)
{
    return contact_linear_dashpot(contact_damping_ratio(e), k,
                                  contact_linear_mass(m_i, m_j));
}

double contact_linear_time(double k, double e, double m_star)
{
    const double eta = contact_linear_damping(k, e, 2 * m_star, 2 * m_star);
    const double decay = eta / (2.0 * m_star);
    const double w2 = k / m_star - decay * decay;

    return w2 > 0.0 ? M_PI / sqrt(w2) : HUGE_VAL; /* [LS 4.4] */
}

static struct contact_constants
contact_linear_constants(const struct material_pair *p)
{
    const double ratio = p->tangential > 0.0 ? p->tangential : sticking_mass;
    return (struct contact_constants){
        .normal = p->stiffness,
        .tangential = ratio * p->stiffness,
        .damping_n = contact_damping_ratio(p->restitution),
        .damping_t = sqrt(sticking_mass * ratio),
        .friction = p->friction,
        .rolling = p->rolling,
    };
}

static double contact_linear_duration(const struct material *m, double R_star,
                                      double m_star, double v)
{
    (void)R_star, (void)v; /* the same at any speed */
    return contact_linear_time(m->stiffness, m->restitution, m_star);
}

/* A spring has no elastic solid behind it: the contact time is its only one. */
static double contact_linear_wave_time(const struct material *m, double r,
                                       double rho)
{
    (void)m, (void)r, (void)rho;
    return HUGE_VAL;
}

/* The constants of the law; without a ratio the tangential spring is 2/7 of the
 * normal one. A pair of materials may have constants of its own. */
const struct key contact_linear_keys[] = {
    {"particles.grains.stiffness", KEY_REAL, "N/m", "> 0", KEY_MODEL_REQUIRED,
     "spring constant k", "LS 4.4", "",
     KEY_AT(particles_setup, grains.of.stiffness)},
    {"particles.grains.tangential_ratio", KEY_REAL, "-", "> 0", KEY_OPTIONAL,
     "tangential spring over k; left out: 2/7", "LS 4.8", "",
     KEY_AT(particles_setup, grains.of.tangential)},
    {"particles.materials.stiffness", KEY_REAL, "N/m", "> 0",
     KEY_MODEL_REQUIRED, "spring constant k of two grains of it", "LS 4.4", "",
     KEY_AT(material_setup, of.stiffness)},
    {"particles.materials.tangential_ratio", KEY_REAL, "-", "> 0", KEY_OPTIONAL,
     "tangential spring over k; left out: 2/7", "LS 4.8", "",
     KEY_AT(material_setup, of.tangential)},
    {"particles.pairs.stiffness", KEY_REAL, "N/m", "> 0", KEY_OPTIONAL,
     "spring constant k; left out: two half springs in series", "LS 4.4", "",
     KEY_AT(pair_setup, of.stiffness)},
    {"particles.pairs.tangential_ratio", KEY_REAL, "-", "> 0", KEY_OPTIONAL,
     "tangential spring over k; left out: the smaller one", "LS 4.8", "",
     KEY_AT(pair_setup, of.tangential)},
    KEY_END};

const struct contact_law contact_linear = {
    .name = "linear",
    .what = "spring and dashpot",
    .equations = "LS 4.4, 4.8",
    .function = "contact_linear_force",
    .keys = {contact_linear_keys},
    .constants = contact_linear_constants,
    .duration = contact_linear_duration,
    .wave_time = contact_linear_wave_time,
    .respond = contact_linear_respond,
};
