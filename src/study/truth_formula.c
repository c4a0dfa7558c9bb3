/* SPDX-License-Identifier: GPL-3.0-or-later */
/* truth_formula.c -- a truth that is typed: 0.05 * (1 - exp(-t / 4e-4)). */
#include "study/truth.h"

#include "fluid/inlets/formula.h"

#include <stdio.h>

/* Whatever no other kind has taken. */
static int truth_formula_is_meant(const char *text)
{
    return text != NULL;
}

static void *truth_formula_create(const char *text)
{
    char wrong[256];
    struct formula *const f = formula_create(text, wrong, sizeof wrong);

    if (f == NULL)
        fprintf(stderr,
                "winnow: study: truth %s: %s; expected a formula of t or x, an "
                "equation KEY name=value ..., FILE.csv, finest, extrapolated "
                "or none\n",
                text, wrong);
    return f;
}

/* All variables are the first column. */
static double truth_formula_value(const void *of, double x)
{
    return formula_value(of, (const double[3]){x, x, x}, x);
}

static void truth_formula_release(void *of)
{
    formula_free(of);
}

const struct truth_function truth_formula = {
    "a formula", truth_formula_is_meant, truth_formula_create,
    truth_formula_value, truth_formula_release};
