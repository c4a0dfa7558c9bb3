/* piso.h -- matrices and work space of one step of the flow solver.
 * Chapter "Pressure".
 *
 * The momentum equation of cell P, in newtons:
 *
 *   a_P u_P + sum_N a_N u_N = b_P + (rho eps_nm1 V / dt) u_P^old
 *                             - gamma_P V_P (grad p)_P
 */
#ifndef FLUID_PISO_H
#define FLUID_PISO_H

#include "fluid/fluid.h"
#include "linear/bicgstab.h"
#include "linear/cg.h"
#include "linear/ldu.h"
#include "linear/multigrid.h"
#include "linear/face_loops.h"

struct piso {
    struct ldu *momentum; /* [kg/s] */
    double *diag;         /* [kg/s] a_P */
    double *diag3;        /* [kg/s] a_P and, on slip walls, their stress */
    double *slip, *slip_implicit; /* [kg/s] that stress, and the part of it so
                                     stiff that it must act on the new velocity;
                                     3 a cell, NULL without slip walls */
    int oblique_slip;             /* 1: a slip wall is not normal to an axis */
    double *b;   /* [N] right side but for pressure and storage */
    double *ddt; /* [kg/s] rho eps_nm1 V / dt */
    double
        *old_time_source; /* [N] storage times the velocity before the step */
    double *rhs;          /* [N] */
    double *H;            /* [N] b - sum a_N u_N */
    double *momentum_residual; /* [N] residual carried into the next step */
    double *defect; /* [m^3/s] d(eps V)/dt + sum phi of the convecting flux: the
                       residual of continuity */
    double *jump_owner; /* [Pa] pressure jump by inertia where eps jumps: the
                           parts */
    double *jump_neighbour; /* [Pa] of it in the cells on either side */
    double *owner_weight;   /* [-] weight of the owner in the face velocity */
    double *upwind_bias;    /* [-] upwind bias of that weight; or NULL */
    double *inertia;        /* [N] force of the jumps on each cell, 3 each */
    double *face_pressure_offset,
        *face_pressure_per_flux; /* [Pa], [Pa s/m^3] p_f minus the linear mean:
                                    by drag and inertia, and per m^3/s of flux
                                  */
    double
        *smooth_force;  /* [N/m^3] force of convection and viscosity on a cell
                           without the jumps, 3 each; NULL if no face uses it */
    double *per_force;  /* [1/m^3] 1 / (gamma V) */
    double *resistance; /* [kg/(m^3 s)] 1 / m_P = a_P / (eps gamma V) */
    double
        *boundary_conductance; /* [m^3/(Pa s)] from a cell to a given pressure:
                    row sums of the pressure's matrix, of conductances */
    double *per_flux;          /* [kg/(m^3 s)] storage per superficial flux */
    double *SS, *Sd;           /* [m^2], [m^3] S.S and S.d of the faces */
    double *face_coefficient;  /* [m] S.S / S.d: area over length of the link */
    double *m_face;            /* [m^3 s/kg] mobility of a face */
    double *conductance;       /* [m^3/(Pa s)] m_face S.S / S.d */
    double *explicit_flux; /* [m^3/s] part of the flux that all correctors have
                              in common: by the old flux and the time
                              derivative, and by the inertia of the jumps */
    double *phi_old;       /* [m^3/s] */
    const double *convecting_flux; /* [m^3/s] the flux that convects momentum:
                                      phi_old, or */
    double *convecting_flux_own; /* [m^3/s] a separate one, if the scheme needs
                                    it */
    struct time_weights weights; /* [-] of this step */
    const double *eps_new,
        *eps_old; /* [-] fluid fraction of the mass with velocity u at the end
                     and at the beginning of the step */
    const double *eps_older; /* [-] the same one step earlier, with ddt_older;
                                else NULL */
    double *ddt_older;       /* [kg/s] the part of a two-step scheme, or NULL */
    double *u_known; /* [m/s] u extrapolated to the new time; or NULL: u */
    double *velocity_gradient,
        *u_boundary;    /* [1/s], [m/s] 9 a cell, 3 a boundary face; NULL if no
                           scheme needs more than two cells */
    double *source;     /* [m^3/s] d(eps V)/dt or the solid's flux */
    double *divergence; /* [m^3/s] */
    double scale;    /* [m^3/s] its scale: 2-norm of the sums of |phi| over the
                        faces of each cell */
    int pinned_cell; /* cell whose pressure is fixed, or -1 if there is an
                        outlet */
    struct multigrid *mg;
    struct cg_work *cg;
    struct bicgstab_work *bicgstab;
};

struct piso *piso_create(const struct fluid *fl);
void piso_free(struct piso *ps);

/* gamma: the fluid's share of the pressure gradient, eps in [XS11 2.8], 1 in
 * [XS11 2.4]. */
static inline double piso_gamma(const struct fluid *fl, int c)
{
    return fl->options.pressure_shared ? fl->eps[c] : 1.0;
}

/* 1: eps varies, and the convection scheme damps nothing. */
static inline int piso_nondissipative(const struct fluid *fl)
{
    return fl->options.coupled && !fl->options.convection->damps;
}

/* p_f minus the pressure on the owner's side of face f [Pa], that is the
 * owner's part of the jump; and the jump of p from owner to neighbour.
 * face_jump.c
 */
static inline double piso_jump_above(const struct fluid *fl, int f, int owner)
{
    return fl->piso->jump_owner[f] / piso_gamma(fl, owner);
}

static inline double piso_jump(const struct fluid *fl, int f, int owner,
                               int neighbour)
{
    return piso_jump_above(fl, f, owner) +
           fl->piso->jump_neighbour[f] / piso_gamma(fl, neighbour);
}

/* ddt.c: sets the terms of the previous steps; sets the convecting flux of
 * an outer iteration; stores the terms for the next step. */
void ddt_begin(struct fluid *fl);
void ddt_renew_flux(struct fluid *fl);
void ddt_end(struct fluid *fl);
/* 1 if the step has outer iterations or a two-step scheme: convected mass and
 * flux are then those of the new time, not of the previous step. */
int ddt_uses_new_time(const struct fluid_options *o);

/* boundary_face.c: the velocity at boundary face f as used in the momentum
 * equation.
 */
void boundary_face_velocity(const struct fluid *fl, const struct boundary *b,
                            int f, double u[3]);
/* The present fluxes of the inlets. */
void boundary_face_inlet_fluxes(const struct fluid *fl, double *phi);

/* mean_gradient.c: 1 if the pressure has a mean gradient beside p; adapts it to
 * the prescribed mean flow and adds its contribution to the fluxes. */
int mean_gradient_exists(const struct fluid_options *o);
void mean_gradient_add(struct fluid *fl);

/* deferred_correction.c: 1 if a scheme needs more than the two cells of a face;
 * adds its explicit part to b from the velocities known so far. */
int deferred_correction_exists(const struct fluid *fl);
void deferred_correction_add(struct fluid *fl);

/* momentum.c: fills momentum, diag3, b, storage from the state. */
void momentum_assemble(struct fluid *fl);
/* velocity.c: */
/* Solves for u with the present grad_p. */
struct solve_report velocity_predict(struct fluid *fl);
/* H = b - sum a_N u_N with the present u: velocity_predicted_sum directly after
 * the predictor, from the residual of its solver, velocity_neighbour_sum at any
 * time.
 */
void velocity_predicted_sum(struct fluid *fl);
void velocity_neighbour_sum(struct fluid *fl);
/* u = (H + past - gamma V grad p) / a. */
void velocity_correct(struct fluid *fl);
/* Stores the residual of the momentum equation with the present u and p;
 * returns its largest entry over the largest term of the equation [-]. */
double velocity_residual(struct fluid *fl);

/* pressure.c: mobilities and the matrix; once a step. */
void pressure_assemble(struct fluid *fl);
/* Solves for p with the present H and sets phi. */
struct solve_report pressure_correct(struct fluid *fl);

/* continuity.c: the source of the pressure equation, and the residual of
 * continuity for the present phi over the largest flux through a cell [-]. */
void continuity_source(struct fluid *fl);
double continuity_residual(struct fluid *fl);

/* face_jump.c: jumps of velocity and pressure where eps jumps; once a step. For
 * nondissipative schemes, face_jump_bias_upwind also biases the weights of
 * faces first .. last - 1 upwind. */
void face_jump_update(struct fluid *fl);
void face_jump_bias_upwind(int first, int last, struct fluid *fl);
/* Where gamma changes: computes the smooth force per volume from the present H
 * and u, and adds the fluxes that it drives to phi; adds its contribution to
 * p_face. */
void face_jump_add_gamma_fluxes(struct fluid *fl);
void face_jump_add_gamma_pressures(struct fluid *fl);

/* momentum_balance.c: change of the fluid's momentum from `before` the step to
 * now minus the impulse of the forces, over the sum of their magnitudes [-].
 * relabelled: fl->relabelled before the step. */
double momentum_balance_residual(const struct fluid *fl, const double before[3],
                                 const double relabelled[3]);

/* gradient.c: gradient_begin computes the parts of p_face and grad_p that do
 * not change during a step, gradient_update p_face and grad_p from p, phi and
 * the forces. */
void gradient_begin(struct fluid *fl);
void gradient_update(struct fluid *fl);

#endif
