/* SPDX-License-Identifier: GPL-3.0-or-later */
/* formula.c -- a truth that is typed: 0.05 * (1 - exp(-t / 4e-4)).
 *
 *     sum     = [-] product { (+|-) product }
 *     product = power { (*|/) power }
 *     power   = atom [ ^ [-] power ]
 *     atom    = number | t | x | pi | function ( sum ) | ( sum )
 */
#include "study/truth.h"

#include "base/alloc.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct reader {
    const char *at;
    double x;
    int wrong; /* [-] 1: what stands at `at` is not what was expected */
};

static double sum(struct reader *r);

static int accept(struct reader *r, char c)
{
    r->at += strspn(r->at, " ");
    if (*r->at != c || r->wrong) return 0;
    r->at++;
    return 1;
}

static double in_brackets(struct reader *r)
{
    if (!accept(r, '(')) {
        r->wrong = 1;
        return NAN;
    }
    const double value = sum(r);
    if (!accept(r, ')')) r->wrong = 1;
    return value;
}

static double named(struct reader *r, const char *name, size_t length)
{
    static const struct {
        const char *name;
        double (*of)(double);
    } functions[] = {{"exp", exp},   {"log", log},   {"sqrt", sqrt},
                     {"sin", sin},   {"cos", cos},   {"tan", tan},
                     {"sinh", sinh}, {"cosh", cosh}, {"tanh", tanh},
                     {"abs", fabs},  {"erf", erf}};

    if (length == 1 && (name[0] == 't' || name[0] == 'x')) return r->x;
    if (length == 2 && strncmp(name, "pi", 2) == 0) return M_PI;
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++)
        if (strlen(functions[i].name) == length &&
            strncmp(functions[i].name, name, length) == 0)
            return functions[i].of(in_brackets(r));
    r->at = name;
    r->wrong = 1;
    return NAN;
}

static double atom(struct reader *r)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz";
    char *end;

    r->at += strspn(r->at, " ");
    if (*r->at == '(') return in_brackets(r);
    const char *const name = r->at;
    const size_t length = strspn(name, letters);
    if (length > 0) {
        r->at += length;
        return named(r, name, length);
    }
    const double number = strtod(r->at, &end);
    if (end == r->at || strchr("+-", *r->at) != NULL) r->wrong = 1;
    if (!r->wrong) r->at = end;
    return number;
}

static double power(struct reader *r)
{
    const double base = atom(r);

    if (!accept(r, '^')) return base;
    const double sign = accept(r, '-') ? -1.0 : 1.0;
    return pow(base, sign * power(r));
}

static double product(struct reader *r)
{
    double value = power(r);

    for (;;) {
        if (accept(r, '*'))
            value *= power(r);
        else if (accept(r, '/'))
            value /= power(r);
        else
            return value;
    }
}

static double sum(struct reader *r)
{
    double value = accept(r, '-') ? -product(r) : product(r);

    for (;;) {
        if (accept(r, '+'))
            value += product(r);
        else if (accept(r, '-'))
            value -= product(r);
        else
            return value;
    }
}

/* Whatever no other kind has taken. */
static int is_meant(const char *text)
{
    return text != NULL;
}

static void *create(const char *text)
{
    struct reader r = {text, 1.0, 0};

    sum(&r);
    r.at += strspn(r.at, " ");
    if (!r.wrong && *r.at == '\0') return strdup(text);
    fprintf(stderr,
            "winnow: study: truth %s: not understood %s%s%s; expected "
            "a formula of t or x, an equation KEY name=value ..., FILE.csv, "
            "finest, extrapolated or none\n",
            text, *r.at == '\0' ? "at its end" : "from \"", r.at,
            *r.at == '\0' ? "" : "\" on");
    return NULL;
}

static double value(const void *of, double x)
{
    struct reader r = {of, x, 0};

    return sum(&r);
}

const struct truth_function truth_formula = {"a formula", is_meant, create,
                                             value, free};
