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
