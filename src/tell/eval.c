/* SPDX-License-Identifier: GPL-3.0-or-later */
/* eval.c -- `winnow eval`: one equation at a time. */
#include "tell/check.h"

#include "case/command.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void eval_list(void)
{
    struct equation e;

    for (int i = 0; equations_at(i, &e); i++) {
        printf("%-10s %s\n", e.key, e.what);
        printf("%-10s %s -> %s [%s], by %s\n", "", e.inputs, e.out, e.unit,
               e.function);
    }
}

static int unknown_key(const char *key)
{
    struct equation e;
    struct nearest n;
    char hint[NEAREST_HINT];

    nearest_init(&n, key);
    for (int i = 0; equations_at(i, &e); i++)
        nearest_offer(&n, e.key);
    fprintf(stderr, "winnow: no equation %s%s\n", key,
            nearest_hint(nearest_best(&n), "; winnow eval lists all", hint));
    return 2;
}

/* Says what is wrong with an input, and what the equation takes. */
static int eval_refuse(const struct equation *e, const char *input,
                       const char *why)
{
    fprintf(stderr, "winnow: eval %s: %s %s; it takes %s\n", e->key, input, why,
            e->inputs);
    return 2;
}

/* Fills x from the inputs; each must be there once. */
static int eval_read_inputs(const struct equation *e, int n,
                            const char *const *inputs, double *x)
{
    int given[EQUATIONS_INPUTS] = {0};
    char name[EQUATIONS_TEXT];

    for (int i = 0; i < n; i++) {
        const size_t length = strcspn(inputs[i], "=");
        const int k = equations_input(e, inputs[i], length);
        const char *const text = inputs[i] + length;
        char *end;

        if (k < 0 || *text != '=')
            return eval_refuse(e, inputs[i], "is not one of its inputs");
        if (given[k]++) return eval_refuse(e, inputs[i], "is given twice");
        x[k] = strtod(text + 1, &end);
        if (end == text + 1 || *end != '\0' || !isfinite(x[k]))
            return eval_refuse(e, inputs[i], "is not a number");
    }
    for (int k = 0; k < equations_inputs(e); k++)
        if (!given[k]) {
            equations_name(e, k, name);
            return eval_refuse(e, name, "is missing");
        }
    return 0;
}

int eval_print(const char *key, int n, const char *const *inputs)
{
    struct equation e;
    double x[EQUATIONS_INPUTS];

    if (!equations_named(key, &e)) return unknown_key(key);
    if (eval_read_inputs(&e, n, inputs, x) != 0) return 2;
    const double value = equations_value(&e, x);
    if (!isfinite(value)) {
        fprintf(stderr, "winnow: eval %s: %s has no value for these inputs\n",
                key, e.out);
        return 2;
    }
    printf("%s = %.12g [%s]\n", e.out, value, e.unit);
    return 0;
}

static int eval_act(const struct command_line *l)
{
    if (l->n_words > 0)
        return eval_print(l->words[0], l->n_words - 1, l->words + 1);
    eval_list();
    return 0;
}

const struct command eval_command = {
    "eval",  "[KEY name=value ...]", "the value of one equation", "", 0, -1,
    eval_act};
