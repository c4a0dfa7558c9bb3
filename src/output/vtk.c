/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/vtk.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

/* Whether the name of a file ends in .vtu. */
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
    for (int k = 0; k < 3; k++) {
        const struct vtk_array edge = {
            .name = name[k], .components = 1, .values = b->edge[k]};
        vtk_file_array(f, &edge, b->n[k] + 1);
    }
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

int vtk_write_polygons(struct vtk_file *f, const char *path,
                       const struct vtk_polygons *p, double time, int n_arrays,
                       const struct vtk_array *arrays)
{
    const struct vtk_array points = {
        .name = "position", .components = 3, .values = p->x};

    return write_items(f, path, p->lines ? &lines : &polys, p->n_points,
                       &points, p->n_polygons, p->corner, p->end, time,
                       n_arrays, arrays);
}

/* --- vtk cells: hexahedra, tetrahedra and polyhedra.
 *
 * In VTK a cell is a list of points. The list of a hexahedron has the points
 * of one face, in the order that gives an inward normal by the right-hand
 * rule, and then the points of the opposite face; that of a tetrahedron
 * likewise, and then its apex. The list of a polyhedron is in any order; a
 * second list has the number of its faces, and for each face the number of its
 * points and the points. */

enum { TETRAHEDRON = 10, HEXAHEDRON = 12, POLYHEDRON = 42 };

/* A growable array of integers. */
struct list {
    int n, room;
    int *value;
};

struct vtk_cells {
    const struct mesh *mesh; /* borrowed */
    int n_points;
    const double *point;       /* [m] 3 a point */
    double *corners;           /* the same, of a box; else NULL */
    struct list points, faces; /* connectivity, faces */
    int *end, *faces_end;      /* [-] offsets of each cell */
    unsigned char *type;
    int polyhedra; /* [-] how many */
};

static void vtk_cells_add(struct list *l, int value)
{
    l->value = alloc_room(l->value, l->n, &l->room, sizeof *l->value);
    l->value[l->n++] = value;
}

static int vtk_cells_is_in(const int *list, int n, int value)
{
    for (int i = 0; i < n; i++)
        if (list[i] == value) return 1;
    return 0;
}

/* Polygon i of cell c: its number of corners, and the first of them. */
static int polygon(const struct mesh_shape *s, int c, int i, const int **corner)
{
    const int p = s->polygon[s->cell_start[c] + i];

    *corner = &s->corner[s->start[p]];
    return s->start[p + 1] - s->start[p];
}

static int vtk_cells_faces_of(const struct mesh_shape *s, int c)
{
    return s->cell_start[c + 1] - s->cell_start[c];
}

/* 1 if all faces of the cell have this number of corners. */
static int all_have(const struct mesh_shape *s, int c, int corners)
{
    const int *corner;

    for (int i = 0; i < vtk_cells_faces_of(s, c); i++)
        if (polygon(s, c, i, &corner) != corners) return 0;
    return 1;
}

/* The first face of the cell, its normal inward. */
static void vtk_cells_base_of(const struct mesh *m, int c, int n, int *base)
{
    const struct mesh_shape *const s = m->shape;
    const double *const x = &m->centre[3 * c];
    const int *corner;
    double inward = 0.0;

    polygon(s, c, 0, &corner);
    for (int i = 0; i < n; i++) {
        double a[3], b[3], normal[3];
        vector_between(&s->point[3 * corner[i]], x, a);
        vector_between(&s->point[3 * corner[(i + 1) % n]], x, b);
        vector_cross(a, b, normal);
        inward -= vector_dot(normal, a);
        vector_between(&s->point[3 * corner[(i + 2) % n]], x, a);
        inward -= vector_dot(normal, a);
    }
    for (int i = 0; i < n; i++)
        base[i] = corner[inward > 0.0 ? i : n - 1 - i];
}

/* The point that is joined to a point of the base by an edge outside the base;
 * -1 if there is no such edge, or more than one. */
static int vtk_cells_across(const struct mesh_shape *s, int c, int n,
                            const int *base, int point)
{
    int found = -1;

    for (int i = 1; i < vtk_cells_faces_of(s, c); i++) {
        const int *corner;
        const int corners = polygon(s, c, i, &corner);
        for (int k = 0; k < corners; k++)
            for (int way = -1; way < 2; way += 2) {
                const int to = corner[(k + way + corners) % corners];
                if (corner[k] != point || vtk_cells_is_in(base, n, to))
                    continue;
                if (found >= 0 && found != to) return -1;
                found = to;
            }
    }
    return found;
}

/* The eight points of a hexahedron; 0 if the cell is none. */
static int is_hexahedron(const struct mesh *m, int c, int point[8])
{
    if (vtk_cells_faces_of(m->shape, c) != 6 || !all_have(m->shape, c, 4))
        return 0;
    vtk_cells_base_of(m, c, 4, point);
    for (int i = 0; i < 4; i++) {
        point[4 + i] = vtk_cells_across(m->shape, c, 4, point, point[i]);
        if (point[4 + i] < 0 || vtk_cells_is_in(&point[4], i, point[4 + i]))
            return 0;
    }
    return 1;
}

static int is_tetrahedron(const struct mesh *m, int c, int point[4])
{
    if (vtk_cells_faces_of(m->shape, c) != 4 || !all_have(m->shape, c, 3))
        return 0;
    vtk_cells_base_of(m, c, 3, point);
    point[3] = vtk_cells_across(m->shape, c, 3, point, point[0]);
    return point[3] >= 0;
}

static void add_polyhedron(struct vtk_cells *v, int c)
{
    const struct mesh_shape *const s = v->mesh->shape;
    const int first = v->points.n;

    vtk_cells_add(&v->faces, vtk_cells_faces_of(s, c));
    for (int i = 0; i < vtk_cells_faces_of(s, c); i++) {
        const int *corner;
        const int corners = polygon(s, c, i, &corner);
        vtk_cells_add(&v->faces, corners);
        for (int k = 0; k < corners; k++) {
            vtk_cells_add(&v->faces, corner[k]);
            if (!vtk_cells_is_in(&v->points.value[first], v->points.n - first,
                                 corner[k]))
                vtk_cells_add(&v->points, corner[k]);
        }
    }
    v->polyhedra++;
}

/* The corners of the cells of a box, and the eight of each cell. */
static void add_box(struct vtk_cells *v, const struct box *b)
{
    const int nx = b->n[0] + 1, ny = b->n[1] + 1, nz = b->n[2] + 1;

    v->n_points = nx * ny * nz;
    v->point = v->corners = owner_doubles(v, 3 * v->n_points);
    for (int p = 0; p < v->n_points; p++) {
        v->corners[3 * p] = b->edge[0][p % nx];
        v->corners[3 * p + 1] = b->edge[1][p / nx % ny];
        v->corners[3 * p + 2] = b->edge[2][p / nx / ny];
    }
    for (int c = 0; c < v->mesh->n_cells; c++) {
        const int i = c % b->n[0], j = c / b->n[0] % b->n[1],
                  k = c / b->n[0] / b->n[1];
        const int p = i + nx * (j + ny * k), up = nx * ny;
        const int corner[8] = {
            p,      p + 1,      p + 1 + nx,      p + nx,
            p + up, p + 1 + up, p + 1 + nx + up, p + nx + up};
        for (int q = 0; q < 8; q++)
            vtk_cells_add(&v->points, corner[q]);
        v->type[c] = HEXAHEDRON;
        v->end[c] = v->points.n;
    }
}

static void add_cell(struct vtk_cells *v, int c)
{
    int point[8];
    const int n = is_hexahedron(v->mesh, c, point)    ? 8
                  : is_tetrahedron(v->mesh, c, point) ? 4
                                                      : 0;

    for (int i = 0; i < n; i++)
        vtk_cells_add(&v->points, point[i]);
    v->type[c] = n == 8 ? HEXAHEDRON : n == 4 ? TETRAHEDRON : POLYHEDRON;
    if (n == 0) add_polyhedron(v, c);
    v->end[c] = v->points.n;
    v->faces_end[c] = n == 0 ? v->faces.n : -1;
}

struct vtk_cells *vtk_cells_create(const struct mesh *m)
{
    struct vtk_cells *const v = owner_create(sizeof *v);

    v->mesh = m;
    v->end = owner_ints(v, m->n_cells);
    v->faces_end = owner_ints(v, m->n_cells);
    v->type = owner_zeroed(v, (size_t)m->n_cells, 1);
    if (m->shape == NULL) {
        add_box(v, &m->box);
        return v;
    }
    v->n_points = m->shape->n_points;
    v->point = m->shape->point;
    for (int c = 0; c < m->n_cells; c++)
        add_cell(v, c);
    return v;
}

void vtk_cells_free(struct vtk_cells *v)
{
    if (v == NULL) return;
    free(v->points.value);
    free(v->faces.value);
    owner_free(v);
}

static void vtk_cells_put(struct vtk_file *f, const struct vtk_cells *v)
{
    const struct mesh *const m = v->mesh;
    const struct vtk_array points = {
        .name = "position", .components = 3, .values = v->point};
    const struct vtk_array list[] = {
        {.name = "connectivity", .components = 1, .ints = v->points.value},
        {.name = "offsets", .components = 1, .ints = v->end},
        {.name = "types", .components = 1, .bytes = v->type},
        {.name = "faces", .components = 1, .ints = v->faces.value},
        {.name = "faceoffsets", .components = 1, .ints = v->faces_end}};

    fprintf(vtk_file_stream(f),
            "<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n", v->n_points,
            m->n_cells);
    vtk_file_section(f, "Points", v->n_points, 1, &points);
    fprintf(vtk_file_stream(f), "<Cells>\n");
    vtk_file_array(f, &list[0], v->points.n);
    vtk_file_array(f, &list[1], m->n_cells);
    vtk_file_array(f, &list[2], m->n_cells);
    if (v->polyhedra > 0) {
        vtk_file_array(f, &list[3], v->faces.n);
        vtk_file_array(f, &list[4], m->n_cells);
    }
    fprintf(vtk_file_stream(f), "</Cells>\n");
}

int vtk_cells_write(struct vtk_file *f, const char *path,
                    const struct vtk_cells *v, double time, int n_arrays,
                    const struct vtk_array *arrays)
{
    if (vtk_file_begin(f, path, "UnstructuredGrid", "", time) != 0) return 1;
    vtk_cells_put(f, v);
    vtk_file_section(f, "CellData", v->mesh->n_cells, n_arrays, arrays);
    fprintf(vtk_file_stream(f), "</Piece>\n");
    return vtk_file_end(f);
}
