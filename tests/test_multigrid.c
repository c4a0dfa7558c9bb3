/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/multigrid.h"

#include "linear/solvers.h"
#include "facts.h"
#include "linear_case.h"

#include <omp.h>

static const double unit[3] = {1, 1, 1};
static const int closed[3] = {0, 0, 0}, round_about[3] = {1, 1, 1};

enum side { WALL, PINNED };

static struct preconditioned with(struct multigrid *mg)
{
    return (struct preconditioned){&multigrid_preconditioned, mg};
}

static struct multigrid *create(const struct links *b, const struct csr *A)
{
    struct multigrid *const mg = multigrid_create(
        b->n, b->n_links, b->owner, b->neighbour, b->strength, b->link, b->V);

    set_from(with(mg), A);
    return mg;
}

/* A box with conductivities of its own in every cell and one wall. */
struct cycle {
    struct links b;
    struct csr *A;
    struct multigrid *mg;
    double *r, *z; /* residual in, correction out */
};

static struct cycle one_cycle(struct links b)
{
    struct cycle c = {.b = b};
    double *const k = smooth_coefficients(&b);

    c.A = diffusion(&b, k);
    add_wall(c.A, &b, k, unit);
    c.mg = create(&b, c.A);
    c.r = noise_vector(b.n, 1);
    c.z = alloc_doubles(b.n);
    free(k);
    return c;
}

static void release(struct cycle *c)
{
    free(c->r);
    free(c->z);
    owner_free(c->mg);
    owner_free(c->A);
    links_free(&c->b);
}

/* Iterations to 1e-6 from zero for random right-hand sides, the largest of
 * two; 1000 if the limit did not suffice or the true residual is larger. The
 * sides let nothing through but x = 0, which has the value 0 (WALL), or
 * nothing at all, and cell 0 is held by twice its diagonal (PINNED). Frees b.
 */
static int iterations(struct links b, const double *h, const double *k,
                      enum side side)
{
    struct csr *const A = diffusion(&b, k);
    struct cg_work *const w = cg_work_create(b.n);
    int most = 0;

    if (side == WALL)
        add_wall(A, &b, k, h);
    else
        A->diag[0] = A->diag[0] > 0.0 ? 2.0 * A->diag[0] : 1.0;

    struct multigrid *const mg = create(&b, A);

    for (unsigned seed = 1; seed <= 2; seed++) {
        double *const rhs = noise_vector(b.n, seed);
        double *const x = alloc_doubles(b.n);
        const struct solve_report r =
            cg_solve(with(mg), rhs, x, 1e-6, 0.0, 300, w);
        const int good = r.converged && true_residual(A, rhs, x) < 1.001e-6;

        if (!good) most = 1000;
        if (r.iterations > most) most = r.iterations;
        free(rhs);
        free(x);
    }
    owner_free(mg);
    owner_free(w);
    owner_free(A);
    links_free(&b);
    return most;
}

static int smooth_iterations(int nx, int ny, int nz)
{
    struct links b = links_cube(nx, ny, nz);
    double *const k = smooth_coefficients(&b);
    const int n = iterations(b, unit, k, WALL);

    free(k);
    return n;
}

/* Measured: 4 to 10. With coarse coefficients that are not divided by how much
 * their links grew it takes 9 to 34, and more on larger meshes. */
FACT(iterations_do_not_grow_with_the_mesh)
{
    const int sizes[][3] = {{16, 16, 1},   {32, 32, 1},  {64, 64, 1},
                            {128, 128, 1}, {16, 16, 16}, {32, 32, 32},
                            {100, 1, 1},   {1000, 1, 1}, {18, 50, 4},
                            {37, 29, 23},  {45, 61, 1},  {1, 33, 47}};

    for (int s = 0; s < 12; s++) {
        const int n = smooth_iterations(sizes[s][0], sizes[s][1], sizes[s][2]);

        ck_assert_msg(n <= 10, "%d x %d x %d: %d iterations", sizes[s][0],
                      sizes[s][1], sizes[s][2], n);
    }
}

FACT(one_cell_and_two_cells_are_solved)
{
    const int sizes[][3] = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {2, 2, 2}};

    for (int s = 0; s < 4; s++)
        for (int periodic = 0; periodic < 2; periodic++) {
            struct links b = links_box(sizes[s][0], sizes[s][1], sizes[s][2],
                                       unit, periodic ? round_about : closed);

            ck_assert_int_le(iterations(b, unit, NULL, PINNED), 2);
        }
}

/* Measured: 6 to 9. Coarsening all directions alike takes 13 to 87. */
FACT(flat_cells_cost_no_more)
{
    const double ratios[] = {2, 4, 10}; /* of lengths: 4, 16, 100 of S/d */

    for (int s = 0; s < 3; s++)
        for (int k = 0; k < 3; k++)
            for (int thin = 0; thin < 2; thin++) {
                double h[3] = {1, 1, 1};
                const struct links b =
                    (h[k] = thin ? 1.0 / ratios[s] : ratios[s],
                     links_box(20, 20, 20, h, closed));
                const int n = iterations(b, h, NULL, WALL);

                ck_assert_msg(n <= 14, "direction %d, %g: %d", k, h[k], n);
            }
}

/* Widths that grow by 10 across the box: flat cells here, round ones there.
 * Measured: 9 to 12. */
FACT(a_graded_box_costs_little_more)
{
    const int cells[][3] = {{64, 64, 1}, {24, 24, 24}};

    for (int s = 0; s < 2; s++)
        for (int k = 0; k < 2; k++) {
            struct links b = links_cube(cells[s][0], cells[s][1], cells[s][2]);

            links_stretch(&b, k, 10.0);

            const int n = iterations(b, unit, NULL, PINNED);

            ck_assert_msg(n <= 15, "%d, direction %d: %d", s, k, n);
        }
}

/* Measured: 7 to 11 (28 for 128^2): corrections constant on an aggregate do not
 * follow jumps. */
FACT(jumps_of_1000_converge_within_30_iterations)
{
    const int sizes[][3] = {
        {32, 32, 1}, {64, 64, 1}, {16, 16, 16}, {32, 32, 32}};

    for (int s = 0; s < 4; s++) {
        struct links b = links_cube(sizes[s][0], sizes[s][1], sizes[s][2]);
        double *const k = jumping_coefficients(&b);
        const int n = iterations(b, unit, k, WALL);

        free(k);
        ck_assert_msg(n <= 30, "%d: %d iterations", s, n);
    }
}

/* Without flux out the matrix is singular until one cell is held. */
FACT(a_closed_box_with_one_cell_held_converges_as_fast)
{
    const int sizes[][3] = {{64, 64, 1}, {20, 20, 20}, {18, 50, 4}};

    for (int s = 0; s < 3; s++)
        for (int periodic = 0; periodic < 2; periodic++) {
            const struct links b =
                links_box(sizes[s][0], sizes[s][1], sizes[s][2], unit,
                          periodic ? round_about : closed);
            const int n = iterations(b, unit, NULL, PINNED);

            ck_assert_msg(n <= 12, "%d, periodic %d: %d", s, periodic, n);
        }
}

/* The right-hand side must add up to zero; then nothing needs to be held. */
FACT(even_the_singular_system_converges)
{
    struct links b = links_box(30, 20, 10, unit, (int[3]){0, 1, 1});
    struct csr *const A = diffusion(&b, NULL);
    struct multigrid *const mg = create(&b, A);
    struct cg_work *const w = cg_work_create(b.n);
    double *const x = alloc_doubles(b.n), *const rhs = noise_vector(b.n, 8);
    double mean = 0.0;

    for (int i = 0; i < b.n; i++)
        mean += rhs[i] / b.n;
    for (int i = 0; i < b.n; i++)
        rhs[i] -= mean;

    const struct solve_report r = cg_solve(with(mg), rhs, x, 1e-8, 0.0, 50, w);

    ck_assert(r.converged);
    ck_assert_int_le(r.iterations, 15);
    ck_assert_double_le(true_residual(A, rhs, x), 1.001e-8);
    free(x);
    free(rhs);
    owner_free(w);
    owner_free(mg);
    owner_free(A);
    links_free(&b);
}

/* Measured: 9 to 12, on aggregates that are no longer boxes. */
FACT(cells_in_random_order_converge)
{
    const int sizes[][3] = {{64, 64, 1}, {20, 20, 20}, {300, 1, 1}};

    for (int s = 0; s < 3; s++) {
        struct links b = links_cube(sizes[s][0], sizes[s][1], sizes[s][2]);

        links_shuffle(&b, 21);

        const int n = iterations(b, unit, NULL, WALL);

        ck_assert_msg(n <= 20, "%d: %d iterations", s, n);
    }
}

/* Nothing to coarsen and too many to solve directly: smoothing alone, which
 * leaves a little of what the diagonal would have solved. */
FACT(unknowns_without_links_are_solved)
{
    struct links b = links_cube(100, 1, 1);

    b.n_links = 0;

    struct csr *const A = diffusion(&b, NULL);

    for (int i = 0; i < b.n; i++)
        A->diag[i] = 1 + i % 3;

    struct multigrid *const mg = create(&b, A);
    struct cg_work *const w = cg_work_create(b.n);
    double *const x = alloc_doubles(b.n), *const rhs = noise_vector(b.n, 8);

    ck_assert_int_eq(multigrid_levels(mg), 1);
    ck_assert_int_eq(multigrid_unknowns(mg, 0), 100);
    ck_assert_int_le(cg_solve(with(mg), rhs, x, 1e-6, 0.0, 10, w).iterations,
                     2);
    for (int i = 0; i < b.n; i++)
        ck_assert_double_eq_tol(x[i], rhs[i] / (1 + i % 3), 1e-5);
    free(x);
    free(rhs);
    owner_free(w);
    owner_free(mg);
    owner_free(A);
    links_free(&b);
}

/* x.My and y.Mx differ by the single precision inside: 1e-7 of a sum of terms
 * without order; a smoother that is not symmetric is off by 1e-2. */
FACT(the_cycle_is_symmetric_and_positive)
{
    for (int shuffled = 0; shuffled < 2; shuffled++) {
        struct links b = links_box(17, 12, 9, unit, (int[3]){0, 0, 1});

        if (shuffled) links_shuffle(&b, 2);

        struct cycle c = one_cycle(b);
        double *const y = noise_vector(b.n, 2), *const My = alloc_doubles(b.n);
        const double rMr = multigrid_apply(c.mg, c.r, c.z);
        const double yMy = multigrid_apply(c.mg, y, My);

        ck_assert_double_gt(rMr, 0.0);
        ck_assert_double_eq_tol(rMr / dot_plain(b.n, c.r, c.z), 1.0, 1e-13);
        ck_assert_double_eq_tol(dot_plain(b.n, c.r, My), dot_plain(b.n, y, c.z),
                                1e-6 * sqrt(rMr * yMy));
        free(y);
        free(My);
        release(&c);
    }
}

/* The update replaces all data of the previous matrix. */
FACT(an_update_leaves_nothing_of_the_matrix_before)
{
    struct cycle c = one_cycle(links_cube(20, 10, 10));
    struct csr *const other = diffusion(&c.b, NULL);
    double *const z = alloc_doubles(c.b.n);

    other->diag[0] *= 2.0;
    struct multigrid *const fresh = create(&c.b, other);

    multigrid_apply(c.mg, c.r, c.z);
    multigrid_apply(fresh, c.r, z);
    ck_assert_mem_ne(c.z, z, (size_t)c.b.n * sizeof *z);
    set_from(with(c.mg), other);
    multigrid_apply(c.mg, c.r, c.z);
    ck_assert_mem_eq(c.z, z, (size_t)c.b.n * sizeof *z);
    owner_free(fresh);
    free(z);
    owner_free(other);
    release(&c);
}

/* In SI units a pressure matrix may be of order 1e-12 and its residual of
 * order 1e-30: products of the two are lost in single precision. */
FACT(units_do_not_matter)
{
    struct cycle c = one_cycle(links_cube(16, 16, 16));
    double *const z = alloc_doubles(c.b.n);

    multigrid_apply(c.mg, c.r, c.z);
    for (int e = 0; e < 2 * c.b.n_links; e++)
        c.A->a[e] *= 0x1p-140;
    for (int i = 0; i < c.b.n; i++) {
        c.A->diag[i] *= 0x1p-140;
        c.r[i] *= 0x1p-200;
    }
    set_from(with(c.mg), c.A);
    multigrid_apply(c.mg, c.r, z);
    for (int i = 0; i < c.b.n; i++) /* powers of two: the same digits */
        ck_assert_double_eq(c.z[i] * 0x1p-60, z[i]);
    free(z);
    release(&c);
}

FACT(threads_do_not_change_a_bit)
{
    struct cycle c = one_cycle(links_cube(50, 40, 30));
    double *const two = alloc_doubles(c.b.n);

    multigrid_apply(c.mg, c.r, c.z);
    omp_set_num_threads(2);
    set_from(with(c.mg), c.A);
    multigrid_apply(c.mg, c.r, two);
    ck_assert_mem_eq(c.z, two, (size_t)c.b.n * sizeof *two);
    free(two);
    release(&c);
}
