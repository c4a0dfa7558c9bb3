/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contact_hertz.c -- elastic spheres after Hertz and Mindlin [LS 4.7-4.10].
 *
 * The stiffness at overlap delta is S_n = 2 E* sqrt(R* delta), and (2/3) S_n
 * delta is Hertz's force. Damping eta = 2 sqrt(5/6) ratio sqrt(S m*), with S_n
 * in the normal and S_t = k_t in the tangential direction, gives the same
 * restitution e at any speed.
 */
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_gamma.h>

#include "particles/contact_loop.h"

double contact_effective_young(double E_i, double E_j, double nu_i, double nu_j)
{
    return 1.0 / ((1.0 - nu_i * nu_i) / E_i + (1.0 - nu_j * nu_j) / E_j);
}

double contact_effective_shear(double E_i, double E_j, double nu_i, double nu_j)
{
    const double G_i = E_i / (2.0 * (1.0 + nu_i));
    const double G_j = E_j / (2.0 * (1.0 + nu_j));
    return 1.0 / ((2.0 - nu_i) / G_i + (2.0 - nu_j) / G_j);
}

double contact_hertz_stiffness(double E, double R)
{
    return 4.0 / 3.0 * E * sqrt(R); /* [LS 4.9] */
}

double contact_hertz_force(double E, double R, double delta)
{
    return contact_hertz_stiffness(E, R) * delta * sqrt(delta); /* [LS 4.7] */
}

double contact_mindlin_stiffness(double G, double R, double delta)
{
    return 8.0 * G * sqrt(R * delta); /* [LS 4.10] */
}

double contact_hertz_overlap(double E, double R, double m, double v)
{
    return pow(15.0 * m * v * v / (16.0 * E * sqrt(R)), 0.4);
}

/* t = 2 (delta/v) int_0^1 dx / sqrt(1 - x^2.5), the integral being
 * sqrt(pi) Gamma(7/5) / Gamma(9/10) = 1.4716. */
double contact_hertz_time(double E, double R, double m, double v)
{
    const double integral = sqrt(M_PI) * gsl_sf_gamma(1.4) / gsl_sf_gamma(0.9);
    return 2.0 * integral * contact_hertz_overlap(E, R, m, v) / v;
}

static struct contact_constants hertz_constants(const struct material *m)
{
    const struct contact_constants c = {
        .E =
            contact_effective_young(m->young, m->young, m->poisson, m->poisson),
        .G =
            contact_effective_shear(m->young, m->young, m->poisson, m->poisson),
        .damping =
            2.0 * sqrt(5.0 / 6.0) * contact_damping_ratio(m->restitution),
        .friction = m->friction};
    return c;
}

static inline void hertz_springs(const struct contact_constants *c,
                                 double delta, double R, double m,
                                 struct springs *s)
{
    const double root = sqrt(R * delta);
    const double S_n = 2.0 * c->E * root;

    s->elastic = 2.0 / 3.0 * S_n * delta; /* [LS 4.7, 4.9] */
    s->eta_n = c->damping * sqrt(S_n * m);
    s->k_t = 8.0 * c->G * root; /* [LS 4.10] */
    s->eta_t = c->damping * sqrt(s->k_t * m);
}

static void hertz_pairs(const struct contact_constants *c, double dt,
                        const struct particles *ps, struct pair_list *list,
                        int strip, struct strip_forces *f)
{
    contact_pairs(hertz_springs, 0, c, dt, ps, list, strip, f);
}

static void hertz_pairs_periodic(const struct contact_constants *c, double dt,
                                 const struct particles *ps,
                                 struct pair_list *list, int strip,
                                 struct strip_forces *f)
{
    contact_pairs(hertz_springs, 1, c, dt, ps, list, strip, f);
}

static void hertz_walls(const struct contact_constants *c, double dt,
                        const struct particles *ps, struct pair_list *list,
                        int strip, struct strip_forces *f)
{
    contact_walls(hertz_springs, c, dt, ps, list, strip, f);
}

static double hertz_time(const struct material *m, double d, double v)
{
    const double mass = m->density * M_PI / 6.0 * d * d * d;
    const double E =
        contact_effective_young(m->young, m->young, m->poisson, m->poisson);
    return contact_hertz_time(E, 0.25 * d, 0.5 * mass, v);
}

const struct contact_law contact_hertz = {
    "hertz",         "LS 4.7-4.12", "elastic spheres after Hertz and Mindlin",
    hertz_constants, hertz_pairs,   hertz_pairs_periodic,
    hertz_walls,     hertz_time};
