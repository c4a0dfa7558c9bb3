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
#include "linear/csr.h"
#include "linear/multigrid.h"

struct piso {
    struct csr *momentum; /* [kg/s] */
    double *diag3;        /* [kg/s] a_P and, on slip walls, their stress */
    double *b;            /* [N] right side but for pressure and storage */
    double *storage;      /* [kg/s] rho eps_start V / dt */
    double *u_old;        /* [m/s] */
    double *rhs;          /* [N] */
    double *H;            /* [N] b - sum a_N u_N */
    double *owed;         /* [N] residual carried into the next step */
    double *defect;       /* [m^3/s] d(eps V)/dt + sum phi of the flux that
                             carries momentum: what continuity lacks */
    double *jump;         /* [Pa] inertia at a face where eps jumps */
    double *share;        /* [-] of the owner in the carried velocity */
    double *inertia;      /* [N] what the jumps put on a cell, 3 each */
    double *mobility;     /* [m^3 s/kg] m_P = eps gamma V / a_P */
    double *drive;        /* [Pa/m] H / (gamma V), 3 a cell */
    struct csr *pressure; /* [m^3/(Pa s)] */
    double *m_face;       /* [m^3 s/kg] mobility of a face */
    double *conductance;  /* [m^3/(Pa s)] m_face S.S / S.d */
    double *phi_old;      /* [m^3/s] */
    double *source;       /* [m^3/s] d(eps V)/dt or the solid's flux */
    double *divergence;   /* [m^3/s] */
    int pinned;           /* cell whose level is fixed, or -1: an outlet */
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

/* momentum.c: fills momentum, diag3, b, storage from the state. */
void momentum_assemble(struct fluid *fl);
/* Solves for u with the present grad_p. */
struct solve_report momentum_predict(struct fluid *fl);
/* H = b - sum a_N u_N with the present u. */
void momentum_neighbours(struct fluid *fl);
/* u = (H + storage u_old - gamma V grad p) / a. */
void momentum_correct(struct fluid *fl);
/* What is left of the equation with the present u and p goes to `owed`;
 * returns its largest entry over the largest term of the equation [-]. */
double momentum_rest(struct fluid *fl);

/* pressure.c: mobilities and the matrix; once a step. */
void pressure_assemble(struct fluid *fl);
/* Solves for p with the present H and sets phi. */
struct solve_report pressure_correct(struct fluid *fl);

/* continuity.c: the source of the pressure equation, and what the present phi
 * leaves of continuity over the largest flux through a cell [-]. */
void continuity_source(struct fluid *fl);
double continuity_residual(struct fluid *fl);

/* jump.c: where eps jumps, so do velocity and pressure; once a step. */
void jump_update(struct fluid *fl);
/* The step of p across face f, owner to neighbour [Pa]. */
double jump_pressure(const struct fluid *fl, int f);
/* By how much p_f lies above the owner's side of the face [Pa]. */
double jump_above_owner(const struct fluid *fl, int f);

/* balance.c: how far the momentum of the fluid, `before` the step and now,
 * changed otherwise than by the forces on it, over the sum of their sizes [-].
 * relabelled: fl->relabelled before the step. */
double balance_residual(const struct fluid *fl, const double before[3],
                        const double relabelled[3]);

/* gradient.c: p_face and grad_p from p, phi and the forces. */
void gradient_update(struct fluid *fl);

#endif
