/* vtk_polygons.h -- walls, outlines and lines for ParaView, as vtk.h. */
#ifndef OUTPUT_POLYGONS_VTK_POLYGONS_H
#define OUTPUT_POLYGONS_VTK_POLYGONS_H

#include "output/vtk_file.h"

/* Polygons with values a polygon: point k is at x[3 k], x[3 k + 1], x[3 k + 2]
 * [m]; corner lists the points of all polygons one after the other, end the end
 * of each. */
struct vtk_polygons {
    int n_points, n_polygons;
    const double *x;
    const int *corner, *end;
};
int vtk_write_polygons(struct vtk_file *f, const char *path,
                       const struct vtk_polygons *p, double time, int n_arrays,
                       const struct vtk_array *arrays);

/* The same, each polygon an open line. */
int vtk_write_lines(struct vtk_file *f, const char *path,
                    const struct vtk_polygons *p, double time, int n_arrays,
                    const struct vtk_array *arrays);

#endif
