/* piso.h -- what one step of the flow solver works with.  Chapter 6.
 *
 * The momentum equation of cell P, in newtons:
 *
 *   a_P u_P + sum_N a_N u_N = b_P + (rho eps_start V / dt) u_P^old
 *                             - gamma_P V_P (grad p)_P
 */
#ifndef PISO_H
#define PISO_H

#include "fluid/fluid.h"
#include "linear/bicgstab.h"
#include "linear/cg.h"
#include "linear/ldu.h"
#include "linear/multigrid.h"
#include "linear/runs.h"
#include "linear/strips.h"

struct piso {
    struct runs *runs;    /* of the mesh's faces; NULL: go by lists */
    struct ldu *momentum; /* [kg/s] */
    double *diag;         /* [kg/s] a_P */
    double *diag3;        /* [kg/s] a_P and, on slip walls, their stress */
    double *slip, *held;  /* [kg/s] that stress, and where it is so stiff that
                             the new velocity must bear it; 3 a cell, NULL
                             without slip walls */
    int oblique_slip;     /* 1: a slip wall is not normal to an axis */
    double *b;            /* [N] right side but for pressure and storage */
    double *storage;      /* [kg/s] rho eps_start V / dt */
    double *past;         /* [N] storage times the velocity before the step */
    double *rhs;          /* [N] */
    double *H;            /* [N] b - sum a_N u_N */
    double *owed;         /* [N] residual carried into the next step */
    double *defect;       /* [m^3/s] d(eps V)/dt + sum phi of the flux that
                             carries momentum: what continuity lacks */
    double *jump_owner;   /* [Pa] inertia at a face where eps jumps: what the */
    double *jump_neighbour; /* [Pa] cells on either side have of it */
    double *share;          /* [-] of the owner in the carried velocity */
    double *upstream;       /* [-] by how much it leans upstream; or NULL */
    double *inertia;        /* [N] what the jumps put on a cell, 3 each */
    double *bend, *lean;    /* [Pa], [Pa s/m^3] p_f beside the linear mean: by
                               drag and inertia, and for each m^3/s */
    double *rest;        /* [N/m^3] what convection and viscosity do to a cell
                            beside that, 3 each; or NULL: no face asks */
    double *per_force;   /* [1/m^3] 1 / (gamma V) */
    double *resistance;  /* [kg/(m^3 s)] 1 / m_P = a_P / (eps gamma V) */
    double *ground;      /* [m^3/(Pa s)] from a cell to a given pressure: row
                            sums of the pressure's matrix, of conductances */
    double *per_flux;    /* [kg/(m^3 s)] storage per superficial flux */
    double *SS, *Sd;     /* [m^2], [m^3] S.S and S.d of the faces */
    double *link;        /* [m] S.S / S.d: area over length of the link */
    double *m_face;      /* [m^3 s/kg] mobility of a face */
    double *conductance; /* [m^3/(Pa s)] m_face S.S / S.d */
    double *kept;        /* [m^3/s] what all correctors share: of the flux
                            before, by storage; by the jumps' inertia */
    double *phi_old;     /* [m^3/s] */
    const double
        *carry;        /* [m^3/s] the flux that carries momentum: phi_old, or */
    double *carry_own; /* [m^3/s] one of its own, if step or scheme ask */
    struct time_weights weights; /* [-] of this step */
    const double *eps_new,
        *eps_old;            /* [-] of the mass that u has at the end and
                                the beginning of the step; and before */
    const double *eps_older; /* [-] that, with storage_older; else NULL */
    double *storage_older;  /* [kg/s] what looking at two steps adds, or NULL */
    double *u_known;        /* [m/s] u continued to the new time; or NULL: u */
    double *slope, *u_edge; /* [1/s], [m/s] 9 a cell, 3 a boundary face; NULL
                               if nothing looks beyond two cells */
    double *source;         /* [m^3/s] d(eps V)/dt or the solid's flux */
    double *divergence;     /* [m^3/s] */
    double scale;           /* [m^3/s] of it: 2-norm of what meets in a cell */
    int pinned;             /* cell whose level is fixed, or -1: an outlet */
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
static inline int piso_rings(const struct fluid *fl)
{
    return fl->options.coupled && !fl->options.convection->damps;
}

/* By how much p_f lies above the owner's side of face f [Pa]: its part of the
 * inertia there; and the step of p from owner to neighbour. jump.c */
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

/* storage.c: what the step inherits from those before it; what carries momentum
 * in a repetition; and what the step leaves to the next. */
void storage_begin(struct fluid *fl);
void storage_renew(struct fluid *fl);
void storage_end(struct fluid *fl);
/* 1 if a step repeats or looks at two steps: mass and flux that carry momentum
 * are then those of the new time, not of the step before. */
int storage_is_new(const struct fluid_options *o);

/* edge.c: the velocity at boundary face f, as the momentum equation takes it.
 */
void edge_velocity(const struct fluid *fl, const struct boundary *b, int f,
                   double u[3]);
/* The present fluxes of the inlets. */
void edge_inlet_fluxes(const struct fluid *fl, double *phi);

/* mean_gradient.c: 1 if the pressure has a mean gradient beside p; what it does
 * to the fluxes, after it has been adapted to the flow that is to be kept. */
int mean_gradient_exists(const struct fluid_options *o);
void mean_gradient_add(struct fluid *fl);

/* deferred.c: 1 if something looks beyond the two cells of a face; adds it to
 * b from the velocities known so far. */
int deferred_exists(const struct fluid *fl);
void deferred_add(struct fluid *fl);

/* momentum.c: fills momentum, diag3, b, storage from the state. */
void momentum_assemble(struct fluid *fl);
/* velocity.c: */
/* Solves for u with the present grad_p. */
struct solve_report velocity_predict(struct fluid *fl);
/* H = b - sum a_N u_N with the present u: at once after the prediction, whose
 * solver knows the sum, and at any time. */
void velocity_predicted(struct fluid *fl);
void velocity_neighbours(struct fluid *fl);
/* u = (H + past - gamma V grad p) / a. */
void velocity_correct(struct fluid *fl);
/* What is left of the equation with the present u and p goes to `owed`;
 * returns its largest entry over the largest term of the equation [-]. */
double velocity_rest(struct fluid *fl);

/* pressure.c: mobilities and the matrix; once a step. */
void pressure_assemble(struct fluid *fl);
/* Solves for p with the present H and sets phi. */
struct solve_report pressure_correct(struct fluid *fl);

/* continuity.c: the source of the pressure equation, and what the present phi
 * leaves of continuity over the largest flux through a cell [-]. */
void continuity_source(struct fluid *fl);
double continuity_residual(struct fluid *fl);

/* jump.c: where eps jumps, so do velocity and pressure; once a step. Of a
 * scheme that rings, also the shares of a stretch of faces. */
void jump_update(struct fluid *fl);
void jump_lean(int first, int last, struct fluid *fl);
/* Fills `rest` from the present H and u. What it adds to p_N - p_O across face
 * f where gamma changes, and to p_f [Pa]. */
void jump_rest(struct fluid *fl);
double jump_of_rest(const struct fluid *fl, int f);
double jump_rest_at_face(const struct fluid *fl, int f);

/* balance.c: how far the momentum of the fluid, `before` the step and now,
 * changed otherwise than by the forces on it, over the sum of their sizes [-].
 * relabelled: fl->relabelled before the step. */
double balance_residual(const struct fluid *fl, const double before[3],
                        const double relabelled[3]);

/* gradient.c: p_face and grad_p from p, phi and the forces; what they make of
 * these at all times of a step, once. */
void gradient_begin(struct fluid *fl);
void gradient_update(struct fluid *fl);

#endif
