/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/coupling.h"
#include "case/build.h"
#include "case/case_file.h"

#include "facts.h"
#include "capture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char said[CAPTURE_TEXT];

/* A case in build/, so that its mesh is beside it at ../tests/data/poly. */
static const char file[] = "build/case_mesh.cfg";
static const char sides[] =
    "bottom = { inlet = 0.5; }; top = { outlet = 0.0; }; left = \"no-slip\"; "
    "right = \"no-slip\"; front = \"slip\"; back = \"slip\";";

static struct settings *read_case(const char *mesh, const char *patches,
                                  const char *more, int *code)
{
    FILE *const f = fopen(file, "w");
    fprintf(f,
            "mesh = { %s };\nfluid = { density = 1.2; viscosity = 0.01; "
            "step = %s; %s };\noutput = { end = 100.0; every = 100.0; };\n%s\n",
            mesh, strstr(patches, "mean_gradient") ? "5.0" : "0.01", patches,
            more);
    fclose(f);
    struct capture c = capture_begin(2);
    struct settings *const s = case_file_read(file, 0, NULL, code);
    capture_end(&c, said);
    return s;
}

static void refused(const char *mesh, const char *patches, const char *part)
{
    int code;

    ck_assert_ptr_null(read_case(mesh, patches, "", &code));
    ck_assert_int_eq(code, 2);
    ck_assert_msg(strstr(said, part) != NULL, "no \"%s\" in %s", part, said);
}

static struct simulation *flow_after(int steps, const char *mesh,
                                     const char *patches)
{
    int code;
    struct settings *const s = read_case(mesh, patches, "", &code);
    ck_assert_msg(s != NULL, "%s", said);
    struct simulation *const sim = build_simulation(s, &code);
    ck_assert_ptr_nonnull(sim);
    settings_free(s);
    ck_assert_int_eq(coupling_start(sim), 0);
    for (int i = 0; i < steps; i++)
        ck_assert_int_eq(coupling_step(sim), 0);
    return sim;
}

/* The mesh of blockMesh's box is our box: so is the flow through it, to what
 * the linear solvers leave, 1e-8. */
FACT(a_box_from_files_has_the_flow_of_our_box)
{
    struct simulation *const a =
        flow_after(20, "size = [1.0, 2.0, 0.5]; cells = [4, 3, 2];", sides);
    struct simulation *const b =
        flow_after(20, "polymesh = \"../tests/data/poly/box\";", sides);

    for (int c = 0; c < a->mesh->n_cells; c++) {
        const double *const x = &a->mesh->centre[3 * c];
        const int there = mesh_cell_at(b->mesh, x[0], x[1], x[2]);
        ck_assert_double_eq_tol(a->fluid->p[c], b->fluid->p[there], 1e-7);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(a->fluid->u[3 * c + k],
                                    b->fluid->u[3 * there + k], 1e-8);
    }
    ck_assert_double_gt(a->fluid->p[0], 0.1);
    build_free(a);
    build_free(b);
}

/* Sheared by nothing the box is the box, through all that a mesh of faces
 * takes. */
FACT(a_box_sheared_by_nothing_has_the_flow_of_the_box)
{
    struct simulation *const a =
        flow_after(20, "size = [1.0, 2.0, 0.5]; cells = [4, 3, 2];", sides);
    struct simulation *const b = flow_after(
        20,
        "size = [1.0, 2.0, 0.5]; cells = [4, 3, 2]; shear = [0.0, 0.0, 0.0];",
        sides);

    for (int c = 0; c < a->mesh->n_cells; c++) {
        const double *const x = &a->mesh->centre[3 * c];
        const int there = mesh_cell_at(b->mesh, x[0], x[1], x[2]);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(a->fluid->u[3 * c + k],
                                    b->fluid->u[3 * there + k], 1e-8);
    }
    build_free(a);
    build_free(b);
}

/* A gradient along x drives a sheared box that is periodic in x and walled in
 * y; what is driven through it is Poiseuille's flow, which does not depend on
 * the shear: u(y) = G y (H - y) / (2 mu), with the error of a straight mesh. */
FACT(a_sheared_channel_has_poiseuilles_flow)
{
    double error[2];

    for (int fine = 0; fine < 2; fine++) {
        char mesh[160];
        snprintf(mesh, sizeof mesh,
                 "size = [0.5, 1.0, 1.0]; cells = [4, %d, 1]; shear = [0.5, "
                 "0.0, 0.0]; periodic = [true, false, true];",
                 fine ? 16 : 8);
        struct simulation *const sim = flow_after(
            200, mesh,
            "bottom_top = \"no-slip\"; mean_gradient = [-0.08, 0.0, 0.0];");
        error[fine] = 0.0;
        for (int c = 0; c < sim->mesh->n_cells; c++) {
            const double y = sim->mesh->centre[3 * c + 1];
            const double exact = 0.08 * y * (1.0 - y) / (2.0 * 0.01);
            error[fine] = fmax(error[fine], fabs(sim->fluid->u[3 * c] - exact));
        }
        build_free(sim);
    }
    /* Half a cell at the wall: the scheme is off by G h^2 / (8 mu). */
    ck_assert_double_eq_tol(error[0], 1.0 / 64.0, 1e-6);
    ck_assert_double_eq_tol(error[1], 1.0 / 256.0, 1e-6);
}

/* --- grains -----------------------------------------------------------------
 */

static const char bed[] =
    "particles = { contact = \"linear\"; step = 1e-4; grains = { density = "
    "1000; stiffness = 1e5; restitution = 0.5; friction = 0.3; }; bed = { "
    "count = 60; diameter = 0.1; settle = 2.0; }; };\n"
    "averaging = { method = \"diffusion\"; bandwidth = 0.3; };\n"
    "exchange = { drag = \"syamlal-obrien\"; };\n"
    "effects = { gravity = [0.0, -9.81, 0.0]; pressure_gradient = {}; };";

static struct simulation *bed_after(int steps, const char *mesh)
{
    int code;
    struct settings *const s = read_case(mesh, sides, bed, &code);
    ck_assert_msg(s != NULL, "%s", said);
    struct capture c = capture_begin(2);
    struct simulation *const sim = build_simulation(s, &code);
    capture_end(&c, said);
    ck_assert_msg(sim != NULL, "%s", said);
    settings_free(s);
    ck_assert_int_eq(coupling_start(sim), 0);
    for (int i = 0; i < steps; i++)
        ck_assert_int_eq(coupling_step(sim), 0);
    return sim;
}

/* The walls of the box from files lie in the sides of the smallest box around
 * it, so the same contacts settle the same bed; then drag and pressure come
 * through two meshes, and differ by what the linear solvers leave. */
FACT(a_box_from_files_has_the_bed_of_our_box)
{
    struct simulation *const a =
        bed_after(5, "size = [1.0, 2.0, 0.5]; cells = [4, 3, 2];");
    struct simulation *const b =
        bed_after(5, "polymesh = \"../tests/data/poly/box\";");
    const struct particles *const p = a->particles, *const q = b->particles;

    ck_assert_int_eq(p->n, 60);
    ck_assert_int_eq(b->n_surfaces, 0);
    ck_assert_int_eq(q->n, 60);
    for (int i = 0; i < p->n; i++) {
        ck_assert_double_eq_tol(p->x[i], q->x[i], 1e-9);
        ck_assert_double_eq_tol(p->y[i], q->y[i], 1e-9);
        ck_assert_double_eq_tol(p->z[i], q->z[i], 1e-9);
        ck_assert_double_eq_tol(p->vy[i], q->vy[i], 1e-7);
    }
    for (int c = 0; c < a->mesh->n_cells; c++) {
        const double *const x = &a->mesh->centre[3 * c];
        const int there = mesh_cell_at(b->mesh, x[0], x[1], x[2]);
        ck_assert_double_eq_tol(a->fluid->eps[c], b->fluid->eps[there], 1e-7);
        ck_assert_double_eq_tol(a->fluid->p[c], b->fluid->p[there], 1e-6);
    }
    build_free(a);
    build_free(b);
}

/* Slanted walls hold the grains for any mesh and any numbering: each grain has
 * a cell, and a distance of nearly its radius or more from all planes. */
FACT_FOR_EACH(slanted_walls_hold_the_grains, 3)
{
    static const char *const meshes[] = {
        "polymesh = \"../tests/data/poly/sheared\";",
        "polymesh = \"../tests/data/poly/shuffled\";",
        "size = [1.0, 2.0, 0.5]; cells = [8, 8, 3]; shear = [0.3, 0.0, 0.0];"};
    struct simulation *const sim = bed_after(50, meshes[_i]);
    const struct mesh *const m = sim->mesh;

    ck_assert_int_eq(sim->n_surfaces, 1);
    ck_assert_int_eq(sim->particles->n, 60);
    for (int i = 0; i < 60; i++) {
        const double x[3] = {sim->particles->x[i], sim->particles->y[i],
                             sim->particles->z[i]};
        double offset[3];
        ck_assert_int_ge(mesh_cell_and_offset(m, x, offset), 0);
        for (int f = m->n_internal; f < m->n_faces; f++) {
            double out = 0.0, S = 0.0;
            for (int k = 0; k < 3; k++) {
                out += (x[k] - m->face_centre[3 * f + k]) * mesh_S(m, f)[k];
                S += mesh_S(m, f)[k] * mesh_S(m, f)[k];
            }
            ck_assert_double_lt(out / sqrt(S), -0.99 * 0.05);
        }
    }
    build_free(sim);
}

FACT(unsupported_particle_features_on_a_polyhedral_mesh_are_refused)
{
    static const char box[] = "polymesh = \"../tests/data/poly/sheared\";";
    static const char grains[] =
        "particles = { contact = \"linear\"; step = 5e-5; grains = { density "
        "= 1000; stiffness = 1e5; restitution = 0.5; friction = 0.3; }; "
        "place = ( { position = [%s]; diameter = 0.1; } ); };\n";
    char more[512];
    int code;

    snprintf(more, sizeof more, grains, "0.05, 0.9, 0.25");
    ck_assert_ptr_null(read_case(box, sides, more, &code));
    ck_assert_ptr_nonnull(strstr(said, "is not inside the mesh"));
    snprintf(more, sizeof more, grains, "0.55, 0.5, 0.25");
    ck_assert_ptr_null(
        read_case("size = [1.0, 1.0, 0.5]; cells = [4, 4, 2]; shear = [0.3, "
                  "0.0, 0.0]; periodic = [false, true, false];",
                  "sides = \"no-slip\"; front_back = \"slip\";", more, &code));
    ck_assert_ptr_nonnull(strstr(said, "a period must be along x, y or z"));
}

FACT(patches_go_by_their_own_names)
{
    static const char box[] = "polymesh = \"../tests/data/poly/box\";";

    refused(box, "bottom = { inlet = 0.5; }; topp = { outlet = 0.0; };",
            "fluid.topp: no such key; did you mean fluid.top,");
    refused(
        box, "bottom = { inlet = 0.5; }; top = { outlet = 0.0; };",
        "the patch left, 6 faces with 1 m^2, has no boundary condition: give "
        "fluid.left");
    refused(box, "sides = \"slip\";", "fluid.sides: no such key");
    refused("polymesh = \"../tests/data/poly/cyclic\";", "left = \"slip\";",
            "fluid.left: no such key");
    refused("polymesh = \"../tests/data/poly/sheared\";",
            "left = { wall = [0.0, 1.0, 0.0]; }; bottom = \"slip\"; top = "
            "\"slip\"; right = \"slip\"; front = \"slip\"; back = \"slip\";",
            "move through itself");
}

FACT(a_mesh_is_a_box_or_from_files)
{
    refused("polymesh = \"nowhere\";", "",
            "case_mesh.cfg:1: mesh.polymesh: there is no mesh in the folder "
            "build/nowhere");
    refused("polymesh = \"../tests/data/poly/box\"; size = [1, 1, 1];", sides,
            "mesh.size: the mesh comes from files");
    refused("cells = [1, 1, 1];", sides, "mesh.size is missing");
}

/* Nothing flows through it; the box of one cell has one. */
FACT(a_patch_of_no_faces_needs_no_condition)
{
    int code;
    struct settings *const s =
        read_case("polymesh = \"../tests/data/poly/one-cell\";",
                  "bottom = \"no-slip\"; top = \"slip\";", "", &code);

    ck_assert_msg(s != NULL, "%s", said);
    settings_free(s);
    refused("polymesh = \"../tests/data/poly/one-cell\";",
            "bottom = \"no-slip\";", "the patch top, 1 faces");
}

FACT(a_file_of_gmsh_is_refused_with_what_makes_a_folder_of_it)
{
    refused("polymesh = \"case_mesh.cfg\";", sides,
            "found the file build/case_mesh.cfg; gmshToFoam makes one");
}
