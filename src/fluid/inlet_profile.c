/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/inlet_profile.h"

#include "base/model.h"

const struct inlet_profile *const inlet_profiles[] = {
    &inlet_profile_uniform, &parabola_profile, &formula_profile,
    &table_profile,         &file_profile,     NULL};

MODEL_NAMED(inlet_profile)

static int uniform(const struct inlet_request *r, struct boundary *b,
                   char wrong[INLET_PROFILE_TEXT])
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
