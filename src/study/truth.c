/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/truth.h"

#include "base/alloc.h"
#include "study/results.h"
#include "study/statistics.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Written by models.awk. */
extern const struct truth_function *const truth_functions[];

static int is_table(const char *text)
{
    const size_t n = strlen(text);

    return n > 4 && strcmp(text + n - 4, ".csv") == 0;
}

static int read_table(struct truth *t)
{
    t->kind = TRUTH_TABLE;
    t->table = results_table_read(t->text);
    if (t->table != NULL && t->table->n_columns > 1) return 0;
    fprintf(stderr,
            "winnow: study: truth %s: cannot be read as a table of two columns "
            "or more, with a head line and commas\n",
            t->text);
    return 4;
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
    if (is_table(text)) return read_table(t);
    t->kind = TRUTH_FUNCTION;
    for (int i = 0; truth_functions[i] != NULL && t->function == NULL; i++)
        if (truth_functions[i]->is_meant(text))
            t->function = truth_functions[i];
    if (t->function != NULL) t->of = t->function->create(text);
    return t->of != NULL ? 0 : 2;
}

void truth_free(struct truth *t)
{
    if (t->of != NULL) t->function->free(t->of);
    results_table_free(t->table);
    free(t->text);
    *t = (struct truth){0};
}

static double in_table(const struct results_table *t, double x)
{
    double *const column = alloc_doubles(2 * t->n_rows);

    for (int i = 0; i < t->n_rows; i++)
        for (int k = 0; k < 2; k++)
            column[k * t->n_rows + i] = t->value[i * t->n_columns + k];
    const double y =
        statistics_between(t->n_rows, column, column + t->n_rows, x);
    free(column);
    return y;
}

double truth_value(const struct truth *t, double x)
{
    return t->kind == TRUTH_TABLE ? in_table(t->table, x)
                                  : t->function->value(t->of, x);
}
