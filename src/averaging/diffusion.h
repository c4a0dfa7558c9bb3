/* diffusion.h -- the particle-centroid field, smoothed by diffusion.
 *
 * Chapter "Averaging".
 *
 *     d phi / d tau = lap phi,  phi(0) = the field of pcm,  tau = 0 .. T
 *     no flux through the boundary,  T = b^2 / 4            [SX15 5a-c]
 *
 * Far from walls this is the Gaussian kernel [SX15 6] of bandwidth b; at a wall
 * it is that kernel plus its mirror image. All particle quantities, eps_s,
 * eps_s U_s and eps_f F [SX15 9], are diffused together. Because there is no
 * flux through the boundary, the sum of V phi is conserved [SX15 A.3-A.6].
 *
 * The result is exp(-T V^-1 K) of that field, where K is the mesh Laplacian
 * times -V. The scheme "exponential" takes no steps and has no error in tau
 * beyond the tolerance; in a box it is applied direction by direction
 * (more/separable.h), else by its Chebyshev series, as the scheme "series"
 * always is. The schemes with steps are in diffusion_steps.c.
 */
#ifndef AVERAGING_DIFFUSION_H
#define AVERAGING_DIFFUSION_H

#include "averaging/averaging.h"
#include "base/model.h"
#include "linear/matrix.h"
#include "mesh/mesh.h"

extern const struct averaging_method diffusion_method;

/* Names for options.vary, ended by NULL; the first is the default: uniform. */
extern const struct model bandwidth_uniform, bandwidth_cells, bandwidth_grains;
extern const struct model *const bandwidth_rules[];

/* The keys that the method reads besides the bandwidth. */
extern const struct key diffusion_keys[];

/* [SX15 6]: h = exp(-r^2 / b^2) / (b^2 pi)^(3/2) [1/m^3]. r, b in [m]. */
double diffusion_kernel(double r, double b);

/* With at least this many steps [-] Crank-Nicolson does not undershoot for any
 * field, because in the explicit half of a step no cell loses more than it
 * contains, dtau / 2 K_cc / V_c <= 1; b [m]. In equal cubes 3 T / dx^2, 2 T /
 * dx^2 in two dimensions. Fewer may be sufficient; see the chapter. */
double diffusion_safe_steps(const struct mesh *m, double b);

/* T [m^2] that belongs to b [m]. */
double diffusion_time(double b);

/* 0, or the number of steps [-] that the scheme of the options, which are
 * complete, needs to avoid undershoots, if it has fewer. */
int diffusion_needed_steps(const struct mesh *mesh,
                           const struct averaging_options *o);

/* The descriptor of a time scheme of the diffusion. */

struct averaging_options;
struct averaging_report;
struct diffusion_scheme;

/* How a scheme takes its steps in pseudo-time (diffusion_steps.c). fill
 * sets the matrices for D on the internal faces [-], NULL for 1; apply diffuses
 * m fields side by side and reports the work of the solver. */
struct diffusion_stepping {
    void *(*create)(const struct diffusion_scheme *scheme,
                    const struct mesh *mesh, const struct averaging_options *o);
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

/* A = diag + factor times -V div (D grad) [m]; diag [m^3] or NULL for none. D:
 * one more factor for each internal face [-], or NULL for 1. */
void diffusion_matrix_fill(struct csr *A, const struct mesh *m,
                           const double *diag, double factor, const double *D);

#endif
