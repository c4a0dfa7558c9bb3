/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/truth.h"

#include "study/results.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const struct truth_function truth_equation, truth_formula;
static const struct truth_function *const truth_functions[] = {
    &truth_equation, &truth_formula, NULL};

int truth_is_table(const char *text)
{
    const size_t n = strlen(text);

    return n > 4 && strcmp(text + n - 4, ".csv") == 0;
}

static int truth_refuse(const struct truth *t, int code, const char *why)
{
    fprintf(stderr, "winnow: study: truth %s: %s\n", t->text, why);
    return code;
}

/* The first two columns of a table, but for rows without a value. */
static int take_columns(struct truth *t, const struct results_table *table)
{
    struct curve *const c = &t->table;
    const int m = table->n_columns;

    if (m < 2)
        return truth_refuse(t, 2, "has one column; expected x and a value");
    *c = curve_create(table->n_rows);
    c->n = 0;
    for (int i = 0; i < table->n_rows; i++) {
        const double x = table->value[i * m], q = table->value[i * m + 1];
        if (isnan(q)) continue;
        if (isinf(x) || isinf(q))
            return truth_refuse(t, 2, "has an infinite number");
        if (isnan(x) || (c->n > 0 && x <= c->x[c->n - 1]))
            return truth_refuse(t, 2,
                                "its first column does not rise from row to "
                                "row");
        c->x[c->n] = x;
        c->value[c->n++] = q;
    }
    return c->n > 0 ? 0
                    : truth_refuse(t, 2, "has no values in its second column");
}

static int read_table(struct truth *t)
{
    int wrong, code;
    char why[128];
    struct results_table *const table = results_table_read(t->text, &wrong);

    t->kind = TRUTH_TABLE;
    snprintf(why, sizeof why,
             "line %d is not a row of numbers with commas between, one for "
             "each name of the head line",
             wrong);
    code = table != NULL ? take_columns(t, table)
           : wrong < 0   ? truth_refuse(t, 4, "cannot be read")
           : wrong > 0   ? truth_refuse(t, 2, why)
                       : truth_refuse(t, 2, "has no head line with rows below");
    results_table_free(table);
    return code;
}

double truth_value(const struct truth *t, double x)
{
    return t->kind == TRUTH_TABLE ? curve_at(&t->table, x, NULL)
                                  : t->function->value(t->of, x);
}

int truth_parse(struct truth *t, const char *text)
{
    static const char *const words[] = {"finest", "extrapolated", "none"};

    *t = (struct truth){.text = strdup(text)};
    for (int i = 0; i < 3; i++)
        if (strcmp(text, words[i]) == 0) {
            t->kind = (enum truth_kind)(TRUTH_FINEST + i);
            return 0;
        }
    if (truth_is_table(text)) return read_table(t);
    t->kind = TRUTH_FUNCTION;
    for (int i = 0; truth_functions[i] != NULL && t->function == NULL; i++)
        if (truth_functions[i]->is_meant(text))
            t->function = truth_functions[i];
    if (t->function != NULL) t->of = t->function->create(text);
    if (t->of == NULL) return 2;
    const double one = truth_value(t, 0.3), other = truth_value(t, 0.7);
    if (isfinite(one) && one != 0.0) return 0;
    if (isfinite(other) && other != 0.0) return 0;
    return truth_refuse(
        t, 2, "is 0 or nan everywhere, and no error is relative to that");
}

void truth_free(struct truth *t)
{
    if (t->of != NULL) t->function->free(t->of);
    curve_free(&t->table);
    free(t->text);
    *t = (struct truth){0};
}
