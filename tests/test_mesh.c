/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/mesh.h"
#include "mesh/poly/poly.h"
#include "mesh/measures.h"
#include "facts.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

static struct mesh *box(int nx, int ny, int nz, double grading, int periodic)
{
    const struct box_spec spec = {{0.3, 1.2, 0.5},
                                  {nx, ny, nz},
                                  {grading, 1.0 / grading, grading},
                                  {periodic, 0, periodic}};
    return mesh_create_box(&spec);
}

/* Shapes that between them have every special case: one cell, one direction,
 * graded, periodic with 1, 2 and more cells. */
static const struct {
    int n[3];
    double grading;
    int periodic;
} shapes[] = {{{1, 1, 1}, 1.0, 0}, {{1, 7, 1}, 3.0, 0}, {{4, 5, 1}, 1.0, 1},
              {{2, 3, 2}, 2.0, 1}, {{1, 4, 3}, 1.0, 1}, {{6, 5, 4}, 5.0, 0}};
enum { N_SHAPES = sizeof shapes / sizeof *shapes };

static struct mesh *shape(int i)
{
    return box(shapes[i].n[0], shapes[i].n[1], shapes[i].n[2],
               shapes[i].grading, shapes[i].periodic);
}

FACT_FOR_EACH(cell_volumes_fill_the_box, N_SHAPES)
{
    struct mesh *const m = shape(_i);
    double sum = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        ck_assert(m->V[c] > 0.0);
        sum += m->V[c];
    }
    ck_assert_double_eq_tol(sum, 0.3 * 1.2 * 0.5, 1e-15); /* rounding */
    mesh_free(m);
}

FACT_FOR_EACH(outline_of_a_box_says_what_the_box_has, N_SHAPES)
{
    struct mesh *const m = shape(_i);
    const struct box_spec spec = {
        {m->hi[0], m->hi[1], m->hi[2]},
        {m->box.n[0], m->box.n[1], m->box.n[2]},
        {shapes[_i].grading, 1.0 / shapes[_i].grading, shapes[_i].grading},
        {m->box.periodic[0], m->box.periodic[1], m->box.periodic[2]}};
    struct mesh *const o = mesh_outline_box(&spec);
    double least, most, mean, V_least = HUGE_VAL, V_most = 0.0, fastest = 0.0;

    ck_assert_ptr_null(o->V);
    ck_assert_int_eq(o->n_cells, m->n_cells);
    ck_assert_int_eq(o->n_faces, m->n_faces);
    ck_assert_int_eq(o->n_internal, m->n_internal);
    ck_assert_double_ge(mesh_box_faces(&spec), m->n_faces);
    ck_assert_int_eq(o->n_patches, m->n_patches);
    for (int p = 0; p < m->n_patches; p++) {
        ck_assert_str_eq(o->patches[p].name, m->patches[p].name);
        ck_assert_int_eq(o->patches[p].n, m->patches[p].n);
    }
    for (int c = 0; c < m->n_cells; c++) {
        double rate = 0.0;
        V_least = fmin(V_least, m->V[c]);
        V_most = fmax(V_most, m->V[c]);
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            double SS = 0.0, Sd = 0.0;
            for (int k = 0; k < 3; k++) {
                SS += mesh_S(m, f)[k] * mesh_S(m, f)[k];
                Sd += mesh_S(m, f)[k] * mesh_d(m, f)[k];
            }
            if (f < m->n_internal) rate += SS / Sd / m->V[c];
        }
        fastest = fmax(fastest, rate);
    }
    mesh_volumes(o, &least, &most, &mean);
    /* products of three widths, and sums of six terms, in another order */
    ck_assert_double_eq_tol(least / V_least, 1.0, 1e-14);
    ck_assert_double_eq_tol(most / V_most, 1.0, 1e-14);
    ck_assert_double_eq_tol(mean * m->n_cells / (0.3 * 1.2 * 0.5), 1.0, 1e-14);
    ck_assert_double_le(fabs(mesh_diffusion_rate(o) - fastest),
                        1e-13 * fastest);
    mesh_free(o);
    mesh_free(m);
}

FACT_FOR_EACH(every_cell_is_closed_where_no_direction_is_periodic_with_one_cell,
              N_SHAPES)
{
    struct mesh *const m = shape(_i);
    ck_assert_double_lt(mesh_openness(m), 1e-15);
    mesh_free(m);
}

/* Gauss: the sum over a cell's faces of x_f . S is 3 V; with x_f measured from
 * the cell centre it needs only links and weights, also across a period. */
FACT_FOR_EACH(links_weights_and_areas_give_each_volume_back, N_SHAPES)
{
    struct mesh *const m = shape(_i);
    int directions[3] = {1, 1, 1};
    for (int k = 0; k < 3; k++) /* such a direction has no faces at all */
        directions[k] = !(m->box.periodic[k] && m->box.n[k] == 1);
    const int n_dir = directions[0] + directions[1] + directions[2];
    for (int c = 0; c < m->n_cells; c++) {
        double sum = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a], mine = m->owner[f] == c;
            const double share = mine ? 1.0 - m->w[f] : m->w[f];
            for (int k = 0; k < 3; k++)
                sum += share * mesh_d(m, f)[k] * mesh_S(m, f)[k];
        }
        ck_assert_double_eq_tol(sum / m->V[c], n_dir, 1e-12);
    }
    mesh_free(m);
}

FACT(grading_is_the_ratio_of_the_last_cell_to_the_first)
{
    struct mesh *const m = box(6, 5, 4, 5.0, 0);
    const double *const e = m->box.edge[0];
    ck_assert_double_eq_tol((e[6] - e[5]) / (e[1] - e[0]), 5.0, 1e-12);
    ck_assert_double_eq_tol((e[2] - e[1]) / (e[1] - e[0]), pow(5.0, 0.2),
                            1e-12);
    mesh_free(m);
}

/* Faces, edges and corners are where a point could be owned twice or never. */
FACT_FOR_EACH(every_point_of_the_box_has_exactly_one_owner, N_SHAPES)
{
    struct mesh *const m = shape(_i);
    const struct box *const b = &m->box;
    int hits = 0, points = 0;
    for (int i = 0; i <= 2 * b->n[0]; i++)
        for (int j = 0; j <= 2 * b->n[1]; j++)
            for (int k = 0; k <= 2 * b->n[2]; k++) {
                const int at[3] = {i, j, k};
                double x[3];
                for (int a = 0; a < 3; a++) /* edges and midpoints by turns */
                    x[a] = at[a] % 2 == 0 ? b->edge[a][at[a] / 2]
                                          : 0.5 * (b->edge[a][at[a] / 2] +
                                                   b->edge[a][at[a] / 2 + 1]);
                const int c = mesh_cell_at(m, x[0], x[1], x[2]);
                points++;
                ck_assert_int_ge(c, 0);
                ck_assert_int_lt(c, m->n_cells);
                hits += c >= 0;
            }
    ck_assert_int_eq(hits, points);
    mesh_free(m);
}

/* The point x along direction k, elsewhere in the middle of the first cell. */
static int index_at(const struct mesh *m, int k, double x)
{
    double point[3];
    for (int a = 0; a < 3; a++)
        point[a] = a == k ? x : 0.5 * m->box.edge[a][1];
    const int c = mesh_cell_at(m, point[0], point[1], point[2]);
    const int at[3] = {c % m->box.n[0], c / m->box.n[0] % m->box.n[1],
                       c / m->box.n[0] / m->box.n[1]};
    return at[k];
}

static void check_interval(const struct mesh *m, int k, int i)
{
    const double lo = m->box.edge[k][i], hi = m->box.edge[k][i + 1];
    ck_assert_int_eq(index_at(m, k, lo), i);
    ck_assert_int_eq(index_at(m, k, 0.5 * (lo + hi)), i);
    ck_assert_int_eq(index_at(m, k, nextafter(hi, lo)), i);
}

/* To the last bit: at its lower edge, within, and just below its upper edge.
 * On graded cells a division alone is wrong by whole cells, on equal ones for
 * many an edge, because an edge is a rounded number. */
FACT_FOR_EACH(a_cell_owns_the_points_between_its_edges_to_the_last_bit,
              N_SHAPES)
{
    struct mesh *const m = shape(_i);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < m->box.n[k]; i++)
            check_interval(m, k, i);
    mesh_free(m);
    for (int n = 10 * _i + 1; n <= 10 * _i + 10; n++) {
        struct mesh *const line = box(1, n, 1, 1.0, 0);
        for (int i = 0; i < n; i++)
            check_interval(line, 1, i);
        mesh_free(line);
    }
}

FACT(a_point_on_a_face_belongs_to_the_cell_above_it)
{
    struct mesh *const m = box(4, 5, 1, 1.0, 0);
    const double y = m->box.edge[1][2];
    ck_assert_int_eq(mesh_cell_at(m, 0.01, y, 0.1), 8);
    ck_assert_int_eq(mesh_cell_at(m, 0.01, nextafter(y, 0.0), 0.1), 4);
    ck_assert_int_eq(mesh_cell_at(m, 0.01, 1.2, 0.1), 16); /* the end */
    ck_assert_int_eq(mesh_cell_at(m, 0.01, nextafter(1.2, 2.0), 0.1), -1);
    ck_assert_int_eq(mesh_cell_at(m, -1e-300, 0.1, 0.1), -1);
    ck_assert_int_eq(mesh_cell_at(m, NAN, 0.1, 0.1), -1);
    mesh_free(m);
}

FACT(a_periodic_direction_wraps_points)
{
    struct mesh *const m = box(4, 5, 3, 1.0, 1);
    const int c = mesh_cell_at(m, 0.01, 0.1, 0.1);
    ck_assert_int_eq(mesh_cell_at(m, 0.01 + 0.3, 0.1, 0.1 - 0.5), c);
    ck_assert_int_eq(mesh_cell_at(m, 0.01 - 3.0, 0.1, 0.1), c);
    ck_assert_int_ge(mesh_cell_at(m, -1e-300, 0.1, 0.1), 0);
    ck_assert_int_eq(m->n_patches, 2);
    ck_assert_ptr_null(mesh_patch(m, "left"));
    mesh_free(m);
}

FACT(patches_stand_where_their_names_say)
{
    struct mesh *const m = box(4, 5, 3, 1.0, 0);
    const struct {
        const char *name;
        int n, k;
        double sign;
    } expect[] = {{"left", 15, 0, -1.0},   {"right", 15, 0, 1.0},
                  {"bottom", 12, 1, -1.0}, {"top", 12, 1, 1.0},
                  {"back", 20, 2, -1.0},   {"front", 20, 2, 1.0}};
    for (int i = 0; i < 6; i++) {
        const struct patch *const p = mesh_patch(m, expect[i].name);
        ck_assert_ptr_nonnull(p);
        ck_assert_int_eq(p->n, expect[i].n);
        for (int f = p->first; f < p->first + p->n; f++)
            ck_assert(expect[i].sign * mesh_S(m, f)[expect[i].k] > 0.0);
    }
    mesh_free(m);
}

/* A row of cells that are 1, 2 and 4 wide, 0.5 deep and 0.3 high: from a centre
 * to the middles of its faces it is half of each. */
FACT(the_measures_of_a_graded_row_are_those_of_its_widths)
{
    const struct box_spec spec = {
        {0.3, 7.0, 0.5}, {1, 3, 1}, {1.0, 4.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
    const struct mesh_quality q = mesh_quality(m);
    ck_assert_double_eq_tol(q.aspect, 4.0 / 0.3, 1e-12);
    ck_assert_int_eq(q.n_flat, 2);
    ck_assert_double_eq_tol(q.growth, 2.0, 1e-12);
    ck_assert_double_eq_tol(q.V_min, 0.15, 1e-12);
    ck_assert_double_eq_tol(q.V_max, 0.6, 1e-12);
    ck_assert_int_eq(q.n_small, 0);
    ck_assert_double_eq(q.skewness, 0.0);
    ck_assert_double_lt(q.non_orthogonal, 1e-5); /* acos of 1 to rounding */
    mesh_free(m);
}

/* The same numbers from cells in a ring, where each face is within: the ends
 * are 4 and 1 wide, and the smallest cell comes last. */
FACT(a_ring_of_graded_cells_has_the_largest_growth_where_it_closes)
{
    const struct box_spec spec = {
        {7.0, 1.0, 1.0}, {3, 1, 1}, {0.25, 1.0, 1.0}, {1, 1, 1}};
    struct mesh *const m = mesh_create_box(&spec);
    const struct mesh_quality q = mesh_quality(m);
    ck_assert_double_eq_tol(q.growth, 4.0, 1e-12);
    ck_assert_double_eq_tol(q.aspect, 1.0, 1e-12); /* half a width each way */
    ck_assert_int_eq(q.n_small, 2);
    mesh_free(m);
}

/* 0.5 x 0.25 x 2: the single cell in z has no neighbours, so that its size does
 * not count. Of the graded mesh the widest column in x crosses the narrowest
 * row in y. */
FACT(the_longest_cell_is_as_long_as_its_links)
{
    const struct box_spec even = {
        {2.0, 1.0, 2.0}, {4, 4, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct box_spec graded = {
        {7.0, 3.0, 1.0}, {3, 2, 1}, {4.0, 2.0, 1.0}, {0, 0, 0}};
    struct mesh *const outline = mesh_outline_box(&even);
    struct mesh *const box = mesh_create_box(&graded);
    struct mesh *const poly = mesh_create_sheared(&even, (double[3]){0.0});
    int c;

    ck_assert_double_eq_tol(mesh_longest_cell(outline, &c), 2.0, 1e-12);
    ck_assert_int_eq(c, -1);
    ck_assert_double_eq_tol(mesh_longest_cell(box, &c), 4.0, 1e-12);
    ck_assert_double_eq_tol(mesh_longest_cell(poly, &c), 2.0, 1e-12);
    ck_assert_int_ge(c, 0);
    mesh_free(outline);
    mesh_free(box);
    mesh_free(poly);
}

/* With y / 2 added to x, links between rows lean by atan(1/2); the faces across
 * x lean by as much. The link of the rows crosses their face in its middle. */
FACT(a_sheared_box_is_as_crooked_as_its_shear)
{
    const struct box_spec spec = {
        {1.0, 1.0, 1.0}, {2, 2, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_sheared(&spec, (double[]){0.5, 0, 0});
    const struct mesh_quality q = mesh_quality(m);
    ck_assert_double_eq_tol(q.non_orthogonal, atan(0.5) * 180.0 / M_PI, 1e-9);
    ck_assert_double_lt(q.skewness, 1e-12);
    ck_assert_double_eq_tol(q.growth, 1.0, 1e-12);
    mesh_free(m);
}

/* A face's middle that stands aside by a tenth of the link, along it and
 * across it: only the second is skewness, as the weight says where the link
 * crosses. */
FACT(skewness_is_the_way_from_the_link_to_the_middle_of_the_face)
{
    const struct box_spec spec = {
        {1.0, 3.0, 1.0}, {1, 3, 1}, {1.0, 4.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_sheared(&spec, (double[]){0, 0, 0});
    const double way = mesh_d(m, 1)[1]; /* of face 1, along y */
    m->face_centre[3] += 0.06 * way;
    m->face_centre[5] -= 0.08 * way;
    const struct mesh_quality q = mesh_quality(m);
    ck_assert_double_eq_tol(q.skewness, 0.1, 1e-12);
    ck_assert_int_eq(q.n_skewed, m->owner[1]);
    mesh_free(m);
}
