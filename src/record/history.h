/* history.h -- the numbers of one moment, a row of history.csv.
 *
 * Physical quantities come first, then residuals, iterations and every
 * correction that the numerical method has made to the solution. A column that
 * does not apply to a case is left out.
 */
#ifndef RECORD_HISTORY_H
#define RECORD_HISTORY_H

#include "coupling/simulation.h"

/* One column. */
struct history_column {
    const char *name; /* with its unit: "pressure_drop [Pa]" */
    double (*value)(const struct simulation *sim);
    int needs;        /* HISTORY_... */
    const char *what; /* it is */
};

enum {
    HISTORY_FLUID = 1,
    HISTORY_PARTICLES = 2,
    HISTORY_COUPLING = 4,
    HISTORY_MEAN_GRADIENT = 8, /* a flow prescribed through periodic ends */
    HISTORY_PARTS = 16,        /* a step of the fluid that may be divided */
    HISTORY_POPULATION = 32,   /* insertion or removal */
    HISTORY_BUDGET = 64,       /* of the particles' energy */
    HISTORY_PARCELS = 128,     /* particles that stand for several grains */
    HISTORY_GRAINS = 256       /* those, or balls of clumps */
};

/* The function of a column that is one expression of the simulation, and those
 * of three, by the component k = 0, 1, 2. */
#define HISTORY_VALUE(name, expression)                                        \
    static double name(const struct simulation *sim)                           \
    {                                                                          \
        return expression;                                                     \
    }
#define HISTORY_VECTOR(name, expression)                                       \
    static double name(const struct simulation *sim, int k)                    \
    {                                                                          \
        return expression;                                                     \
    }                                                                          \
    HISTORY_VALUE(name##_x, name(sim, 0))                                      \
    HISTORY_VALUE(name##_y, name(sim, 1))                                      \
    HISTORY_VALUE(name##_z, name(sim, 2))

/* All but those of the parts (recorder_part.h) and of the effects, in the order
 * of the row; the last has no name. */
extern const struct history_column history_columns[];

/* 1 if the simulation has what the column needs. */
int history_applies(const struct history_column *c,
                    const struct simulation *sim);

/* --- numbers of the whole bed, which means of a run are made of, too ------ */

/* Mean pressure where the fluid enters less that where it leaves [Pa]; between
 * the lower and the upper end where there is no inlet. */
double history_pressure_drop(const struct simulation *sim);

/* Weight of the particles over the cross-section of the box normal to gravity
 * [Pa]; 0 without gravity. */
double history_bed_weight(const struct simulation *sim);

/* The same less the weight of the fluid in their place [Pa]. */
double history_buoyant_weight(const struct simulation *sim);

/* Upwards: against gravity, of which a part along a period, where nothing is
 * high or low, does not count beside another part; without gravity y. */
void history_up(const struct simulation *sim, double up[3]);

#endif
