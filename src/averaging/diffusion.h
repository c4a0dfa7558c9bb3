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
 * always is. The schemes with steps are in schemes/diffusion_steps.h.
 */
#ifndef AVERAGING_DIFFUSION_H
#define AVERAGING_DIFFUSION_H

#include "averaging/averaging_method.h"
#include "averaging/diffusion_scheme.h"
#include "base/model.h"
#include "mesh/mesh.h"

extern const struct averaging_method diffusion_method;

/* Names for options.vary, ended by NULL; the first is the default: uniform. */
extern const struct model bandwidth_uniform, bandwidth_cells, bandwidth_grains;
extern const struct model *const bandwidth_rules[];

/* The keys that the method reads besides the bandwidth. */
extern const struct key diffusion_keys[];

/* [SX15 6]: h = exp(-r^2 / b^2) / (b^2 pi)^(3/2) [1/m^3]. r, b in [m]. */
double diffusion_kernel(double r, double b);

/* T [m^2] that belongs to b [m], and b to T. */
double diffusion_time(double b);
double diffusion_bandwidth(double T);

/* 0, or the number of steps [-] that the scheme of the options, which are
 * complete, needs to avoid undershoots, if it has fewer. */
int diffusion_needed_steps(const struct mesh *mesh,
                           const struct averaging_options *o);

#endif
