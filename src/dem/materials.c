/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/materials.h"

#include <math.h>
#include <stddef.h>

/* Each half of the contact is a spring of twice the stiffness. */
static double in_series(double k_a, double k_b)
{
    if (k_a == k_b) return k_a; /* not rounded */
    return k_a + k_b > 0.0 ? 2.0 * k_a * k_b / (k_a + k_b) : 0.0;
}

/* k_t / k, where 0 stands for 2/7 (contact_linear.h). */
static double smaller_ratio(double a, double b)
{
    return a > 0.0 && b > 0.0 ? fmin(a, b) : fmax(a, b);
}

struct material_pair materials_mixed(const struct material *a,
                                     const struct material *b)
{
    return (struct material_pair){
        .of = {a, b},
        .stiffness = in_series(a->stiffness, b->stiffness),
        .tangential = smaller_ratio(a->tangential, b->tangential),
        .restitution = fmin(a->restitution, b->restitution),
        .friction = fmin(a->friction, b->friction),
        .rolling = fmin(a->rolling, b->rolling)};
}

/* A measured value replaces the mixed one. */
static void replace(double measured, double *value)
{
    if (measured >= 0.0) *value = measured;
}

static const struct material *
material_number(const struct material *zero, const struct materials *all, int a)
{
    return a == 0 ? zero : &all->further[a - 1];
}

struct material_pair materials_pair(const struct material *zero,
                                    const struct materials *all, int a, int b)
{
    struct material_pair p = materials_mixed(material_number(zero, all, a),
                                             material_number(zero, all, b));

    for (int k = 0; all != NULL && k < all->n_measured; k++) {
        const struct materials_measured *const m = &all->measured[k];
        if (!(m->a == a && m->b == b) && !(m->a == b && m->b == a)) continue;
        replace(m->stiffness, &p.stiffness);
        replace(m->tangential, &p.tangential);
        replace(m->restitution, &p.restitution);
        replace(m->friction, &p.friction);
        replace(m->rolling, &p.rolling);
    }
    return p;
}

int materials_count(const struct materials *all)
{
    return all != NULL ? all->n : 1;
}

int materials_have_rolling(const struct material *zero,
                           const struct materials *all)
{
    const int n = materials_count(all);

    for (int k = 0; k < n * n; k++)
        if (materials_pair(zero, all, k / n, k % n).rolling > 0.0) return 1;
    return 0;
}

void materials_table(const struct contact_law *law, const struct material *zero,
                     const struct materials *all,
                     struct contact_constants *table)
{
    const int n = materials_count(all);

    for (int k = 0; k < n * n; k++) {
        const struct material_pair p = materials_pair(zero, all, k / n, k % n);
        table[k] = law->constants(&p);
    }
}
