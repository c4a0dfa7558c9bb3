/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaps of about a cell and less: what the mesh and the film do together. */
#include "brenner.h"
#include "facts.h"
#include "narrow_gap.h"
#include "resolved/mark.h"

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

/* The cells are looked at by their numbers in the box. By the faces it is the
 * same, with each cell in turn marked otherwise than all others. */
FACT(cells_beside_one_by_number_are_those_by_its_faces)
{
    const struct box_spec spec = {.size = {1.0, 1.0, 1.0},
                                  .cells = {4, 5, 6},
                                  .grading = {1.0, 1.0, 1.0},
                                  .periodic = {1, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
    int *const mark = calloc((size_t)m->n_cells, sizeof *mark), found = 0;

    for (int odd = 0; odd < m->n_cells; odd++) {
        mark[odd] = 1;
        for (int c = 0; c < m->n_cells; c++) {
            const int x = c % 4; /* the ends of a period are left out */
            int alike = x > 0 && x < 3;
            for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
                const int f = m->cell_face[a], inner = f < m->n_internal;
                const int k = fabs(m->S[3 * f]) > 0.0       ? 0
                              : fabs(m->S[3 * f + 1]) > 0.0 ? 1
                                                            : 2;
                const int up = m->out[a] * m->S[3 * f + k] > 0.0;
                ck_assert_int_eq(box_goes_on(&m->box, c, 2 * k + up), inner);
                alike &= inner && mark[m->owner[f]] == mark[m->neighbour[f]];
            }
            ck_assert_int_eq(box_is_alike(&m->box, mark, c), alike);
            found += alike;
        }
        mark[odd] = 0;
    }
    ck_assert_int_gt(found, 0);
    mesh_free(m);
    free(mark);
}
