/* coupling.h -- momentum between fluid and particles.  Chapter 10.
 *
 * The force of the fluid on particle i is k_i (u_f - u_p), k_i = eps_f B_i =
 * V_p beta / eps_s [XS11 2.9, 2.10]. What the particles receive, the fluid
 * loses. In a step the fluid, solved first, pays from an estimate; afterwards
 * the particles receive what they receive. Each particle carries the
 * difference, `owed`, and the fluid pays it in the next step. So at any time
 *
 *   momentum of the fluid + momentum of the particles - sum of owed
 *
 * changes only by what comes from outside.
 *
 * explicit:       estimate 0. The fluid pays one step late what was received.
 * semi-implicit:  estimate k_i (u_f^new - mean u_p) dt, with the fluid's new
 *                 velocity: K and F of fluid.h [XS11 3.13-3.15].
 */
#ifndef COUPLING_H
#define COUPLING_H

#include "averaging/interpolation.h"
#include "exchange/drag.h"
#include "exchange/simulation.h"

enum treatment { TREATMENT_EXPLICIT, TREATMENT_SEMI_IMPLICIT };

/* The drag on a particle during a sub-step, in which k and u_f stand still.
 * frozen:       k (u_f - u_p) of the start, to the end [XS11 3.18].
 * exponential:  k (u_f - u_p) with u_p as it changes, contacts and all
 *               (response.h): no sub-step is too long. */
enum relaxation { RELAXATION_FROZEN, RELAXATION_EXPONENTIAL };

struct coupling_options {
    const struct drag_law *law;
    enum treatment treatment;
    enum relaxation relaxation;
    const struct interpolation *interpolation;
    int substeps; /* [-] drag updates a step; 0: as many as the shortest
                     relaxation time asks for [XS11 section 3.3] */
    int two_way;  /* 0: the fluid does not feel the particles */
};

struct coupling_report {
    int substeps;             /* [-] of the last step */
    double shortest_time;     /* [s] smallest m_i / k_i */
    double exchange_residual; /* [-] |what the fluid paid - what the particles
                                 were charged| over what was paid, summed */
    double eps_lowest;        /* [-] smallest fluid fraction of a cell */
    double seen_lowest;       /* [-] and smallest that a particle sees, which a
                                 slope may make less */
};

struct replacement;

struct coupling {
    struct coupling_options options;
    struct coupling_report report;
    /* One row a particle; all follow the particles when these are sorted. */
    double *u_f;    /* [m/s] fluid velocity, 3 */
    double *eps;    /* [-] fluid fraction */
    double *k;      /* [kg/s] the coefficient that the fluid was charged with */
    double *u_mean; /* [m/s] mean velocity over the sub-steps [XS11 3.20], 3 */
    double *owed;   /* [N s] received and not yet paid by the fluid, 3 */
    /* Work space. */
    double *u_b;    /* [m/s] fluid velocity on the boundary faces, 3 a face;
                       NULL unless the interpolation is linear */
    double *smooth; /* [m/s] adjoint of averaging applied to u, 3 a particle */
    double *amount; /* up to 4 a particle */
    double *field;  /* up to 4 a cell */
    struct replacement *replacement; /* NULL unless particles come or go */
};

struct coupling *coupling_create(struct simulation *sim,
                                 const struct coupling_options *options);
void coupling_free(struct coupling *cp);

/* Averages the initial particles, so that the first step knows them. Non-zero
 * if one is outside the mesh. */
int coupling_start(struct simulation *sim);

/* One step of [XS11 Algorithm 3.1], for any scene: a scene without fluid has
 * no steps 1, 2 and 5, one without particles only step 1. Non-zero if the
 * computation broke down; the reports say how. */
int coupling_step(struct simulation *sim);

/* Particle i has received this impulse [N s] from the fluid, which will pay it
 * in its next step. For effects, while the particles have their turn. */
void coupling_charge(struct simulation *sim, int i, const double impulse[3]);

/* Sum of owed over the particles [N s]. */
void coupling_owed(const struct simulation *sim, double owed[3]);

/* Momentum of fluid and particles less what is owed [N s]: constant in a
 * closed periodic box without gravity, up to fluid->relabelled. */
void coupling_total_momentum(const struct simulation *sim, double total[3]);

#endif
