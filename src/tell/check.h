/* check.h -- what is told of a case, of models, keys and equations. */
#ifndef TELL_CHECK_H
#define TELL_CHECK_H

#include <stddef.h>

#include "case/checks/checks.h"
#include "coupling/effect.h"

/* --- check: `winnow check`: a case in derived numbers, before it is run. */

struct command_line;
struct effect;

/* Solids fraction of a packed bed, where the interstitial velocity is largest
 * [-]. */
#define CHECK_PACKED 0.6

/* Prints on stdout what follows from the case: resolution, time scales, chosen
 * steps, cost. Returns the exit code; 3 where the first steps break down. */
int check_case(const struct settings *s);

/* Its sections: the Courant number of the flow as it enters; the bandwidth
 * beside cells, particles and bed; relaxation times and what a bed asks for;
 * attractions; every effect, named or not, and how the phases should be
 * coupled; the next finer and the next coarser choices. */
void check_flow(const struct settings *s, const struct case_scales *k);
/* The Courant number of that flow, 0 if nothing is known to move. */
double check_courant(const struct settings *s, const struct case_scales *k);
void check_averaging(const struct settings *s, const struct case_scales *k);
void check_drag(const struct settings *s, const struct case_scales *k);
void check_cohesion(const struct settings *s, const struct case_scales *k);
void check_effects(const struct settings *s, const struct case_scales *k);
void check_accuracy(const struct settings *s, const struct case_scales *k);

/* The scales from which the effects estimate themselves. */
struct effect_scales check_scales(const struct settings *s,
                                  const struct case_scales *in);

/* `winnow check CASE --try SECONDS`: runs the case so long with all effects
 * that could matter, then without each of them. Returns the exit code. */
int check_try(const struct command_line *l);

/* What is said of an effect. */
enum { CHECK_EFFECTS = 32 };
struct effect_row {
    const struct effect *effect;
    const struct effect *instead; /* stands for it; or NULL */
    int named;                    /* [-] 1: it is on */
    int refused;                  /* [-] 1: the case's clumps cannot have it */
    double time;                  /* [-] of the run without it */
    struct effect_estimate estimate;
};

/* In words: needed, negligible or unknown. */
enum { CHECK_VERDICT = 256 };
void check_verdict(const struct effect_row *r, char text[CHECK_VERDICT]);

/* The size in per cent, after "<" if it is a bound. */
enum { CHECK_SIZE = 32 };
void check_size(const struct effect_estimate *e, char text[CHECK_SIZE]);

/* Fills the rows of all effects that the case has or could have; how many. */
int check_effect_rows(const struct settings *s, struct effect_scales *k,
                      const struct case_scales *in,
                      struct effect_row row[CHECK_EFFECTS]);

/* --- list: `winnow list`: what there is to choose from. */

/* Prints the kinds of models on stdout. */
void list_kinds(void);

struct model;

/* Prints a model with its keys. */
void list_model(const struct model *m);

/* Prints every model of a kind with its keys, or for "keys" the whole table of
 * keys. 0, or 2 after a message if there is no such kind. */
int list_models(const char *kind);

/* Prints the cases that come with the program. The exit code. */
int list_cases(void);

/* The keys of one part of a case ("fluid"), or of all for NULL. Returns the
 * exit code, 2 after a message if there is no such part. */
int list_keys(const char *part);

/* --- equations: every equation that stands alone, by its key.
 *
 * A row carries an equation of the documents to the function that the solver
 * itself calls, so that what `winnow eval` prints is what a run computes. */

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
