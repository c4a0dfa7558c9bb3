/* probe.h -- the value of a field at a point.
 *
 * In a box: linear between the centres of the cells along each direction;
 * beyond the last centre the value of the last cell. In any other mesh: the
 * value of the cell plus its least-squares gradient from the neighbours, which
 * is exact for linear fields. A weighted field has the value of the cell there.
 */
#ifndef OUTPUT_MEANS_PROBE_H
#define OUTPUT_MEANS_PROBE_H

#include "mesh/mesh.h"

enum { PROBE_CELLS = 32 };

struct probe {
    int n;
    int weighted; /* [-] number of cells that are used for a weighted field */
    int cell[PROBE_CELLS];     /* [-] the cells around the point */
    double share[PROBE_CELLS]; /* [-] weight of each; the sum is 1 */
};

/* Of the cells of a box along direction k: the middle of row i; and the row
 * whose middle is below x, or the first, with the weight of the row above it.
 */
double probe_middle(const struct box *b, int k, int i);
int probe_row(const struct box *b, int k, double x, double *upper);

/* Finds the cells around x [m], which lies in the box; none if x is outside a
 * polyhedral mesh. */
struct probe probe_at(const struct mesh *m, const double x[3]);

/* values[components * cell + component] at the point; weighted by weight[cell]
 * if that is not NULL, and then 0 where all weights are 0. */
double probe_value(const struct probe *p, const double *values, int components,
                   int component, const double *weight);

/* The same before the division by the sum of the weights, which is added to
 * *whole. */
double probe_amount(const struct probe *p, const double *values, int components,
                    int component, const double *weight, double *whole);

#endif
