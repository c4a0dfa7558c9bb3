/* diffusion_steps.h -- the diffusion by implicit steps in pseudo-time.
 * Chapter "Averaging".
 *
 * With K the mesh Laplacian of [SX15 5a] times -V:
 *
 *   crank-nicolson  as [SX15]: second order; undershoots if the steps are few
 *   implicit-euler  first order; never undershoots
 *   sdirk2          second order, L-stable; two stages a step
 */
#ifndef AVERAGING_SCHEMES_DIFFUSION_STEPS_H
#define AVERAGING_SCHEMES_DIFFUSION_STEPS_H

#include "averaging/diffusion_scheme.h"

extern const struct diffusion_scheme diffusion_crank_nicolson,
    diffusion_implicit_euler, diffusion_sdirk2;

/* With at least this many steps [-] Crank-Nicolson does not undershoot for any
 * field, because in the explicit half of a step no cell loses more than it
 * contains, dtau / 2 K_cc / V_c <= 1; b [m]. In equal cubes 3 T / dx^2, 2 T /
 * dx^2 in two dimensions. Fewer may be sufficient; see the chapter. */
double diffusion_safe_steps(const struct mesh *m, double b);

#endif
