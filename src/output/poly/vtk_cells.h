/* vtk_cells.h -- the cells of any mesh as lists of points for VTK, .vtu.
 * Hexahedra and tetrahedra have these types, all other cells are polyhedra. */
#ifndef OUTPUT_POLY_VTK_CELLS_H
#define OUTPUT_POLY_VTK_CELLS_H

#include "mesh/mesh.h"
#include "output/vtk_file.h"

struct vtk_cells;

/* The mesh has a shape, and is borrowed. */
struct vtk_cells *vtk_cells_create(const struct mesh *m);
void vtk_cells_free(struct vtk_cells *v);

/* As vtk_write_box. */
int vtk_cells_write(struct vtk_file *f, const char *path,
                    const struct vtk_cells *v, double time, int n_arrays,
                    const struct vtk_array *arrays);

#endif
