/* history.h -- the numbers of one moment, a row of history.csv.
 *
 * Physical quantities come first, then residuals, iterations and every
 * correction that the numerical method has made to the solution. A column that
 * does not apply to a case is left out.
 */
#ifndef RECORD_HISTORY_H
#define RECORD_HISTORY_H

#include "coupling/simulation.h"

struct summary;

/* One column. */
struct history_column {
    const char *name; /* with its unit: "pressure_drop [Pa]" */
    double (*value)(const struct simulation *sim);
    int needs; /* HISTORY_... */
};

enum {
    HISTORY_FLUID = 1,
    HISTORY_PARTICLES = 2,
    HISTORY_COUPLING = 4,
    HISTORY_MEAN_GRADIENT = 8, /* a flow prescribed through periodic ends */
    HISTORY_PARTS = 16         /* a step of the fluid that may be divided */
};

/* The function of a column that is one expression of the simulation. */
#define HISTORY_VALUE(name, expression)                                        \
    static double name(const struct simulation *sim)                           \
    {                                                                          \
        return expression;                                                     \
    }

/* Columns that stand together, ended by one without a name. */
struct history_table {
    const struct history_column *columns;
    int (*applies)(const struct simulation *sim); /* NULL: to all */
    /* Its numbers in the summary, or NULL. */
    void (*summarize)(const struct simulation *sim, struct summary *f);
};

/* All of them, in the order of the row, ended by NULL. */
extern const struct history_table history_of_bed, history_population,
    history_budget, history_further;
extern const struct history_table *const history_tables[];

/* Loops over all columns; t is the table of column c. */
#define HISTORY_EACH(t, c)                                                     \
    for (const struct history_table *const *at_##t = history_tables, *t;       \
         (t = *at_##t) != NULL; at_##t++)                                      \
        for (const struct history_column *c = t->columns; c->name != NULL; c++)

/* 1 if the simulation has what the table and the column need. */
int history_applies(const struct history_table *t,
                    const struct history_column *c,
                    const struct simulation *sim);

#endif
