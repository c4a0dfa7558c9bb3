/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/unit_range.h"

#include <math.h>
#include <string.h>

/* The last row is that of all other units. */
static const struct unit_range ranges[] = {
    {"m", 1e-12, 1e12},      /* a hundredth of an atom, the orbit of Saturn */
    {"m/s", 1e-20, 3e8},     /* an atom in a century, light */
    {"kg/m^3", 1e-12, 1e20}, /* the best vacuum, more than a nucleus */
    {"s", 1e-20, HUGE_VAL},  /* light through an atom; the steps are counted */
    {"", 1e-30, 1e30}};
enum { RANGES = sizeof ranges / sizeof *ranges };

const struct unit_range *unit_range_of(const char *unit)
{
    int i = 0;

    while (i < RANGES - 1 && strcmp(ranges[i].unit, unit) != 0)
        i++;
    return &ranges[i];
}

int unit_range_holds(const struct unit_range *r, double x)
{
    return x == 0.0 || (fabs(x) >= r->least && fabs(x) <= r->most);
}
