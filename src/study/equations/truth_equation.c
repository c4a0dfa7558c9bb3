/* SPDX-License-Identifier: GPL-3.0-or-later */
/* truth_equation.c -- a truth that is an equation of `winnow eval`. */
#include "study/truth.h"

#include "base/alloc.h"
#include "tell/equations.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct equation_truth {
    struct equation equation;
    double input[EQUATIONS_INPUTS];
    int variable; /* the input that is t or x; -1: none */
};

/* A document and a number, "XS11:4.1". */
static int truth_equation_is_meant(const char *text)
{
    const size_t n = strcspn(text, ": ");

    return isupper((unsigned char)text[0]) && n > 0 && text[n] == ':';
}

static void *truth_equation_refuse(struct equation_truth *e, const char *text,
                                   const char *why)
{
    fprintf(stderr, "winnow: study: truth %s: %s%s%s\n", text, why,
            e->equation.what != NULL ? "; it takes " : "",
            e->equation.what != NULL ? e->equation.inputs : "");
    free(e);
    return NULL;
}

/* Reads "name=value name=value ..."; the number of those that are wrong. */
static int truth_equation_read_inputs(struct equation_truth *e,
                                      const char *text,
                                      int given[EQUATIONS_INPUTS])
{
    while (*(text += strspn(text, " ")) != '\0') {
        const size_t length = strcspn(text, "= ");
        const int k = equations_input(&e->equation, text, length);
        char *end;

        if (k < 0 || text[length] != '=' || given[k]) return 1;
        e->input[k] = strtod(text + length + 1, &end);
        if (end == text + length + 1 || (*end != ' ' && *end != '\0')) return 1;
        given[k] = 1;
        text = end;
    }
    return 0;
}

static void *truth_equation_create(const char *text)
{
    struct equation_truth *const e = alloc_zeroed(1, sizeof *e);
    int given[EQUATIONS_INPUTS] = {0};
    char name[EQUATIONS_TEXT];
    const size_t length = strcspn(text, " ");

    snprintf(name, sizeof name, "%.*s", (int)length, text);
    e->variable = -1;
    if (!equations_named(name, &e->equation))
        return truth_equation_refuse(e, text,
                                     "no such equation; winnow eval lists all");
    if (truth_equation_read_inputs(e, text + length, given) != 0)
        return truth_equation_refuse(
            e, text, "expected name=value for its inputs, each once");
    for (int k = 0; k < equations_inputs(&e->equation); k++) {
        if (given[k]) continue;
        equations_name(&e->equation, k, name);
        if (e->variable >= 0 ||
            (strcmp(name, "t") != 0 && strcmp(name, "x") != 0))
            return truth_equation_refuse(e, text, "an input is missing");
        e->variable = k;
    }
    return e;
}

static double truth_equation_value(const void *of, double x)
{
    const struct equation_truth *const e = of;
    double input[EQUATIONS_INPUTS];

    memcpy(input, e->input, sizeof input);
    if (e->variable >= 0) input[e->variable] = x;
    return equations_value(&e->equation, input);
}

const struct truth_function truth_equation = {
    "an equation", truth_equation_is_meant, truth_equation_create,
    truth_equation_value, free};
