/* vtk.h -- the files that ParaView opens: cells, particles, walls.
 *
 * .vtr: the cells of a box, with values a cell; .vtu: those of any mesh. .vtp:
 * a point a particle, with values a particle; or polygons with values each;
 * where the path ends in .vtu, the same as cells, for readers of .vtu alone.
 * The files are XML followed by binary data compressed by zlib, and contain the
 * time of the state. The caller chooses the values.
 *
 * A write allocates nothing but the stream of the file, and buffers when an
 * array is larger than any before.
 */
#ifndef OUTPUT_VTK_H
#define OUTPUT_VTK_H

#include "mesh/mesh.h"
#include "output/vtk_file.h"

/* These return non-zero after a message if the file could not be written
 * completely; it then does not exist. Time in s; names must differ. */
int vtk_write_box(struct vtk_file *f, const char *path, const struct mesh *m,
                  double time, int n_arrays, const struct vtk_array *arrays);

/* The same as a piece of a larger box, from its cell `at` on. */
int vtk_write_box_at(struct vtk_file *f, const char *path, const struct mesh *m,
                     const int at[3], double time, int n_arrays,
                     const struct vtk_array *arrays);

/* n particles, 0 allowed, with centres x[0][i], x[1][i], x[2][i] [m]. */
int vtk_write_particles(struct vtk_file *f, const char *path, int n,
                        const double *const x[3], double time, int n_arrays,
                        const struct vtk_array *arrays);

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

/* The cells of any mesh, which is borrowed, as lists of points.
 * Hexahedra and tetrahedra have these types, all other cells are polyhedra. */
struct vtk_cells;
struct vtk_cells *vtk_cells_create(const struct mesh *m);
void vtk_cells_free(struct vtk_cells *v);
int vtk_cells_write(struct vtk_file *f, const char *path,
                    const struct vtk_cells *v, double time, int n_arrays,
                    const struct vtk_array *arrays);

#endif
