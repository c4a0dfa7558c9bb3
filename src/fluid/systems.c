/* SPDX-License-Identifier: GPL-3.0-or-later */
/* systems.c -- creates and frees what a fluid computes with. */
#include "fluid/piso.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "linear/faces.h"
#include "fluid/deferred.h"
#include "fluid/face_jump.h"
#include "fluid/systems.h"

static int systems_has(const struct fluid *fl, enum boundary_kind kind)
{
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        if (b->kind == kind) return 1;
    return 0;
}

/* 1 if a slip wall is not normal to an axis. */
static int has_inclined_slip(const struct fluid *fl)
{
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f) {
        const double *const S = mesh_S(fl->mesh, f);
        const double x = fabs(S[0]), y = fabs(S[1]), z = fabs(S[2]);
        const double smallest = fmin(fmin(x + y, y + z), z + x);
        if (b->kind == BOUNDARY_SLIP && smallest > 1e-12 * (x + y + z))
            return 1;
    }
    return 0;
}

/* 1 if the time scheme uses two old levels. */
static int two_steps(const struct fluid_options *o)
{
    return o->time != NULL && o->time->time_levels > 1;
}

/* What an array has a number for, and the condition under which it exists. A
 * ROOM has three a cell or one a face, whichever is more; WORK too, and one a
 * boundary face beyond. */
enum place { CELL, FACE, INNER_FACE, ROOM, WORK, PLACES };
enum need {
    ALWAYS,
    COUPLED,    /* with particles */
    BIASED,     /* with a nondissipative scheme */
    SMOOTH,     /* which also shares the pressure gradient with particles */
    SLIP_WALLS, /* at least one */
    TWO_STEPS,  /* in a two-step scheme */
    WEIGHTS,    /* where a force at a face follows the convecting velocity */
    OWN_FLUX,   /* if momentum is not convected by the last step's flux */
    NEEDS
};

struct array {
    double **at;
    int per; /* [-] numbers for each cell or face */
    enum place place;
    enum need need;
};

enum { MOST_ARRAYS = 64 };

/* The table of all arrays; returns their number. It does not read the mesh,
 * which may no longer exist when the arrays are freed. */
static int systems_list_arrays(struct fluid *fl, struct array list[MOST_ARRAYS])
{
    const struct array rows[] = {
        {&fl->u, 3, CELL, ALWAYS},
        {&fl->grad_p, 3, CELL, ALWAYS},
        {&fl->p, 1, CELL, ALWAYS},
        {&fl->eps, 1, CELL, ALWAYS},
        {&fl->eps_n, 1, CELL, COUPLED},
        {&fl->eps_nm1, 1, CELL, COUPLED},
        {&fl->phi, 1, FACE, ALWAYS},
        {&fl->F, 3, CELL, COUPLED},
        {&fl->eps_us, 3, CELL, COUPLED},
        {&fl->K, 1, CELL, COUPLED},
        {&fl->u_older, 3, CELL, TWO_STEPS},
        {&fl->phi_older, 1, FACE, TWO_STEPS},
        {&fl->momentum->diag, 1, CELL, ALWAYS},
        {&fl->momentum->defect, 1, CELL, ALWAYS},
        {&fl->momentum->diag3, 3, CELL, SLIP_WALLS},
        {&fl->momentum->b, 3, CELL, ALWAYS},
        {&fl->momentum->H, 3, CELL, ALWAYS},
        {&fl->momentum->owner_weight, 1, INNER_FACE, WEIGHTS},
        {&fl->pressure->source, 1, CELL, COUPLED},
        {&fl->pressure->per_force, 3, CELL, ALWAYS},
        {&fl->pressure->m_face, 1, ROOM, ALWAYS},
        {&fl->pressure->conductance, 1, ROOM, ALWAYS},
        {&fl->pressure->explicit_flux, 1, ROOM, ALWAYS},
        {&fl->pressure->work, 1, WORK, ALWAYS},
        {&fl->jump->owner_part, 1, INNER_FACE, COUPLED},
        {&fl->jump->neighbour_part, 1, INNER_FACE, COUPLED},
        {&fl->jump->pressure_offset, 1, INNER_FACE, COUPLED},
        {&fl->jump->pressure_per_flux, 1, INNER_FACE, COUPLED},
        {&fl->jump->inertia, 3, CELL, COUPLED},
        {&fl->jump->upwind_bias, 1, INNER_FACE, BIASED},
        {&fl->jump->smooth_force, 3, CELL, SMOOTH},
        {&fl->levels->ddt, 1, CELL, ALWAYS},
        {&fl->levels->old_time_source, 3, CELL, ALWAYS},
        {&fl->levels->phi_old, 1, FACE, ALWAYS},
        {&fl->levels->convecting_flux_own, 1, FACE, OWN_FLUX},
        {&fl->levels->ddt_older, 1, CELL, TWO_STEPS},
        {&fl->levels->u_known, 3, CELL, TWO_STEPS}};
    const int n = sizeof rows / sizeof *rows;

    assert(n <= MOST_ARRAYS);
    memcpy(list, rows, sizeof rows);
    return n;
}

static void allocate_arrays(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct fluid_options *const o = &fl->options;
    const int biased = piso_nondissipative(fl);
    const int vector = 3 * m->n_cells, inner = m->n_internal;
    const int count[PLACES] = {
        [CELL] = m->n_cells,
        [FACE] = m->n_faces,
        [INNER_FACE] = inner,
        [ROOM] = vector > fl->faces->n ? vector : fl->faces->n,
        [WORK] = (vector > inner ? vector : inner) + m->n_faces - inner};
    const int needed[NEEDS] = {[ALWAYS] = 1,
                               [COUPLED] = o->coupled,
                               [BIASED] = biased,
                               [SMOOTH] = biased && o->pressure_shared,
                               [SLIP_WALLS] = systems_has(fl, BOUNDARY_SLIP),
                               [TWO_STEPS] = two_steps(o),
                               [WEIGHTS] = o->coupled || fl->deferred != NULL,
                               [OWN_FLUX] = ddt_uses_new_time(o)};
    struct array list[MOST_ARRAYS];
    const int n = systems_list_arrays(fl, list);

    for (int i = 0; i < n; i++)
        if (needed[list[i].need])
            *list[i].at = alloc_doubles(list[i].per * count[list[i].place]);
    if (!o->coupled) fl->eps_n = fl->eps_nm1 = fl->eps;
    fl->p_face = fl->pressure->work + (count[WORK] - m->n_faces);
}

static void systems_free_arrays(struct fluid *fl)
{
    struct array list[MOST_ARRAYS];
    const int n = systems_list_arrays(fl, list);

    if (!fl->options.coupled) fl->eps_n = fl->eps_nm1 = NULL;
    for (int i = 0; i < n; i++)
        free(*list[i].at);
    free(fl->momentum->own_residual);
}

/* Geometric coefficients of each face, computed once. */
static void create_geometry(struct face_geometry *g, const struct mesh *m)
{
    g->face_coefficient = alloc_doubles(m->n_faces);
    for (int f = 0; f < m->n_faces; f++) {
        const double *const S = mesh_S(m, f);
        g->face_coefficient[f] = vector_dot(S, S) / vector_dot(S, mesh_d(m, f));
    }
}

/* --- a plane
 *
 * Where a mesh is one layer of cells between two slip walls, nothing flows
 * across the layer: the component of the velocity across it stays zero, and
 * those walls have no flux and no stress. Their faces do nothing then, and if
 * they are the last of the mesh, the loops over faces end before them. */

/* The part of the area vector of face f along axis k, and across it [m^2]. */
static double area_along(const struct mesh *m, int f, int k)
{
    return fabs(mesh_S(m, f)[k]);
}

static double area_across(const struct mesh *m, int f, int k)
{
    const double *const S = mesh_S(m, f);

    return fabs(S[(k + 1) % 3]) + fabs(S[(k + 2) % 3]);
}

static const double rounding = 1e-12; /* [-] of an area vector */

/* 1 if patch i is a slip wall normal to axis k. */
static int ends_layer(const struct fluid *fl, int i, int k)
{
    const struct mesh *const m = fl->mesh;
    const struct patch *const p = &m->patches[i];

    for (int f = p->first; f < p->first + p->n; f++)
        if (area_across(m, f, k) > rounding * area_along(m, f, k)) return 0;
    return fl->options.boundaries[i].kind == BOUNDARY_SLIP;
}

/* 1 if nothing but the faces from n on could move the fluid along axis k. */
static int lies_across(const struct fluid *fl, int n, int k)
{
    const struct mesh *const m = fl->mesh;
    const struct fluid_options *const o = &fl->options;
    int moves = o->mean_gradient[k] != 0.0 || o->keeps_flow[k];

    for (int f = 0; f < n && !moves; f++)
        moves = area_along(m, f, k) > rounding * area_across(m, f, k);
    for (int i = 0; i < m->n_patches; i++)
        for (int j = 0; j < m->patches[i].n && !moves; j++)
            moves = boundary_wall_velocity(&o->boundaries[i], j)[k] != 0.0;
    return !moves;
}

/* How many faces do something. */
static int faces_that_act(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const int undisturbed = fl->options.undisturbed &&
                            fl->options.shared == NULL && fl->deferred == NULL;

    for (int k = 0; k < 3 && undisturbed; k++) {
        int i = m->n_patches;
        while (i > 0 && ends_layer(fl, i - 1, k))
            i--;
        if (i < m->n_patches && lies_across(fl, m->patches[i].first, k))
            return m->patches[i].first;
    }
    return m->n_faces;
}

static struct faces *systems_faces_of(const struct mesh *m, int n)
{
    struct faces *const f = alloc_zeroed(1, sizeof *f);

    *f = (struct faces){.n_inner = m->n_internal,
                        .n = n,
                        .n_cells = m->n_cells,
                        .owner = m->owner,
                        .neighbour = m->neighbour,
                        .cell_start = m->cell_start,
                        .cell_face = m->cell_face,
                        .out = m->out,
                        .S = m->S,
                        .S_at = m->S_at};
    faces_divide(f);
    return f;
}

static struct preconditioned pressure_matrix(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double *const link = mesh_links(m);
    const struct preconditioned A =
        preconditioned_create(m->n_cells, m->n_internal, m->owner, m->neighbour,
                              fl->geometry->face_coefficient, link, m->V);

    free(link);
    return A;
}

void systems_own_residual(struct fluid *fl)
{
    struct momentum_system *const m = fl->momentum;
    const int n = 3 * fl->mesh->n_cells;

    if (m == NULL || m->own_residual != NULL)
        return; /* no arrays: an outline */
    m->own_residual = alloc_doubles(n);
    memcpy(m->own_residual, m->residual, (size_t)n * sizeof *m->residual);
    m->residual = m->own_residual;
}

/* Between two predictions of the velocity the pressure has its numbers of cells
 * and faces in the vectors of BiCGStab. In the fourth, `work`, are by turns the
 * residual, from the last solution of a step until the next step has begun; the
 * vectors of conjugate gradients, of which the third begins as the right-hand
 * side; and the pressures of the inner faces, until they have become a
 * gradient. Those of the boundary faces lie behind, and stay. */
static void create_solvers(struct fluid *fl)
{
    struct pressure_system *const p = fl->pressure;
    double *const work = p->work;
    const int n = fl->mesh->n_cells;

    p->resistance = p->boundary_conductance = p->per_force + n;
    p->per_flux = p->per_force + 2L * n;
    p->divergence = work + 2L * n;
    p->cg = cg_work_lent(n, (double *const[]){work, work + n, p->divergence});
    fl->momentum->residual = work;
    fl->momentum->bicgstab = bicgstab_work_lent(
        n, (double *const[]){p->per_force, p->m_face, p->conductance, work,
                             p->explicit_flux});
    if (fl->options.outer_correctors > 0 || fl->options.shared != NULL)
        systems_own_residual(fl);
}

void systems_create(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const int n = m->n_cells;

    fl->momentum = alloc_zeroed(1, sizeof *fl->momentum);
    fl->pressure = alloc_zeroed(1, sizeof *fl->pressure);
    fl->jump = alloc_zeroed(1, sizeof *fl->jump);
    fl->levels = alloc_zeroed(1, sizeof *fl->levels);
    fl->geometry = alloc_zeroed(1, sizeof *fl->geometry);
    create_geometry(fl->geometry, m);
    /* Before the arrays, because it takes more memory while it is made. */
    if (fl->options.shared == NULL) fl->pressure->matrix = pressure_matrix(fl);
    fl->deferred = deferred_create(fl);
    fl->faces = systems_faces_of(m, faces_that_act(fl));
    allocate_arrays(fl);
    fl->momentum->matrix =
        ldu_create(n, m->n_internal, m->owner, m->neighbour, fl->faces->pieces);
    fl->momentum->matrix->diagonals = fl->momentum->diag3 != NULL ? 3 : 1;
    fl->momentum->oblique_slip = has_inclined_slip(fl);
    fl->pressure->pinned_cell = systems_has(fl, BOUNDARY_OUTLET) ? -1 : 0;
    create_solvers(fl);
}

void systems_free(struct fluid *fl)
{
    ldu_free(fl->momentum->matrix);
    free(fl->momentum->bicgstab);
    preconditioned_free(fl->pressure->matrix);
    cg_work_free(fl->pressure->cg);
    deferred_free(fl->deferred);
    systems_free_arrays(fl);
    faces_release(fl->faces);
    free(fl->faces);
    free(fl->momentum);
    free(fl->pressure);
    free(fl->jump);
    free(fl->levels);
    free(fl->geometry->face_coefficient);
    free(fl->geometry);
}
