/* profile.h -- averages in time on a line through the box.
 *
 * The line runs along one direction (x) at a given place in a second (y); the
 * third (z), the depth, is averaged over. Between the rows of cell centres the
 * values are linear in y; below the first and above the last row they are those
 * of that row. One point for each column of cells. In a polyhedral mesh the
 * line is sampled by probes half a mean cell apart, along the line and in the
 * depth.
 *
 * A field may be weighted by another: a particle velocity by the solids
 * fraction, so that cells without particles do not count:
 *
 *     sample at x  = sum_z w u dz / sum_z w dz
 *     mean over t  = sum_t W sample dt / sum_t W dt,   W = sum_z w dz / depth
 *
 * The error of a mean is estimated in two ways: by the means of blocks of the
 * series (mean.h), and by the mirror. Where a case is the same seen in a
 * mirror, so is its mean over endless time, and half the difference of the two
 * sides is an error.
 */
#ifndef OUTPUT_MEANS_PROFILE_H
#define OUTPUT_MEANS_PROFILE_H

#include "base/state.h"
#include "mesh/mesh.h"

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

/* NULL after a message if the line is outside the box. */
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
