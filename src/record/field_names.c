/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/field_names.h"

#include <string.h>

#include "case/build.h"

struct profile_field field_names_find(const struct snapshot *s,
                                      const char *name)
{
    const struct profile_field fields[] = {
        {"eps_f", "-", s->eps, 1, 0, NULL},
        {"eps_s", "-", s->eps_s, 1, 0, NULL},
        {"p", "Pa", s->p, 1, 0, NULL},
        {"u_x", "m/s", s->u, 3, 0, NULL},
        {"u_y", "m/s", s->u, 3, 1, NULL},
        {"u_z", "m/s", s->u, 3, 2, NULL},
        {"us_x", "m/s", s->u_s, 3, 0, s->eps_s},
        {"us_y", "m/s", s->u_s, 3, 1, s->eps_s},
        {"us_z", "m/s", s->u_s, 3, 2, s->eps_s}};
    const int n = sizeof fields / sizeof *fields;

    for (int i = 0; i < n; i++)
        if (strcmp(fields[i].name, name) == 0) return fields[i];
    return (struct profile_field){.name = name};
}

/* There are fields where there is a fluid, and those of the solids where the
 * particles act on it. */
int field_names_check(const struct settings *s, const char *list,
                      const char *field)
{
    const int of_solids =
        strcmp(field, "eps_s") == 0 || strncmp(field, "us_", 3) == 0;

    if (!s->has.fluid)
        return settings_wrong(s, list,
                              "the case has no field %s: fields are those of "
                              "a fluid",
                              field);
    if (of_solids && !s->exchange.two_way)
        return settings_wrong(s, list,
                              "the case has no field %s: it needs exchange "
                              "with coupling = \"two-way\"",
                              field);
    return 0;
}
