/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/truth.h"

#include "study/results.h"

#include <math.h>
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
    struct results_table *const table = results_table_read(t->text);
    const int n = table != NULL && table->n_columns > 1 ? table->n_rows : 0;
    int rises = n > 0;

    t->kind = TRUTH_TABLE;
    t->table = curve_create(n);
    for (int i = 0; i < n; i++) {
        t->table.x[i] = table->value[i * table->n_columns];
        t->table.value[i] = table->value[i * table->n_columns + 1];
        rises &= i == 0 || t->table.x[i] > t->table.x[i - 1];
    }
    results_table_free(table);
    if (rises) return 0;
    fprintf(stderr,
            "winnow: study: truth %s: cannot be read as a table of two columns "
            "or more, with a head line and commas, the first rising\n",
            t->text);
    return n > 0 ? 2 : 4;
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
    if (is_table(text)) return read_table(t);
    t->kind = TRUTH_FUNCTION;
    for (int i = 0; truth_functions[i] != NULL && t->function == NULL; i++)
        if (truth_functions[i]->is_meant(text))
            t->function = truth_functions[i];
    if (t->function != NULL) t->of = t->function->create(text);
    if (t->of == NULL) return 2;
    const double one = truth_value(t, 0.3), other = truth_value(t, 0.7);
    if (isfinite(one) && one != 0.0) return 0;
    if (isfinite(other) && other != 0.0) return 0;
    fprintf(stderr,
            "winnow: study: truth %s: is %g everywhere, and no error is "
            "relative to that\n",
            text, one);
    return 2;
}

void truth_free(struct truth *t)
{
    if (t->of != NULL) t->function->free(t->of);
    curve_free(&t->table);
    free(t->text);
    *t = (struct truth){0};
}
