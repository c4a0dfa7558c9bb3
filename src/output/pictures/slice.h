/* slice.h -- a plane through the middle of a mesh, as a grid of points.
 *
 * The plane is normal to the direction in which there is least to see: one with
 * a single cell, else the shortest. Its axes are x and y where that is z, or
 * the way up is one of them, upwards.
 */
#ifndef OUTPUT_PICTURES_SLICE_H
#define OUTPUT_PICTURES_SLICE_H

#include "mesh/mesh.h"

struct slice {
    int axis[2];           /* [-] the directions to the right and up */
    int n[2];              /* [-] points along each */
    double lo[2], step[2]; /* [m] the first point, and between two */
    double *u, *v, *speed; /* [m/s] in the plane, and of all components */
    double *p;             /* [Pa] */
    unsigned char *inside; /* [-] 1 where there is a cell; else all are 0 */
};

/* Of cell values u (3 a cell) and p, with so many points, about. */
struct slice slice_of(const struct mesh *m, const double *u, const double *p,
                      const double up[3], int points);
void slice_release(struct slice *s);

/* The velocity in the plane at a place of it, linear between the points; 0 if
 * one of those is outside. Returns 1 if it is inside. */
int slice_velocity(const struct slice *s, const double x[2], double w[2]);

/* Lines along the velocity, evenly spread: for each point calls put(of, x), and
 * after each line put(of, NULL). `apart` [m] is their distance, about. */
void slice_streamlines(const struct slice *s, double apart,
                       void (*put)(void *of, const double *x), void *of);

#endif
