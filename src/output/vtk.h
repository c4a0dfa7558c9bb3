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

#include <stdio.h>

#include "mesh/mesh.h"

/* --- vtk file: the frame of a VTK XML file: text first, then the data.
 *
 * The XML says of each array only where its bytes begin, counted from behind
 * the "_" of <AppendedData>. These offsets are not known when the XML is
 * written, so digits are reserved for them and filled in at the end. */

/* One named array of numbers.
 *
 * The numbers are not copied: they may be interleaved, in one array a
 * component, or integers. They are Float64 in the file, bit for bit what was
 * computed, or Float32 if `single` is set: seven digits at half the size,
 * enough for values that are only displayed (velocities), but not for
 * positions, whose differences are overlaps of 1e-4 d, nor for values that will
 * be summed.
 *
 * Fill it by name: {.name = "velocity", .components = 3, .split = {vx, vy, vz}}
 */
struct vtk_array {
    const char *name;
    int components;             /* [-] numbers a point or cell, 1 to 9 */
    const double *values;       /* side by side, [components * i + k]; or */
    const double *split[3];     /* one array a component; or */
    const int *ints;            /* whole numbers, side by side, Int32; or */
    const unsigned char *bytes; /* small ones, UInt8; or */
    int from;   /* if all are NULL: from, from + 1, ... as Int32 */
    int same;   /* [-] 1: or every one is `from`, as UInt8 */
    int single; /* [-] 1: Float32 */
};

/* Those that are only displayed, side by side or one array a component. */
static inline struct vtk_array vtk_single(const char *name, int components,
                                          const double *values)
{
    return (struct vtk_array){
        .name = name, .components = components, .values = values, .single = 1};
}

static inline struct vtk_array vtk_vector(const char *name, const double *x,
                                          const double *y, const double *z)
{
    return (struct vtk_array){
        .name = name, .components = 3, .split = {x, y, z}, .single = 1};
}

/* VTK's name of its type: "Float64", "Float32", "Int32", "UInt8". */
const char *vtk_array_type(const struct vtk_array *a);

/* Most arrays in one file, coordinates and cells among them. */
enum { VTK_FILE_ARRAYS = 64 };

/* One writer serves all files of a run, one after the other. */
struct vtk_file;

struct vtk_file *vtk_file_create(void);
void vtk_file_free(struct vtk_file *f);

/* Opens the file and writes its head up to the time; kind is the VTK type, such
 * as "RectilinearGrid"; extent is an attribute of it, or "". Non-zero after a
 * message. */
int vtk_file_begin(struct vtk_file *f, const char *path, const char *kind,
                   const char *extent, double time /* [s] */);

/* The stream, for text that is specific to one kind of file. */
FILE *vtk_file_stream(struct vtk_file *f);

/* Declares arrays in a section <name>, for n points or cells. The arrays must
 * exist until vtk_file_end. */
void vtk_file_section(struct vtk_file *f, const char *name, int n, int n_arrays,
                      const struct vtk_array *arrays);

/* Declares one array. */
void vtk_file_array(struct vtk_file *f, const struct vtk_array *a, int n);

/* Writes the arrays' bytes and commits the file; non-zero after a message. */
int vtk_file_end(struct vtk_file *f);

/* --- vtk ------------------------------------------------------------------ */

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
    int lines; /* [-] 1: each is an open line */
};
int vtk_write_polygons(struct vtk_file *f, const char *path,
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
