/* poly.h -- meshes of OpenFOAM: points, faces, owner, neighbour, boundary.
 *
 * Chapter "The mesh".
 */
#ifndef MESH_POLY_POLY_H
#define MESH_POLY_POLY_H

#include "base/file.h"
#include "mesh/mesh.h"

/* The mesh of the five files in dir, or in dir/polyMesh or
 * dir/constant/polyMesh, ascii or binary, packed by gzip or not; NULL after
 * one message on stderr. What was read stays in `files`, if that is not NULL.
 * Cells and faces are renumbered (poly_order.c);
 * boundary faces stay in their patch. */
struct mesh *poly_read(const char *dir, struct inputs **files);

enum { POLY_FOLDER = 960 };
/* Finds the folder of the five files; 0 and dir itself if there is none. */
int poly_folder(const char *dir, char folder[POLY_FOLDER]);
/* 1 if such a folder exists; it is looked for where POLY_LOOKED_FOR says. */
#define POLY_LOOKED_FOR                                                        \
    "no file boundary in it, in polyMesh or in constant/polyMesh"
int poly_is(const char *dir);

struct mesh_patch_name {
    char name[64];
};

/* Reads only the names of the patches that are not cyclic. Returns their number
 * and a list that the caller frees; -1 after one message. */
int poly_patches(const char *dir, struct inputs **files,
                 struct mesh_patch_name **list);

/* The box of the specification, sheared: x grows by shear[0] y + shear[1] z, y
 * by shear[2] z. NULL after a message if its cells are too distorted. */
struct mesh *mesh_create_sheared(const struct box_spec *spec,
                                 const double shear[3]);

/* The search for the cell of a point in a polyhedral mesh. */

/* Creates m->search; everything else of the mesh must be set. No corner is
 * farther from the plane of its face than slack [m]. */
void locate_create(struct mesh *m, double slack);

/* The cell that contains x [m], or -1 outside, by a walk from cell to cell that
 * begins in the cell `begin`: each step crosses the face that the point is
 * farthest beyond, until the point is beyond none. If the walk fails (around a
 * hole, or out of a concave region), or begin is -1, all cells of the point's
 * bin are tested. offset [m] becomes the vector from the centre of the cell to
 * the point; it is not set outside. */
int locate_from(const struct mesh *m, int begin, const double x[3],
                double offset[3]);

#endif
