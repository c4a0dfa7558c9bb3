/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/vtk.h"

#include <string.h>

static int vtk_is_grid(const char *path)
{
    const char *const end = strrchr(path, '.');
    return end != NULL && strcmp(end, ".vtu") == 0;
}

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

/* What a file of points, lines or polygons consists of. */
struct items {
    const char *section; /* of PolyData */
    int type;            /* of a cell of an UnstructuredGrid */
    const char *data;    /* what the values belong to */
};
static const struct items verts = {"Verts", 1, "PointData"};
static const struct items lines = {"Lines", 3, "CellData"};
static const struct items polys = {"Polys", 7, "CellData"};

static void put_piece(FILE *out, const struct items *is, int grid, int points,
                      int n)
{
    if (grid)
        fprintf(out, "<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n",
                points, n);
    else
        fprintf(out,
                "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"%d\" "
                "NumberOfLines=\"%d\" NumberOfStrips=\"0\" "
                "NumberOfPolys=\"%d\">\n",
                points, is == &verts ? n : 0, is == &lines ? n : 0,
                is == &polys ? n : 0);
}

/* n items with their corners among so many points, as PolyData or, where the
 * path ends in .vtu, as cells. Points without a cell are not drawn, so each
 * point is one. */
static int write_items(struct vtk_file *f, const char *path,
                       const struct items *is, int n_points,
                       const struct vtk_array *points, int n, const int *corner,
                       const int *end, double time, int n_arrays,
                       const struct vtk_array *arrays)
{
    const int grid = vtk_is_grid(path);
    const struct vtk_array list[3] = {
        {.name = "connectivity", .components = 1, .ints = corner},
        {.name = "offsets", .components = 1, .ints = end, .from = 1},
        {.name = "types", .components = 1, .from = is->type, .same = 1}};

    if (vtk_file_begin(f, path, grid ? "UnstructuredGrid" : "PolyData", "",
                       time) != 0)
        return 1;
    put_piece(vtk_file_stream(f), is, grid, n_points, n);
    vtk_file_section(f, "Points", n_points, 1, points);
    fprintf(vtk_file_stream(f), "<%s>\n", grid ? "Cells" : is->section);
    vtk_file_array(f, &list[0], n_points);
    vtk_file_array(f, &list[1], n);
    if (grid) vtk_file_array(f, &list[2], n);
    fprintf(vtk_file_stream(f), "</%s>\n", grid ? "Cells" : is->section);
    vtk_file_section(f, is->data, n, n_arrays, arrays);
    fprintf(vtk_file_stream(f), "</Piece>\n");
    return vtk_file_end(f);
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

    return write_items(f, path, &verts, n, &centres, n, NULL, NULL, time,
                       n_arrays, arrays);
}

static int write_shapes(struct vtk_file *f, const char *path,
                        const struct items *is, const struct vtk_polygons *p,
                        double time, int n_arrays,
                        const struct vtk_array *arrays)
{
    const struct vtk_array points = {
        .name = "position", .components = 3, .values = p->x};

    return write_items(f, path, is, p->n_points, &points, p->n_polygons,
                       p->corner, p->end, time, n_arrays, arrays);
}

int vtk_write_polygons(struct vtk_file *f, const char *path,
                       const struct vtk_polygons *p, double time, int n_arrays,
                       const struct vtk_array *arrays)
{
    return write_shapes(f, path, &polys, p, time, n_arrays, arrays);
}

int vtk_write_lines(struct vtk_file *f, const char *path,
                    const struct vtk_polygons *p, double time, int n_arrays,
                    const struct vtk_array *arrays)
{
    return write_shapes(f, path, &lines, p, time, n_arrays, arrays);
}
