/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/unit_range.h"

#include "case/source.h"

#include <libconfig.h>
#include <math.h>
#include <string.h>

/* [unit] of the magnitude of a number that is not 0. */
struct unit_range {
    const char *unit;
    double least, most;
};

/* The last row is that of all other units. */
static const struct unit_range ranges[] = {
    {"m", 1e-12, 1e12},      /* a hundredth of an atom, the orbit of Saturn */
    {"m/s", 1e-20, 3e8},     /* an atom in a century, light */
    {"kg/m^3", 1e-12, 1e20}, /* the best vacuum, more than a nucleus */
    {"s", 1e-20, HUGE_VAL},  /* light through an atom; the steps are counted */
    {"", 1e-30, 1e30}};
enum { RANGES = sizeof ranges / sizeof *ranges };

static const struct unit_range *unit_range_of(const char *unit)
{
    int i = 0;

    while (i < RANGES - 1 && strcmp(ranges[i].unit, unit) != 0)
        i++;
    return &ranges[i];
}

static int unit_range_holds(const struct unit_range *r, double x)
{
    return x == 0.0 || (fabs(x) >= r->least && fabs(x) <= r->most);
}

/* A component of a point or of a direction may be a 0 with a rounding error. */
static int may_be_tiny(const struct key *key)
{
    return key->type == KEY_VECTOR && strchr(key->allowed, '>') == NULL;
}

/* The first number in s whose magnitude the unit of its key cannot have; 0 if
 * there is none. The times of a series may be any. */
static double extreme(const struct key *key, const config_setting_t *s)
{
    const int whole = key->type == KEY_INT || key->type == KEY_COUNTS;
    const struct unit_range *const r = unit_range_of(key->unit);
    const int n = config_setting_is_array(s) || config_setting_is_list(s)
                      ? config_setting_length(s)
                      : 0;
    double x = 0.0;

    if (config_setting_is_number(s) && !whole &&
        !unit_range_holds(r, source_number(s)) &&
        !(may_be_tiny(key) && fabs(source_number(s)) < r->least))
        return source_number(s);
    for (int i = key->type == KEY_SERIES && n == 2 &&
                 config_setting_is_number(config_setting_get_elem(s, 0));
         i < n && x == 0.0; i++)
        x = extreme(key, config_setting_get_elem(s, (unsigned)i));
    return x;
}

int unit_range_check(const struct key *key, const char *path,
                     const config_setting_t *s)
{
    const struct unit_range *const r = unit_range_of(key->unit);
    const double x = extreme(key, s);

    if (x == 0.0) return 0;
    return source_wrong(s,
                        "%s: expected 0 or a magnitude between %g and %g [%s], "
                        "found %g",
                        path, r->least, r->most, key->unit, x);
}
