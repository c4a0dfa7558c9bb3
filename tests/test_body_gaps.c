/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaps of about a cell and less: what the mesh and the film do together. */
#include "brenner.h"
#include "facts.h"
#include "narrow_gap.h"
#include "resolved/body_cells.h"
#include "resolved/fluid_parts.h"

/* Far from everything it is Stokes' force, at a small gap R/z, twice as much as
 * between two; in between his table, where the distance is cosh 1, 2, 3 R. */
FACT(brenner61_the_exact_force_has_its_limits)
{
    ck_assert_double_eq_tol(brenner_force(1e3, 0), 1.0, 2e-3);
    ck_assert_double_eq_tol(brenner_force(cosh(1.0) - 1.0, 0), 3.0361, 1e-4);
    ck_assert_double_eq_tol(brenner_force(cosh(2.0) - 1.0, 0), 1.4129, 1e-4);
    ck_assert_double_eq_tol(brenner_force(cosh(3.0) - 1.0, 0), 1.1252, 1e-4);
    ck_assert_double_eq_tol(brenner_force(1e-3, 0) / 1e3, 1.0, 4e-3);
    ck_assert_double_eq_tol(brenner_force(1e-3, 1) / 500.0, 1.0, 1e-2);
}

/* One sphere above a floor, or two, with z/h between: the force of mesh and
 * film over the exact one. */
static double force_over_exact(double z_over_h, int of_two)
{
    const double h = narrow_gap_h, z = z_over_h * h;
    const double of_mesh = narrow_gap_force(z, of_two, of_two ? 0.25 * h : 0.03,
                                            of_two ? 0.01 : 0.0);
    const double film = narrow_gap_film(z, of_two, squeeze_film_cells * h);

    return (of_mesh + film) / brenner_force(z / narrow_gap_R, of_two);
}

/* Gaps of 1, 1/2, 1/4, 1/8 of a cell. The mesh alone has 0.9, 0.7, 0.4 and 0.24
 * of the force. A film that began at two cells would make it 1.3 of it. */
FACT_FOR_EACH(cox67_mesh_and_film_have_the_force_of_a_sphere_at_a_wall, 4)
{
    ck_assert_double_eq_tol(force_over_exact(exp2(-_i), 0), 1.0, 0.12);
}

/* Likewise, with the gap across the cells. */
FACT_FOR_EACH(cox67_mesh_and_film_have_the_force_of_two_spheres, 2)
{
    ck_assert_double_eq_tol(force_over_exact(exp2(-2 * _i), 1), 1.0, 0.15);
}

static struct mesh *small_box(void)
{
    const struct box_spec spec = {.size = {1.0, 1.0, 1.0},
                                  .cells = {4, 5, 6},
                                  .grading = {1.0, 1.0, 1.0},
                                  .periodic = {1, 0, 1}};
    return mesh_create_box(&spec);
}

/* As many marked cells of eight as n says, scattered. */
static void scatter(int *mark, int cells, int n)
{
    for (unsigned c = 0, x = (unsigned)n; c < (unsigned)cells; c++) {
        x = x * 1664525u + 1013904223u;
        mark[c] = (int)(x >> 29) < n ? 1 + (int)(x >> 20) % 3 : 0;
    }
}

/* What is beside cell c, by its faces. */
struct beside {
    int meets, marked[3]; /* along each axis */
};

static struct beside beside(const struct mesh *m, const int *mark, int c)
{
    struct beside s = {0};

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a], inner = f < m->n_internal;
        const double *const S = mesh_S(m, f);
        const int k = fabs(S[0]) > 0.0 ? 0 : fabs(S[1]) > 0.0 ? 1 : 2;
        const int next = !inner             ? -1
                         : m->owner[f] == c ? m->neighbour[f]
                                            : m->owner[f];
        ck_assert_int_eq(
            box_beside(&m->box, c, 2 * k + (m->out[a] * S[k] > 0.0)), next);
        s.marked[k] += !inner || mark[next] != 0;
        s.meets |= !inner || (mark[next] != 0 && mark[next] != mark[c]);
    }
    return s;
}

/* The cells are looked at by their numbers in the box. By the faces it is the
 * same. */
FACT_FOR_EACH(cells_beside_one_by_number_are_those_by_its_faces, 8)
{
    struct mesh *const m = small_box();
    int *const mark = calloc((size_t)m->n_cells, sizeof *mark), amid = 0;

    scatter(mark, m->n_cells, _i);
    for (int c = 0; c < m->n_cells; c++) {
        const struct beside s = beside(m, mark, c);
        const int is = box_is_amid(&m->box, c), *const of = s.marked;
        for (int fast = 0; fast <= is; fast++) {
            ck_assert_int_eq(box_meets_other(&m->box, fast, mark, c), s.meets);
            ck_assert_int_eq(box_is_between(&m->box, fast, mark, c),
                             of[0] == 2 || of[1] == 2 || of[2] == 2);
        }
        amid += is;
    }
    ck_assert_int_eq(amid, 2 * 3 * 4);
    mesh_free(m);
    free(mark);
}

/* The least number of a cell that each is joined with, through faces. */
static void join_by_faces(const struct mesh *m, const int *mark, int *least)
{
    for (int c = 0; c < m->n_cells; c++)
        least[c] = c;
    for (int changed = 1; changed;) {
        changed = 0;
        for (int f = 0; f < m->n_internal; f++) {
            int *const o = &least[m->owner[f]], *const n =
                                                    &least[m->neighbour[f]];
            if (mark[m->owner[f]] || mark[m->neighbour[f]] || *o == *n)
                continue;
            *o = *n = *o < *n ? *o : *n;
            changed = 1;
        }
    }
}

/* The parts of the fluid are found by rows. Through the faces they are the
 * same, and each cell is in one. */
FACT_FOR_EACH(parts_by_rows_are_those_by_faces, 8)
{
    struct mesh *const m = small_box();
    int *const mark = calloc(3 * (size_t)m->n_cells, sizeof *mark);
    int *const least = mark + m->n_cells, *const part = least + m->n_cells;
    int n = 0;

    scatter(mark, m->n_cells, _i);
    join_by_faces(m, mark, least);
    struct fluid_parts *const p = fluid_parts_find(&m->box, mark);
    for (int e = 0; e < p->runs; e++) {
        if (p->run[e].root != e) continue;
        const int cells = fluid_parts_cells(p, e, part);
        for (int c = 0; c < cells; c++) {
            ck_assert_int_eq(least[part[c]], p->run[e].first);
            ck_assert_int_eq(p->run[fluid_parts_run(p, part[c])].root, e);
        }
        n += cells;
    }
    for (int c = 0; c < m->n_cells; c++)
        n += mark[c] != 0;
    ck_assert_int_eq(n, m->n_cells);
    owner_free(p);
    mesh_free(m);
    free(mark);
}
