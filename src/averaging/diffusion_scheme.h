/* diffusion_scheme.h -- the descriptor of a time scheme of the diffusion.
 * Chapter "Averaging".
 */
#ifndef AVERAGING_DIFFUSION_SCHEME_H
#define AVERAGING_DIFFUSION_SCHEME_H

#include "base/model.h"
#include "mesh/mesh.h"

struct averaging_options;
struct averaging_report;
struct diffusion_scheme;

/* How a scheme takes its steps in pseudo-time (schemes/diffusion_steps.h). fill
 * sets the matrices for D on the internal faces [-], NULL for 1; apply diffuses
 * m fields side by side and reports the work of the solver. */
struct diffusion_stepping {
    void *(*create)(const struct diffusion_scheme *scheme,
                    const struct mesh *mesh, const struct averaging_options *o);
    void (*free)(void *state);
    void (*fill)(void *state, const double *D);
    void (*apply)(void *state, int m, double *u, struct averaging_report *r);
    /* The number of steps [-] from which on no field undershoots for the
     * bandwidth b [m]; NULL: any number. */
    int (*safe_steps)(const struct mesh *mesh, double b);
};

/* A time scheme of the diffusion. */
struct diffusion_scheme {
    MODEL_MEMBERS;                             /* base/model.h */
    const struct diffusion_stepping *stepping; /* NULL: the exponential */
    int directly;    /* [-] 1: applied direction by direction where possible */
    int stages;      /* [-] linear systems in a step */
    double implicit; /* [-] share of dtau K in the matrix of a stage */
};

/* All of them, ended by NULL, the default first; diffusion_scheme_named: NULL
 * for an unknown name. */
extern const struct diffusion_scheme diffusion_exponential, diffusion_series,
    diffusion_implicit_euler, diffusion_sdirk2;
extern const struct diffusion_scheme diffusion_crank_nicolson,
    diffusion_implicit_euler, diffusion_sdirk2;
extern const struct diffusion_scheme *const diffusion_schemes[];
const struct diffusion_scheme *diffusion_scheme_named(const char *name);

#endif
