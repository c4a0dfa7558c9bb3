/* probe.h -- a field at one point of the box, as a sensor there would see it.
 *
 * Linear between the centres of the cells along each direction; beyond the
 * last centre the value of the last cell.
 */
#ifndef PROBE_H
#define PROBE_H

#include "mesh/mesh.h"

struct probe {
    int cell[8];     /* [-] the centres around the point */
    double share[8]; /* [-] what each counts; they add up to 1 */
};

/* Finds the cells around x [m], which lies in the box. */
struct probe probe_at(const struct mesh *m, const double x[3]);

/* values[components * cell + component] there; weighted by weight[cell] if
 * that is not NULL, and then 0 where all weights are. */
double probe_value(const struct probe *p, const double *values, int components,
                   int component, const double *weight);

#endif
