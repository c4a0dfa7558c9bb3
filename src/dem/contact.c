/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/contact.h"

#include <gsl/gsl_math.h>

#include "base/model.h"
#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"

double contact_damping_ratio(double e)
{
    const double ln_e = log(e);
    /* e = 0 is critical damping [LS 4.11, 4.12] */
    return e > 0.0 ? -ln_e / sqrt(M_PI * M_PI + ln_e * ln_e) : 1.0;
}

const struct contact_law *const contact_laws[] = {&contact_hertz,
                                                  &contact_linear, NULL};

MODEL_NAMED(contact_law)

/* --- limits --------------------------------------------------------------- */

static const double steps_a_contact = 25.0, min_steps_a_contact = 15.0;
static const double fraction_of_rayleigh = 0.1;
static const double way_of_a_step = 0.5; /* of d */
static const double max_over_undamped = 5.0 / 3.0;

double limits_rayleigh(double r, double rho, double G, double nu)
{
    return M_PI * r * sqrt(rho / G) / (0.1631 * nu + 0.8766); /* [LS 5.11] */
}

double limits_contact_time(const struct contact_law *law,
                           const struct material *m, double d, double rho,
                           double v)
{
    const double mass = rho * M_PI / 6.0 * d * d * d;
    return law->duration(m, 0.25 * d, 0.5 * mass, v);
}

/* The contact time grows with the damping, at e = 0 without limit, although the
 * force changes as fast as before; so it is bounded by that without damping. */
static double resolved_time(const struct contact_law *law,
                            const struct material *m, double d, double rho,
                            double v)
{
    struct material undamped = *m;

    undamped.restitution = 1.0;
    return fmin(limits_contact_time(law, m, d, rho, v),
                max_over_undamped *
                    limits_contact_time(law, &undamped, d, rho, v));
}

double limits_step(const struct contact_law *law, const struct material *m,
                   double d, double rho, double v)
{
    const double wave = fraction_of_rayleigh * law->wave_time(m, 0.5 * d, rho);

    return fmin(fmin(resolved_time(law, m, d, rho, v) / steps_a_contact, wave),
                way_of_a_step * min_steps_a_contact / steps_a_contact * d / v);
}

double limits_longest_step(const struct contact_law *law,
                           const struct material *m, double d, double rho,
                           double v)
{
    return fmin(resolved_time(law, m, d, rho, v) / min_steps_a_contact,
                way_of_a_step * d / v);
}
