/* measures.h -- volumes of a mesh, and sums over its faces, for what is checked
 * and printed.  Chapter "The mesh".
 */
#ifndef MESH_MEASURES_H
#define MESH_MEASURES_H

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

/* The corners of boundary faces, of any mesh. */

/* Copies the corners of boundary face f to x [m], at most `max` of them, and
 * returns how many the face has. Their order is counterclockwise, seen from
 * outside. */
int mesh_face_corners(const struct mesh *m, int f, int max, double (*x)[3]);

/* x = the centre of boundary face f [m]. */
void mesh_face_middle(const struct mesh *m, int f, double x[3]);

/* Measures of the quality of a mesh. */

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

/* The largest distance of a cell from a neighbour [m], also of an outline; 0
 * for a single cell. */
double mesh_widest_link(const struct mesh *m);

#endif
