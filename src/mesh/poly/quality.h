/* quality.h -- measures of the quality of a mesh.  Chapter "The mesh". */
#ifndef MESH_POLY_QUALITY_H
#define MESH_POLY_QUALITY_H

#include "mesh/mesh.h"

struct mesh_quality {
    double openness;       /* [-] mesh_openness */
    double non_orthogonal; /* [deg] largest angle between S and d */
    double skewness;       /* [-] largest distance of a face's middle from
                              where its link crosses it, over the link */
    double aspect;         /* [-] largest distance of a cell's centre from the
                              middle of a face over the smallest */
    double growth;         /* [-] largest ratio of the volumes of neighbours */
    double V_min, V_max;   /* [m^3] */
    int n_non_orthogonal, n_skewed, n_flat,
        n_small; /* [-] numbers of such cells */
};
struct mesh_quality mesh_quality(const struct mesh *m);

/* The largest length of a cell over its width [-], both as the links to its
 * neighbours have them, also of an outline; 1 for a mesh with tetrahedra. cell
 * is where that is, -1 in a box, whose cells have no numbers in an outline. */
double mesh_longest_cell(const struct mesh *m, int *cell);

#endif
