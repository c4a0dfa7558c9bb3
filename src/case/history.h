/* history.h -- the numbers of one moment, a row of history.csv.
 *
 * Physical quantities come first, then residuals, iterations and every
 * correction that the numerical method has made to the solution. A column that
 * does not apply to a case is left out.
 */
#ifndef CASE_HISTORY_H
#define CASE_HISTORY_H

#include "coupling/simulation.h"

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
    HISTORY_PARTS = 16,        /* a step of the fluid that may be divided */
    HISTORY_BUDGET = 32,       /* of the energy of the particles */
    HISTORY_POPULATION = 64    /* particles inserted or removed */
};

/* All columns, ended by one without a name. */
extern const struct history_column history_columns[];

/* 1 if the simulation has what the column needs. */
int history_applies(const struct history_column *c,
                    const struct simulation *sim);

#endif
