/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/inlet_profile.h"

const struct inlet_profile *const inlet_profiles[] = {
    &inlet_profile_uniform, &parabola_profile, &formula_profile,
    &table_profile,         &file_profile,     NULL};

int inlet_profile_is_given(const struct inlet_profile *profile,
                           const struct boundary_options *o)
{
    return profile->asks == NULL ||
           *(const int *)((const char *)o + profile->keys[0]->given - 1);
}

static int uniform(const struct boundary_request *r, struct boundary *b,
                   char wrong[BOUNDARY_TEXT])
{
    (void)r;
    (void)b;
    (void)wrong;
    return 0;
}

const struct inlet_profile inlet_profile_uniform = {
    .name = "uniform",
    .what = "the same velocity everywhere",
    .equations = "",
    .function = "uniform",
    .create = uniform,
};
