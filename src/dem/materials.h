/* materials.h -- several materials, and the properties of their pairs.
 * Chapter "Materials, rolling and cohesion".
 *
 * Every particle is of a material, known by its number: 0 is that of
 * dem_options, the others are listed here. In a contact of two materials, the
 * elastic constants of both enter the formulas of the law [LS 4.9, 4.10]; two
 * linear springs act in series,
 *
 *   1/k = (1/k_a + 1/k_b) / 2,
 *
 * and of restitution, friction, rolling friction and k_t/k, which belong to the
 * pair and not to either, the smaller one is used where no measured value is
 * given.
 */
#ifndef DEM_MATERIALS_H
#define DEM_MATERIALS_H

#include "dem/contact.h"

/* Measured properties of the pair of materials a and b. Negative: not given. */
struct materials_measured {
    int a, b;
    double stiffness, tangential;          /* [N/m], [-] */
    double restitution, friction, rolling; /* [-] */
};

struct materials {
    int n;                          /* [-] with material 0 */
    const struct material *further; /* numbers 1 to n - 1 */
    int n_measured;
    const struct materials_measured *measured;
    int wall; /* [-] number of the material of the box */
};

/* The pair of two materials by the rules above; that of a material with itself
 * has its own values, to the bit. */
struct material_pair materials_mixed(const struct material *a,
                                     const struct material *b);

/* The pair of materials number a and b, where `zero` is number 0 and `all` has
 * the others (NULL: there is no other), with what was measured for it. */
struct material_pair materials_pair(const struct material *zero,
                                    const struct materials *all, int a, int b);

/* Number of materials, and 1 if any pair of them resists rolling. */
int materials_count(const struct materials *all);
int materials_have_rolling(const struct material *zero,
                           const struct materials *all);

/* Fills the table of all pairs, row a and column b at table[a * count + b]. */
void materials_table(const struct contact_law *law, const struct material *zero,
                     const struct materials *all,
                     struct contact_constants *table);

#endif
