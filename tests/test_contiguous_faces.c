/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/fluid.h"
#include "linear/matrix.h"
#include "linear/faces.h"
#include "linear/reduce.h"

#include "facts.h"
#include "linear_case.h"
#include "mesh/mesh.h"

static struct mesh *box(int nx, int ny, int nz, int periodic)
{
    const struct box_spec spec = {{1.0, 0.7, 0.4},
                                  {nx, ny, nz},
                                  {1.3, 1.0, 0.8},
                                  {periodic, 0, periodic}};

    return mesh_create_box(&spec);
}

static struct face_pieces *runs_of(const struct mesh *m)
{
    return faces_find_pieces(m->n_internal, m->n_faces, m->owner, m->neighbour);
}

/* Odd sizes, so that rows end anywhere in a range; and one cell thick. */
static const struct {
    int n[3], periodic;
} boxes[] = {{{17, 13, 9}, 0}, {{17, 13, 9}, 1}, {{64, 40, 1}, 0}};

FACT_FOR_EACH(each_face_occurs_once_from_its_owner, 3)
{
    struct mesh *const m =
        box(boxes[_i].n[0], boxes[_i].n[1], boxes[_i].n[2], boxes[_i].periodic);
    struct face_pieces *const r = runs_of(m);
    int *const met = alloc_ints(m->n_faces);

    ck_assert_ptr_nonnull(r);
    for (int first = 0; first < m->n_cells; first += 50) {
        const int last = first + 50 < m->n_cells ? first + 50 : m->n_cells;
        struct face_piece p = {0};
        while (faces_next_of_owners(r, first, last, &p))
            for (int j = 0; j < p.n; j++) {
                const int f = p.face + j;
                ck_assert(p.cell + j >= first && p.cell + j < last);
                ck_assert_int_eq(p.cell + j, m->owner[f]);
                if (f < m->n_internal)
                    ck_assert_int_eq(p.other + j, m->neighbour[f]);
                met[f]++;
            }
    }
    for (int f = 0; f < m->n_faces; f++)
        ck_assert_int_eq(met[f], 1);
    free(met);
    owner_free(r);
    mesh_free(m);
}

/* The division into ranges for the threads must not matter. */
FACT_FOR_EACH(each_cell_has_its_faces_in_one_order, 3)
{
    struct mesh *const m =
        box(boxes[_i].n[0], boxes[_i].n[1], boxes[_i].n[2], boxes[_i].periodic);
    struct face_pieces *const r = runs_of(m);
    const int n = m->n_cells, lengths[] = {n, 100, 7};
    int *const seen = alloc_ints(n * 8), *const of = alloc_ints(n);

    for (int a = 0; a < 3; a++) {
        memset(of, 0, (size_t)n * sizeof *of);
        for (int first = 0; first < n; first += lengths[a]) {
            const int last = first + lengths[a] < n ? first + lengths[a] : n;
            struct face_piece p = {0};
            while (faces_next_of_cells(r, first, last, &p))
                for (int j = 0; j < p.n; j++) {
                    const int c = p.cell + j, f = p.face + j;
                    const int own = p.out > 0.0;
                    ck_assert(c >= first && c < last);
                    ck_assert_int_eq(c, own ? m->owner[f] : m->neighbour[f]);
                    if (f < m->n_internal)
                        ck_assert_int_eq(p.other + j,
                                         own ? m->neighbour[f] : m->owner[f]);
                    if (a == 0) seen[8 * c + of[c]] = f;
                    ck_assert_int_eq(seen[8 * c + of[c]], f);
                    of[c]++;
                }
        }
        for (int c = 0; c < n; c++)
            ck_assert_int_eq(of[c], m->cell_start[c + 1] - m->cell_start[c]);
    }
    free(seen);
    free(of);
    owner_free(r);
    mesh_free(m);
}

/* Pieces of 96, 88, ... 8 faces with a cell between two: the place of a cell
 * among equal pieces would be one too far on. */
FACT(a_piece_is_found_among_unequal_ones)
{
    enum { PIECES = 12, CELLS = 4 * PIECES * (PIECES + 1) + PIECES };
    int owner[CELLS], neighbour[CELLS], met[CELLS] = {0}, n = 0, cell = 0;

    for (int i = PIECES; i > 0; i--, cell++)
        for (int j = 0; j < 8 * i; j++, cell++, n++) {
            owner[n] = cell;
            neighbour[n] = cell + 1;
        }
    struct face_pieces *const r = faces_find_pieces(n, n, owner, neighbour);
    ck_assert_ptr_nonnull(r);
    for (int first = 0; first < CELLS; first += 5) {
        struct face_piece p = {0};
        while (faces_next_of_owners(r, first, first + 5, &p))
            for (int j = 0; j < p.n; j++) {
                ck_assert_int_eq(owner[p.face + j], p.cell + j);
                met[p.face + j]++;
            }
    }
    for (int f = 0; f < n; f++)
        ck_assert_int_eq(met[f], 1);
    owner_free(r);
}

/* As in a patch that goes round a corner. */
FACT(the_faces_of_a_piece_have_one_axis)
{
    enum { FACES = 48 };
    int owner[FACES], n = 0;
    double S[3 * FACES] = {0.0};
    struct faces f = {.n = FACES, .n_cells = FACES, .owner = owner, .S = S};
    struct face_piece p = {0};

    for (int i = 0; i < FACES; i++) {
        owner[i] = i;
        S[3 * i + 2 * i / FACES] = 1.0;
    }
    faces_divide(&f);
    ck_assert(faces_aligned(&f));
    for (; faces_next_of_owners(f.pieces, 0, FACES, &p); n++) {
        ck_assert_int_eq(p.n, FACES / 2);
        ck_assert_int_eq(p.axis, n);
    }
    ck_assert_int_eq(n, 2);
    owner_free(f.pieces);
    S[1] = 0.5; /* a face that has none */
    f.area = NULL;
    faces_divide(&f);
    ck_assert(f.pieces != NULL && !faces_aligned(&f));
    owner_free(f.pieces);
}

FACT(faces_in_disorder_have_no_contiguous_ranges)
{
    struct links b = links_cube(12, 12, 12);

    links_shuffle(&b, 3);
    ck_assert_ptr_null(
        faces_find_pieces(b.n_links, b.n_links, b.owner, b.neighbour));
    links_free(&b);
}

/* By runs, by rows, and term by term. Seven terms of order 1. */
FACT_FOR_EACH(product_by_contiguous_faces_is_that_by_rows, 3)
{
    struct mesh *const m =
        box(boxes[_i].n[0], boxes[_i].n[1], boxes[_i].n[2], boxes[_i].periodic);
    struct face_pieces *const r = runs_of(m);
    const int n = m->n_cells, links = m->n_internal;
    struct ldu *const fast = ldu_create(n, links, m->owner, m->neighbour, r);
    struct ldu *const rows = ldu_create(n, links, m->owner, m->neighbour, NULL);
    double *const x = noise_vector(3 * n, 1), *const d = noise_vector(3 * n, 2);
    double *const upper = noise_vector(links, 3);
    double *const lower = noise_vector(links, 4);
    double *const y = alloc_doubles(3 * n), *const z = alloc_doubles(3 * n);
    double *const sum = alloc_doubles(n), *const plain = alloc_doubles(n);

    memcpy(fast->upper, upper, (size_t)links * sizeof *upper);
    memcpy(rows->upper, upper, (size_t)links * sizeof *upper);
    memcpy(fast->lower, lower, (size_t)links * sizeof *lower);
    memcpy(rows->lower, lower, (size_t)links * sizeof *lower);
    ldu_update(fast);
    ldu_update(rows);
    for (int own = 0; own < 2; own++) {
        ldu_rows(0, n, fast, own ? d : NULL, x, y);
        ldu_rows(0, n, rows, own ? d : NULL, x, z);
        for (int i = 0; i < 3 * n; i++)
            ck_assert_double_eq_tol(y[i], z[i], 1e-14);
    }
    for (int i = 0; i < 3 * n; i++)
        z[i] = d[i] * x[i];
    for (int l = 0; l < links; l++)
        for (int k = 0; k < 3; k++) {
            const int o = m->owner[l], e = m->neighbour[l];
            z[3 * o + k] += upper[l] * x[3 * e + k];
            z[3 * e + k] += lower[l] * x[3 * o + k];
        }
    for (int i = 0; i < 3 * n; i++)
        ck_assert_double_eq_tol(y[i], z[i], 1e-14);
    ldu_row_sums(0, n, fast, sum);
    ldu_row_sums(0, n, rows, plain);
    for (int i = 0; i < n; i++)
        ck_assert_double_eq_tol(sum[i], plain[i], 1e-14);
    free(x);
    free(d);
    free(upper);
    free(lower);
    free(y);
    free(z);
    free(sum);
    free(plain);
    owner_free(fast);
    owner_free(rows);
    owner_free(r);
    mesh_free(m);
}

FACT(one_number_times_three_is_as_in_a_plain_loop)
{
    enum { N = 300 }; /* two blocks and some */
    double *const a = noise_vector(N, 1), *const x = noise_vector(3 * N, 2);
    double *const y = noise_vector(3 * N, 3), *const z = noise_vector(3 * N, 3);
    double sum[3] = {1.0, 2.0, 3.0}, plain[3] = {1.0, 2.0, 3.0};

    vec3_add(N, -2.0, a, x, y);
    vec3_sum(N, a, x, sum);
    for (int i = 0; i < 3 * N; i++) {
        z[i] += -2.0 * a[i / 3] * x[i];
        plain[i % 3] += a[i / 3] * x[i];
        ck_assert_double_eq(y[i], z[i]);
    }
    for (int k = 0; k < 3; k++) /* another order of 300 terms */
        ck_assert_double_eq_tol(sum[k], plain[k], 1e-13);
    free(a);
    free(x);
    free(y);
    free(z);
}

/* Anything from -1 to 1. */
static double any(int i)
{
    return sin(9.0 * i * i + i);
}

enum bed { WHOLE_GRADIENT, SHARED_GRADIENT, NO_BED };
enum way { ALIGNED, BY_VECTORS, BY_LISTS };

/* A bed of any eps, forces and friction that jump, grains that move. */
static void stir(struct fluid *fl, int n)
{
    for (int c = 0; c < fl->mesh->n_cells; c++) {
        fl->eps[c] += 0.01 * any(c + n);
        fl->K[c] = 1e4 * (1.0 + any(3 * c));
        for (int k = 0; k < 3; k++) {
            fl->F[3 * c + k] = 100.0 * any(5 * c + k);
            fl->eps_us[3 * c + k] = 0.01 * any(7 * c + k + n);
        }
    }
}

/* A few steps of a flow in which all terms are at work, from an inlet to an
 * outlet. */
static struct fluid *flow(const struct mesh *m, const struct boundary *b,
                          int bed, enum way way)
{
    const int shared = bed == SHARED_GRADIENT;
    const struct fluid_options o = {
        .rho = 1000.0,
        .mu = 0.1,
        .dt = 1e-2,
        .convection = convection_scheme_named(bed ? "linear" : "upwind"),
        .continuity = shared ? CONTINUITY_MIXTURE : CONTINUITY_VOID_RATE,
        .correctors = 3,
        .tolerance = 1e-13,
        .coupled = bed != NO_BED,
        .pressure_shared = shared,
        .boundaries = b};
    struct fluid *const fl = fluid_create(m, &o);
    struct face_pieces *const runs = fl->faces->pieces;
    double *const area = fl->faces->area;

    ck_assert_ptr_nonnull(runs);
    ck_assert_ptr_nonnull(area);
    if (way == BY_LISTS) fl->faces->pieces = NULL;
    if (way == BY_VECTORS) fl->faces->area = NULL;
    for (int c = 0; c < m->n_cells && bed != NO_BED; c++)
        fl->eps[c] = 0.7 + 0.2 * any(c);
    fluid_reset_eps_history(fl);
    for (int n = 0; n < 3; n++) {
        if (bed != NO_BED) stir(fl, n);
        ck_assert_int_eq(fluid_step(fl), 0);
        ck_assert_double_lt(fl->report.mass_residual, 1e-9);
    }
    fl->faces->pieces = runs;
    fl->faces->area = area;
    return fl;
}

static const double U = 0.3, zero = 0.0;
static const struct box_spec column = {
    {0.1, 0.2, 0.1}, {10, 9, 8}, {1.0, 2.0, 1.0}, {0, 0, 1}};
static const struct boundary around[6] = {
    {.kind = BOUNDARY_NO_SLIP},
    {.kind = BOUNDARY_SLIP},
    {.kind = BOUNDARY_INLET, .n_points = 1, .time = &zero, .velocity = &U},
    {.kind = BOUNDARY_OUTLET}};

FACT_FOR_EACH(a_flow_is_the_same_by_lists_and_by_contiguous_faces, 3)
{
    struct mesh *const m = mesh_create_box(&column);
    struct fluid *const runs = flow(m, around, _i, ALIGNED);
    struct fluid *const lists = flow(m, around, _i, BY_LISTS);
    double u = 0.0, p = 0.0, phi = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        u = fmax(u, fabs(runs->u[3 * c + 1]));
        p = fmax(p, fabs(runs->p[c]));
    }
    for (int f = 0; f < m->n_faces; f++)
        phi = fmax(phi, fabs(runs->phi[f]));
    ck_assert_double_gt(u, 0.3);
    for (int i = 0; i < 3 * m->n_cells; i++)
        ck_assert_double_eq_tol(runs->u[i], lists->u[i], 1e-9 * u);
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq_tol(runs->p[c], lists->p[c], 1e-9 * p);
    for (int f = 0; f < m->n_faces; f++)
        ck_assert_double_eq_tol(runs->phi[f], lists->phi[f], 1e-9 * phi);
    owner_free(runs);
    owner_free(lists);
    mesh_free(m);
}

FACT_FOR_EACH(one_component_of_aligned_faces_gives_the_bits_of_three, 3)
{
    struct mesh *const m = mesh_create_box(&column);
    struct fluid *const one = flow(m, around, _i, ALIGNED);
    struct fluid *const three = flow(m, around, _i, BY_VECTORS);

    for (int i = 0; i < 3 * m->n_cells; i++)
        ck_assert_double_eq(one->u[i], three->u[i]);
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq(one->p[c], three->p[c]);
    for (int i = 0; i < 3 * m->n_cells; i++)
        ck_assert_double_eq(one->grad_p[i], three->grad_p[i]);
    for (int f = 0; f < m->n_faces; f++)
        ck_assert_double_eq(one->phi[f], three->phi[f]);
    owner_free(one);
    owner_free(three);
    mesh_free(m);
}

FACT(faces_that_are_not_normal_to_an_axis_have_all_components)
{
    struct mesh *const m = mesh_create_box(&column);
    struct faces f = {.n_inner = m->n_internal,
                      .n = m->n_faces,
                      .n_cells = m->n_cells,
                      .owner = m->owner,
                      .neighbour = m->neighbour,
                      .S = m->S,
                      .S_at = m->S_at};

    m->S[3 * m->S_at[m->n_internal / 2]] = 1e-20; /* of a face across y */
    faces_divide(&f);
    ck_assert_ptr_nonnull(f.pieces);
    ck_assert_int_eq(faces_aligned(&f), 0);
    owner_free(f.pieces);
    mesh_free(m);
}
