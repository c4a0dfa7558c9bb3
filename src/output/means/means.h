/* means.h -- means over time: of numbers, at a point, on a line. */
#ifndef OUTPUT_MEANS_MEANS_H
#define OUTPUT_MEANS_MEANS_H

#include "base/state.h"
#include "mesh/mesh.h"

/* --- mean: running means over time of many numbers at once.
 *
 * With a weight w_k for each sample x_k (its interval of time, and for phase
 * averages the amount of the phase present):
 *
 *     mean = sum w x / sum w,   spread = sqrt(sum w (x - mean)^2 / sum w)
 *
 * updated sample by sample [Welford62, West79], which keeps the spread exact
 * where the difference of the two sums would cancel. */

struct mean {
    int n;
    double *weight; /* [unit of w] sum of w, one a number */
    double *value;  /* [unit of x] mean so far; nan where weight is 0 */
    double *square; /* [unit of w x^2] sum of w (x - mean)^2 */
};

struct mean *mean_create(int n);

/* Adds x[0 .. n-1] for an interval of dt [s], each further weighted by w[i] >=
 * 0; NULL for equal weights. A weight of 0 leaves its mean as it is. */
void mean_add(struct mean *m, double dt, const double *x, const double *w);

/* Spread over time of number i; nan where weight is 0. */
double mean_spread(const struct mean *m, int i);

/* All sums (state.h). */
void mean_state(struct mean *m, struct state *s);

/* --- the statistical error of means over time. Chapter "Output". -----------
 *
 * Samples that follow each other are not independent. The series is cut into
 * blocks, and the spread of their means b_i gives the error of the whole:
 *
 *     error^2 = 1 / (m (m - 1)) sum_i (b_i - mean)^2                   (12.6)
 *
 * for blocks of one weight; a block with another one counts by it. It grows
 * with the length of the blocks until they are independent [Flyvbjerg89], so
 * the largest is taken of all lengths that leave at least 8 blocks. The end of
 * the series need not be known: when there are 32 blocks, neighbours are
 * joined, and the next ones are twice as long.
 */
struct mean_blocks;

/* For n numbers at once. */
struct mean_blocks *mean_blocks_create(int n);

/* Adds a sample x[0 .. n-1] of weights w [dt, times the amount of the phase];
 * where a weight is 0 its x may be nan. */
void mean_blocks_add(struct mean_blocks *b, const double *x, const double *w);

/* The error of the mean of number i, in its unit; nan while there are fewer
 * than 8 blocks. A block that is not full yet is left out. */
double mean_blocks_error(const struct mean_blocks *b, int i);

/* The blocks so far (state.h). */
void mean_blocks_state(struct mean_blocks *b, struct state *s);

/* --- probe: the value of a field at a point.
 *
 * In a box: linear between the centres of the cells along each direction;
 * beyond the last centre the value of the last cell. In any other mesh: the
 * value of the cell plus its least-squares gradient from the neighbours, which
 * is exact for linear fields. A weighted field has the value of the cell
 * there. */

enum { PROBE_CELLS = 32 };

struct probe {
    int n;
    int weighted; /* [-] number of cells that are used for a weighted field */
    int cell[PROBE_CELLS];     /* [-] the cells around the point */
    double share[PROBE_CELLS]; /* [-] weight of each; the sum is 1 */
};

/* Finds the cells around x [m], which lies in the box; none if x is outside a
 * polyhedral mesh. */
struct probe probe_at(const struct mesh *m, const double x[3]);

/* values[components * cell + component] at the point; weighted by weight[cell]
 * if that is not NULL, and then 0 where all weights are 0. */
double probe_value(const struct probe *p, const double *values, int components,
                   int component, const double *weight);

/* --- profile: averages in time on a line through the box.
 *
 * The line runs along one direction (x) at a given place in a second (y); the
 * third (z), the depth, is averaged over. Between the rows of cell centres the
 * values are linear in y; below the first and above the last row they are
 * those of that row. One point for each column of cells. In a polyhedral mesh
 * the line is sampled by probes half a mean cell apart, along the line and in
 * the depth.
 *
 * A field may be weighted by another: a particle velocity by the solids
 * fraction, so that cells without particles do not count:
 *
 *     sample at x  = sum_z w u dz / sum_z w dz
 *     mean over t  = sum_t W sample dt / sum_t W dt,   W = sum_z w dz / depth
 *
 * The error of a mean is estimated in two ways: by the means of blocks of the
 * series, and by the mirror. Where a case is the same seen in a
 * mirror, so is its mean over endless time, and half the difference of the two
 * sides is an error. */

/* Directions: 0, 1, 2 for x, y, z; along and across must differ. */
struct profile_line {
    int along;
    int across;
    double at;   /* [m] place of the line in the direction `across` */
    double from; /* [s] samples from this time on count */
};

/* A field to be averaged. The arrays are borrowed and must not be moved. */
struct profile_field {
    const char *name;     /* "void_fraction", "particle_velocity_y" */
    const char *unit;     /* "-", "m/s" */
    const double *values; /* [components * cell + component] */
    int components, component;
    const double *weight; /* [-] a number a cell, >= 0; NULL: equal weights */
};

struct profile;

/* The line lies within the box. */
struct profile *profile_create(const struct mesh *m,
                               const struct profile_line *line,
                               const struct profile_field *field);
void profile_free(struct profile *p);

/* Takes a sample of the present field at `time`; it represents an interval of
 * dt [s]. */
void profile_add(struct profile *p, double time, double dt);

/* As root mean squares over the line, in the unit of the field; nan if there is
 * nothing to compare: half the difference of the mean and its mirror image (a
 * velocity along the line changes its sign there), and the error by blocks. */
double profile_mirror_error(const struct profile *p);
double profile_block_error(const struct profile *p);

/* The means so far (state.h). */
void profile_state(struct profile *p, struct state *s);

/* Columns: x [m], then NAME_mean, NAME_std (over time) and NAME_error (of the
 * mean, by blocks), nan where the weight was always 0. Non-zero
 * after a message. */
int profile_write(const struct profile *p, const char *path);

#endif
