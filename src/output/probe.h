/* probe.h -- the value of a field at a point.
 *
 * In a box: linear between the centres of the cells along each direction;
 * beyond the last centre the value of the last cell. In any other mesh: the
 * value of the cell and its slope to the neighbours, by least squares; so
 * linear fields are exact. A weighted field has the value of the cell there.
 */
#ifndef OUTPUT_PROBE_H
#define OUTPUT_PROBE_H

#include "mesh/mesh.h"

enum { PROBE_CELLS = 32 };

struct probe {
    int n;
    int weighted; /* [-] of a weighted field, so many of the cells count */
    int cell[PROBE_CELLS];     /* [-] the centres around the point */
    double share[PROBE_CELLS]; /* [-] what each counts; they add up to 1 */
};

/* Finds the cells around x [m], which lies in the box; none of them where x is
 * outside of a mesh that is no box. */
struct probe probe_at(const struct mesh *m, const double x[3]);

/* values[components * cell + component] there; weighted by weight[cell] if
 * that is not NULL, and then 0 where all weights are. */
double probe_value(const struct probe *p, const double *values, int components,
                   int component, const double *weight);

/* The same before the division: adds the sum of the shares, times the weights,
 * to *whole. */
double probe_amount(const struct probe *p, const double *values, int components,
                    int component, const double *weight, double *whole);

#endif
