/* interpolation.h -- interpolation of a field to the particles.
 * Chapter "Averaging".
 *
 * nearest  the value of its own cell. Exact for constants; jumps from cell to
 *          cell.
 * linear   the value of that cell and its Gauss gradient g,
 *
 *            phi_i = phi_c + g . (x_i - x_c),
 *            g = (1 / V_c) sum_f S_f (phi_f - phi_c).
 *
 *          Exact for linear fields, also on graded meshes and across a period;
 *          second order for smooth ones; discontinuous at faces. At a boundary
 *          phi_f is the given value; then it is exact there as well. If none
 *          is given, the gradient of a cell at the boundary is fitted to its
 *          neighbours, again exact for linear fields; there is none in a
 *          direction of one cell. It may exceed the range of the neighbouring
 *          values: there is no limiter.
 *
 * same     the adjoint of the averaging: the weights are those with which the
 *          forces are averaged [XS11 3.9].
 */
#ifndef AVERAGING_INTERPOLATION_H
#define AVERAGING_INTERPOLATION_H

#include "averaging/averaging.h"
#include "base/model.h"

/* One interpolation. apply interpolates m interleaved fields to the particles
 * of the last averaging_bind. The values on the boundary faces, boundary[m * (f
 * - n_internal) + k], or NULL, are used by "linear" only. */
struct interpolation {
    MODEL_MEMBERS; /* base/model.h */
    void (*apply)(struct averaging *a, int m, const double *field,
                  const double *boundary, double *q);
};

/* All of them, ended by NULL; interpolation_named gives NULL for an unknown
 * name. */
extern const struct interpolation interpolation_nearest, interpolation_linear,
    interpolation_same;
extern const struct interpolation *const interpolations[];
const struct interpolation *interpolation_named(const char *name);

#endif
