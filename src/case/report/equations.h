/* equations.h -- every equation that stands alone, by its key.
 *
 * A row carries an equation of the documents to the function that the solver
 * itself calls, so that what `winnow eval` prints is what a run computes.
 */
#ifndef CASE_REPORT_EQUATIONS_H
#define CASE_REPORT_EQUATIONS_H

#include <stddef.h>

/* Most inputs of one equation, and room for the name of one. */
enum { EQUATIONS_INPUTS = 8, EQUATIONS_TEXT = 32 };

struct equation {
    const char *key;      /* document:number, "XS11:2.13"; "drag:rong" */
    const char *what;     /* its name */
    const char *formula;  /* as one would type it */
    const char *inputs;   /* each with its unit: "Re [-], eps_f [-]" */
    const char *out;      /* symbol of the value */
    const char *unit;     /* and its unit, "-" for a pure number */
    const char *function; /* that evaluates it */
    double (*value)(const double *in); /* in the order of inputs */
};

/* The i-th of all, in the order of the documents; NULL past the last. */
const struct equation *equations_at(int i);

/* Those of EW18, of the further forces, and one for each drag law, ended by one
 * without a key. */
extern const struct equation equations_ew18[];
extern const struct equation equations_forces[];
extern const struct equation equations_drag[];

/* The equation of that key, or NULL. */
const struct equation *equations_named(const char *key);

/* Number of its inputs; the place of the input with that name, given by its
 * first letter and its length, or -1; the name of the i-th. */
int equations_inputs(const struct equation *e);
int equations_input(const struct equation *e, const char *name, size_t length);
void equations_name(const struct equation *e, int i, char name[EQUATIONS_TEXT]);

#endif
