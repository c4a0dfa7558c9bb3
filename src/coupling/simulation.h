/* simulation.h -- all parts of a simulation.
 * Chapter "The coupled loop".
 *
 * A pointer is NULL if the case does not have that part: no fluid, no
 * particles, no coupling between them. An effect that is not named is not in
 * the list.
 */
#ifndef COUPLING_SIMULATION_H
#define COUPLING_SIMULATION_H

#include "averaging/averaging.h"
#include "coupling/effect.h"
#include "dem/dem.h"
#include "dem/particles.h"
#include "dem/bed.h"
#include "fluid/fluid.h"
#include "mesh/mesh.h"

struct coupling;
struct population;
struct processes;

/* Wall-clock seconds spent so far, by part; and processor seconds of all
 * threads, without output. */
struct seconds {
    double cfd, dem, averaging, exchange, output;
    double processor;
};

struct simulation {
    struct mesh *mesh;
    struct fluid *fluid;
    struct particles *particles;
    struct dem *dem;
    struct surface *surfaces; /* walls other than the box; NULL: none */
    int n_surfaces;
    const char **surface_names; /* n_surfaces */
    struct prescribed_particle
        *prescribed; /* particles of prescribed motion; NULL: none */
    struct population *population;  /* NULL: no insertion or removal */
    struct case_walls *walls;       /* of a polyhedral mesh; or NULL */
    struct placement_region region; /* where particles may be placed */
    struct materials *materials;    /* NULL: all are of one */
    struct attraction *attractions; /* NULL: none */
    struct averaging *averaging;
    struct coupling *coupling;
    double dt;          /* [s] of the loop: that of the fluid, if any */
    int dem_steps;      /* [-] particle steps in one step of the loop */
    double t;           /* [s] */
    long steps;         /* [-] done */
    double substep;     /* [s] of the drag, that is being computed */
    double gravity[3];  /* [m/s^2] 0 unless the case names it */
    double *held_force; /* [N] constant forces of effects on the particles in
                           this step, 3 a particle */
    struct dem_report dem_report; /* of the last step */
    struct boundary *boundaries;  /* one a patch, of the fluid */
    int n_effects;
    struct effect_state *effects;
    struct effect_state *running_effect; /* the one whose hook runs, or
                                            that is created */
    struct effect_tally force_scale; /* what their forces are compared with */
    struct seconds seconds;
    struct processes *processes; /* with the other parts of it; NULL: there is
                                    one process */
};

/* Visits all parts that decide the next step (state.h); a simulation that is
 * loaded was built from the same case. Non-zero after a message. */
int simulation_state(struct simulation *sim, struct state *s);

/* Why a computation broke down. */

/* Where, when, what, and a remedy, in one paragraph. */
enum { BREAKDOWN_TEXT = 512 };
void breakdown_describe(const struct simulation *sim,
                        char text[BREAKDOWN_TEXT]);

/* 1 if an overlap is deeper than expected; breakdown_warn: says so, once in a
 * run, as *told says. */
int breakdown_overlaps(const struct simulation *sim);
void breakdown_warn(int *told, const struct simulation *sim);

#endif
