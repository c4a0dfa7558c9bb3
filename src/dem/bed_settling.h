/* bed_settling.h -- the settling of a bed.
 * Chapter "Particles and contact".
 *
 * A bed settles first with a very dissipative material and a viscous drag,
 * without which rolling spheres would not stop; then with the real material.
 */
#ifndef DEM_BED_SETTLING_H
#define DEM_BED_SETTLING_H

#include "dem/bed.h"

/* The stages of the settling at which a saver is called. */
enum bed_stage { BED_STAGE_START, BED_STAGE_STEPS, BED_STAGE_END };

struct bed_settling;

/* All that the rest of the settling depends on (state.h). */
void bed_settling_state(struct bed_settling *b, struct state *s);

/* The time since it was dropped [s]. */
double bed_settling_time(const struct bed_settling *b);

/* Saves a bed while it settles. */
struct bed_saver {
    void *memory; /* borrowed */
    /* Called once before the first step, where a bed that was saved may be
     * loaded; before each fifty steps; and once when the bed is at rest.
     * Settling ends where it returns an exit code that is not 0. */
    int (*visit)(void *memory, struct bed_settling *b, enum bed_stage stage);
};

/* Lets ps settle, as bed_settle does. */
int bed_settling_run(struct particles *ps, const struct bed_options *bed,
                     const struct dem_options *dem, struct bed_report *r,
                     struct bed_histories *histories);

#endif
