/* momentum_system.h -- the momentum equation of the cells and its solution.
 * Chapter "Averaged flow".
 *
 * The equation of cell P, in newtons:
 *
 *   a_P u_P + sum_N a_N u_N = b_P + (rho eps_nm1 V / dt) u_P^old
 *                             - gamma_P V_P (grad p)_P
 */
#ifndef FLUID_MOMENTUM_SYSTEM_H
#define FLUID_MOMENTUM_SYSTEM_H

#include "fluid/fluid.h"
#include "linear/bicgstab.h"
#include "linear/ldu.h"

struct momentum_system {
    struct ldu *matrix; /* [kg/s] the a_N */
    double *diag;       /* [kg/s] a_P */
    double *diag3;      /* [kg/s] a_P and, on slip walls, their stress */
    /* That stress over the velocity, 3 a cell, and the part of it that is
     * implicit in the corrector because it is stiff [kg/s]; NULL without slip
     * walls. */
    double *slip, *slip_implicit;
    int oblique_slip; /* 1: a slip wall is not normal to an axis */
    double *b;        /* [N] right-hand side without the pressure and the old
                         velocity */
    double *rhs;      /* [N] the whole right-hand side of the predictor */
    double *H;        /* [N] b - sum a_N u_N */
    double *residual; /* [N] residual carried into the next step */
    double inertia;   /* [-] the largest of a cell over the largest term, with
                         the last residual; [N] before it is known */
    double *defect;   /* [m^3/s] d(eps V)/dt + sum phi of the convecting
                         flux: the residual of continuity */
    double *owner_weight; /* [-] weight of the owner in the face velocity */
    struct bicgstab_work *bicgstab;
};

/* momentum.c: fills the matrix, diag3 and b from the state. */
void momentum_assemble(struct fluid *fl);

/* velocity.c: solves for u with the present grad_p. */
struct solve_report velocity_predict(struct fluid *fl);
/* H = b - sum a_N u_N with the present u: velocity_predicted_sum directly after
 * the predictor, from the residual of its solver, velocity_neighbour_sum at any
 * time. */
void velocity_predicted_sum(struct fluid *fl);
void velocity_neighbour_sum(struct fluid *fl);
/* u = (H + old_time_source - gamma V grad p) / a. */
void velocity_correct(struct fluid *fl);
/* Stores the residual of the momentum equation with the present u and p;
 * returns its largest entry over the largest term of the equation [-]. */
double velocity_residual(struct fluid *fl);

/* boundary_velocity.c: the velocity at boundary face f, face j of its patch, as
 * used in the momentum equation; the present fluxes of the inlets. */
void boundary_face_velocity(const struct fluid *fl, const struct boundary *b,
                            int j, int f, double u[3]);
void boundary_face_inlet_fluxes(const struct fluid *fl, double *phi);

/* momentum_balance.c: what convection and viscosity bring through all boundary
 * faces in a step with the present velocity [N s], without the pressure. */
void momentum_balance_of_boundaries(const struct fluid *fl, double impulse[3]);
/* Change of the fluid's momentum from `before` the step to
 * now minus the impulse of the forces, over the sum of their magnitudes [-].
 * relabelled: fl->relabelled before the step. */
double momentum_balance_residual(const struct fluid *fl, const double before[3],
                                 const double relabelled[3]);

#endif
