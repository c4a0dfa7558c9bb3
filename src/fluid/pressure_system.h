/* pressure_system.h -- the pressure equation of the cells, the fluxes through
 * faces, and the pressure gradient. Chapter "Pressure".
 *
 *   sum_f conductance_f (p_N - p_P) = the residual of continuity of the fluxes
 *                                     without the pressure   [m^3/s]
 */
#ifndef FLUID_PRESSURE_SYSTEM_H
#define FLUID_PRESSURE_SYSTEM_H

#include "fluid/fluid.h"
#include "linear/cg.h"
#include "linear/preconditioned.h"

struct pressure_system {
    double *per_force;  /* [1/m^3] 1 / (gamma V) */
    double *resistance; /* [kg/(m^3 s)] 1 / m_P = a_P / (eps gamma V) */
    double *per_flux;   /* [kg/(m^3 s)] time derivative per superficial flux */
    double *boundary_conductance; /* [m^3/(Pa s)] from a cell to a given
                                     pressure: the row sums of the matrix */
    double *m_face;               /* [m^3 s/kg] mobility of a face */
    double *conductance;          /* [m^3/(Pa s)] m_face S.S / S.d */
    double *explicit_flux; /* [m^3/s] part of the flux that all correctors have
                              in common: by the old flux and the time
                              derivative, and by the inertia of the jumps */
    double *source;        /* [m^3/s] d(eps V)/dt or the solid's flux */
    double *divergence;    /* [m^3/s] */
    double scale;    /* [m^3/s] its scale: 2-norm of the sums of |phi| over the
                        faces of each cell */
    int pinned_cell; /* cell whose pressure is fixed, or -1 if there is an
                        outlet */
    struct preconditioned matrix;
    struct cg_work *cg;
};

/* pressure.c: mobilities and the matrix; once a step. */
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

#endif
