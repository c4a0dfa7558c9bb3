/* SPDX-License-Identifier: GPL-3.0-or-later */
/* truth.c -- curves and their statistics, orders and the extrapolation, and
 * what else a measure is compared with. */
#include "study/curve.h"

#include "base/alloc.h"
#include "base/statistics.h"
#include "tell/check.h"
#include "fluid/inlet_profile.h"
#include "study/plan.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- statistics ----------------------------------------------------------- */

enum { FEWEST_BLOCKS = 8 };

/* The standard error of the mean of n independent samples. */
double curve_scatter(int n, const double *x)
{
    double sum = 0.0, squares = 0.0;

    /* From the first, so that equal samples have exactly no scatter. */
    for (int i = 0; i < n; i++)
        sum += x[i] - x[0];
    for (int i = 0; i < n; i++)
        squares += pow(x[i] - x[0] - sum / n, 2.0);
    return n > 1 ? sqrt(squares / ((double)n * (n - 1))) : 0.0;
}

/* Halves a series: each block of two becomes its mean. Returns their number. */
static int halve(int n, double *x)
{
    for (int i = 0; i < n / 2; i++)
        x[i] = 0.5 * (x[2 * i] + x[2 * i + 1]);
    return n / 2;
}

double curve_block_error(int n, const double *x)
{
    double *const block = alloc_doubles(n);
    double largest = n < FEWEST_BLOCKS ? 0.0 : curve_scatter(n, x);

    memcpy(block, x, (size_t)n * sizeof *x);
    for (int m = halve(n, block); m >= FEWEST_BLOCKS; m = halve(m, block))
        largest = fmax(largest, curve_scatter(m, block));
    free(block);
    return largest;
}

double curve_order(double h_coarse, double e_coarse, double h_fine,
                   double e_fine)
{
    return log(e_coarse / e_fine) / log(h_coarse / h_fine);
}

/* Ratio of the two changes if the order is p. */
static double ratio_at(const double h[3], double p)
{
    const double r = pow(h[1] / h[0], p);

    return (1.0 - r) / (r - pow(h[2] / h[0], p));
}

double curve_richardson(const double h[3], double ratio)
{
    double low = 0.1, high = 12.0;

    if (!(ratio > ratio_at(h, low) && ratio < ratio_at(h, high))) return NAN;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        if (ratio_at(h, middle) < ratio)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* --- curves --------------------------------------------------------------- */

struct curve curve_create(int n)
{
    return (struct curve){n, alloc_doubles(n), alloc_doubles(n),
                          alloc_doubles(n)};
}

void curve_free(struct curve *c)
{
    free(c->x);
    free(c->value);
    free(c->error);
    *c = (struct curve){0};
}

/* y at x, linear between the points; nan beyond them. */
static double between(const struct curve *c, const double *y, double x)
{
    const int n = c->n;
    int i = 0;

    if (n < 2) return n == 1 ? y[0] : NAN;
    const double near = 1e-9 * (fabs(c->x[0]) + fabs(c->x[n - 1]));
    if (!(x >= c->x[0] - near && x <= c->x[n - 1] + near)) return NAN;
    while (i < n - 2 && c->x[i + 1] < x)
        i++;
    return y[i] + (y[i + 1] - y[i]) * (x - c->x[i]) / (c->x[i + 1] - c->x[i]);
}

double curve_at(const struct curve *c, double x, double *error)
{
    if (error != NULL) *error = between(c, c->error, x);
    return between(c, c->value, x);
}

struct curve curve_mean(int n, const struct curve *of)
{
    struct curve mean = curve_create(of[0].n);
    double *const q = alloc_doubles(n);

    for (int i = 0; i < mean.n; i++) {
        double squares = 0.0;
        for (int k = 0; k < n; k++) {
            const int same = of[k].n == mean.n;
            q[k] = same ? of[k].value[i] : curve_at(&of[k], of[0].x[i], NULL);
            squares += same ? of[k].error[i] * of[k].error[i] : 0.0;
        }
        mean.x[i] = of[0].x[i];
        mean.value[i] = moments_mean(n, q);
        mean.error[i] = fmax(sqrt(squares) / n, curve_scatter(n, q));
    }
    free(q);
    return mean;
}

double curve_changes(const struct curve *a, const struct curve *b,
                     const struct curve *c)
{
    double first = 0.0, last = 0.0, both = 0.0, chance = 0.0;

    for (int i = 0; i < c->n; i++) {
        double e;
        const double q = curve_at(b, c->x[i], &e);
        const double from = q - curve_at(a, c->x[i], NULL);
        const double to = c->value[i] - q;
        if (!isfinite(from) || !isfinite(to)) continue;
        first += from * from;
        last += to * to;
        both += from * to;
        chance += e * e + c->error[i] * c->error[i];
    }
    return last > 4.0 * chance ? copysign(sqrt(first / last), both) : NAN;
}

/* --- an equation ---------------------------------------------------------- */

struct truth_equation {
    struct equation equation;
    double input[EQUATIONS_INPUTS];
    int variable; /* the input that is t or x; -1: none */
};

/* A document and a number, "XS11:4.1". */
static int is_equation(const char *text)
{
    const size_t n = strcspn(text, ": ");

    return isupper((unsigned char)text[0]) && n > 0 && text[n] == ':';
}

/* Reads "name=value name=value ..."; non-zero if one of them is wrong. */
static int truth_read_inputs(struct truth_equation *e, const char *text,
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

/* What is wrong with the text, or NULL. */
static const char *read_equation(struct truth_equation *e, const char *text)
{
    int given[EQUATIONS_INPUTS] = {0};
    char name[EQUATIONS_TEXT];
    const size_t length = strcspn(text, " ");

    snprintf(name, sizeof name, "%.*s", (int)length, text);
    e->variable = -1;
    if (!equations_named(name, &e->equation))
        return "no such equation; winnow eval lists all";
    if (truth_read_inputs(e, text + length, given) != 0)
        return "expected name=value for its inputs, each once";
    for (int k = 0; k < equations_inputs(&e->equation); k++) {
        if (given[k]) continue;
        equations_name(&e->equation, k, name);
        if (e->variable >= 0 ||
            (strcmp(name, "t") != 0 && strcmp(name, "x") != 0))
            return "an input is missing";
        e->variable = k;
    }
    return NULL;
}

static double value_of_equation(const struct truth_equation *e, double x)
{
    double input[EQUATIONS_INPUTS];

    memcpy(input, e->input, sizeof input);
    if (e->variable >= 0) input[e->variable] = x;
    return equations_value(&e->equation, input);
}

/* --- all kinds ------------------------------------------------------------ */

int truth_is_table(const char *text)
{
    const size_t n = strlen(text);

    return n > 4 && strcmp(text + n - 4, ".csv") == 0;
}

static int truth_refuse(const struct truth *t, int code, const char *why)
{
    plan_wrong("truth %s: %s", t->text, why);
    return code;
}

/* The first two columns of a table, but for rows without a value. */
static int take_columns(struct truth *t, const struct measure_table *table)
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
            return truth_refuse(
                t, 2, "its first column does not rise from row to row");
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
    struct measure_table *const table = measure_table_read(t->text, &wrong);

    t->kind = TRUTH_TABLE;
    snprintf(why, sizeof why,
             "line %d is not a row of numbers with commas between, one for "
             "each name of the head line",
             wrong);
    code = table != NULL ? take_columns(t, table)
           : wrong < 0   ? truth_refuse(t, 4, "cannot be read")
           : wrong > 0   ? truth_refuse(t, 2, why)
                       : truth_refuse(t, 2, "has no head line with rows below");
    measure_table_free(table);
    return code;
}

/* A formula, of which all variables are the first column, or an equation. */
static int read_function(struct truth *t)
{
    char wrong[256];

    if (is_equation(t->text)) {
        t->kind = TRUTH_EQUATION;
        t->equation = alloc_zeroed(1, sizeof *t->equation);
        const char *const why = read_equation(t->equation, t->text);
        const struct equation *const e = &t->equation->equation;
        return why == NULL ? 0
                           : plan_wrong("truth %s: %s%s%s", t->text, why,
                                        e->what != NULL ? "; it takes " : "",
                                        e->what != NULL ? e->inputs : "");
    }
    t->kind = TRUTH_FORMULA;
    t->formula = formula_create(t->text, wrong, sizeof wrong);
    if (t->formula != NULL) return 0;
    return plan_wrong(
        "truth %s: %s; expected a formula of t or x, an equation KEY "
        "name=value ..., FILE.csv, finest, extrapolated or none",
        t->text, wrong);
}

double truth_value(const struct truth *t, double x)
{
    return t->kind == TRUTH_TABLE ? curve_at(&t->table, x, NULL)
           : t->kind == TRUTH_EQUATION
               ? value_of_equation(t->equation, x)
               : formula_value(t->formula, (const double[3]){x, x, x}, x);
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
    if (read_function(t) != 0) return 2;
    const double one = truth_value(t, 0.3), other = truth_value(t, 0.7);
    return (isfinite(one) && one != 0.0) || (isfinite(other) && other != 0.0)
               ? 0
               : truth_refuse(t, 2,
                              "is 0 or nan everywhere, and no error is "
                              "relative to that");
}

void truth_free(struct truth *t)
{
    formula_free(t->formula);
    free(t->equation);
    curve_free(&t->table);
    free(t->text);
    *t = (struct truth){0};
}
