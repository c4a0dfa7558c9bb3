/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"
#include "facts.h"

#include <stddef.h>
#include <string.h>

static const char *nearest_of(const char *wanted, struct nearest *n)
{
    static const char *const known[] = {"density", "viscosity", "step",
                                        "convection", NULL};

    nearest_init(n, wanted);
    for (int i = 0; known[i] != NULL; i++)
        nearest_offer(n, known[i]);
    return nearest_best(n);
}

FACT(edits_between_kitten_and_sitting_are_three)
{
    ck_assert_int_eq(nearest_edits("kitten", "sitting"), 3);
    ck_assert_int_eq(nearest_edits("", "abc"), 3);
    ck_assert_int_eq(nearest_edits("same", "same"), 0);
}

FACT(edits_are_the_same_both_ways)
{
    ck_assert_int_eq(nearest_edits("density", "destiny"),
                     nearest_edits("destiny", "density"));
}

FACT(two_swapped_letters_are_one_edit)
{
    ck_assert_int_eq(nearest_edits("friciton", "friction"), 1);
}

FACT(capitals_are_no_edit)
{
    ck_assert_int_eq(nearest_edits("Density", "denSITY"), 0);
}

FACT(misspelt_word_finds_the_one_meant)
{
    struct nearest n;

    ck_assert_str_eq(nearest_of("densty", &n), "density");
    ck_assert_str_eq(nearest_of("setp", &n), "step");
    ck_assert_str_eq(nearest_of("visc", &n), "viscosity");
}

FACT(strange_word_finds_none)
{
    struct nearest n;
    char lengthy[500];

    memset(lengthy, 'd', sizeof lengthy - 1);
    lengthy[sizeof lengthy - 1] = '\0';
    ck_assert_ptr_null(nearest_of("banana", &n));
    ck_assert_ptr_null(nearest_of("", &n));
    ck_assert_ptr_null(nearest_of("x", &n));
    ck_assert_ptr_null(nearest_of(lengthy, &n));
}
