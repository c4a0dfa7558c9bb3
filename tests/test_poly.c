/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/measures.h"
#include "fluid/fluid.h"
#include "mesh/poly/poly.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "boxes.h"
#include "facts.h"
#include "capture.h"
#include "cloud.h"
#include "warped.h"

static const char *const all[] = {"box", "sheared", "shuffled", "dual",
                                  "cyclic"};

static struct mesh *mesh_of(const char *name)
{
    char dir[128];
    snprintf(dir, sizeof dir, "tests/data/poly/%s", name);
    struct mesh *const m = poly_read(dir, NULL);
    ck_assert_ptr_nonnull(m);
    return m;
}

static double volume(const struct mesh *m)
{
    double sum = 0.0;
    for (int c = 0; c < m->n_cells; c++)
        sum += m->V[c];
    return sum;
}

/* A block of 1 x 2 x 0.5 m in 4 x 3 x 2 cells: the same faces, volumes and
 * links as our own box. */
FACT(a_block_is_our_box)
{
    struct mesh *const m = mesh_of("box"), *const b = closed_box(1.0, 2.0, 0.5,
                                                                 4, 3, 2);
    ck_assert_int_eq(m->n_cells, b->n_cells);
    ck_assert_int_eq(m->n_faces, b->n_faces);
    ck_assert_int_eq(m->n_internal, b->n_internal);
    ck_assert_int_eq(m->oblique, 0);
    for (int c = 0; c < m->n_cells; c++) {
        const double *const x = &m->centre[3 * c];
        const int there = mesh_cell_at(b, x[0], x[1], x[2]);
        ck_assert_double_eq_tol(m->V[c], b->V[there], 1e-12);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(x[k], b->centre[3 * there + k], 1e-9);
    }
    for (int i = 0; i < 6; i++) {
        const struct patch *const p = mesh_patch(m, b->patches[i].name);
        ck_assert_ptr_nonnull(p);
        ck_assert_int_eq(p->n, b->patches[i].n);
        double S[3] = {0.0, 0.0, 0.0}, ours[3] = {0.0, 0.0, 0.0};
        for (int j = 0; j < 3 * p->n; j++) {
            S[j % 3] += mesh_S(m, p->first + j / 3)[j % 3];
            ours[j % 3] += mesh_S(b, b->patches[i].first + j / 3)[j % 3];
        }
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(S[k], ours[k], 1e-12);
    }
    mesh_free(m);
    mesh_free(b);
}

/* 1 if the inner faces come by their owners, or by how far apart their cells
 * are and then by owners. */
static int in_order(const struct mesh *m)
{
    int by_owner = 1, by_distance = 1;

    for (int f = 1; f < m->n_internal; f++) {
        const int up = m->owner[f] - m->owner[f - 1];
        const int apart = m->neighbour[f] - m->neighbour[f - 1] - up;
        by_owner &= up >= 0;
        by_distance &= apart > 0 || (apart == 0 && up > 0);
    }
    return by_owner || by_distance;
}

/* Owner before neighbour, S along d, cells closed, volumes that fill what they
 * fill. The dual has 24 cells with more than six faces. */
FACT_FOR_EACH(every_mesh_is_closed_and_in_order, 5)
{
    const double V[] = {1.0, 0.5, 0.5, 1.0, 0.2};
    struct mesh *const m = mesh_of(all[_i]);
    const struct mesh_quality q = mesh_quality(m);
    int many = 0;
    ck_assert_double_lt(q.openness, 1e-10);
    ck_assert_double_eq_tol(volume(m), V[_i], 1e-9);
    for (int f = 0; f < m->n_internal; f++) {
        double Sd = 0.0;
        for (int k = 0; k < 3; k++)
            Sd += mesh_S(m, f)[k] * mesh_d(m, f)[k];
        ck_assert_int_lt(m->owner[f], m->neighbour[f]);
        ck_assert_double_gt(Sd, 0.0);
    }
    ck_assert(in_order(m));
    for (int c = 0; c < m->n_cells; c++)
        many += m->cell_start[c + 1] - m->cell_start[c] > 6;
    if (_i == 3) ck_assert_int_eq(many, 24);
    if (_i == 1) /* the shear is 0.4 in 1 */
        ck_assert_double_gt(q.non_orthogonal, 21.0);
    mesh_free(m);
}

/* Hexahedra, 6 x 6 x 2 of them, bent and numbered at random: they stand in rows
 * again, with one distance a direction. */
FACT(shuffled_hexahedra_are_put_in_rows)
{
    struct mesh *const m = mesh_of("shuffled");
    int between[73] = {0};
    for (int f = 0; f < m->n_internal; f++)
        between[m->neighbour[f] - m->owner[f]]++;
    ck_assert_int_eq(between[1], 5 * 6 * 2);
    ck_assert_int_eq(between[6], 6 * 5 * 2);
    ck_assert_int_eq(between[36], 6 * 6 * 1);
    for (int i = 0; i < m->n_patches; i++) /* one face a cell in each */
        for (int j = 1; j < m->patches[i].n; j++) {
            const int *const cell = &m->owner[m->patches[i].first];
            ck_assert_int_lt(cell[j - 1], cell[j]);
        }
    mesh_free(m);
}

static int widest(const struct mesh *m)
{
    int most = 0;
    for (int f = 0; f < m->n_internal; f++)
        most = m->neighbour[f] - m->owner[f] > most
                   ? m->neighbour[f] - m->owner[f]
                   : most;
    return most;
}

/* Polyhedra have no rows. With their numbers multiplied, modulo how many there
 * are, any two may touch; in waves they come as close as they were. */
FACT(shuffled_polyhedra_are_put_in_waves)
{
    struct mesh *const filed = mesh_of("dual");
    char command[256];
    snprintf(command, sizeof command,
             "mkdir -p build/poly-waves && cd build/poly-waves && "
             "for f in ../../tests/data/poly/dual/*; do awk '/^[0-9]+$/ && "
             "FILENAME ~ /owner|neighbour/ && begun++ { print $1 * 11 %% %d; "
             "next } { print }' $f >${f##*/}; done",
             filed->n_cells);
    ck_assert_int_eq(filed->n_cells % 11 == 0, 0);
    ck_assert_int_eq(system(command), 0);
    struct mesh *const m = poly_read("build/poly-waves", NULL);
    ck_assert_ptr_nonnull(m);
    ck_assert_int_eq(m->n_internal, filed->n_internal);
    ck_assert_int_le(widest(m), 3 * widest(filed) / 2);
    ck_assert_int_lt(widest(m), m->n_cells / 2);
    mesh_free(m);
    mesh_free(filed);
}

/* Two cells with two faces each in a patch: one of each, and again. */
FACT(faces_of_a_patch_come_one_a_cell)
{
    int owner[] = {1, 0, 0, 1}, number[] = {0, 1};
    struct poly_part part = {.n = 4};
    const struct poly_raw r = {.n_faces = 4,
                               .n_cells = 2,
                               .n_parts = 1,
                               .owner = owner,
                               .number = number,
                               .part = &part};
    const int expected[] = {1, 0, 2, 3};
    int *const order = poly_boundary_order(&r);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(order[i], expected[i]);
    free(order);
}

/* Each centre, and points anywhere, from any cell; the cell found is the one
 * whose faces the point is behind. */
FACT_FOR_EACH(a_walk_finds_the_cell_of_a_point, 5)
{
    struct mesh *const m = mesh_of(all[_i]);
    for (int c = 0; c < m->n_cells; c++) {
        const double *const x = &m->centre[3 * c];
        double offset[3];
        for (int from = 0; from < m->n_cells; from += 7)
            ck_assert_int_eq(locate_from(m, from, x, offset), c);
        ck_assert_int_eq(mesh_cell_at(m, x[0], x[1], x[2]), c);
    }
    const double outside[3] = {-1.0, 0.1, 0.1};
    double none[3];
    if (m->n_periods == 0)
        ck_assert_int_eq(locate_from(m, 0, outside, none), -1);
    mesh_free(m);
}

/* On a cyclic mesh: points near each centre and near each face, as they are and
 * moved by a few periods, belong to one cell, and the way to them from its
 * centre is the same. */
FACT(a_period_more_is_the_same_point)
{
    struct mesh *const m = mesh_of("cyclic");
    ck_assert_int_eq(m->n_periods, 1);
    for (int a = 0; a < m->cell_start[m->n_cells]; a++) {
        const int f = m->cell_face[a];
        int c = 0;
        while (m->cell_start[c + 1] <= a)
            c++;
        const double share = m->out[a] > 0.0 ? 1.0 - m->w[f] : -m->w[f];
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = m->centre[3 * c + k] + 0.99 * share * mesh_d(m, f)[k];
        for (int laps = -2; laps < 3; laps++) {
            double y[3], offset[3];
            for (int k = 0; k < 3; k++)
                y[k] = x[k] + laps * m->period[0][k];
            ck_assert_int_eq(mesh_cell_and_offset(m, y, offset), c);
            for (int k = 0; k < 3; k++)
                ck_assert_double_eq_tol(m->centre[3 * c + k] + offset[k], x[k],
                                        1e-12);
        }
    }
    mesh_free(m);
}

/* How many cells have the point behind all their faces, and the last one. */
static int holders(const struct mesh *m, const double x[3], int *last)
{
    int n = 0;

    for (int c = 0; c < m->n_cells; c++) {
        int in = 1;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            double out = 0.0;
            for (int k = 0; k < 3; k++)
                out += m->out[a] * mesh_S(m, f)[k] *
                       (x[k] - m->face_centre[3 * f + k]);
            in &= out <= 0.0;
        }
        n += in;
        if (in) *last = c;
    }
    return n;
}

/* Points at random in a mesh of warped faces: those that one cell holds belong
 * to it; those in gaps and overlaps, and there are some, to one cell too. */
FACT(every_point_of_a_warped_mesh_has_one_cell)
{
    struct mesh *const m = warped();
    uint64_t state = 9;
    int gaps = 0, overlaps = 0;

    for (int i = 0; i < 8000; i++) {
        const double y = cloud_random(&state);
        const double x[3] = {0.4 * y + cloud_random(&state), y,
                             0.5 * cloud_random(&state)};
        double offset[3];
        int only = -1;
        const int n = holders(m, x, &only);
        const int c = mesh_cell_and_offset(m, x, offset);
        ck_assert_int_ge(c, 0);
        if (n == 1) ck_assert_int_eq(c, only);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(m->centre[3 * c + k] + offset[k], x[k],
                                    1e-12);
        gaps += n == 0;
        overlaps += n > 1;
    }
    ck_assert_int_gt(gaps, 0);
    ck_assert_int_gt(overlaps, 0);
    mesh_free(m);
}

/* Round a corner: the way from the near cell leads through the wall. */
FACT(a_point_behind_a_corner_is_found)
{
    struct poly_raw r = {0};
    struct mesh *m;

    ck_assert_int_eq(poly_raw_read(&r, "tests/data/poly/sheared"), 0);
    for (int i = 0; i < r.n_points; i++) { /* a quarter of a ring */
        double *const x = &r.point[3 * i];
        const double s = 0.5 + x[0] - 0.4 * x[1], turn = 1.5 * M_PI * x[1];
        x[0] = s * cos(turn);
        x[1] = s * sin(turn);
    }
    m = poly_build(&r, "ring");
    ck_assert_ptr_nonnull(m);
    double offset[3];
    for (int c = 0; c < m->n_cells; c++)
        for (int from = 0; from < m->n_cells; from++)
            ck_assert_int_eq(locate_from(m, from, &m->centre[3 * c], offset),
                             c);
    const double middle[3] = {0.0, 0.0, 0.25};
    ck_assert_int_eq(mesh_cell_and_offset(m, middle, offset), -1);
    poly_raw_release(&r);
    mesh_free(m);
}

/* --- flow ------------------------------------------------------------------
 */

static struct fluid *still(const struct mesh *m, struct boundary *b)
{
    for (int i = 0; i < m->n_patches; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_NO_SLIP};
    const struct fluid_options o = {
        .rho = 1.0,
        .mu = 0.1,
        .dt = 0.01,
        .convection = convection_scheme_named("linear"),
        .velocity_gradient = velocity_gradient_scheme_named("least-squares"),
        .correctors = 3,
        .piso_tolerance = 1e-6,
        .tolerance = 1e-10,
        .boundaries = b};
    return fluid_create(m, &o);
}

/* Walls that all move with one velocity: so does the fluid, on any mesh, any
 * step; the volume through a face is u . S. */
FACT_FOR_EACH(a_uniform_stream_stays_uniform_on_any_mesh, 10)
{
    static const double U[3] = {0.3, -0.2, 0.1};
    struct mesh *const m = mesh_of(all[_i % 5]);
    struct boundary b[6];
    struct fluid *const fl = still(m, b);
    fl->options.dt = _i < 5 ? 0.01 : 1.0;
    for (int i = 0; i < m->n_patches; i++)
        for (int k = 0; k < 3; k++)
            b[i].wall[k] = U[k];
    for (int i = 0; i < 3 * m->n_cells; i++)
        fl->u[i] = U[i % 3];
    for (int f = 0; f < m->n_faces; f++)
        for (int k = 0; k < 3; k++)
            fl->phi[f] += U[k] * mesh_S(m, f)[k];
    for (int n = 0; n < 5; n++)
        ck_assert_int_eq(fluid_step(fl), 0);
    for (int i = 0; i < 3 * m->n_cells; i++)
        ck_assert_double_eq_tol(fl->u[i], U[i % 3], 1e-8);
    owner_free(fl);
    mesh_free(m);
}

/* Whatever eps is and whatever it drags on, on any mesh, over any step: nothing
 * drives a fluid at rest, and nothing moves. */
FACT_FOR_EACH(fluid_at_rest_stays_at_rest_on_any_mesh, 10)
{
    struct mesh *const m = mesh_of(all[_i % 5]);
    struct boundary b[6];
    struct fluid *const made = still(m, b);
    struct fluid_options o = made->options;
    owner_free(made);
    o.coupled = o.pressure_shared = 1;
    o.dt = _i < 5 ? 0.01 : 100.0;
    struct fluid *const fl = fluid_create(m, &o);
    for (int c = 0; c < m->n_cells; c++) {
        fl->eps[c] = 0.7 + 0.3 * sin(5.0 * c);
        fl->K[c] = c % 3 ? 0.0 : 1e8;
    }
    fluid_reset_eps_history(fl);
    for (int n = 0; n < 3; n++)
        ck_assert_int_eq(fluid_step(fl), 0);
    for (int i = 0; i < 3 * m->n_cells; i++)
        ck_assert_double_eq(fl->u[i], 0.0);
    owner_free(fl);
    mesh_free(m);
}

/* A lid in the sheared block: the same cells in another order, the same flow,
 * to what the solvers leave. */
FACT(the_order_of_the_cells_does_not_matter_to_the_flow)
{
    double u[2][216];
    for (int i = 0; i < 2; i++) {
        struct mesh *const m = mesh_of(i ? "shuffled" : "sheared");
        struct mesh *const first = mesh_of("sheared");
        struct boundary b[6];
        struct fluid *const fl = still(m, b);
        b[mesh_patch(m, "top") - m->patches].wall[0] = 1.0;
        for (int n = 0; n < 40; n++)
            ck_assert_int_eq(fluid_step(fl), 0);
        ck_assert_double_gt(fluid_kinetic_energy(fl), 1e-4);
        ck_assert_double_lt(fl->report.momentum_residual, 1e-10);
        for (int c = 0; c < 72; c++) {
            const double *const x = &first->centre[3 * c];
            memcpy(&u[i][3 * c], &fl->u[3 * mesh_cell_at(m, x[0], x[1], x[2])],
                   3 * sizeof(double));
        }
        owner_free(fl);
        mesh_free(m);
        mesh_free(first);
    }
    for (int j = 0; j < 216; j++)
        ck_assert_double_eq_tol(u[0][j], u[1][j], 1e-6);
}

/* --- files that are wrong ----------------------------------------------------
 */

/* The box with one text in one file replaced. */
static void spoil(const char *name, const char *old, const char *by)
{
    static const char *const files[] = {"points", "faces", "owner", "neighbour",
                                        "boundary"};
    ck_assert_int_eq(system("mkdir -p build/poly"), 0);
    for (int i = 0; i < 5; i++) {
        char command[256];
        snprintf(command, sizeof command,
                 strcmp(files[i], name) == 0
                     ? "sed 's/%s/%s/' tests/data/poly/box/%s >build/poly/%s"
                     : "cp %.0s%.0stests/data/poly/box/%s build/poly/%s",
                 old, by, files[i], files[i]);
        ck_assert_int_eq(system(command), 0);
    }
}

/* --- as OpenFOAM writes with writeFormat binary --------------------------- */

static FILE *begin_binary(const char *name, const char *class, int label,
                          int scalar)
{
    char path[64];

    snprintf(path, sizeof path, "build/poly/%s", name);
    FILE *const f = fopen(path, "wb");
    ck_assert_ptr_nonnull(f);
    fprintf(f,
            "FoamFile\n{\n    version 2.0;\n    format binary;\n    arch "
            "\"LSB;label=%d;scalar=%d\";\n    class %s;\n    note "
            "\"nCells: 1; }\";\n}\n",
            label, scalar, class);
    return f;
}

static void put_labels(FILE *f, int label, const int *list, int n)
{
    fprintf(f, "\n%d\n", n);
    if (n == 0) return;
    fputc('(', f);
    for (int i = 0; i < n; i++) {
        const int64_t wide = list[i];
        const int32_t narrow = list[i];
        fwrite(label == 64 ? (const void *)&wide : &narrow, 1,
               (size_t)label / 8, f);
    }
    fputc(')', f);
}

static void put_faces(const struct poly_raw *r, int label, int compact)
{
    FILE *const f = begin_binary(
        "faces", compact ? "faceCompactList" : "faceList", label, 64);

    if (compact) {
        put_labels(f, label, r->start, r->n_faces + 1);
        put_labels(f, label, r->corner, r->start[r->n_faces]);
    } else
        fprintf(f, "%d\n(\n", r->n_faces);
    for (int i = 0; i < r->n_faces && !compact; i++)
        put_labels(f, label, &r->corner[r->start[i]],
                   r->start[i + 1] - r->start[i]);
    if (!compact) fputs(")\n", f);
    fclose(f);
}

/* Whole numbers of 32 or 64 bits, faces in two lists or one each. */
static void put_binary(const struct poly_raw *r, int label, int scalar,
                       int compact)
{
    FILE *f = begin_binary("points", "vectorField", label, scalar);

    fprintf(f, "%d\n(", r->n_points);
    for (int i = 0; i < 3 * r->n_points; i++) {
        const float narrow = (float)r->point[i];
        fwrite(scalar == 64 ? (const void *)&r->point[i] : &narrow, 1,
               (size_t)scalar / 8, f);
    }
    fputs(")\n", f);
    fclose(f);
    put_faces(r, label, compact);
    f = begin_binary("owner", "labelList", label, scalar);
    put_labels(f, label, r->owner, r->n_faces);
    fclose(f);
    f = begin_binary("neighbour", "labelList", label, scalar);
    put_labels(f, label, r->neighbour, r->n_inner);
    fclose(f);
}

FACT_FOR_EACH(a_binary_mesh_is_that_of_the_text, 16)
{
    static const char *const names[] = {"box", "dual"};
    const int label = _i & 1 ? 64 : 32, scalar = _i & 2 ? 64 : 32;
    char dir[64];
    struct poly_raw text = {0}, bytes = {0};

    snprintf(dir, sizeof dir, "tests/data/poly/%s", names[_i >> 3]);
    spoil("boundary", "ascii", "binary");
    ck_assert_int_eq(poly_raw_read(&text, dir), 0);
    put_binary(&text, label, scalar, _i & 4);
    if (_i >> 3)
        ck_assert_int_eq(system("cp tests/data/poly/dual/boundary build/poly"),
                         0);
    ck_assert_int_eq(poly_raw_read(&bytes, "build/poly"), 0);
    ck_assert_int_eq(bytes.n_faces, text.n_faces);
    ck_assert_int_eq(bytes.n_inner, text.n_inner);
    ck_assert_int_eq(bytes.n_cells, text.n_cells);
    ck_assert_int_eq(bytes.n_parts, text.n_parts);
    for (int i = 0; i < 3 * text.n_points; i++)
        ck_assert_double_eq(bytes.point[i], scalar == 64
                                                ? text.point[i]
                                                : (float)text.point[i]);
    for (int i = 0; i < text.start[text.n_faces]; i++)
        ck_assert_int_eq(bytes.corner[i], text.corner[i]);
    for (int f = 0; f < text.n_faces; f++)
        ck_assert_int_eq(bytes.owner[f], text.owner[f]);
    for (int f = 0; f < text.n_inner; f++)
        ck_assert_int_eq(bytes.neighbour[f], text.neighbour[f]);
    poly_raw_release(&text);
    poly_raw_release(&bytes);
}

/* One cell, as blockMesh writes it: a list of equal numbers, a dictionary in a
 * patch, and a patch of no faces, whose kind is of no interest. */
FACT(one_cell_of_equal_owners_is_read)
{
    struct mesh *const m = poly_read("tests/data/poly/one-cell", NULL);

    ck_assert_ptr_nonnull(m);
    ck_assert_int_eq(m->n_cells, 1);
    ck_assert_int_eq(m->n_faces, 6);
    ck_assert_int_eq(m->n_patches, 4);
    ck_assert_int_eq(m->patches[3].n, 0);
    ck_assert_double_eq_tol(m->V[0], 1e-6, 1e-18);
    mesh_free(m);
}

FACT_FOR_EACH(what_is_not_a_mesh_is_refused_with_file_and_line, 17)
{
    static const struct {
        const char *name, *old, *by, *message;
    } rows[] = {
        {"points", "ascii", "other", "points:4: format other is not read"},
        {"points", "ascii;", "binary; arch \"MSB;label=32;scalar=64\";",
         "points:4: arch \"MSB;label=32;scalar=64\" is not read"},
        {"points", "ascii", "binary", "points:10: the file ends too early"},
        {"owner", "ascii", "binary", "is more than there are faces"},
        {"points", "^60$", "61", "points"},
        {"faces", "4(1 6 26 21)", "4(1 6 99 21)", "point 99 of 60"},
        {"owner", "^98$", "97", "owner"},
        {"boundary", "wall;", "processor;", "type processor is not read"},
        {"boundary", "startFace *46", "startFace 40", "not of the boundary"},
        {"neighbour", "^46$", "4600000", "4600000 entries, but there are 98"},
        {"owner", "^23$", "5", "is not closed: its faces miss"},
        {"points", "(0.25 0 0)", "(0.25 9 0)", "expected > 0"},
        {"points", "(0.25 0 0)", "(0.25 1e120 0)", "at most 1e12, found 1e120"},
        {"boundary", "nFaces *8", "nFaces 7", "begins with face"},
        {"boundary", "right", "left", "the name is there twice"},
        {"faces", "4(1 6 26 21)", "2147483647(1 6 26 21)",
         "faces:11: 2147483647 entries are more than the file can hold"},
        {"points", "^60$", "600", "600 entries are more than the file can"}};
    spoil(rows[_i].name, rows[_i].old, rows[_i].by);
    struct mesh *m;
    char said[CAPTURE_TEXT];
    struct capture capture = capture_begin(2);
    m = poly_read("build/poly", NULL);
    capture_end(&capture, said);
    ck_assert_ptr_null(m);
    ck_assert_msg(strstr(said, rows[_i].message) != NULL, "%s", said);
}
