/* SPDX-License-Identifier: GPL-3.0-or-later */
/* formula.c -- a grammar with one function a rule:
 *
 *   sum      = product { (+|-) product }
 *   product  = sign { (*|/) sign }
 *   sign     = [+|-] sign | power
 *   power    = operand [ ^ sign ]
 *   operand  = number | name | name ( sum [, sum] ) | ( sum )
 *
 * so that - binds looser than ^, as on paper: -x^2 is -(x^2), and 2^3^2 is
 * 2^(3^2).
 */
#include "fluid/inlet_profile.h"

#include <ctype.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

enum { MOST_STEPS = 256, MOST_DEPTH = 64 };

enum step_kind { NUMBER, PLACE, TIME, ONE, TWO };

/* A step pushes a number onto the stack, or replaces one or two numbers at its
 * top by a function of them. */
struct step {
    enum step_kind kind;
    double number; /* of NUMBER */
    int k;         /* of PLACE: x, y or z */
    double (*one)(double);
    double (*two)(double, double);
};

struct formula {
    int n;
    struct step step[MOST_STEPS];
};

static double formula_add(double a, double b)
{
    return a + b;
}

static double formula_subtract(double a, double b)
{
    return a - b;
}

static double formula_multiply(double a, double b)
{
    return a * b;
}

static double formula_divide(double a, double b)
{
    return a / b;
}

static double negative(double a)
{
    return -a;
}

static const struct {
    const char *name;
    struct step step;
} names[] = {{"x", {.kind = PLACE, .k = 0}},
             {"y", {.kind = PLACE, .k = 1}},
             {"z", {.kind = PLACE, .k = 2}},
             {"t", {.kind = TIME}},
             {"pi", {.kind = NUMBER, .number = M_PI}},
             {"abs", {.kind = ONE, .one = fabs}},
             {"sqrt", {.kind = ONE, .one = sqrt}},
             {"exp", {.kind = ONE, .one = exp}},
             {"log", {.kind = ONE, .one = log}},
             {"sin", {.kind = ONE, .one = sin}},
             {"cos", {.kind = ONE, .one = cos}},
             {"tan", {.kind = ONE, .one = tan}},
             {"sinh", {.kind = ONE, .one = sinh}},
             {"cosh", {.kind = ONE, .one = cosh}},
             {"tanh", {.kind = ONE, .one = tanh}},
             {"erf", {.kind = ONE, .one = erf}},
             {"min", {.kind = TWO, .two = fmin}},
             {"max", {.kind = TWO, .two = fmax}}};

/* The state of reading a text. */
struct reader {
    const char *text, *at;
    struct formula *made;
    int depth;         /* [-] of open rules */
    int stack, height; /* [-] numbers on the stack, and the most of them */
    char *wrong;
    int room, failed;
};

static void fail(struct reader *r, const char *expected)
{
    if (!r->failed)
        snprintf(r->wrong, (size_t)r->room,
                 "expected %s at sign %d, before \"%.20s\"", expected,
                 (int)(r->at - r->text) + 1, r->at);
    r->failed = 1;
}

static void formula_put(struct reader *r, struct step step)
{
    if (r->made->n == MOST_STEPS) fail(r, "a shorter formula");
    if (r->failed) return;
    r->made->step[r->made->n++] = step;
    r->stack += step.kind == TWO ? -1 : step.kind != ONE;
    if (r->stack > r->height) r->height = r->stack;
    if (r->height > MOST_DEPTH) fail(r, "fewer parentheses");
}

/* Reads the next sign if it is c; returns 1 if so. */
static int took(struct reader *r, char c)
{
    while (isspace((unsigned char)*r->at))
        r->at++;
    if (*r->at != c) return 0;
    r->at++;
    return 1;
}

static void put_two(struct reader *r, double (*two)(double, double))
{
    formula_put(r, (struct step){.kind = TWO, .two = two});
}

static void formula_sum(struct reader *r);

static void name(struct reader *r)
{
    int length = 0;

    while (isalpha((unsigned char)r->at[length]))
        length++;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const struct step step = names[i].step;
        if ((int)strlen(names[i].name) != length ||
            strncmp(names[i].name, r->at, (size_t)length) != 0)
            continue;
        r->at += length;
        if (step.kind >= ONE) {
            if (!took(r, '(')) fail(r, "(");
            formula_sum(r);
            if (step.kind == TWO && !took(r, ',')) fail(r, ",");
            if (step.kind == TWO) formula_sum(r);
            if (!took(r, ')')) fail(r, ")");
        }
        formula_put(r, step);
        return;
    }
    fail(r, "x, y, z, t, pi, or abs, sqrt, exp, log, sin, cos, tan, sinh, "
            "cosh, tanh, erf, min, max");
}

static void operand(struct reader *r)
{
    if (took(r, '(')) {
        formula_sum(r);
        if (!took(r, ')')) fail(r, ")");
    } else if (isalpha((unsigned char)*r->at))
        name(r);
    else if (isdigit((unsigned char)*r->at) || *r->at == '.') {
        char *end;
        const double number = strtod(r->at, &end);
        if (end == r->at) {
            fail(r, "a number");
            return;
        }
        formula_put(r, (struct step){.kind = NUMBER, .number = number});
        r->at = end;
    } else
        fail(r, "a number, a name or (");
}

static void sign(struct reader *r)
{
    if (++r->depth > MOST_DEPTH) fail(r, "fewer parentheses");
    if (r->failed) return;
    if (took(r, '-')) {
        sign(r);
        formula_put(r, (struct step){.kind = ONE, .one = negative});
    } else if (took(r, '+'))
        sign(r);
    else {
        operand(r);
        if (took(r, '^')) {
            sign(r);
            put_two(r, pow);
        }
    }
    r->depth--;
}

static void formula_product(struct reader *r)
{
    sign(r);
    for (;;)
        if (took(r, '*')) {
            sign(r);
            put_two(r, formula_multiply);
        } else if (took(r, '/')) {
            sign(r);
            put_two(r, formula_divide);
        } else
            return;
}

static void formula_sum(struct reader *r)
{
    formula_product(r);
    for (;;)
        if (took(r, '+')) {
            formula_product(r);
            put_two(r, formula_add);
        } else if (took(r, '-')) {
            formula_product(r);
            put_two(r, formula_subtract);
        } else
            return;
}

struct formula *formula_create(const char *text, char *wrong, int room)
{
    struct formula *const f = alloc_zeroed(1, sizeof *f);
    struct reader r = {
        .text = text, .at = text, .made = f, .wrong = wrong, .room = room};

    formula_sum(&r);
    if (!took(&r, '\0')) fail(&r, "an operator or the end");
    if (!r.failed) return f;
    formula_free(f);
    return NULL;
}

void formula_free(struct formula *f)
{
    free(f);
}

double formula_value(const struct formula *f, const double x[3], double t)
{
    double stack[MOST_DEPTH + 1];
    int n = 0;

    for (int i = 0; i < f->n; i++) {
        const struct step *const s = &f->step[i];
        if (s->kind == ONE)
            stack[n - 1] = s->one(stack[n - 1]);
        else if (s->kind == TWO) {
            n--;
            stack[n - 1] = s->two(stack[n - 1], stack[n]);
        } else
            stack[n++] = s->kind == NUMBER  ? s->number
                         : s->kind == PLACE ? x[s->k]
                                            : t;
    }
    return stack[0];
}

int formula_varies(const struct formula *f)
{
    int varies = 0;

    for (int i = 0; i < f->n; i++)
        varies |= f->step[i].kind == TIME;
    return varies;
}
