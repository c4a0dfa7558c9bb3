/* diffusion_variants.h -- variants of the diffusion that folders provide.
 *
 * Chapter "Averaging".
 */
#ifndef AVERAGING_DIFFUSION_VARIANTS_H
#define AVERAGING_DIFFUSION_VARIANTS_H

#include "mesh/mesh.h"

struct averaging_options;
struct bandwidth;
struct cell_of_particle;

/* A way to apply exp(-T L) on some meshes that is faster than the series.
 * create returns NULL where it does not hold; b [m] is 0, or the bandwidth that
 * T [m^2] belongs to, from which the width of the cells is subtracted; tail [-]
 * is the error. apply: u becomes exp(-T L) u, for m fields side by side. */
struct diffusion_operator {
    const char *name;
    void *(*create)(const struct mesh *mesh, double T, double b, double tail);
    void (*free)(void *state);
    void (*apply)(void *state, int m, double *u);
};

/* Bandwidths that vary in space, by regions or by these rules (more/bandwidth.h
 * has the functions). */
struct diffusion_variation {
    int (*has_rule)(const char *vary); /* 1: a value of options.vary */
    int (*is_by_lines)(const struct averaging_options *o);
    struct bandwidth *(*create)(const struct cell_of_particle *h,
                                const struct averaging_options *o);
    void (*free)(struct bandwidth *w);
    int (*bind)(struct bandwidth *w);
    const double *(*D)(const struct bandwidth *w);
    double (*largest)(const struct bandwidth *w);
};

/* Those that are built in, ended by NULL. */
extern const struct diffusion_operator *const diffusion_operators[];
extern const struct diffusion_variation *const diffusion_variations[];

#endif
