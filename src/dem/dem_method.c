/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/dem_method.h"

#include <stddef.h>
#include <string.h>

#include "dem/fast/fast.h"
#include "dem/reference.h"

const struct dem_method *const dem_methods[] = {
    &fast_verlet, &reference_link_cells, &reference_all_pairs, NULL};

const struct dem_method *dem_method_named(const char *name)
{
    for (int i = 0; dem_methods[i] != NULL; i++)
        if (strcmp(dem_methods[i]->name, name) == 0) return dem_methods[i];
    return NULL;
}
