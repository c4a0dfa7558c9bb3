/* vtk_cells.h -- the cells of any mesh as lists of points for VTK. */
#ifndef OUTPUT_POLY_VTK_CELLS_H
#define OUTPUT_POLY_VTK_CELLS_H

#include "output/vtk.h"
#include "output/vtk_file.h"

int vtk_cells_number(const struct vtk_cells *c);

/* Opens the <Piece> and declares its points and cells. */
void vtk_cells_put(struct vtk_file *f, const struct vtk_cells *c);

#endif
