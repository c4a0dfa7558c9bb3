/* measures.h -- volumes of a mesh, and sums over its faces, for what is checked
 * and printed.  Chapter "The mesh".
 */
#ifndef MESH_GEOMETRY_MEASURES_H
#define MESH_GEOMETRY_MEASURES_H

#include "mesh/mesh.h"

/* An upper bound of the number of faces of a box, which must not exceed
 * MESH_MOST_FACES [-]. */
double mesh_box_faces(const struct box_spec *spec);

/* The volumes of the smallest and of the largest cell, and the mean of all
 * [m^3]; of an outline, too. */
void mesh_volumes(const struct mesh *m, double *min, double *max, double *mean);

/* The largest sum of S.S / S.d over the inner faces of a cell, over its volume,
 * also of an outline [1/m^2]: the rate at which a diffusion with D = 1 m^2/s
 * decays [1/s]. */
double mesh_diffusion_rate(const struct mesh *m);

/* Largest |sum of S| over the faces of a cell, over its surface [-]: 0 for a
 * closed mesh up to rounding. */
double mesh_openness(const struct mesh *m);

#endif
