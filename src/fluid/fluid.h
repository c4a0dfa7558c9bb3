/* fluid.h -- the locally averaged Navier-Stokes equations.
 * Chapter "Averaged flow".
 *
 *   d(eps rho u)/dt + div(eps rho u u) = -gamma grad p + mu lap u + F - K u
 *
 * with eps the fluid fraction and one of the two forms of continuity
 *
 *   d eps/dt + div(eps u) = 0             void-rate  [XS11 2.3]
 *   div(eps u + eps_s u_s) = 0            mixture    [XS11 2.7, SX15 2a]
 *
 * p is the pressure without its hydrostatic part: gravity then cancels from the
 * momentum equation. F [N/m^3] and K [kg/(m^3 s)] are the explicit and implicit
 * part of the force of the particles on the fluid; in [XS11 3.14] F = eps rho A
 * and K = eps rho Omega. gamma is eps where the force -V_p grad p acts on the
 * particles (model A, [XS11 2.8]), else 1 (the whole gradient acts on the
 * fluid, [XS11 2.4] with [2.5] in F). The viscous stress stays with the fluid.
 *
 * The unknowns are stored at the cell centres (collocated); phi, the volume of
 * fluid through each face per second, is a separate unknown and satisfies
 * continuity to solver tolerance. In a periodic direction the pressure may have
 * a mean gradient in addition to p.
 */
#ifndef FLUID_FLUID_H
#define FLUID_FLUID_H

#include "base/model.h"
#include "base/state.h"
#include "fluid/boundary.h"
#include "fluid/schemes.h"
#include "fluid/hooks.h"
#include "linear/solvers.h"
#include "mesh/mesh.h"

enum continuity { CONTINUITY_MIXTURE, CONTINUITY_VOID_RATE };
extern const struct model fluid_continuity_mixture, fluid_continuity_void_rate;
extern const struct model *const fluid_continuity_forms[]; /* ended by NULL */

extern const struct key fluid_keys[];

struct fluid_options {
    double rho;                     /* [kg/m^3] */
    double mu;                      /* [Pa s] */
    double dt;                      /* [s] may change from step to step */
    const struct time_scheme *time; /* NULL: euler */
    const struct convection_scheme *convection;
    double blend; /* [-] of linear, in the scheme `blended` */
    /* of u, where a scheme needs it; NULL: by-mesh */
    const struct velocity_gradient_scheme *velocity_gradient;
    enum continuity continuity;
    int correctors;              /* [-] pressure corrections a step, at least */
    double p_relative_tolerance; /* [-] residual reduction of all pressure
                                    corrections but the last; 0: all have the
                                    same tolerance */
    double piso_tolerance; /* [-] more corrections follow while the residual of
                              the splitting exceeds this; 0: none */
    int outer_correctors;  /* [-] outer iterations after the first */
    double tolerance;      /* [-] residuals, relative */
    double u_tolerance;    /* [-] of the momentum predictor; 0: the same */
    double cfl;      /* [-] largest Courant number of fluid_advance; 0: any */
    int coupled;     /* 1: with particles; F and K exist */
    int undisturbed; /* 1: no particle and no body will act on the fluid */
    int pressure_shared;               /* 1: gamma = eps */
    const struct boundary *boundaries; /* one a patch of the mesh, borrowed */
    double mean_gradient[3]; /* [Pa/m] of the pressure, beside that of p */
    /* In a direction where keeps_flow is 1 the mean gradient is adapted, so
     * that the mean superficial velocity remains mean_flow [m/s]. */
    int keeps_flow[3];
    double mean_flow[3];
    int has_mean_gradient, has_mean_flow; /* [-] 1: the case gives it */
    const struct shared_solution *shared; /* of one part of a mesh; NULL */
};

/* Residuals of the last step. */
struct fluid_report {
    struct solve_report momentum, pressure; /* the worst of the step */
    double mass_residual;     /* [-] largest defect of continuity in a cell,
                                 from the face fluxes, over the largest flux
                                 through a cell */
    double momentum_residual; /* [-] change of the fluid's momentum minus the
                                 impulse of all forces (faces, particles), over
                                 the sum of their magnitudes */
    double piso_residual;     /* [-] residual of the momentum equation after the
                                 last corrector, over its largest term; it is added
                                 to the next step */
    double cfl;               /* [-] largest dt (sum |phi|) / (2 eps V) */
    int correctors;           /* [-] made in the last step */
    int backflow_faces;       /* [-] outlet faces with flow inward */
    int flow_substeps;        /* [-] steps that fluid_advance took */
};

struct fluid {
    const struct mesh *mesh;
    struct fluid_options options;
    struct faces *faces; /* of the mesh, for loops over them, without those at
                            the end that do nothing (systems.c) */
    double t;            /* [s] */
    double *u;           /* [m/s] interstitial velocity, 3 a cell */
    double *p;           /* [Pa] without the hydrostatic part */
    double *p_face;      /* [Pa] at the boundary faces; at the others until
                            grad_p is known (systems.c) */
    double *grad_p;      /* [Pa/m] 3 a cell */
    double *phi;         /* [m^3/s] superficial flux, owner to neighbour */
    /* The fluid fraction [-] at the new time, which the coupling writes, at the
     * end of the last step and at its start; without particles one array. */
    double *eps, *eps_n, *eps_nm1;
    double mean_gradient[3]; /* [Pa/m] now; a part of grad_p */
    double *F;               /* [N/m^3] explicit force on the fluid, 3 a cell */
    double *K;               /* [kg/(m^3 s)] implicit friction */
    double *eps_us;          /* [m/s] eps_s u_s, 3 a cell */
    double dt_older;         /* [s] the step before, 0 before the first */
    /* In two-step schemes: the values one step before the last, else NULL; and
     * what the fluid gained in the last step. */
    double *u_older, *phi_older; /* [m/s], [m^3/s] */
    double momentum_gained[3];   /* [N s] */
    /* Of an impulse of 1 in the last step, what the fluid gains in all [-]: 1,
     * but for the first step of BDF2 (ddt.c). */
    double impulse_weight;
    double relabelled[3]; /* [N s] momentum that averaging moved between cells
                             by itself: see fluid_momentum */
    /* The mass [kg] of the fluid that inserted particles displaced, minus that
     * which took the place of removed ones; and its momentum [N s]. */
    double replaced, replaced_momentum[3];
    struct fluid_report report;
    struct momentum_system *momentum; /* matrices and work space */
    struct pressure_system *pressure;
    struct face_jump *jump;
    struct time_levels *levels;
    struct face_geometry *geometry;
    struct deferred *deferred; /* explicit terms of gradients; NULL: none */
    struct immersed *immersed; /* bodies that hold the fluid; NULL: none */
};

/* At rest, p = 0, eps = 1. F, K and eps_us exist only when coupled. */
struct fluid *fluid_create(const struct mesh *mesh,
                           const struct fluid_options *options);

/* All that the next step depends on (state.h). */
void fluid_state(struct fluid *fl, struct state *s);

/* Sets the old values of eps to the present one; called after the first
 * averaging. */
void fluid_reset_eps_history(struct fluid *fl);

/* One step of dt by PISO. Non-zero if a solver failed or a value is no longer
 * finite; the report says which. */
int fluid_step(struct fluid *fl);

/* Advances by dt [s], in one step or, where the Courant number would exceed
 * options.cfl, in several equal steps. */
int fluid_advance(struct fluid *fl, double dt);

/* Momentum of the fluid [N s], including the residual of the last step, which
 * is added to the next one. It changes by forces, boundary fluxes and
 * `relabelled`: rho dt sum u (d(eps V)/dt + sum phi), with the masses and the
 * flux that the momentum equation uses. In the void-rate form `relabelled` is
 * zero to solver tolerance if these are of the same step: with outer iterations
 * always, without them for implicit Euler at a constant step. Where the step
 * changes, the flux of the last step does not bring the mass of this one; and
 * the flux that BDF2 extrapolates does not follow a change of eps that varies
 * from step to step. (BDF2 distributes an impulse over several steps; the part
 * still to come is included.) */
void fluid_momentum(const struct fluid *fl, double momentum[3]);

/* Mean superficial velocity [m/s], over all of the mesh. */
void fluid_mean_flow(const struct fluid *fl, double flow[3]);

/* Kinetic energy of the fluid [J]. */
double fluid_kinetic_energy(const struct fluid *fl);

/* The pressure on boundary face f [Pa]. */
double fluid_boundary_pressure(const struct fluid *fl, int f);

/* Mean pressure over a patch [Pa]. */
double fluid_patch_pressure(const struct fluid *fl, const struct patch *patch);

/* The mean superficial velocity of the first inlet, now [m/s]; 0 without. */
double fluid_inlet_velocity(const struct fluid *fl);

/* The velocity [m/s] on the boundary faces, u_b[3 * (f - n_internal) + k]: that
 * of a no-slip wall, that of an inlet's flux, the tangential velocity of the
 * cell at a slip wall, and at an outlet the velocity of the cell. */
void fluid_boundary_velocity(const struct fluid *fl, double *u_b);

#endif
