/* coupling.h -- momentum between fluid and particles.
 * Chapter "The coupled loop".
 *
 * The force of the fluid on particle i is k_i (u_f - u_p), k_i = eps_f B_i =
 * V_p beta / eps_s [XS11 2.9, 2.10]. The impulse on the particles is taken from
 * the fluid. In a step the fluid is solved first, with an estimate of the
 * impulse; the impulse on the particles is known afterwards. Each particle
 * stores the difference, `unpaid_impulse`, which is applied to the fluid in the
 * next step. Therefore at any time
 *
 *   momentum of the fluid + momentum of the particles - sum of unpaid_impulse
 *
 * changes only by what comes from outside.
 *
 * explicit:       estimate 0. The reaction acts on the fluid one step late.
 * semi-implicit:  estimate k_i (u_f^new - mean u_p) dt, with the fluid's new
 *                 velocity: K and F of fluid.h [XS11 3.13-3.15].
 */
#ifndef COUPLING_COUPLING_H
#define COUPLING_COUPLING_H

#include "averaging/interpolation.h"
#include "base/model.h"
#include "coupling/drag.h"
#include "coupling/effect.h"
#include "coupling/simulation.h"

enum treatment { TREATMENT_EXPLICIT, TREATMENT_SEMI_IMPLICIT };

/* Integration of the slip of a particle during a sub-step, in which k and u_f
 * are constant.
 * frozen:       k (u_f - u_p) of the start, to the end [XS11 3.18].
 * exponential:  k (u_f - u_p) with u_p as it changes, contacts and all
 *               (implicit_drag.h): no sub-step is too long. */
enum slip_integration { SLIP_INTEGRATION_FROZEN, SLIP_INTEGRATION_EXPONENTIAL };

/* The choices of a case: of these two; of the form of the fluid's equation,
 * with the value 1 if it contains only the fluid's share of the pressure
 * gradient (A); and of the direction of the coupling, with the value of
 * two_way. Each list is ended by NULL. */
extern const struct model *const coupling_treatments[];
extern const struct model *const coupling_slip_integrations[];
extern const struct model *const coupling_forms[];
extern const struct model *const coupling_directions[];

struct coupling_options {
    const struct drag_law *law;
    const struct drag_shape *shape;
    enum treatment treatment;
    enum slip_integration slip_integration;
    const struct interpolation *interpolation; /* that of the averaging */
    int form_a;                                /* [-] 1: model A, 0: model B */
    int substeps; /* [-] drag updates a step; 0: as many as the shortest
                     relaxation time requires [XS11 section 3.3] */
    int two_way;  /* 0: no force of the particles on the fluid */
};

extern const struct key coupling_keys[]; /* of the group `exchange` */

struct coupling_report {
    int substeps;             /* [-] of the last step */
    double shortest_time;     /* [s] smallest m_i / k_i */
    double exchange_residual; /* [-] |impulse on the fluid - that expected from
                                 the particles| over the sum of the sizes of
                                 the latter: rounding, or as the tolerance of
                                 an implicit diffusion */
    double eps_lowest;        /* [-] smallest fluid fraction of a cell */
    double lowest_interpolated; /* [-] and smallest value at a particle, which
                                   linear interpolation may make smaller */
};

/* The exchange of removed particles that is still to act (population/). */
struct replacement {
    double *unpaid_impulse; /* [N s/m^3] that has not acted on the fluid yet, 3
                               a cell */
    double unpaid_sum[3];   /* [N s] its integral; 0 after it has acted */
    double *eps_before;     /* [-] fluid fraction before they were removed */
};

struct coupling {
    struct coupling_options options;
    struct coupling_report report;
    struct drag_law law; /* that of the options, copied */
    /* One row a particle; all follow the particles when these are sorted. */
    double *u_f;    /* [m/s] fluid velocity, 3 */
    double *eps;    /* [-] fluid fraction */
    double *k;      /* [kg/s] the coefficient in the fluid's last step */
    double *u_mean; /* [m/s] mean velocity over the sub-steps [XS11 3.20], 3 */
    double *unpaid_impulse; /* [N s] impulse on the particle whose reaction has
                               not acted on the fluid yet, 3 */
    /* Set by effect_force_inertia (effects/); NULL if no effect has called it.
     */
    double *inertia;  /* [kg] */
    double *u_before; /* [m/s] fluid velocity when it was called, 3 */
    /* Work space. */
    double *u_b;    /* [m/s] fluid velocity on the boundary faces, 3 a face;
                       NULL unless the interpolation is linear */
    double *smooth; /* [m/s] adjoint of averaging applied to u, 3 a particle */
    double *amount; /* up to 4 a particle */
    double *rate;   /* [kg/s] k at the end of the step */
    double *field;  /* up to 4 a cell */
    struct replacement *replacement; /* NULL: none was removed or inserted */
};

struct coupling *coupling_create(struct simulation *sim,
                                 const struct coupling_options *options);

/* Averages the initial particles for the first step. Non-zero if one is outside
 * the mesh, or if a cell is full. */
int coupling_start(struct simulation *sim);

/* One step of [XS11 Algorithm 3.1], for any case: a case without fluid has no
 * steps 1, 2 and 5, one without particles only step 1. Non-zero if the
 * computation broke down; the reports say how. */
int coupling_step(struct simulation *sim);

/* Frozen drag updates [-] of a step that lasts x of the shortest relaxation
 * time [XS11 section 3.3]; from that half on at least two. */
double coupling_needed_substeps(double x);

/* Visits what coupling, insertion and removal keep from step to step besides
 * the particles (state.h). */
void coupling_state(struct simulation *sim, struct state *s);

/* Adds an impulse [N s] of the fluid on particle i, whose reaction acts on the
 * fluid in its next step. For effects, while the particles are advanced. */
void coupling_add_impulse(struct simulation *sim, int i,
                          const double impulse[3]);

/* The slip u_f - v of particle i at this moment [m/s]. */
void coupling_slip(const struct simulation *sim, int i, double w[3]);

/* Sum of unpaid_impulse over the particles [N s]. */
void coupling_unpaid_impulse(const struct simulation *sim, double unpaid[3]);

/* Momentum of fluid and particles minus the unpaid impulse [N s]: constant in a
 * closed periodic box without gravity, up to fluid->relabelled. */
void coupling_total_momentum(const struct simulation *sim, double total[3]);

/* --- stability ------------------------------------------------------------ */

/* Limits of a coupled step besides those of the particles.
 *
 * Chapter "Which treatment is stable".
 *
 * The drag on a bed that moves as a whole is 1/eps_f^2 times that on one
 * particle in it, because the fluid is frozen while the particles move:
 *
 *   dt < 2 eps_f^2 tau_p                                             (20.6)
 *
 * The fluid flows back between the particles one step after they have moved.
 * With r = rho_s/rho_f and q = eps_s/eps_f, an acceleration of the bed is
 * multiplied in each step by a root L of
 *
 *   (r + C) L^2 + q (1 + 2 C + s q C) L + (1 - s) q^2 C = 0         (20.10)
 *
 * where C is the added mass and s the share of its reaction that the fluid
 * receives in the same step. */

/* The longest step [s] of the fluid above a packed bed of which eps_f [-] is
 * fluid, and whose particles relax within tau_p [s]. */
double stability_longest_step(double eps_f, double tau_p);

/* The longest step over tau_p [-] of a suspension with frozen drag, one update
 * a step, and semi-implicit treatment: 2 for M = 0, 1/2 for the heaviest. */
double stability_frozen_limit(double M);

/* Mass of the particles over that of the fluid in the same volume, M [-]. */
double stability_loading(double rho_s, double eps_s, double rho_f);

/* The factor [-], without its sign, by which an acceleration of a bed is
 * multiplied in a step: of a bed that is free (20.10), (20.12), or of the fluid
 * in a bed at rest (20.13). From 1 on it grows. `implicit`: the treatment of
 * the drag is semi-implicit, which charges the fluid in advance. */
double stability_amplification(const struct added_mass *added, double ratio,
                               double eps_s, int implicit);

/* The solid fraction [-] at which that is 1. */
double stability_max_solid_fraction(const struct added_mass *added,
                                    double ratio, int implicit);

#endif
