/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a case chooses by its name. */
#include <stdio.h>

#include "averaging/averaging.h"
#include "averaging/interpolation.h"
#include "coupling/effects.h"
#include "coupling/drag.h"
#include "fluid/schemes.h"
#include "dem/contact.h"
#include "dem/integrator.h"
#include "dem/population/sizes.h"
#include "facts.h"

/* By a name spelled anew, so that it is the letters that count. */
static const char *copy(const char *name, char to[64])
{
    snprintf(to, 64, "%s", name);
    return to;
}

#define CHECK_ROW(named, row)                                                  \
    do {                                                                       \
        char name_[64];                                                        \
        ck_assert_ptr_eq(named(copy((row)->name, name_)), row);                \
    } while (0)

FACT(each_name_finds_its_own_row)
{
    for (int i = 0; averaging_methods[i] != NULL; i++)
        CHECK_ROW(averaging_method_named, averaging_methods[i]);
    for (int i = 0; interpolations[i] != NULL; i++)
        CHECK_ROW(interpolation_named, interpolations[i]);
    for (int i = 0; contact_laws[i] != NULL; i++)
        CHECK_ROW(contact_law_named, contact_laws[i]);
    for (int i = 0; drag_laws[i] != NULL; i++)
        CHECK_ROW(drag_law_named, drag_laws[i]);
    for (int i = 0; convection_schemes[i] != NULL; i++)
        CHECK_ROW(convection_scheme_named, convection_schemes[i]);
    for (int i = 0; velocity_gradient_schemes[i] != NULL; i++)
        CHECK_ROW(velocity_gradient_scheme_named, velocity_gradient_schemes[i]);
    for (int i = 0; time_schemes[i] != NULL; i++)
        CHECK_ROW(time_scheme_named, time_schemes[i]);
    for (int i = 0; integrators[i] != NULL; i++)
        CHECK_ROW(integrator_named, integrators[i]);
    for (int i = 0; effects[i] != NULL; i++)
        CHECK_ROW(effect_named, effects[i]);
    for (int i = 0; sizes_laws[i] != NULL; i++)
        CHECK_ROW(sizes_law_named, sizes_laws[i]);
}

FACT(a_name_that_no_row_has_finds_none)
{
    static const char *const wrong[] = {"", "Euler", "gausss", "upwin",
                                        "linear "};
    for (int i = 0; i < 5; i++) {
        ck_assert_ptr_null(averaging_method_named(wrong[i]));
        ck_assert_ptr_null(interpolation_named(wrong[i]));
        ck_assert_ptr_null(contact_law_named(wrong[i]));
        ck_assert_ptr_null(drag_law_named(wrong[i]));
        ck_assert_ptr_null(convection_scheme_named(wrong[i]));
        ck_assert_ptr_null(velocity_gradient_scheme_named(wrong[i]));
        ck_assert_ptr_null(time_scheme_named(wrong[i]));
        ck_assert_ptr_null(integrator_named(wrong[i]));
        ck_assert_ptr_null(effect_named(wrong[i]));
        ck_assert_ptr_null(sizes_law_named(wrong[i]));
    }
}
