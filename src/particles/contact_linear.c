/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contact_linear.c -- spring and dashpot [LS 4.4].
 *
 * m* x'' + eta x' + k x = 0 for the overlap: every collision takes the same
 * time and gives back the same share e of the speed. In the tangential
 * direction a sphere resists with (2/7) m*; with k_t = (2/7) k and eta_t =
 * (2/7) eta both directions swing with one period.
 */
#include <gsl/gsl_math.h>

#include "particles/contact_loop.h"

double contact_effective_mass(double m_i, double m_j)
{
    return m_i * m_j / (m_i + m_j);
}

double contact_damping_ratio(double e)
{
    const double l = log(e);
    return -l / sqrt(M_PI * M_PI + l * l);
}

double contact_linear_damping(double k, double e, double m_i, double m_j)
{
    return 2.0 * contact_damping_ratio(e) *
           sqrt(contact_effective_mass(m_i, m_j) * k); /* [LS 4.4] */
}

double contact_linear_time(double k, double e, double m_i, double m_j)
{
    const double m = contact_effective_mass(m_i, m_j);
    const double half = contact_linear_damping(k, e, m_i, m_j) / (2.0 * m);
    return M_PI / sqrt(k / m - half * half);
}

static struct contact_constants linear_constants(const struct material *m)
{
    const struct contact_constants c = {
        .k = m->stiffness,
        .damping = 2.0 * contact_damping_ratio(m->restitution),
        .friction = m->friction};
    return c;
}

static inline void linear_springs(const struct contact_constants *c,
                                  double delta, double R, double m,
                                  struct springs *s)
{
    (void)R;
    s->elastic = c->k * delta;
    s->eta_n = c->damping * sqrt(c->k * m);
    s->k_t = 2.0 / 7.0 * c->k;
    s->eta_t = 2.0 / 7.0 * s->eta_n;
}

static void linear_pairs(const struct contact_constants *c, double dt,
                         const struct particles *ps, struct pair_list *list,
                         int strip, struct strip_forces *f)
{
    contact_pairs(linear_springs, 0, c, dt, ps, list, strip, f);
}

static void linear_pairs_periodic(const struct contact_constants *c, double dt,
                                  const struct particles *ps,
                                  struct pair_list *list, int strip,
                                  struct strip_forces *f)
{
    contact_pairs(linear_springs, 1, c, dt, ps, list, strip, f);
}

static void linear_walls(const struct contact_constants *c, double dt,
                         const struct particles *ps, struct pair_list *list,
                         int strip, struct strip_forces *f)
{
    contact_walls(linear_springs, c, dt, ps, list, strip, f);
}

static double linear_time(const struct material *m, double d, double v)
{
    const double mass = m->density * M_PI / 6.0 * d * d * d;
    (void)v;
    return contact_linear_time(m->stiffness, m->restitution, mass, mass);
}

const struct contact_law contact_linear = {
    "linear",     "LS 4.4, 4.8",         "spring and dashpot", linear_constants,
    linear_pairs, linear_pairs_periodic, linear_walls,         linear_time};
