/* face_mean.h -- means of a function over boundary faces. */
#ifndef FLUID_INLETS_FACE_MEAN_H
#define FLUID_INLETS_FACE_MEAN_H

#include "mesh/mesh.h"

/* The mean of the function g(of, x), x [m], over boundary face f. The face is
 * divided into triangles about the middle of its corners; the mean is exact for
 * polynomials of degree 5. */
double face_mean(const struct mesh *m, int f,
                 double (*g)(const void *of, const double x[3]),
                 const void *of);

#endif
