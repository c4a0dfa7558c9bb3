/* plane.h -- slices through the middle of a mesh, from its file.
 *
 * A slice is a raster: each point of it shows the cell whose box contains it,
 * of several the one with the nearest centre.
 */
#ifndef REPORT_PLANE_H
#define REPORT_PLANE_H

#include "report/vtk_read.h"

enum { PLANE_MOST = 96 }; /* points of a raster along the longer side */

struct plane {
    int n[2]; /* [-] points; 0: there is no such slice */
    double low[3], high[3];
    int cells; /* [-] of the mesh */
    int *cell; /* of each point; -1: none */
};

/* The slices across x, y and z; non-zero if the file has not so many cells. */
int plane_make(struct plane plane[3], const struct vtk_read *f, size_t cells);
void plane_free(struct plane plane[3]);

#endif
