/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/contact.h"

#include <stddef.h>
#include <string.h>

const struct contact_law *const contact_laws[] = {&contact_linear,
                                                  &contact_hertz, NULL};

const struct contact_law *contact_law_named(const char *name)
{
    for (const struct contact_law *const *law = contact_laws; *law != NULL;
         law++)
        if (strcmp((*law)->name, name) == 0) return *law;
    return NULL;
}
