/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/polygons/vtk_polygons.h"

/* As lines or as polygons. */
static int write_shapes(struct vtk_file *f, const char *path, int as_lines,
                        const struct vtk_polygons *p, double time, int n_arrays,
                        const struct vtk_array *arrays)
{
    const char *const kind = as_lines ? "Lines" : "Polys";
    const struct vtk_array points = {
        .name = "position", .components = 3, .values = p->x};
    const struct vtk_array corner = {
        .name = "connectivity", .components = 1, .ints = p->corner};
    const struct vtk_array end = {
        .name = "offsets", .components = 1, .ints = p->end};

    if (vtk_file_begin(f, path, "PolyData", "", time) != 0) return 1;
    fprintf(vtk_file_stream(f),
            "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"0\" "
            "NumberOfLines=\"%d\" NumberOfStrips=\"0\" "
            "NumberOfPolys=\"%d\">\n",
            p->n_points, as_lines ? p->n_polygons : 0,
            as_lines ? 0 : p->n_polygons);
    vtk_file_section(f, "Points", p->n_points, 1, &points);
    fprintf(vtk_file_stream(f), "<%s>\n", kind);
    vtk_file_array(f, &corner, p->n_points);
    vtk_file_array(f, &end, p->n_polygons);
    fprintf(vtk_file_stream(f), "</%s>\n", kind);
    vtk_file_section(f, "CellData", p->n_polygons, n_arrays, arrays);
    fprintf(vtk_file_stream(f), "</Piece>\n");
    return vtk_file_end(f);
}

int vtk_write_polygons(struct vtk_file *f, const char *path,
                       const struct vtk_polygons *p, double time, int n_arrays,
                       const struct vtk_array *arrays)
{
    return write_shapes(f, path, 0, p, time, n_arrays, arrays);
}

int vtk_write_lines(struct vtk_file *f, const char *path,
                    const struct vtk_polygons *p, double time, int n_arrays,
                    const struct vtk_array *arrays)
{
    return write_shapes(f, path, 1, p, time, n_arrays, arrays);
}
