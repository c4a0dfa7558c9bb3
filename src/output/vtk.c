/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/vtk.h"

/* The edges of the cells along x, y and z: n + 1 numbers each. */
static void put_edges(struct vtk_file *f, const struct box *b)
{
    static const char *const name[3] = {"x", "y", "z"};

    fprintf(vtk_file_stream(f), "<Coordinates>\n");
    for (int k = 0; k < 3; k++)
        vtk_file_array(f,
                       &(struct vtk_array){.name = name[k],
                                           .components = 1,
                                           .values = b->edge[k]},
                       b->n[k] + 1);
    fprintf(vtk_file_stream(f), "</Coordinates>\n");
}

int vtk_write_box(struct vtk_file *f, const char *path, const struct mesh *m,
                  double time, int n_arrays, const struct vtk_array *arrays)
{
    static const int at[3] = {0, 0, 0};
    return vtk_write_box_at(f, path, m, at, time, n_arrays, arrays);
}

int vtk_write_box_at(struct vtk_file *f, const char *path, const struct mesh *m,
                     const int at[3], double time, int n_arrays,
                     const struct vtk_array *arrays)
{
    const int *const n = m->box.n;
    char extent[96], whole[128];

    snprintf(extent, sizeof extent, "Extent=\"%d %d %d %d %d %d\"", at[0],
             at[0] + n[0], at[1], at[1] + n[1], at[2], at[2] + n[2]);
    snprintf(whole, sizeof whole, " Whole%s", extent);
    if (vtk_file_begin(f, path, "RectilinearGrid", whole, time) != 0) return 1;
    fprintf(vtk_file_stream(f), "<Piece %s>\n", extent);
    put_edges(f, &m->box);
    vtk_file_section(f, "CellData", m->n_cells, n_arrays, arrays);
    fprintf(vtk_file_stream(f), "</Piece>\n");
    return vtk_file_end(f);
}

/* Points without a cell are not drawn, so each point is a cell. */
static void put_verts(struct vtk_file *f, int n)
{
    const struct vtk_array verts[2] = {
        {.name = "connectivity", .components = 1, .from = 0},
        {.name = "offsets", .components = 1, .from = 1}};

    vtk_file_section(f, "Verts", n, 2, verts);
}

int vtk_write_particles(struct vtk_file *f, const char *path, int n,
                        const double *const x[3], double time, int n_arrays,
                        const struct vtk_array *arrays)
{
    /* with n = 0 there may be no arrays; the type is still Float64 */
    static const double none;
    const struct vtk_array centres = {
        .name = "position",
        .components = 3,
        .split = {n ? x[0] : &none, n ? x[1] : &none, n ? x[2] : &none}};

    if (vtk_file_begin(f, path, "PolyData", "", time) != 0) return 1;
    fprintf(vtk_file_stream(f),
            "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"%d\" "
            "NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
            n, n);
    vtk_file_section(f, "Points", n, 1, &centres);
    put_verts(f, n);
    vtk_file_section(f, "PointData", n, n_arrays, arrays);
    fprintf(vtk_file_stream(f), "</Piece>\n");
    return vtk_file_end(f);
}

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
