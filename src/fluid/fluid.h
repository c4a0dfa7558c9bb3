/* fluid.h -- the locally averaged Navier-Stokes equations.  Chapter 5.
 *
 *   d(eps rho u)/dt + div(eps rho u u) = -gamma grad p + mu lap u + F - K u
 *
 * with eps the fluid fraction and one of the two forms of continuity
 *
 *   d eps/dt + div(eps u) = 0             void-rate  [XS11 2.3]
 *   div(eps u + eps_s u_s) = 0            mixture    [XS11 2.7, SX15 2a]
 *
 * p is the pressure without its hydrostatic part: gravity then cancels from
 * the momentum equation. F [N/m^3] and K [kg/(m^3 s)] are what the particles
 * do to the fluid; in [XS11 3.14] F = eps rho A and K = eps rho Omega. gamma
 * is eps where the particles take their share -V_p grad p of the pressure
 * gradient (model A, [XS11 2.8]), else 1 (all of it stays with the fluid,
 * [XS11 2.4] with [2.5] left to F). The viscous stress stays with the fluid.
 *
 * The unknowns live in the cells; phi, the volume of fluid through each face
 * per second, is a state of its own and meets continuity to solver tolerance.
 * In a periodic direction the pressure may have a mean gradient beside p.
 */
#ifndef FLUID_H
#define FLUID_H

#include "fluid/boundary.h"
#include "fluid/convection.h"
#include "fluid/slope.h"
#include "fluid/time_scheme.h"
#include "linear/report.h"
#include "mesh/mesh.h"

enum continuity { CONTINUITY_MIXTURE, CONTINUITY_VOID_RATE };

struct fluid_options {
    double rho;                     /* [kg/m^3] */
    double mu;                      /* [Pa s] */
    double dt;                      /* [s] may change from step to step */
    const struct time_scheme *time; /* NULL: euler */
    const struct convection_scheme *convection;
    double blend; /* [-] of linear, in the scheme `blended` */
    const struct slope_scheme *slope; /* of u, where a face asks for it; NULL:
                                         gauss */
    enum continuity continuity;
    int correctors;      /* [-] pressure corrections a step, at least */
    double enough;       /* [-] all but the last of them are solved until this
                            share of their residual is left; 0: all alike */
    double splitting;    /* [-] more are made while report.splitting is above;
                            0: none */
    int repeats;         /* [-] times that a step is done again with what it
                            found: outer iterations after the first */
    double tolerance;    /* [-] residuals, relative */
    double predictor;    /* [-] the same of the predicted velocity, which the
                            corrections change; 0: the same */
    double cfl;          /* [-] largest Courant number of fluid_advance; 0:
                            any */
    int coupled;         /* 1: there are particles, F and K exist */
    int pressure_shared; /* 1: gamma = eps */
    const struct boundary *boundaries; /* one a patch of the mesh, borrowed */
    double mean_gradient[3]; /* [Pa/m] of the pressure, beside that of p */
    int keeps_flow[3]; /* 1: the mean gradient in this direction adapts, for */
    double mean_flow[3]; /* [m/s] this superficial velocity on average */
};

/* How well the last step was solved. */
struct fluid_report {
    struct solve_report momentum, pressure; /* the worst of the step */
    double mass_residual;     /* [-] largest defect of continuity in a cell,
                                 from the face fluxes, over the largest flux
                                 through a cell */
    double momentum_residual; /* [-] change of the fluid's momentum that no
                                 force accounts for, over the sum of their
                                 sizes: from faces and particles */
    double splitting;         /* [-] what the last corrector left of the
                                 momentum equation, over its largest term;
                                 carried into the next step, not lost */
    double cfl;               /* [-] largest dt (sum |phi|) / (2 eps V) */
    int correctors;           /* [-] made in the last step */
    int backflow_faces;       /* [-] outlet faces with flow inward */
    int parts;                /* [-] steps that fluid_advance took */
};

struct fluid {
    const struct mesh *mesh;
    struct fluid_options options;
    double t;          /* [s] */
    double *u;         /* [m/s] interstitial velocity, 3 a cell */
    double *p;         /* [Pa] without the hydrostatic part */
    double *p_face;    /* [Pa] at the faces */
    double *grad_p;    /* [Pa/m] 3 a cell */
    double *phi;       /* [m^3/s] superficial flux, owner to neighbour */
    double *eps;       /* [-] fluid fraction now; the coupling writes it */
    double *eps_phi;   /* [-] fluid fraction at the end of phi's step */
    double *eps_start; /* [-] ... and at its start: the mass that u carries */
    double mean_gradient[3]; /* [Pa/m] now; a part of grad_p */
    double *F;               /* [N/m^3] explicit force on the fluid, 3 a cell */
    double *K;               /* [kg/(m^3 s)] implicit friction */
    double *eps_us;          /* [m/s] eps_s u_s, 3 a cell */
    double dt_older;         /* [s] the step before, 0 before the first */
    /* What a scheme that looks at two steps keeps of the one before the last,
     * else NULL; and what the momentum has in advance of the forces. */
    double *u_older, *phi_older; /* [m/s], [m^3/s] */
    double gained[3], ahead[3];  /* [N s] */
    double relabelled[3]; /* [N s] momentum that averaging moved between cells
                             by itself: see fluid_momentum */
    double replaced; /* [kg] mass of the fluid that made room for particles,
                        less what took the place of particles: fluid_replace */
    double replaced_momentum[3]; /* [N s] and its momentum */
    struct fluid_report report;
    struct piso *piso; /* matrices and work space */
};

/* At rest, p = 0, eps = 1. F, K and eps_us exist only when coupled. */
struct fluid *fluid_create(const struct mesh *mesh,
                           const struct fluid_options *options);
void fluid_free(struct fluid *fl);

/* Takes the present eps for the past as well: after the first averaging. */
void fluid_settle_eps(struct fluid *fl);

/* Particles were put into the fluid or taken out of it at rest: eps has changed
 * from eps_before by that alone. They and the fluid replace each other on the
 * spot, so that nothing flows: the eps of the past change as well, and the
 * fluid that made room leaves with its velocity. Returns the lowest eps of the
 * past
 * [-]: not above 0 if more solids came than there was fluid. */
double fluid_replace(struct fluid *fl, const double *eps_before);

/* One step of dt by PISO. Non-zero if a solver failed or a value is no longer
 * finite; the report says which. */
int fluid_step(struct fluid *fl);

/* Goes on by dt [s], in one step or, where the Courant number would be above
 * options.cfl, in as many as it asks for. */
int fluid_advance(struct fluid *fl, double dt);

/* Momentum of the fluid [N s], with what the last step left unsolved and so
 * still owes. With the void-rate form it changes only by forces and boundary
 * fluxes; with the mixture form also by `relabelled`. (BDF2 spreads an impulse
 * over several steps; what it has still to give is counted in.) */
void fluid_momentum(const struct fluid *fl, double momentum[3]);

/* Mean superficial velocity [m/s], over all of the mesh. */
void fluid_mean_flow(const struct fluid *fl, double flow[3]);

/* Kinetic energy of the fluid [J]. */
double fluid_kinetic_energy(const struct fluid *fl);

/* Mean pressure over a patch [Pa]. */
double fluid_patch_pressure(const struct fluid *fl, const struct patch *patch);

/* The velocity [m/s] on the boundary faces, u_b[3 * (f - n_internal) + k]: that
 * of a no-slip wall, of an inlet's flux, what slides along a slip wall; at an
 * outlet that of the cell. */
void fluid_boundary_velocity(const struct fluid *fl, double *u_b);

#endif
