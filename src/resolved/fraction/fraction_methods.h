/* fraction_methods.h -- two older ways to hold the fluid, by solid fractions.
 * Chapter "Resolving the grains".
 *
 * Both set the velocity in a cell by its solid fraction b after the viscous
 * step is done, so that what they give depends on nu dt / h^2. They are here to
 * show that. LS calls the first one a fictitious domain method [LS 5.17-5.20],
 * the second one PISO-IB [LS 5.21].
 */
#ifndef RESOLVED_FRACTION_FRACTION_METHODS_H
#define RESOLVED_FRACTION_FRACTION_METHODS_H

#include "resolved/solid_bodies.h"

extern const struct body_method fraction_methods_fictitious,
    fraction_methods_piso_ib;

#endif
