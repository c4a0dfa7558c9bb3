/* formula.h -- formulas of x, y, z and t that a case writes.
 *
 * Numbers, pi, + - * / ^, parentheses, and the functions abs, sqrt, exp, log,
 * sin, cos, tan, sinh, cosh, tanh, erf, min(a, b), max(a, b). A formula is
 * translated once into steps on a stack; to evaluate it is a loop over them.
 */
#ifndef FLUID_INLETS_FORMULA_H
#define FLUID_INLETS_FORMULA_H

struct formula;

/* Translates a formula; NULL if it is wrong, and `wrong` then says what and
 * where. */
struct formula *formula_create(const char *text, char *wrong, int room);
void formula_free(struct formula *f);

/* The value of the formula at x [m] and t [s]. */
double formula_value(const struct formula *f, const double x[3], double t);

/* 1 if t stands in it. */
int formula_varies(const struct formula *f);

#endif
