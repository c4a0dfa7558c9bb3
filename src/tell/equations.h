/* equations.h -- every equation that stands alone, by its key.
 *
 * A row carries an equation of the documents to the function that the solver
 * itself calls, so that what `winnow eval` prints is what a run computes.
 */
#ifndef TELL_EQUATIONS_H
#define TELL_EQUATIONS_H

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

/* The i-th of all, in the order of the documents; 0 past the last. */
int equations_at(int i, struct equation *e);

/* The equation of that key; 0 if there is none, and e is then empty. */
int equations_named(const char *key, struct equation *e);

/* Its value for these inputs. */
double equations_value(const struct equation *e, const double *in);

/* Number of its inputs; the place of the input with that name, given by its
 * first letter and its length, or -1; the name of the i-th. */
int equations_inputs(const struct equation *e);
int equations_input(const struct equation *e, const char *name, size_t length);
void equations_name(const struct equation *e, int i, char name[EQUATIONS_TEXT]);

/* `winnow eval`: lists every equation; prints the value of one for inputs
 * "name=value", and returns 0, or 2 after one message. */
void eval_list(void);
int eval_print(const char *key, int n, const char *const *inputs);

/* The index of the book, chapters/equations.md, which `make weave` gathers from
 * the keys in source, tests and chapters; the build turns it into C. */
enum equation_index_kind {
    EQUATION_INDEX_SAYS,   /* name: what the equation says */
    EQUATION_INDEX_STATUS, /* name: what is missing yet */
    EQUATION_INDEX_AS, /* name: the key of the equation that stands for it */
    EQUATION_INDEX_FUNCTION, /* name and file, and so below */
    EQUATION_INDEX_TEST,
    EQUATION_INDEX_SECTION
};

/* All of them, those of an equation together; ended by one without a key. */
struct equation_index_row {
    const char *key; /* "XS11 2.13" */
    enum equation_index_kind kind;
    const char *name, *file;
};
extern const struct equation_index_row equation_index_rows[];

#endif
