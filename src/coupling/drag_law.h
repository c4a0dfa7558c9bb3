/* drag_law.h -- the descriptor of a drag law.
 * Chapter "Drag".
 */
#ifndef COUPLING_DRAG_LAW_H
#define COUPLING_DRAG_LAW_H

#include "base/model.h"

/* One correlation. resistance: eps_f [-], rho_f [kg/m^3], mu [Pa s], d [m],
 * u_r [m/s] -> beta / eps_s [kg/(m^3 s)]. */
struct drag_law {
    MODEL_MEMBERS;           /* base/model.h */
    double eps_min, eps_max; /* [-] fluid fractions of its data, */
    double Re_min, Re_max;   /* [-] and eps_f rho_f d u_r / mu; `winnow check`
                                warns outside of them */
    double (*resistance)(double eps_f, double rho_f, double mu, double d,
                         double u_r);
    /* A law with keys of its own (base/model.h), one of the tables above, has
     * this function instead. Their numbers are those of the case; in the
     * descriptor, those with which the law is tested. */
    const struct key *own_keys;
    double own[MODEL_NUMBERS];
    double (*resistance_with)(const double *own, double eps_f, double rho_f,
                              double mu, double d, double u_r);
};

/* beta / eps_s [kg/(m^3 s)] by the law. */
static inline double drag_resistance(const struct drag_law *law, double eps_f,
                                     double rho_f, double mu, double d,
                                     double u_r)
{
    return law->resistance != NULL
               ? law->resistance(eps_f, rho_f, mu, d, u_r)
               : law->resistance_with(law->own, eps_f, rho_f, mu, d, u_r);
}

#endif
