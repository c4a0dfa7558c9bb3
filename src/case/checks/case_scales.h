/* case_scales.h -- lengths, times and speeds that follow from a case.
 *
 * `winnow check` prints them, and a run is refused if its step does not resolve
 * the impacts of its particles.
 */
#ifndef CASE_CHECKS_CASE_SCALES_H
#define CASE_CHECKS_CASE_SCALES_H

#include "case/settings.h"

/* A member is 0 where the case has no such thing. */
struct case_scales {
    int cells, particles;
    double S_c;        /* [m] S_c = V_c^(1/3), of the mean cell [SX15 10] */
    double d, d_most;  /* [m] smallest and largest diameter */
    double volume;     /* [m^3] of the particles of a bed */
    double density;    /* [kg/m^3] of the particles */
    double dt, dem_dt; /* [s] of the loop, of the particles */
    int dem_steps;     /* [-] in one step of the loop */
    double inlet;      /* [m/s] largest superficial velocity of an inlet */
    double impact;     /* [m/s] speed of collisions that is assumed */
    double end;        /* [s] */
};
struct case_scales case_scales_of(const struct settings *s);

/* particles.step = "auto": 1, or 0 if the case has a number or no particles. */
int case_scales_is_auto(const struct settings *s);

/* Then the suggested step becomes that of the case, of which the fluid's step
 * is a whole number. 0, or 2 after a message. */
int case_scales_auto_step(struct settings *s);

/* Whether the machine has the memory that the averaging takes, besides all
 * else. 0, or 2 after a message. */
int case_scales_check_memory(const struct settings *s,
                             const struct case_scales *k);

/* Whether a run can begin: the memory, and a particle step that resolves the
 * impacts, unless particles.unsafe_step is set. 0, or 2 after a message. */
int case_scales_check(const struct settings *s);

#endif
