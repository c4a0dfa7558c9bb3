/* systems.h -- the two linear systems of a step of the fluid, and the stress on
 * its walls.
 */
#ifndef FLUID_SYSTEMS_H
#define FLUID_SYSTEMS_H

#include "fluid/fluid.h"
#include "linear/matrix.h"
#include "linear/solvers.h"

/* --- momentum system ------------------------------------------------------ */

/* The momentum equation of the cells and its solution.
 *
 * The equation of cell P, in newtons:
 *
 *   a_P u_P + sum_N a_N u_N = b_P + (rho eps_nm1 V / dt) u_P^old
 *                             - gamma_P V_P (grad p)_P */

struct momentum_system {
    struct ldu *matrix; /* [kg/s] the a_N */
    double *diag;       /* [kg/s] a_P */
    double *diag3;      /* [kg/s] a_P and, on slip walls, their stress over the
                           velocity, 3 a cell; NULL without slip walls */
    int oblique_slip;   /* 1: a slip wall is not normal to an axis */
    double *b;          /* [N] right-hand side without the pressure and the old
                           velocity */
    double *H;          /* [N] b - sum a_N u_N; the whole right-hand side, while
                           the velocity is predicted */
    double *residual;   /* [N] residual carried into the next step; in the
                           pressure's work, or own_residual */
    double *own_residual; /* NULL: no solver works before the next step */
    double inertia; /* [-] the largest of a cell over the largest term, with
                       the last residual; [N] before it is known */
    double *defect; /* [m^3/s] d(eps V)/dt + sum phi of the convecting
                       flux: the residual of continuity */
    double *owner_weight; /* [-] weight of the owner in the face velocity, until
                             it is predicted; NULL where it is needed for a
                             block of faces only */
    struct bicgstab_work *bicgstab;
};

/* The diagonal, as the matrix expects it. */
static inline const double *momentum_diagonal(const struct momentum_system *m)
{
    return m->diag3 != NULL ? m->diag3 : m->diag;
}

/* systems.c: the residual has memory of its own, for a fluid in which a solver
 * works between it and the next step. */
void systems_own_residual(struct fluid *fl);

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

/* boundary.c: the velocity at boundary face f, face j of its patch, as
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

/* --- pressure system ------------------------------------------------------ */

/* The pressure equation of the cells, the fluxes through faces, and the
 * pressure gradient. Chapter "Pressure".
 *
 *   sum_f conductance_f (p_N - p_P) = the residual of continuity of the fluxes
 *                                     without the pressure   [m^3/s] */

struct pressure_system {
    double *per_force;  /* [1/m^3] 1 / (gamma V) */
    double *resistance; /* [kg/(m^3 s)] 1 / m_P = a_P / (eps gamma V) */
    double *per_flux;   /* [kg/(m^3 s)] time derivative per superficial flux */
    double *boundary_conductance; /* [m^3/(Pa s)] from a cell to a given
                                     pressure: the row sums of the matrix; in
                                     the place of the resistance */
    double *m_face;               /* [m^3 s/kg] mobility of a face */
    double *conductance;          /* [m^3/(Pa s)] m_face S.S / S.d */
    double *explicit_flux; /* [m^3/s] part of the flux that all correctors have
                              in common: by the old flux and the time
                              derivative, and by the inertia of the jumps */
    double *source;     /* [m^3/s] d(eps V)/dt or the solid's flux; NULL: 0 */
    double *divergence; /* [m^3/s] until its solver has begun */
    double *work;       /* what is needed for a while (systems.c) */
    double scale;    /* [m^3/s] its scale: 2-norm of the sums of |phi| over the
                        faces of each cell */
    int pinned_cell; /* cell whose pressure is fixed, or -1 if there is an
                        outlet */
    struct preconditioned matrix;
    struct cg_work *cg;
};

/* The source of cell c [m^3/s]. */
static inline double pressure_source(const struct pressure_system *p, int c)
{
    return p->source != NULL ? p->source[c] : 0.0;
}

/* pressure.c: mobilities and the matrix; after each prediction, whose solver
 * works in the same arrays (systems.c). */
void pressure_assemble(struct fluid *fl);
/* The time derivative of cell c per superficial flux one step before the last,
 * in a two-step scheme [kg/(m^3 s)]. */
double pressure_older_per_flux(const struct fluid *fl, int c);
/* Solves for p with the present H and sets phi. */
struct solve_report pressure_correct(struct fluid *fl);

/* continuity.c: the source of the pressure equation, and the residual of
 * continuity for the present phi over the largest flux through a cell [-]. */
void continuity_source(struct fluid *fl);
double continuity_residual(struct fluid *fl);

/* gradient.c: gradient_begin computes the parts of p_face and grad_p that do
 * not change during a step, gradient_update p_face and grad_p from p, phi and
 * the forces, gradient_of_faces grad_p from p_face alone. */
void gradient_begin(struct fluid *fl);
void gradient_update(struct fluid *fl);
void gradient_of_faces(struct fluid *fl);

/* And there: 1 if the pressure has a mean gradient beside p; adapts it to
 * the prescribed mean flow and adds its contribution to the fluxes. */
int gradient_mean_exists(const struct fluid_options *o);
void gradient_add_mean(struct fluid *fl);

/* --- wall stress ---------------------------------------------------------- */

/* The stress of the fluid on its boundary faces.
 *
 * On a face with the area vector S out of the fluid
 *
 *   F_p = (p + G . x) S,   F_v = mu SS / S.d (u_c - u_w) + mu |S| Omega x n
 *
 * with G the mean gradient of the pressure where there is one. F_v is the
 * viscous force in the momentum equation of the cell, and the term that a
 * rotating wall adds: that equation has mu lap u, which has the same sum over
 * all boundaries as the stress mu (grad u + grad u^T) and another one on each
 * of them. */

struct wall_stress {
    double pressure[3]; /* [N] of the pressure on the face */
    double viscous[3];  /* [N] of viscosity */
    double shear[3];    /* [Pa] F_v / |S| without its normal part */
    double area;        /* [m^2] */
    double y_plus;      /* [-] distance y of the cell's centre from the wall:
                           y sqrt(|shear| / rho) rho / mu */
};

/* Of face j of a patch that is a wall, slip or not. */
struct wall_stress wall_stress(const struct fluid *fl, int patch, int j);

/* 1 if nothing flows through the patch. */
int wall_stress_is_wall(const struct fluid *fl, int patch);

#endif
