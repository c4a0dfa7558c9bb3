/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects.h"

#include <string.h>

const struct effect *effects_named(const char *name)
{
    for (const struct effect *const *e = effects; *e != NULL; e++)
        if (strcmp((*e)->name, name) == 0) return *e;
    return NULL;
}
