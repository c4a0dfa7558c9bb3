/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/contact.h"

#include <gsl/gsl_math.h>
#include <stddef.h>
#include <string.h>

#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"

const struct contact_law *contact_law_named(const char *name)
{
    for (int i = 0; contact_laws[i] != NULL; i++)
        if (strcmp(contact_laws[i]->name, name) == 0) return contact_laws[i];
    return NULL;
}

double contact_damping_ratio(double e)
{
    const double ln_e = log(e);
    /* e = 0 is critical damping [LS 4.11, 4.12] */
    return e > 0.0 ? -ln_e / sqrt(M_PI * M_PI + ln_e * ln_e) : 1.0;
}
