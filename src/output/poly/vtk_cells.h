/* vtk_cells.h -- the cells of any mesh as lists of points for VTK. */
#ifndef OUTPUT_POLY_VTK_CELLS_H
#define OUTPUT_POLY_VTK_CELLS_H

#include "output/vtk.h"
#include "output/vtk_file.h"

/* Hexahedra and tetrahedra with these types, all other cells as polyhedra. */
extern const struct vtk_grid vtk_cells_grid;

#endif
