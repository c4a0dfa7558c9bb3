/* equations.h -- every equation that stands alone, by its key.
 *
 * A row carries an equation of the documents to the function that the solver
 * itself calls, so that what `winnow eval` prints is what a run computes.
 */
#ifndef CASE_REPORT_EQUATIONS_H
#define CASE_REPORT_EQUATIONS_H

#include <stddef.h>

/* Most inputs of one equation, and room for a key, the name of an input and for
 * all of them. */
enum { EQUATIONS_INPUTS = 8, EQUATIONS_TEXT = 32, EQUATIONS_INPUT_TEXT = 192 };

struct equation {
    char key[EQUATIONS_TEXT]; /* document:number, "XS11:2.13"; "drag:rong" */
    const char *what;         /* its name */
    const char *formula;      /* as one would type it */
    char inputs[EQUATIONS_INPUT_TEXT]; /* and units: "Re [-], eps_f [-]" */
    const char *out;                   /* symbol of the value */
    const char *unit;                  /* and its unit, "-" for a pure number */
    const char *function;              /* that evaluates it */
    double (*value)(const double *in); /* in the order of inputs; NULL for a
                                          drag law */
};

/* A function of one to seven numbers as the value of an equation whose inputs
 * are these: EQUATION_OF_2(f), and EQUATION_BY(f) as the end of its row. */
#define EQUATION_OF(f, ...)                                                    \
    static double value_of_##f(const double *x)                                \
    {                                                                          \
        return f(__VA_ARGS__);                                                 \
    }
#define EQUATION_OF_1(f) EQUATION_OF(f, x[0])
#define EQUATION_OF_2(f) EQUATION_OF(f, x[0], x[1])
#define EQUATION_OF_3(f) EQUATION_OF(f, x[0], x[1], x[2])
#define EQUATION_OF_4(f) EQUATION_OF(f, x[0], x[1], x[2], x[3])
#define EQUATION_OF_5(f) EQUATION_OF(f, x[0], x[1], x[2], x[3], x[4])
#define EQUATION_OF_6(f) EQUATION_OF(f, x[0], x[1], x[2], x[3], x[4], x[5])
#define EQUATION_OF_7(f)                                                       \
    EQUATION_OF(f, x[0], x[1], x[2], x[3], x[4], x[5], x[6])
#define EQUATION_BY(f) #f, value_of_##f

/* The i-th of all, in the order of the documents; 0 past the last. */
int equations_at(int i, struct equation *e);

/* Those of EW18 and of the further forces, ended by one without a key; that of
 * the i-th drag law, 0 past the last, and its value. */
extern const struct equation equations_ew18[];
extern const struct equation equations_forces[];
int equations_drag(int i, struct equation *e);
double equations_drag_value(const struct equation *e, const double *in);

/* The equation of that key; 0 if there is none, and e is then empty. */
int equations_named(const char *key, struct equation *e);

/* Its value for these inputs. */
double equations_value(const struct equation *e, const double *in);

/* Number of its inputs; the place of the input with that name, given by its
 * first letter and its length, or -1; the name of the i-th. */
int equations_inputs(const struct equation *e);
int equations_input(const struct equation *e, const char *name, size_t length);
void equations_name(const struct equation *e, int i, char name[EQUATIONS_TEXT]);

#endif
